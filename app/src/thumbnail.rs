//! Small pictures of ready-made clouds, skies and scenes, drawn by the CPU off the frame.
//!
//! A choice of pictures asks for that of each [`Subject`] that it shows. The first time, that queues it for a thread of its
//! own, which draws one after the other and wakes the window after each; from then on the texture is there for the
//! session. Nothing is drawn, and no thread runs, before the first choice is shown.

use crate::opening;
use crate::starter::Template;
use cloudwright_core::derived::Derived;
use cloudwright_core::draw;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::preset::Preset;
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::{
    BoxId, Category, Cloud, CloudBox, CloudId, CloudModel, CullRadius, GroupCenter, ModelId, Scene,
};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::watch::Watch;
use egui::{ColorImage, Context, TextureHandle, TextureId, TextureOptions};
use glam::DVec3;
use std::collections::HashMap;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread;

/// Pixels.
pub(crate) const SIZE: [u32; 2] = [192, 120];
/// Samples along a pixel's side.
const SAMPLES_SIDE: u32 = 2;
/// Of a file's scene: more take long.
const MOST_SPRITES: u64 = 300_000;

/// What there is a picture of.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub enum Subject {
    /// A ready-made cloud, as its own scene shows it.
    Preset(&'static Preset),
    /// A box of that category's sprites.
    Category(Category),
    /// A sky to begin with, as its first camera sees it.
    Template(Template),
    /// A scene's file, as its first camera sees it.
    File(PathBuf),
}

/// The pictures drawn so far in this session.
pub struct Thumbnails {
    context: Context,
    /// None: asked for, and on its way.
    textures: HashMap<Subject, Option<TextureHandle>>,
    artist: Option<Artist>,
}

/// The thread's two ends. It ends when they are dropped, after the picture in hand.
struct Artist {
    subjects: Sender<Subject>,
    pictures: Receiver<(Subject, Picture)>,
}

impl Thumbnails {
    /// No pictures yet.
    pub fn new(context: &Context) -> Self {
        Self { context: context.clone(), textures: HashMap::new(), artist: None }
    }

    /// The picture of `subject`, 192 × 120 pixels; none while it is still to come.
    pub fn texture(&mut self, subject: &Subject) -> Option<TextureId> {
        self.take_up();
        if let Some(texture) = self.textures.get(subject) {
            return texture.as_ref().map(TextureHandle::id);
        }
        // Without a thread (the system gives none) a choice shows names alone.
        if self.artist.is_none() {
            self.artist = Artist::start(&self.context).ok();
        }
        let asked = self.artist.as_ref().is_some_and(|artist| artist.subjects.send(subject.clone()).is_ok());
        if asked {
            self.textures.insert(subject.clone(), None);
        }
        None
    }

    /// Makes textures of what was drawn since.
    fn take_up(&mut self) {
        let Some(artist) = &self.artist else { return };
        for (subject, picture) in artist.pictures.try_iter() {
            let image = ColorImage::from_rgba_unmultiplied(SIZE.map(|side| side as usize), picture.as_bytes());
            let texture = self.context.load_texture("thumbnail", image, TextureOptions::LINEAR);
            self.textures.insert(subject, Some(texture));
        }
    }
}

impl Artist {
    fn start(context: &Context) -> std::io::Result<Self> {
        let (subjects, asked) = channel();
        let (drawn, pictures) = channel();
        let context = context.clone();
        thread::Builder::new().name("thumbnails".into()).spawn(move || {
            for subject in asked {
                let Some(picture) = draw(&subject) else { continue };
                if drawn.send((subject, picture)).is_err() {
                    return;
                }
                context.request_repaint();
            }
        })?;
        Ok(Self { subjects, pictures })
    }
}

/// None for a scene without a camera, and for a file that is no scene, or so large a one that a picture would take long.
fn draw(subject: &Subject) -> Option<Picture> {
    let scene = match subject {
        Subject::Preset(preset) => preset.scene(),
        Subject::Category(category) => sample_of(*category),
        Subject::Template(template) => template.scene().ok()?,
        Subject::File(path) => opening::open_scene(path).ok().filter(|scene| candidates(scene) < MOST_SPRITES)?,
    };
    let derived = Derived::new(&scene);
    let rules = Rules { samples_side: SAMPLES_SIDE, ..Rules::SHIPPED };
    let sight = Sight { rules, ..Sight::still(scene.cameras.first()?, SIZE) };
    draw::picture(&Frame::new(&scene, &derived, Atlas::built_in(), &sight), &Watch::default())
}

/// The sprites that a scene's clouds try.
fn candidates(scene: &Scene) -> u64 {
    let of_model = |model: &CloudModel| model.boxes.iter().map(|each| u64::from(each.sprite_count)).sum::<u64>();
    let counts: HashMap<ModelId, u64> = scene.models.iter().map(|model| (model.id, of_model(model))).collect();
    scene.clouds.iter().filter_map(|cloud| counts.get(&cloud.model)).sum()
}

/// The same few sprites for each category, so that nothing but their tiles tells them apart. The seed is one under
/// which they lie side by side.
fn sample_of(category: Category) -> Scene {
    let mut scene = Scene { time_of_day_h: 15.5, ..Scene::default() };
    let mut model = CloudModel::new(ModelId::new(&mut scene.next_id), category.name(), category);
    (model.seed, model.cull_radius) = (7, CullRadius::SpriteFraction(0.2));
    let mut sample = CloudBox::new(BoxId::new(&mut scene.next_id), DVec3::ZERO);
    sample.size = DVec3::new(560.0, 110.0, 120.0);
    (sample.sprite_count, sample.width, sample.height) = (18, [180.0, 320.0], [180.0, 320.0]);
    sample.lumps = [3, 1, 1];
    sample.light.center = GroupCenter::Pulled(0.33);
    if category == Category::FlatBase {
        // Level undersides only make sense upright and in one plane.
        (sample.size.y, sample.rotation_deg) = (0.0, [-5.0, 5.0]);
    }
    model.boxes.push(sample);
    let at = DVec3::new(0.0, 1000.0, 0.0);
    scene.clouds.push(Cloud::new(CloudId::new(&mut scene.next_id), &model, at));
    scene.models.push(model);
    for camera in &mut scene.cameras {
        // From below, before the blue of the sky.
        camera.position = at + DVec3::new(0.0, -420.0, 1250.0);
        (camera.pitch_deg, camera.field_of_view_deg) = (18.6, 24.0);
    }
    scene
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Pictures with hardly a cloud in them, or all of one grey, are no use to choose by.
    #[test]
    fn every_subject_has_a_picture_with_a_cloud_in_it() {
        let presets = Preset::ALL.iter().map(Subject::Preset);
        for subject in presets.chain(Category::ALL.into_iter().map(Subject::Category)) {
            let picture = draw(&subject).expect("a camera");
            assert_eq!([picture.width, picture.height], SIZE, "{subject:?}");
            let of_sky = |[r, _, b, _]: [u8; 4]| i32::from(b) > i32::from(r) + 24;
            // The upper two thirds: below lies the ground.
            let upper = &picture.pixels[..picture.pixels.len() * 2 / 3];
            let cloud = upper.iter().filter(|pixel| !of_sky(**pixel)).count() as f64 / upper.len() as f64;
            assert!(cloud > 0.04 && cloud < 0.96, "{subject:?}: {cloud:.2} of it is cloud");
        }
    }
}
