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

/// All that there are, by name.
pub const SHIPPED: &[Shipped] = shipped! {
    "altocumulus_sheet" "boxes" "cover";
    "clear_corridor" "chosen";
    "cloud_streets" "cumulus" "boxes";
    "cumulonimbus" "cumulonimbus" "cumulus" "boxes" "cover";
    "cumulus_field" "cumulus" "boxes" "cover";
    "diurnal_cumulus";
    "flat_bases" "chosen";
    "frontal_passage" "deck" "cumulus" "boxes";
    "golden_hour";
    "scatter_along_path";
    "scatter_clouds";
    "sprite_table";
    "storm_look";
    "stratocumulus_deck" "deck" "boxes" "cover";
    "thunderstorm_life" "cumulonimbus" "cumulus" "boxes";
    "wind_lean" "chosen";
};

/// The one of that name.
pub fn named(name: &str) -> Option<&'static Shipped> {
    SHIPPED.iter().find(|shipped| shipped.name == name)
}
