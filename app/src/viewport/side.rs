//! The six sides that a scene can be looked at from, square to the axes of its world.

use crate::command::Command;
use glam::DVec3;

/// Where the eye stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Side {
    East,
    West,
    Top,
    Bottom,
    South,
    North,
}

impl Side {
    /// Each beside its opposite.
    pub(super) const ALL: [Self; 6] = [Self::East, Self::West, Self::Top, Self::Bottom, Self::South, Self::North];

    /// The one that a command means, if it means one.
    pub(crate) fn of(command: Command) -> Option<Self> {
        Self::ALL.into_iter().find(|side| side.command() == command)
    }

    /// The command that looks from there.
    pub(super) fn command(self) -> Command {
        match self {
            Self::East => Command::RightView,
            Self::West => Command::LeftView,
            Self::Top => Command::TopView,
            Self::Bottom => Command::BottomView,
            Self::South => Command::FrontView,
            Self::North => Command::BackView,
        }
    }

    pub(super) fn opposite(self) -> Self {
        match self {
            Self::East => Self::West,
            Self::West => Self::East,
            Self::Top => Self::Bottom,
            Self::Bottom => Self::Top,
            Self::South => Self::North,
            Self::North => Self::South,
        }
    }

    /// From the scene towards the eye, unit.
    pub(super) fn direction(self) -> DVec3 {
        match self {
            Self::East => DVec3::X,
            Self::West => DVec3::NEG_X,
            Self::Top => DVec3::Y,
            Self::Bottom => DVec3::NEG_Y,
            Self::South => DVec3::Z,
            Self::North => DVec3::NEG_Z,
        }
    }

    /// Heading and pitch of the look from there, degrees. From above, north is at the picture's top; from below, south.
    pub(super) fn look_deg(self) -> [f64; 2] {
        match self {
            Self::East => [-90.0, 0.0],
            Self::West => [90.0, 0.0],
            Self::Top => [0.0, -90.0],
            Self::Bottom => [0.0, 90.0],
            Self::South => [0.0, 0.0],
            Self::North => [180.0, 0.0],
        }
    }

    /// As the command that looks from there calls it.
    pub(super) fn name(self) -> &'static str {
        let label = self.command().row().label();
        label.strip_suffix(" view").unwrap_or(label)
    }

    /// On the compass.
    pub(super) fn letter(self) -> &'static str {
        match self {
            Self::East => "E",
            Self::West => "W",
            Self::Top => "T",
            Self::Bottom => "B",
            Self::South => "S",
            Self::North => "N",
        }
    }

    /// In words: “from the east”.
    pub(super) fn words(self) -> &'static str {
        match self {
            Self::East => "from the east",
            Self::West => "from the west",
            Self::Top => "from the top",
            Self::Bottom => "from the bottom",
            Self::South => "from the south",
            Self::North => "from the north",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::camera::View;
    use cloudwright_core::scene::Camera;

    #[test]
    fn each_looks_back_at_the_scene() {
        for side in Side::ALL {
            let [heading_deg, pitch_deg] = side.look_deg();
            let view = View::new(&Camera { heading_deg, pitch_deg, ..Camera::free(DVec3::ZERO) }, 1, 1);
            assert!((view.forward.as_dvec3() + side.direction()).length() < 1e-6, "{side:?}");
            assert_eq!(side.opposite().direction(), -side.direction());
            assert_eq!(Side::of(side.command()), Some(side));
        }
        assert_eq!(Side::of(Command::FrameAll), None);
    }
}
