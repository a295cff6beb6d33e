//! What is measured of a method in a situation: one number, the larger the worse.

use super::sprite_changes::sprite_changes;
use super::stage::Stage;
use cloudwright_core::color::{Premultiplied, Rgb};
use cloudwright_core::derived::Derived;
use cloudwright_core::draw::Drawn;
use cloudwright_core::image::{Layer, LinearPicture};
use cloudwright_core::measure::{Stability, linear_error, opacity_error};
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::Camera;
use cloudwright_core::weather::{FormingRule, Stepped, SteppedStreaming, StreamingRule};

/// Which number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Figure {
    /// Largest error of any channel of any pixel against the truth, linear light.
    Light,
    /// The same of the clouds alone, premultiplied, their opacity among the channels.
    Clouds,
    /// Largest error of any pixel's opacity against the truth.
    Opacity,
    /// Largest change of any pixel from one picture to the next beyond the truth's own, linear light.
    Excess,
    /// Largest change of any pixel's opacity from one picture to the next, whatever the truth does.
    Steps,
    /// Largest change of any sprite for each metre that it and the eye pass one another, of its alpha, its facing or its up,
    /// in shares of [`super::CHANGES`].
    Sprites,
    /// How far any sprite is carried from its rest, in its cloud's reach.
    Moves,
    /// Largest change of any pixel's opacity when frames come 10, 60 or 240 times a second.
    Rates,
}

impl Figure {
    /// In the order of reports.
    pub const ALL: [Self; 8] =
        [Self::Light, Self::Clouds, Self::Opacity, Self::Excess, Self::Steps, Self::Sprites, Self::Moves, Self::Rates];

    /// As it is called in a report.
    pub fn name(self) -> &'static str {
        match self {
            Self::Light => "light",
            Self::Clouds => "clouds",
            Self::Opacity => "opacity",
            Self::Excess => "excess",
            Self::Steps => "steps",
            Self::Sprites => "sprites",
            Self::Moves => "moves",
            Self::Rates => "rates",
        }
    }

    /// What it is, for a report.
    pub fn about(self) -> &'static str {
        match self {
            Self::Light => "largest error of any channel of any pixel against the truth, linear light",
            Self::Clouds => "the same of the clouds alone, premultiplied, their opacity among the channels",
            Self::Opacity => "largest error of any pixel's opacity against the truth",
            Self::Excess => "largest change of any pixel from picture to picture beyond the truth's own, linear light",
            Self::Steps => "largest change of any pixel's opacity from picture to picture, whatever the truth does",
            Self::Sprites => {
                "largest change of any sprite's alpha, facing or up for each metre that it and the eye pass one another, \
                 times its lock distance, as a share of 3.2, 4 and 16"
            }
            Self::Moves => "how far any sprite is carried from its rest, in its cloud's reach",
            Self::Rates => "largest change of any pixel's opacity when frames come 10, 60 or 240 times a second",
        }
    }

    /// The number for a way to draw, which made `pictures` where the truth made `truths`; none where it has none, as
    /// where clouds have no layer of their own.
    pub fn of(self, stage: &Stage, rules: &Rules, pictures: &[Drawn], truths: &[Drawn]) -> Option<f64> {
        let pairs = || pictures.iter().zip(truths);
        let layers = || pairs().map(|(a, b)| Some((a.clouds.as_ref()?, b.clouds.as_ref()?)));
        match self {
            Self::Light => largest(pairs().map(|(a, b)| Some(linear_error(&a.linear, &b.linear).ok()?.largest))),
            Self::Opacity => largest(layers().map(|pair| opacity(pair?))),
            Self::Clouds => largest(layers().map(|pair| {
                let (a, b) = pair?;
                let colors = linear_error(&colors_of(a), &colors_of(b)).ok()?;
                Some(colors.largest.max(opacity((a, b))?))
            })),
            Self::Excess => {
                let mut stability = Stability::new();
                let maps: Result<Vec<_>, _> = pairs().map(|(a, b)| stability.add(&a.linear, &b.linear)).collect();
                largest(maps.ok()?.into_iter().flatten().map(|map| Some(map.largest())))
            }
            Self::Steps => {
                largest(pictures.windows(2).map(|two| opacity((two[0].clouds.as_ref()?, two[1].clouds.as_ref()?))))
            }
            Self::Sprites => {
                let looks: Vec<(Camera, f64)> =
                    stage.looks.iter().map(|look| (look.camera.clone(), look.clock_s)).collect();
                Some(sprite_changes(&stage.scene, &looks, rules).share().into())
            }
            Self::Moves => {
                let derived = Derived::new(&stage.scene);
                largest(stage.looks.iter().map(|look| Some(largest_move(&derived, rules, look.clock_s))))
            }
            Self::Rates => {
                let [slow, usual, quick] = [10, 60, 240].map(|rate| stage.draw(&at_rate(rules, rate)));
                let (slow, usual, quick) = (slow?, usual?, quick?);
                let both = || slow.iter().zip(&usual).chain(quick.iter().zip(&usual));
                largest(both().map(|(a, b)| opacity((a.clouds.as_ref()?, b.clouds.as_ref()?))))
            }
        }
    }
}

/// What is no number has gone infinitely far.
fn largest_move(derived: &Derived, rules: &Rules, clock_s: f64) -> f32 {
    let mut largest = 0.0_f32;
    for cloud in derived.clouds_at(clock_s, rules.of_weather()) {
        let Some(air) = &cloud.air else { continue };
        for (index, rest) in cloud.placed.sprites.iter().enumerate() {
            let moved = cloud.sprite_now(index).position.distance(cloud.point_now(rest.position)) / air.reach_m;
            largest = largest.max(if moved.is_finite() { moved } else { f32::INFINITY });
        }
    }
    largest
}

/// None if one of them is.
fn largest(values: impl Iterator<Item = Option<f32>>) -> Option<f64> {
    values.collect::<Option<Vec<f32>>>().map(|values| values.into_iter().fold(0.0, f32::max).into())
}

fn opacity((a, b): (&Layer, &Layer)) -> Option<f32> {
    opacity_error(a, b).ok().map(|error| error.largest)
}

fn colors_of(layer: &Layer) -> LinearPicture {
    let color = |pixel: &Premultiplied| Rgb::new(pixel.r, pixel.g, pixel.b);
    LinearPicture { width: layer.width, height: layer.height, pixels: layer.pixels.iter().map(color).collect() }
}

/// The same where frames come so often; what is in closed form has no rate.
fn at_rate(rules: &Rules, frames_a_second: u32) -> Rules {
    let forming = match rules.forming {
        FormingRule::ClosedForm => FormingRule::ClosedForm,
        FormingRule::Stepped(stepped) => FormingRule::Stepped(Stepped { frames_a_second, ..stepped }),
    };
    let streaming = match rules.streaming {
        StreamingRule::ClosedForm => StreamingRule::ClosedForm,
        StreamingRule::Stepped(stepped) => {
            StreamingRule::Stepped(SteppedStreaming { frame_s: 1.0 / f64::from(frames_a_second), ..stepped })
        }
    };
    Rules { forming, streaming, ..*rules }
}
