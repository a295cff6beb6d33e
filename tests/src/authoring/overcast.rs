//! stub
use cloudwright_core::scene::Scene;
pub(super) fn scene() -> Scene {
    Scene::default()
}
