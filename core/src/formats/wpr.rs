//! A weather preset of Microsoft Flight Simulator 2020 and 2024, `NAME.WPR`: XML in UTF-8 with a byte order mark, each
//! element written with a tag and its end, numbers as `Value` with a `Unit`.
//!
//! What is understood is a [`Preset`]; a [`Wpr`] is the whole file, with what is not: reading and writing gives back all
//! its values, comments and their order, if not its white space. Source: presets that the simulator's users share; their
//! elements are named as their fields are here. Not known: what takes part in `Order`, `Image`, `Icon` and `LayeredImage`
//! but the simulator's own menu, how scattering and density are drawn, and what aerosol density measures (its unit says
//! metres).

use super::Misread;
use super::xml::{self, Element, Node, Style};
use std::ops::RangeInclusive;

/// The largest file, bytes: presets have some kilobytes.
pub const MAX_BYTES: usize = 1 << 20;

/// What the simulator takes.
pub const PRESSURE_PA: RangeInclusive<f64> = 50_000.0..=130_000.0;
/// What the simulator takes.
pub const PRECIPITATION_MM_PER_H: RangeInclusive<f64> = 0.0..=100.0;
/// What the simulator takes.
pub const SNOW_M: RangeInclusive<f64> = 0.0..=4.0;
/// What the simulator takes.
pub const WIND_KT: RangeInclusive<f64> = 0.0..=150.0;
/// Layers of cloud, which every preset has as many of; those that it does not need cover nothing.
pub const CLOUD_LAYERS: usize = 3;
/// Where a layer that is not needed lies, and where one without a top ends, metres.
pub const NOWHERE_M: f64 = 60_000.0;

const ROOT: &str = "SimBase.Document";
const PRESET: &str = "WeatherPreset.Preset";
const STYLE: Style = Style { byte_order_mark: true, line_end: "\r\n", indent: "    ", closes: true, declares: true };

/// A whole file.
#[derive(Debug, Clone, PartialEq)]
pub struct Wpr(Element);

/// What a preset says, as far as it is understood. None where it does not say it.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Preset {
    /// As the simulator's menu has it.
    pub name: String,
    /// The picture beside it: the simulator's own are `clear_sky`, `few_clouds`, `overcast` and `storm`.
    pub image: String,
    /// At mean sea level.
    pub pressure_pa: Option<f64>,
    /// At mean sea level.
    pub temperature_k: Option<f64>,
    /// 0 for clear air; the presets at hand have up to 4.5.
    pub aerosol_density: Option<f64>,
    /// 0 to 1.
    pub pollution: Option<f64>,
    /// Rain, or snow where it freezes.
    pub precipitation_mm_per_h: Option<f64>,
    /// On the ground, metres.
    pub snow_m: Option<f64>,
    /// Lightning, 0 to 1.
    pub thunderstorm: Option<f64>,
    /// Whether altitudes count from the ground, not from the sea.
    pub above_ground: bool,
    /// Clouds.
    pub clouds: Vec<CloudLayer>,
    /// Wind at its heights.
    pub winds: Vec<WindLayer>,
    /// Names of elements that are not understood.
    pub unknown: Vec<String>,
}

/// A layer of clouds.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct CloudLayer {
    /// Of the sky, 0 to 1.
    pub coverage: f64,
    /// 0 to 1, and above in some presets.
    pub density: f64,
    /// How much its clouds are torn, 0 to 1.
    pub scattering: f64,
    /// Of its base, metres.
    pub bottom_m: f64,
    /// Of its top, metres.
    pub top_m: f64,
}

/// Wind at a height.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WindLayer {
    /// Metres.
    pub altitude_m: f64,
    /// Where it comes from, clockwise from north.
    pub from_deg: f64,
    /// Knots.
    pub speed_kt: f64,
    /// Its gusts, if it has any.
    pub gust: Option<Gust>,
}

/// Gusts of a wind.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Gust {
    /// Where they come from, clockwise from north.
    pub from_deg: f64,
    /// Knots.
    pub speed_kt: f64,
    /// From one to the next, seconds.
    pub interval_s: f64,
    /// Seconds.
    pub duration_s: f64,
}

