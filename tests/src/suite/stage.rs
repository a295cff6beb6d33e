//! A situation's scene, who looks at it and when; and what a method makes of it.

use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::draw_list::Hidden;
use cloudwright_core::frame::Sight;
use cloudwright_core::method::{Drawn, Settings};
use cloudwright_core::model_in_view::Meshes;
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::sprites::Atlas;
use cloudwright_core::watch::Watch;
use std::borrow::Cow;

/// What is looked at.
pub struct Stage {
    /// The clouds and their light.
    pub scene: Scene,
    /// Their tiles.
    pub atlas: Cow<'static, Atlas>,
    /// Width and height of the pictures, pixels.
    pub size: [u32; 2],
    /// Whether the moments are steps of a flight, 1/60 s apart, which the view remembers; else each is a still.
    pub flies: bool,
    /// In order.
    pub moments: Vec<Moment>,
}

/// A look.
#[derive(Debug, Clone)]
pub struct Moment {
    /// From where.
    pub camera: Camera,
    /// Seconds of the scene's clock: how far clouds have formed.
    pub clock_s: f64,
    /// Whether a picture is made of it.
    pub drawn: bool,
}

impl Stage {
    /// A still.
    pub fn still(scene: Scene, atlas: Cow<'static, Atlas>, camera: Camera) -> Self {
        let moments = vec![Moment { camera, clock_s: 0.0, drawn: true }];
        Self { scene, atlas, size: [96, 54], flies: false, moments }
    }

    /// A flight in steps of 1/60 s, of which those are drawn that `drawn` says.
    pub fn flight(
        scene: Scene,
        atlas: Cow<'static, Atlas>,
        cameras: impl IntoIterator<Item = Camera>,
        drawn: impl Fn(usize) -> bool,
    ) -> Self {
        let moment = |(step, camera)| Moment { camera, clock_s: 0.0, drawn: drawn(step) };
        let moments = cameras.into_iter().enumerate().map(moment).collect();
        Self { scene, atlas, size: [48, 27], flies: true, moments }
    }

    /// All pictures by a way to draw, in order; none on a GPU.
    pub fn draw(&self, settings: &Settings) -> Option<Vec<Drawn>> {
        let all = Derived::new(&self.scene);
        let derived = settings.clouds(&all, &self.atlas);
        let mut history = settings.history();
        let (hidden, meshes) = (&Hidden::default(), &Meshes::default());
        let mut pictures = Vec::new();
        for Moment { camera, clock_s, drawn } in &self.moments {
            if self.flies {
                history.step(&derived, &View::new(camera, self.size[0], self.size[1]));
            }
            if *drawn {
                let (time_h, clock_s, size) = (self.scene.time_of_day_h, *clock_s, self.size);
                let sight = Sight { camera, time_h, clock_s, size, hidden, meshes, history: &history };
                pictures.push(
                    settings.draw(&settings.frame(&self.scene, &derived, &self.atlas, &sight), &Watch::default())?,
                );
            }
        }
        Some(pictures)
    }
}
