//! What a track moves: a whole property, all of its parts.
//!
//! Its address is the property's without a part: `cloud/7/position`.

use super::address::{NoSuchProperty, Table, tables};
use super::owner::Owner;
use super::row::Property;
use super::setting::Kind;
use std::fmt;
use std::str::FromStr;

/// A property of an owner, all of its parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Target {
    /// Whose it is.
    pub owner: Owner,
    /// What it is: one that can be keyed.
    pub property: &'static Property,
}

impl Target {
    /// How many numbers its keys have: 1 or 3.
    pub fn parts(&self) -> usize {
        self.property.parts.names().len()
    }

    /// Whether from one key to the next it turns the short way.
    pub fn turns(&self) -> bool {
        matches!(self.property.kind, Kind::Angle(_))
    }

    /// Brings `number` into the property's range: by whole rounds if it is cyclic, else to the nearer end.
    pub fn bring_within(&self, number: f64) -> f64 {
        let Some(range) = self.property.kind.number() else { return number };
        let within = match self.property.cycle {
            Some(cycle) if !range.allows(number) => {
                let round = number.rem_euclid(cycle);
                // Of two that are the same, the one nearer to zero.
                if range.min < 0.0 && round > 0.5 * cycle { round - cycle } else { round }
            }
            _ => number,
        };
        within.clamp(range.min, range.max)
    }
}

impl fmt::Display for Target {
    /// Its address.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let slash = if self.owner == Owner::Scene { "" } else { "/" };
        write!(f, "{}{slash}{}", self.owner, self.property.address_part())
    }
}

impl FromStr for Target {
    type Err = NoSuchProperty;

    fn from_str(text: &str) -> Result<Self, NoSuchProperty> {
        let mut near = Vec::new();
        // The scene itself has no name of its own, and would be the beginning of anything.
        let may_be = |table: &&Table| !table.pattern.is_empty() || !text.contains('/');
        for table in tables().filter(may_be) {
            let Some((owner, rest)) = table.read(text) else { continue };
            for property in (table.properties)().into_iter().filter(|property| property.keyed) {
                let name = property.address_part();
                if name == rest {
                    return Ok(Self { owner, property });
                }
                near.push((strsim::jaro_winkler(&name, rest), Self { owner, property }));
            }
        }
        let best = near.iter().max_by(|(a, _), (b, _)| a.total_cmp(b));
        let hint = match best {
            Some((score, target)) if *score > 0.75 => format!("did you mean {target}?"),
            Some(_) => {
                let names: Vec<String> = near.iter().map(|(_, target)| target.property.address_part()).collect();
                format!("what can be keyed there is {}", names.join(", "))
            }
            None => "write it as sky/exposure_ev, cloud/7/opacity, model/3/color_levels/2/color".into(),
        };
        Err(NoSuchProperty { address: text.into(), hint })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_property_that_can_be_keyed_is_found_by_its_address() {
        let mut count = 0;
        for table in tables() {
            let owner = table.pattern.replace('N', "7");
            for property in (table.properties)().into_iter().filter(|property| property.keyed) {
                let slash = if owner.is_empty() { "" } else { "/" };
                let text = format!("{owner}{slash}{}", property.address_part());
                // A model has five levels, so that its seventh is named and not there.
                let target = text.parse::<Target>();
                assert_eq!(target.as_ref().map(Target::to_string), Ok(text.clone()));
                assert!(target.is_ok_and(|target| [1, 3].contains(&target.parts())), "{text}");
                count += 1;
            }
        }
        assert!(count >= 40, "{count}");
    }

    #[test]
    fn others_are_told_what_there_is() {
        for (text, hint) in [
            ("cloud/7/opacty", "did you mean cloud/7/opacity?"),
            ("cloud/7/seed", "what can be keyed there is"),
            ("cloud/7/position/x", "cloud/7/position"),
            ("moon/phase", "write it as"),
            ("", "time_of_day_h"),
        ] {
            let error = text.parse::<Target>().expect_err(text);
            assert!(error.hint.contains(hint), "{text}: {error}");
        }
    }

    #[test]
    fn numbers_come_round_or_stay_at_an_end() {
        let bring = |text: &str, number| text.parse::<Target>().expect("a property").bring_within(number);
        for (text, number, want) in [
            ("cloud/7/heading_deg", 725.0, 5.0),
            ("cloud/7/heading_deg", -400.0, -40.0),
            ("cloud/7/heading_deg", 359.0, 359.0),
            ("time_of_day_h", 30.0, 6.0),
            ("time_of_day_h", 24.0, 0.0),
            ("time_of_day_h", -1.0, 23.0),
            ("cloud/7/opacity", 1.5, 1.0),
            ("cloud/7/opacity", -1.5, 0.0),
        ] {
            assert_eq!(bring(text, number), want, "{text} {number}");
        }
    }
}
