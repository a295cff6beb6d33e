//! The plugins within the program, each an example worth reading.

/// One of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shipped {
    /// Of its file, and on the command line.
    pub name: &'static str,
    /// The script.
    pub source: &'static str,
}

/// A script with the parts that it shares with others behind it: a plugin is one text, to be read and copied whole.
macro_rules! shipped {
    ($($name:literal $($part:literal)*;)*) => {
        &[$(Shipped {
            name: $name,
            source: concat!(
                include_str!(concat!("../plugins/", $name, ".rhai"))
                $(, include_str!(concat!("../plugins/parts/", $part, ".rhai")))*
            ),
        }),*]
    };
}

/// The parts, by name.
const PARTS: &[(&str, &str)] = &[
    ("altocumulus", include_str!("../plugins/parts/altocumulus.rhai")),
    ("boxes", include_str!("../plugins/parts/boxes.rhai")),
    ("cumulonimbus", include_str!("../plugins/parts/cumulonimbus.rhai")),
    ("cumulus", include_str!("../plugins/parts/cumulus.rhai")),
    ("deck", include_str!("../plugins/parts/deck.rhai")),
    ("far", include_str!("../plugins/parts/far.rhai")),
    ("lens", include_str!("../plugins/parts/lens.rhai")),
    ("stratus", include_str!("../plugins/parts/stratus.rhai")),
];

/// All that there are, by name.
pub const SHIPPED: &[Shipped] = shipped! {
    "altocumulus_sheet" "altocumulus" "boxes" "cover";
    "clear_corridor" "chosen";
    "cloud_streets" "cumulus" "boxes";
    "cumulonimbus" "cumulonimbus" "cumulus" "boxes" "cover";
    "cumulus_field" "cumulus" "boxes" "cover";
    "diurnal_cumulus";
    "flat_bases" "chosen";
    "frontal_passage" "deck" "cumulus" "boxes";
    "golden_hour";
    "lens_clouds" "lens" "boxes";
    "scatter_along_path";
    "scatter_clouds";
    "sprite_table";
    "storm_look";
    "stratocumulus_deck" "deck" "boxes" "cover";
    "stratus_sheet" "stratus" "boxes" "cover";
    "thunderstorm_life" "cumulonimbus" "cumulus" "boxes";
    "wind_lean" "chosen";
};

/// What several of them share: functions that make a kind of cloud, by the name of their file.
pub fn part(name: &str) -> Option<&'static str> {
    PARTS.iter().find(|(known, _)| *known == name).map(|(_, source)| *source)
}

/// The one of that name.
pub fn named(name: &str) -> Option<&'static Shipped> {
    SHIPPED.iter().find(|shipped| shipped.name == name)
}
