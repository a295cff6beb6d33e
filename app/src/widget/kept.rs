//! How many sprites the cull left of those that were tried, live.

use cloudwright_core::scene::CloudBox;
use cloudwright_core::sprites::PlacedCloud;
use egui::{ProgressBar, Ui};

/// Sprites before and after culling.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) struct Kept {
    kept: usize,
    tried: usize,
    groups: usize,
}

impl Kept {
    /// Of all those clouds.
    pub(crate) fn of_clouds(clouds: &[&PlacedCloud]) -> Self {
        clouds.iter().fold(Self::default(), |sum, cloud| Self {
            kept: sum.kept + cloud.sprites.len(),
            tried: sum.tried + cloud.candidate_count,
            groups: sum.groups + cloud.groups.len(),
        })
    }

    /// Of boxes, as their model is placed in `cloud`. Sprites that were taken out by hand are not tried.
    pub(crate) fn of_boxes<'a>(boxes: impl IntoIterator<Item = &'a CloudBox>, cloud: &PlacedCloud) -> Self {
        boxes.into_iter().fold(Self::default(), |sum, each| {
            let is_dropped =
                |edit: &&cloudwright_core::scene::SpriteEdit| edit.dropped && edit.index < each.sprite_count;
            let dropped = each.sprite_edits.iter().filter(is_dropped).count();
            Self {
                kept: sum.kept + cloud.sprites.iter().filter(|sprite| sprite.box_id == each.id).count(),
                tried: sum.tried + (each.sprite_count as usize).saturating_sub(dropped),
                groups: 0,
            }
        })
    }
}

/// The counts in words, over a bar that shows their share.
pub(crate) fn line(ui: &mut Ui, count: &Kept) {
    let Kept { kept, tried, groups } = *count;
    let share = if tried > 0 { kept as f32 / tried as f32 } else { 0.0 };
    let mut text = format!("{kept} of {tried} sprites kept");
    if groups > 0 {
        text += &format!(", {groups} lump{}", if groups == 1 { "" } else { "s" });
    }
    let bar = ui.add(ProgressBar::new(share).desired_height(crate::theme::THIN_BAR));
    super::name_it(ui, &bar, "Share of sprites kept");
    ui.weak(text);
}
