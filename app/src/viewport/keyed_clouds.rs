//! Clouds that a gizmo carries: what of their place is keyed becomes keys if *Auto-key* is on. If not, the scene's own place
//! changes, and gizmo and outlines stand there until it is keyed or the clock moves.

use super::targets::{Act, Targets};
use crate::state::{Reading, Values, place_value, take_place};
use cloudwright_core::arrange::keys;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::property::Target;

/// Adds the edits that carry the clouds. What was changed beside its track, if anything was.
pub(super) fn edits(targets: &Targets, act: Act, reading: &Reading<'_>, edits: &mut Vec<Edit>) -> Option<Vec<Target>> {
    let scene = reading.session.scene();
    let auto_key = reading.view.timeline.auto_key;
    let (mut keyed, mut beside): (Values, Vec<Target>) = (Vec::new(), Vec::new());
    // All that the act may change, so that what comes back to its start is set back too.
    let paths: &[&str] = match act {
        Act::Move(_) => &["position"],
        Act::Turn(..) => &["position", "heading_deg"],
        Act::Stretch(_) => &["position", "scale"],
    };
    for after in targets.moved_clouds(act) {
        let Some(own) = scene.cloud(after.id) else { continue };
        let mut new = own.clone();
        for path in paths {
            let Some((target, value)) = place_value(&after, path) else { continue };
            let has_track = reading.has_track(&target);
            if has_track && auto_key {
                keyed.push((target, value));
                continue;
            }
            take_place(&mut new, &after, path);
            beside.extend(has_track.then_some(target));
        }
        if new != *own {
            edits.push(Edit::Cloud(ListEdit::Replace(new)));
        }
    }
    edits.extend(keys::keyed(scene, &keyed, reading.clock.time_s()).edits);
    (!beside.is_empty()).then_some(beside)
}
