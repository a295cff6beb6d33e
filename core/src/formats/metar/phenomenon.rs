//! Weather as WMO code table 4678 has it: intensity, descriptor, phenomena, two letters each.

use schemars::JsonSchema;
use serde::Serialize;

/// One group of weather, now.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Weather {
    /// How heavy.
    pub intensity: Intensity,
    /// Within 8 to 16 km of the station, not at it.
    pub nearby: bool,
    /// What is said of all that follows. Thunder that comes alone is a descriptor without phenomena.
    pub descriptors: Vec<Descriptor>,
    /// What falls, or dims the view.
    pub phenomena: Vec<Phenomenon>,
}

/// How heavy weather is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Intensity {
    /// `-`
    Light,
    /// No sign.
    Moderate,
    /// `+`
    Heavy,
}

macro_rules! codes {
    ($(#[$of:meta])* $Kind:ident: $($code:literal $Name:ident $doc:literal;)*) => {
        $(#[$of])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
        #[serde(rename_all = "snake_case")]
        pub enum $Kind {
            $(#[doc = $doc] $Name,)*
        }

        impl $Kind {
            /// Its two letters and what they mean.
            pub const TABLE: &'static [(&'static str, Self)] = &[$(($code, Self::$Name)),*];

            fn named(code: &str) -> Option<Self> {
                Self::TABLE.iter().find(|row| row.0 == code).map(|row| row.1)
            }
        }
    };
}

codes! {
    /// What is said of phenomena.
    Descriptor:
    "MI" Shallow "Below eye level.";
    "PR" Partial "Over a part of the aerodrome.";
    "BC" Patches "Here and there.";
    "DR" Drifting "Raised by the wind, below eye level.";
    "BL" Blowing "Raised by the wind, to eye level and above.";
    "SH" Showers "From convective clouds.";
    "TS" Thunderstorm "With thunder.";
    "FZ" Freezing "Supercooled.";
}

codes! {
    /// What falls or dims the view.
    Phenomenon:
    "DZ" Drizzle "Fine drops.";
    "RA" Rain "Drops.";
    "SN" Snow "Flakes.";
    "SG" SnowGrains "Frozen drizzle.";
    "IC" IceCrystals "Diamond dust.";
    "PL" IcePellets "Frozen rain.";
    "GR" Hail "Of 5 mm and more.";
    "GS" SmallHail "Or snow pellets.";
    "UP" Unknown "Something falls; a sensor can't tell what.";
    "BR" Mist "One sees 1 to 5 km.";
    "FG" Fog "One sees less than 1 km.";
    "FU" Smoke "Of fires.";
    "VA" Ash "Of volcanoes.";
    "DU" Dust "Widespread.";
    "SA" Sand "In the air.";
    "HZ" Haze "Dry and fine.";
    "PY" Spray "Of the sea.";
    "PO" DustWhirls "Dust devils.";
    "SQ" Squall "Wind that leaps up.";
    "FC" FunnelCloud "Or a tornado.";
    "SS" Sandstorm "Sand far up.";
    "DS" Duststorm "Dust far up.";
}

impl Weather {
    /// The group, if it is one of weather.
    pub(super) fn read(text: &str) -> Option<Self> {
        let (intensity, text) = match text.split_at_checked(1)? {
            ("-", rest) => (Intensity::Light, rest),
            ("+", rest) => (Intensity::Heavy, rest),
            _ => (Intensity::Moderate, text),
        };
        let (nearby, mut rest) = text.strip_prefix("VC").map_or((false, text), |rest| (true, rest));
        let mut weather = Self { intensity, nearby, descriptors: Vec::new(), phenomena: Vec::new() };
        // No group has more than two descriptors and three phenomena.
        while let Some((code, after)) = rest.split_at_checked(2) {
            match (Descriptor::named(code), Phenomenon::named(code)) {
                (Some(descriptor), _) if weather.phenomena.is_empty() && weather.descriptors.len() < 2 => {
                    weather.descriptors.push(descriptor);
                }
                (_, Some(phenomenon)) if weather.phenomena.len() < 3 => weather.phenomena.push(phenomenon),
                _ => return None,
            }
            rest = after;
        }
        let alone = [Descriptor::Thunderstorm, Descriptor::Showers];
        let says = !weather.phenomena.is_empty() || weather.descriptors.iter().any(|each| alone.contains(each));
        (rest.is_empty() && says).then_some(weather)
    }

    /// Whether `phenomenon` is at the station.
    pub fn has(&self, phenomenon: Phenomenon) -> bool {
        !self.nearby && self.phenomena.contains(&phenomenon)
    }

    /// Whether that is said of it.
    pub fn is(&self, descriptor: Descriptor) -> bool {
        self.descriptors.contains(&descriptor)
    }
}
