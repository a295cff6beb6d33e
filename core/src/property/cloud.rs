//! Placed clouds.

use super::described::Described;
use super::row::{Row, angle, choice, flag, number, numbers, range_of, seed, setting, text, thing, vector};
use super::setting::{Choice, Kind, Numbers, Setting, Value};
use super::{CLOUD_SCALE, HEADING_DEG, Number, POSITION};
use crate::scene::{Cloud, Formation, FormationChange};

const FORMING: &str = "forming";
const DISSIPATING: &str = "dissipating";
const CHANGES: &[Choice] =
    &[Choice { name: FORMING, label: "forms" }, Choice { name: DISSIPATING, label: "dissipates" }];

/// Of a whole day's length at most, seconds.
const fn seconds(label: &'static str, doc: &'static str) -> Number {
    Number::new(label, &(0.0..=86_400.0), "s", doc)
}
const START_S: Number =
    seconds("Begins at", "When the cloud begins to change, counted from the start of play or flight.");
const CORE_S: Number = seconds("Core takes", "How long the cloud's core takes to form or to dissipate.");
const EDGES_S: Number = seconds("Edges take", "How long the cloud's edges take to form or to dissipate.");
const THRESHOLD: Number =
    Number::new("Edges from", &(0.01..=1.0), "", "Opacity of the core at which the edges begin to form, or have gone.");

const OPACITY: Number = Number::new("Opacity", &(0.0..=1.0), "", "A factor of all its sprites' opacity.");
const GROWTH: Number = Number::new(
    "Growth",
    &(0.01..=10.0),
    "",
    "Heights above its base are multiplied with this: above 1 the heads tower. Sprites keep their size.",
);
const WIND_SHARE: Number =
    Number::new("Goes with wind", &(0.0..=1.0), "", "How much of the wind's way it is carried along: 0 stays.");
const BASE_SHARE: Number = Number::new(
    "Follows base",
    &(0.0..=1.0),
    "",
    "How much it rises and grows with the base that temperature and dew point give: 0 stays.",
);
const FORMED_CORE: Number =
    Number::new("Core formed", &(0.0..=1.0), "", "Opacity of the core, as far as the cloud has formed.");
const FORMED_EDGES: Number =
    Number::new("Edges formed", &(0.0..=1.0), "", "How far the edges have formed: they show once the core does.");

/// How far the cloud has formed: a track sets it, whether or not it is set by hand.
macro_rules! formed {
    ($field:ident: $number:expr) => {
        Row::numbers(
            concat!("formed.", stringify!($field)),
            number($number).keyed(),
            |cloud, _| Some(cloud.formed?.$field),
            |cloud, _, share| cloud.formed.get_or_insert_default().$field = share,
        )
    };
}

/// What is placed, and where.
pub const PLACE: &[Row<Cloud>] = &[
    setting!(name: text("Name", "For people.")),
    setting!(model: thing("Model", "What is placed.", Kind::Model)),
    setting!(folder: thing("Folder", "What it is kept in, to be hidden and locked with others.", Kind::Folder).or("none")),
    numbers!(position: vector(POSITION).keyed()),
    numbers!(heading_deg: angle(HEADING_DEG).keyed()),
    numbers!(scale: number(CLOUD_SCALE).keyed()),
];

/// What of it the model and the air don't say.
pub const LOOK: &[Row<Cloud>] = &[
    numbers!(opacity: number(OPACITY).keyed()),
    numbers!(growth: number(GROWTH).keyed()),
    numbers!(wind_share: number(WIND_SHARE).keyed()),
    numbers!(base_share: number(BASE_SHARE).keyed()),
    setting!(seed: seed("Seed", "Another number strews this cloud's sprites anew.").or("the model's")),
];

/// How it forms or dissipates.
pub const FORMATION: &[Row<Cloud>] = &[
    Row::of(
        "formation.change",
        choice(
            "Formation",
            "By the clock in the Flight panel: a cloud forms from its core, and dissolves from its edges.",
            CHANGES,
        )
        .or("always whole"),
        |cloud| Some(cloud.formation.map_or(Value::None, |formation| Value::Text(name(formation.change).into()))),
        |cloud, value| {
            let change = Option::<String>::from_value(value)?.map(|name| change_named(&name));
            cloud.formation = match change {
                Some(change) => Some(Formation { change: change?, ..cloud.formation.unwrap_or_default() }),
                None => None,
            };
            Some(())
        },
    ),
    numbers!(formation?.start_s: number(START_S)),
    numbers!(formation?.core_s: number(CORE_S)),
    numbers!(formation?.edges_s: number(EDGES_S)),
    numbers!(formation?.threshold: number(THRESHOLD)),
    Row::of(
        "formed",
        flag("Formed by hand", "How far it has formed is set, or keyed, whatever the formation says."),
        |cloud| Some(Value::Flag(cloud.formed.is_some())),
        |cloud, value| {
            cloud.formed = bool::from_value(value)?.then(|| cloud.formed.unwrap_or_default());
            Some(())
        },
    ),
    formed!(core: FORMED_CORE),
    formed!(edges: FORMED_EDGES),
];

impl Described for Cloud {
    const TABLES: &'static [&'static [Row<Self>]] = &[PLACE, LOOK, FORMATION];
}

const fn name(change: FormationChange) -> &'static str {
    match change {
        FormationChange::Forming => FORMING,
        FormationChange::Dissipating => DISSIPATING,
    }
}

fn change_named(name: &str) -> Option<FormationChange> {
    match name {
        FORMING => Some(FormationChange::Forming),
        DISSIPATING => Some(FormationChange::Dissipating),
        _ => None,
    }
}
