//! Failure modes of a part, decided once from the verdict.

use super::{Finding, Light, judgements};
use crate::solver::solution::{StageSolution, Stop};

/// Failure mode of a part or a design; the order is that of importance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum FailureMode {
    /// The sheet tears or necks.
    Tears,
    /// The flange wrinkles.
    Wrinkles,
    /// The press lacks force or energy.
    Press,
    /// Any other red finding.
    Other,
    /// No result: invalid case, no equilibrium, or interrupted.
    NoResult,
}

impl FailureMode {
    /// All modes, in their order.
    pub const ALL: [Self; 5] = [Self::Tears, Self::Wrinkles, Self::Press, Self::Other, Self::NoResult];

    /// Name in files.
    pub fn key(self) -> &'static str {
        match self {
            Self::Tears => "tears",
            Self::Wrinkles => "wrinkles",
            Self::Press => "press",
            Self::Other => "other",
            Self::NoResult => "no_answer",
        }
    }

    /// Mode of a name in files.
    pub fn from_key(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|mode| mode.key() == key)
    }

    /// Name in text.
    pub fn label(self) -> &'static str {
        match self {
            Self::Tears => "tears",
            Self::Wrinkles => "wrinkles",
            Self::Press => "press too small",
            Self::Other => "refused otherwise",
            Self::NoResult => "no result",
        }
    }

    /// All modes of a solved case, the most important first; empty if the part is sound.
    pub fn all(stages: &[StageSolution], findings: &[Finding]) -> Vec<Self> {
        use Stop::{Coalesced, LoadMaximum, Localised, PressureMaximum};
        let Some(stop) = stages.last().map(|stage| &stage.stop) else { return vec![Self::NoResult] };
        if !stop.is_complete() && !stop.is_physical() {
            return vec![Self::NoResult];
        }
        let is_tear = matches!(stop, Localised { .. } | Coalesced { .. } | LoadMaximum { .. } | PressureMaximum { .. });
        let red = judgements(findings).filter(|finding| finding.light == Light::Red).map(|finding| finding.key);
        let mode = |key| match key {
            "stop" if is_tear => Self::Tears,
            "thinning" | "localisation" | "forming_limit" | "bottom_tearing" => Self::Tears,
            "wrinkling" | "wall_wrinkles" => Self::Wrinkles,
            "press_force" | "energy" => Self::Press,
            _ => Self::Other,
        };
        let mut modes: Vec<Self> = red.map(mode).collect();
        modes.sort_unstable();
        modes.dedup();
        modes
    }
}
