//! How long a run's process may take: to start, for its script, and once for the scene's sprites, which is none of the
//! script's time.

use cloudwright_scripts::{ScriptError, TimeOf};
use std::time::{Duration, Instant};

/// Until it has read the scene: longer than any takes on a busy machine.
const START: Duration = Duration::from_secs(20);
/// Placing the sprites of a scene: longer than any takes.
const PLACING: Duration = Duration::from_secs(300);
/// A script looks at its time itself, and then tells where it was; so long it has to say so.
const GRACE: Duration = Duration::from_millis(200);

#[derive(Debug)]
pub(super) struct Clock {
    /// What the script has; none: as long as it likes.
    script: Option<Duration>,
    /// When what goes on now has to have ended.
    until: Option<Instant>,
    stage: Stage,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Stage {
    Starting,
    Script,
    /// What the script has left when sprites have been placed.
    Placing(Option<Duration>),
    ScriptAgain,
}

impl Clock {
    pub(super) fn start(script: Option<Duration>) -> Self {
        Self { script, until: Some(Instant::now() + START), stage: Stage::Starting }
    }

    /// The process says whose time it is. Saying it again and again gains it nothing.
    pub(super) fn is(&mut self, whose: TimeOf) {
        let now = Instant::now();
        let (stage, left) = match (self.stage, whose) {
            (Stage::Starting, TimeOf::Script) => (Stage::Script, self.script.map(|script| script + GRACE)),
            (Stage::Script, TimeOf::Scene) => {
                let left = self.until.map(|until| until.saturating_duration_since(now));
                (Stage::Placing(left), Some(PLACING))
            }
            (Stage::Placing(left), TimeOf::Script) => (Stage::ScriptAgain, left),
            _ => return,
        };
        (self.stage, self.until) = (stage, left.map(|left| now + left));
    }

    /// Why it is over, if it is.
    pub(super) fn over(&self) -> Option<ScriptError> {
        let is_over = self.until.is_some_and(|until| Instant::now() >= until);
        is_over.then(|| match self.stage {
            Stage::Starting => ScriptError::broken("the script's host does not begin"),
            Stage::Placing(_) => ScriptError::limit("placing the scene's sprites takes too long", "hide some clouds"),
            Stage::Script | Stage::ScriptAgain => ScriptError::too_late(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SECOND: Duration = Duration::from_secs(1);

    /// What is left after `said`, of a script that has a second.
    fn left(said: &[TimeOf]) -> Duration {
        let mut clock = Clock::start(Some(SECOND));
        said.iter().for_each(|whose| clock.is(*whose));
        clock.until.expect("a limit").saturating_duration_since(Instant::now())
    }

    #[test]
    fn placing_sprites_costs_a_script_nothing_and_counts_once() {
        use TimeOf::{Scene, Script};
        let most = SECOND + GRACE;
        assert!(left(&[]) > most);
        assert!(left(&[Scene]) > most, "it has not begun");
        for said in [&[Script][..], &[Script; 9], &[Script, Scene, Script], &[Script, Scene, Script, Scene, Scene]] {
            assert!((SECOND..=most).contains(&left(said)), "{said:?}");
        }
        assert!(left(&[Script, Scene]) > most);
        let mut clock = Clock::start(None);
        clock.is(Script);
        assert!(clock.until.is_none() && clock.over().is_none());
        let mut clock = Clock::start(Some(Duration::ZERO));
        clock.is(Script);
        std::thread::sleep(GRACE);
        assert_eq!(clock.over(), Some(ScriptError::too_late()));
    }
}
