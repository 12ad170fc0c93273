//! What becomes of a part: sound, or how it fails.

use crate::assess::{Finding, Light, judgements};
use crate::case::Solution;
use crate::solver::solution::Stop;
use crate::study::verify::Outcome;

/// A way in which a design fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Zone {
    /// The sheet tears, or thins beyond what it is allowed to.
    Tears,
    /// The flange would wrinkle.
    Wrinkles,
    /// The press has not the force or the energy.
    Press,
    /// Red for another reason.
    Other,
    /// It is no case, or the numerics or the user ended it: nothing is known.
    Lost,
}

/// Rows of the verdict that say that a sheet tears; that a flange wrinkles; that a press is too small.
const TEARS: [&str; 6] =
    ["thinning", "localisation", "forming_limit", "strain_paths", "bottom_tearing", "bent_strength"];
const WRINKLES: [&str; 2] = ["wrinkling", "wall_wrinkles"];
const PRESS: [&str; 2] = ["press_force", "energy"];
/// The row that says how a run ended.
const STOP: &str = "stop";

impl Zone {
    /// All of them, those first that a designer asks for first.
    pub const ALL: [Self; 5] = [Self::Tears, Self::Wrinkles, Self::Press, Self::Other, Self::Lost];

    /// Name in files.
    pub fn key(self) -> &'static str {
        match self {
            Self::Tears => "tears",
            Self::Wrinkles => "wrinkles",
            Self::Press => "press",
            Self::Other => "other",
            Self::Lost => "no_answer",
        }
    }

    /// The zone of a name in files.
    pub fn of_key(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|zone| zone.key() == key)
    }

    /// As it stands in a picture.
    pub fn label(self) -> String {
        match self {
            Self::Tears => "tears",
            Self::Wrinkles => "wrinkles",
            Self::Press => "press too small",
            Self::Other => "refused otherwise",
            Self::Lost => "no answer",
        }
        .into()
    }

    /// The zone that a row of the verdict is of, other than that on how the run ended.
    pub fn of_row(key: &str) -> Self {
        match key {
            key if TEARS.contains(&key) => Self::Tears,
            key if WRINKLES.contains(&key) => Self::Wrinkles,
            key if PRESS.contains(&key) => Self::Press,
            _ => Self::Other,
        }
    }

    /// Every way in which a solved case fails, in the order of [`Self::ALL`].
    pub(super) fn of(solution: &Solution, outcome: &Outcome, findings: &[Finding]) -> Vec<Self> {
        if outcome.end.lost {
            return vec![Self::Lost];
        }
        let tore = solution.stages.last().is_some_and(|stage| {
            matches!(
                stage.stop,
                Stop::Localised { .. }
                    | Stop::Coalesced { .. }
                    | Stop::LoadMaximum { .. }
                    | Stop::PressureMaximum { .. }
            )
        });
        let red = judgements(findings).filter(|finding| finding.light == Light::Red);
        let mut zones: Vec<Self> = red
            .map(|finding| match finding.key {
                STOP if tore => Self::Tears,
                STOP => Self::Other,
                key => Self::of_row(key),
            })
            .collect();
        zones.sort_unstable();
        zones.dedup();
        zones
    }
}
