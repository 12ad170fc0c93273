//! Failure modes, by the red rows of a verdict and the end of the run.

use super::*;

/// Rows that judge a tear.
pub(super) const TEARS: [&str; 6] = ["thinning", "localisation", "forming_limit", "fracture", "edge", "tearing"];

named! {
    /// Failure mode of a part or a design; the order is that of importance.
    #[derive(PartialOrd, Ord)]
    pub enum FailureMode;
    /// Name in files.
    fn key;
    Tears: "tears", "The sheet tears or necks.";
    Wrinkles: "wrinkles", "The flange wrinkles.";
    Press: "press", "The press lacks force or energy.";
    Other: "other", "Any other red finding.";
    NoResult: "no_answer", "No result: invalid case, no equilibrium, or interrupted.";
}

impl FailureMode {
    /// Name in text.
    pub fn label(self) -> &'static str {
        ["tears", "wrinkles", "press too small", "refused otherwise", "no result"][self as usize]
    }

    /// All modes of a solved case, the most important first; empty if the part is sound.
    pub fn all(stages: &[StageSolution], findings: &[Finding]) -> Vec<Self> {
        use StopKind::{Coalesced, EdgeLimit, LoadMaximum, Localised, NoEquilibrium, PressureMaximum};
        let Some(stop) = stages.last().map(|stage| &stage.stop) else { return vec![Self::NoResult] };
        let stops_torn = matches!(stop.kind, Localised | Coalesced | EdgeLimit | LoadMaximum | PressureMaximum);
        let red = judgements(findings).filter(|finding| finding.light == Light::Red).map(|finding| finding.key);
        let mode = |key| match key {
            "stop" if stops_torn => Self::Tears,
            _ if TEARS.contains(&key) => Self::Tears,
            "wrinkling" | "wall_wrinkles" | "fold" => Self::Wrinkles,
            "press_force" | "energy" => Self::Press,
            _ => Self::Other,
        };
        let mut modes: Vec<Self> = red.map(mode).collect();
        modes.sort_unstable();
        modes.dedup();
        let is_lost = !stop.is_complete() && !stop.is_physical();
        // A sheet that has torn often comes to no equilibrium after it.
        let tore_before = stop.kind == NoEquilibrium && modes.first() == Some(&Self::Tears);
        if is_lost && !tore_before { vec![Self::NoResult] } else { modes }
    }
}