/// Whether bytes look like such a file.
pub fn looks_like(bytes: &[u8]) -> bool {
    bytes.windows(ROOT.len()).take(4096).any(|window| window == ROOT.as_bytes())
}

impl Wpr {
    /// Reads a file.
    ///
    /// # Errors
    /// If it is no XML or no preset.
    pub fn read(bytes: &[u8]) -> Result<Self, Misread> {
        let root = xml::read(bytes)?;
        if root.name != ROOT || root.element(PRESET).is_none() {
            return Err(root.misread(format_args!("it is no weather preset: {ROOT} with a {PRESET}")));
        }
        Ok(Self(root))
    }

    /// The file's bytes.
    pub fn write(&self) -> Vec<u8> {
        xml::write(&self.0, STYLE)
    }

    /// What it says.
    ///
    /// # Errors
    /// If a number is none, or of another unit than the simulator's.
    pub fn preset(&self) -> Result<Preset, Misread> {
        let Some(element) = self.0.element(PRESET) else { return Ok(Preset::default()) };
        let mut preset = Preset::default();
        for each in element.elements() {
            match each.name.as_str() {
                "Name" => preset.name = each.text(),
                "Image" => preset.image = picture(&each.text()),
                "Order" | "Icon" | "LayeredImage" => {}
                "MSLPressure" => preset.pressure_pa = Some(value(each, "pa")?),
                "MSLTemperature" => preset.temperature_k = Some(value(each, "k")?),
                "AerosolDensity" => preset.aerosol_density = Some(value(each, "")?),
                "Pollution" => preset.pollution = Some(value(each, "")?),
                "Precipitations" => preset.precipitation_mm_per_h = Some(value(each, "mm/h")?),
                "SnowCover" => preset.snow_m = Some(value(each, "m")?),
                "ThunderstormIntensity" => preset.thunderstorm = Some(value(each, "")?),
                "IsAltitudeAMGL" => preset.above_ground = each.text().eq_ignore_ascii_case("true"),
                "CloudLayer" => preset.clouds.push(cloud_layer(each, &mut preset.unknown)?),
                "WindLayer" => preset.winds.push(wind_layer(each, &mut preset.unknown)?),
                other => preset.unknown.push(other.into()),
            }
        }
        Ok(preset)
    }

    /// A file that says `preset`. What it does not say is left out; `unknown` is not written.
    pub fn of(preset: &Preset) -> Self {
        let mut own = Element::new(PRESET);
        let image = |ending: &str| format!("weather/presets/{}{ending}", preset.image);
        for (name, text) in [
            ("Name", preset.name.clone()),
            ("Order", "100".into()),
            ("Image", image(".jpg")),
            ("Icon", image(".svg")),
            ("LayeredImage", image("_layer.png")),
        ] {
            own.push(Element::with_text(name, text));
        }
        let comment = |words: &str| Node::Comment(words.into());
        own.children.push(comment("Surface parameters"));
        for (name, value, unit) in [
            ("MSLPressure", preset.pressure_pa, "pa"),
            ("MSLTemperature", preset.temperature_k, "k"),
            ("AerosolDensity", preset.aerosol_density, "m"),
            ("Pollution", preset.pollution, SHARE),
            ("Precipitations", preset.precipitation_mm_per_h, "mm/h"),
            ("SnowCover", preset.snow_m, "m"),
            ("ThunderstormIntensity", preset.thunderstorm, SHARE),
        ] {
            value.into_iter().for_each(|value| own.push(with_value(name, value, unit)));
        }
        own.push(Element::with_text("IsAltitudeAMGL", if preset.above_ground { "True" } else { "False" }));
        own.children.push(comment("Cloud Layers"));
        for layer in &preset.clouds {
            let mut element = Element::new("CloudLayer");
            element.push(with_value("CloudLayerCoverage", layer.coverage, SHARE));
            element.push(with_value("CloudLayerDensity", layer.density, SHARE));
            element.push(with_value("CloudLayerScattering", layer.scattering, SHARE));
            element.push(with_value("CloudLayerAltitudeBot", layer.bottom_m, "m"));
            element.push(with_value("CloudLayerAltitudeTop", layer.top_m, "m"));
            own.push(element);
        }
        own.children.push(comment("Wind Layers"));
        for layer in &preset.winds {
            let mut element = Element::new("WindLayer");
            element.push(with_value("WindLayerAltitude", layer.altitude_m, "m"));
            element.push(with_value("WindLayerAngle", layer.from_deg, "degrees"));
            element.push(with_value("WindLayerSpeed", layer.speed_kt, "knts"));
            if let Some(gust) = &layer.gust {
                let mut wave = Element::new("GustWave");
                wave.push(with_value("GustWaveInterval", gust.interval_s, "sec"));
                wave.push(with_value("GustWaveDuration", gust.duration_s, "sec"));
                wave.push(with_value("GustWaveSpeed", gust.speed_kt, "knts"));
                wave.push(with_value("GustAngle", gust.from_deg, "degrees"));
                element.push(wave);
            }
            own.push(element);
        }
        let mut root = Element::new(ROOT).with("Type", "WeatherPreset").with("version", "1,3");
        root.push(Element::with_text("Descr", "AceXML Document"));
        root.push(own);
        Self(root)
    }
}

