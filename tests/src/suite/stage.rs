//! A situation's scene, who looks at it and when; and what a method makes of it.

use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::draw::{Drawn, drawn};
use cloudwright_core::frame::Frame;
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::view_history::ViewHistory;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::Moment;
use std::borrow::Cow;
use std::sync::Arc;

/// What is looked at.
pub struct Stage {
    /// The clouds and their light.
    pub scene: Scene,
    /// Their tiles.
    pub atlas: Cow<'static, Atlas>,
    /// Width and height of the pictures, pixels.
    pub size: [u32; 2],
    /// Whether the looks are steps of a flight, 1/60 s apart, which the view remembers; else each is a still.
    pub flies: bool,
    /// In order.
    pub looks: Vec<Look>,
}

/// A look.
#[derive(Debug, Clone)]
pub struct Look {
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
        let looks = vec![Look { camera, clock_s: 0.0, drawn: true }];
        Self { scene, atlas, size: [96, 54], flies: false, looks }
    }

    /// A flight in steps of 1/60 s, of which those are drawn that `drawn` says.
    pub fn flight(
        scene: Scene,
        atlas: Cow<'static, Atlas>,
        cameras: impl IntoIterator<Item = Camera>,
        drawn: impl Fn(usize) -> bool,
    ) -> Self {
        let look = |(step, camera)| Look { camera, clock_s: 0.0, drawn: drawn(step) };
        let looks = cameras.into_iter().enumerate().map(look).collect();
        Self { scene, atlas, size: [48, 27], flies: true, looks }
    }

    /// All pictures by a way to draw, in order; none on a GPU.
    pub fn draw(&self, rules: &Rules) -> Option<Vec<Drawn>> {
        let derived = Derived::new(&self.scene);
        let mut history = Arc::<ViewHistory>::default();
        let mut pictures = Vec::new();
        for look in &self.looks {
            if self.flies {
                let view = View::new(&look.camera, self.size[0], self.size[1]);
                Arc::make_mut(&mut history).step(rules, &derived, look.clock_s, &view);
            }
            if look.drawn {
                let sight = Sight {
                    moment: Moment::at(look.clock_s),
                    history: Arc::clone(&history),
                    rules: *rules,
                    ..Sight::still(&look.camera, self.size)
                };
                pictures.push(drawn(&Frame::new(&self.scene, &derived, &self.atlas, &sight), &Watch::default())?);
            }
        }
        Some(pictures)
    }
}
