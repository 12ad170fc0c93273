//! Failure modes of a part, from its verdict.

use crate::assess::{Finding, Light, judgements};
use crate::case::Solution;
use crate::solver::solution::Stop;

/// How a part fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FailureMode {
    /// The sheet tears, or thins beyond its limit.
    Tears,
    /// The sheet wrinkles.
    Wrinkles,
    /// The press lacks force or energy.
    Press,
    /// Red for another reason.
    Other,
    /// No case, or ended by the numerics or the user.
    NoAnswer,
}

const TEARS: [&str; 6] =
    ["thinning", "localisation", "forming_limit", "strain_paths", "bottom_tearing", "bent_strength"];
const WRINKLES: [&str; 2] = ["wrinkling", "wall_wrinkles"];
const PRESS: [&str; 2] = ["press_force", "energy"];

impl FailureMode {
    /// All, the most important first.
    pub const ALL: [Self; 5] = [Self::Tears, Self::Wrinkles, Self::Press, Self::Other, Self::NoAnswer];

    /// Name in files.
    pub fn key(self) -> &'static str {
        match self {
            Self::Tears => "tears",
            Self::Wrinkles => "wrinkles",
            Self::Press => "press",
            Self::Other => "other",
            Self::NoAnswer => "no_answer",
        }
    }

    /// The mode of a name in files.
    pub fn from_key(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|mode| mode.key() == key)
    }

    /// Name in tables and legends.
    pub fn label(self) -> &'static str {
        match self {
            Self::Tears => "tears",
            Self::Wrinkles => "wrinkles",
            Self::Press => "press too small",
            Self::Other => "red otherwise",
            Self::NoAnswer => "no result",
        }
    }
}

/// Failure modes of a solved case; empty for a sound part.
pub fn failure_modes(solution: &Solution, findings: &[Finding]) -> Vec<FailureMode> {
    let Some(stage) = solution.stages.last() else { return vec![FailureMode::NoAnswer] };
    if !stage.stop.is_complete() && !stage.stop.is_physical() {
        return vec![FailureMode::NoAnswer];
    }
    let tore = matches!(
        stage.stop,
        Stop::Localised { .. } | Stop::Coalesced { .. } | Stop::LoadMaximum { .. } | Stop::PressureMaximum { .. }
    );
    let red = judgements(findings).filter(|finding| finding.light == Light::Red);
    let mut modes: Vec<FailureMode> = red
        .map(|finding| match finding.key {
            "stop" if tore => FailureMode::Tears,
            key if TEARS.contains(&key) => FailureMode::Tears,
            key if WRINKLES.contains(&key) => FailureMode::Wrinkles,
            key if PRESS.contains(&key) => FailureMode::Press,
            _ => FailureMode::Other,
        })
        .collect();
    modes.sort_unstable();
    modes.dedup();
    modes
}