/// `weather/presets/storm.jpg` shows `storm`.
fn picture(path: &str) -> String {
    let name = path.rsplit(['/', '\\']).next().unwrap_or_default();
    name.rsplit_once('.').map_or(name, |(stem, _)| stem).into()
}

const SHARE: &str = "(0 - 1)";

/// Thousandths, as the simulator's own presets have them.
fn with_value(name: &str, value: f64, unit: &str) -> Element {
    // Adding 0 turns −0 into 0.
    Element::new(name).with("Value", format!("{:.3}", value + 0.0)).with("Unit", unit)
}

/// An element's number. If it says that it is of another unit than `unit`, it is refused.
fn value(element: &Element, unit: &str) -> Result<f64, Misread> {
    let text = element.attribute("Value").ok_or_else(|| element.misread("it has no Value"))?;
    let said = element.attribute("Unit").unwrap_or(unit);
    if !unit.is_empty() && !said.eq_ignore_ascii_case(unit) {
        return Err(element.misread(format_args!("its unit is “{said}”; the simulator's is {unit}")));
    }
    element.number(text)
}

fn cloud_layer(element: &Element, unknown: &mut Vec<String>) -> Result<CloudLayer, Misread> {
    let mut layer = CloudLayer::default();
    for each in element.elements() {
        match each.name.as_str() {
            "CloudLayerCoverage" => layer.coverage = value(each, "")?,
            "CloudLayerDensity" => layer.density = value(each, "")?,
            "CloudLayerScattering" => layer.scattering = value(each, "")?,
            "CloudLayerAltitudeBot" => layer.bottom_m = value(each, "m")?,
            "CloudLayerAltitudeTop" => layer.top_m = value(each, "m")?,
            other => unknown.push(other.into()),
        }
    }
    Ok(layer)
}

fn wind_layer(element: &Element, unknown: &mut Vec<String>) -> Result<WindLayer, Misread> {
    let mut layer = WindLayer::default();
    for each in element.elements() {
        match each.name.as_str() {
            "WindLayerAltitude" => layer.altitude_m = value(each, "m")?,
            "WindLayerAngle" => layer.from_deg = value(each, "degrees")?,
            "WindLayerSpeed" => layer.speed_kt = value(each, "knts")?,
            "GustWave" => layer.gust = Some(gust(each, unknown)?),
            other => unknown.push(other.into()),
        }
    }
    Ok(layer)
}

fn gust(element: &Element, unknown: &mut Vec<String>) -> Result<Gust, Misread> {
    let mut gust = Gust::default();
    for each in element.elements() {
        match each.name.as_str() {
            "GustAngle" => gust.from_deg = value(each, "degrees")?,
            "GustWaveSpeed" => gust.speed_kt = value(each, "knts")?,
            "GustWaveInterval" => gust.interval_s = value(each, "sec")?,
            "GustWaveDuration" => gust.duration_s = value(each, "sec")?,
            other => unknown.push(other.into()),
        }
    }
    Ok(gust)
}
