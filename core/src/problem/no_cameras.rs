//! Without a camera there is nothing to draw a picture from: mentioned, since the editor can do without.

use super::Problem;
use super::scope::Scope;

pub(super) fn check(Scope { scene, .. }: Scope<'_>, problems: &mut Vec<Problem>) {
    if scene.cameras.is_empty() {
        problems.push(Problem::note(
            "cameras",
            "the scene has no camera",
            "add one; `render` needs a camera to see from",
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::super::{assert_found, sound_scene};

    #[test]
    fn mentions() {
        let mut scene = sound_scene();
        scene.cameras.clear();
        assert_found(&scene, "cameras", "no camera");
    }
}
