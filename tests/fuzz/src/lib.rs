//! What readers are thrown: any bytes. They answer in words or with something sound; a panic, an endless loop or too much
//! memory is a fault.

use cloudwright_core::exchange::{Arriving, Content, Format};
use cloudwright_core::formats::scene_file;
use cloudwright_core::problem::{Severity, check};
use cloudwright_core::scene::Scene;

/// A file of that format comes in; a scene of it is sound.
pub fn arrives(format: &str, bytes: &[u8]) {
    let format = Format::to_read(Some(format), "", bytes).expect("a format that is read");
    let options = format.usual_for_reading();
    let Ok(arrived) = format.read(&Arriving { bytes, name: "any", options: &options }) else { return };
    if let Content::Scene(scene) = arrived.content {
        is_sound(&scene);
    }
}

/// A scene file is refused, or sound and the same when it is written and read again.
pub fn opens(bytes: &[u8]) {
    let Ok(scene) = scene_file::read(bytes) else { return };
    is_sound(&scene);
    let text = scene_file::write(&scene).expect("what was read can be written");
    assert!(scene_file::read(text.as_bytes()).is_ok_and(|again| again == scene), "it comes back");
}

fn is_sound(scene: &Scene) {
    let errors: Vec<_> = check(scene).into_iter().filter(|each| each.severity == Severity::Error).collect();
    assert!(errors.is_empty(), "{errors:?}");
}
