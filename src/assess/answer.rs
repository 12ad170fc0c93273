//! Verdict in one sentence, its failure modes, and the numbers of the part.

use super::finding::labels;
use super::key_number::numbers;
use super::tear::{self, Tear, place, tear};
use super::{Finding, Light, forming_limit, judgements};
use crate::case::Case;
use crate::solver::solution::{StageSolution, StopKind};
use crate::units::{Amount, Quantity, joined};
use serde::Serialize;

/// Verdict in one sentence, and the numbers that a part is known by.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Answer {
    /// Worst light of the verdict.
    pub light: Light,
    /// Failure, or the most important warning.
    pub sentence: String,
    /// Failure modes, the most important first; empty for a sound part.
    #[serde(skip)]
    pub failures: Vec<FailureMode>,
    /// Reason of a planned end before the full travel; else empty.
    #[serde(skip)]
    pub end: String,
    /// Numbers of the part and the press.
    pub numbers: Vec<Quantity>,
}

impl Answer {
    /// Answer from solved stages and the [findings](super::after) on them.
    pub fn of(case: &Case, stages: &[StageSolution], findings: &[Finding]) -> Self {
        let light = judgements(findings).map(|finding| finding.light).max().unwrap_or(Light::Grey);
        let end = stages.last().map(|stage| &stage.stop);
        let end = end.filter(|stop| stop.is_complete() && stop.kind != StopKind::FullTravel);
        let failures = FailureMode::all(stages, findings);
        let tear = tear(stages);
        Self {
            light,
            sentence: sentence(stages, findings, &failures, tear.as_ref()),
            end: end.map_or_else(String::new, ToString::to_string),
            numbers: numbers(case, stages, tear.is_some()),
            failures,
        }
    }
}

fn sentence(stages: &[StageSolution], findings: &[Finding], failures: &[FailureMode], tear: Option<&Tear>) -> String {
    if let Some(tear) = tear {
        return tear.sentence(stages.len());
    }
    let row = |key: &str| judgements(findings).find(|finding| finding.key == key);
    let is = |key: &str, light: Light| row(key).is_some_and(|finding| finding.light == light);
    let share = |key: &str| row(key)?.value().map(|percent| 0.01 * percent);
    match stages.last().map(|stage| &stage.stop) {
        Some(stop) if stop.kind == StopKind::Interrupted => return "interrupted by the user".into(),
        Some(stop) if !stop.is_complete() && is("stop", Light::Red) => {
            return format!("not solved to its end: {}", stop.kind.name());
        }
        _ => {}
    }
    let thinnest = stages.last().and_then(|stage| stage.steps.last());
    let at = thinnest.map_or_else(String::new, |step| place(stages, step.thinnest_s0));
    let [red, amber] = [Light::Red, Light::Amber].map(|light| labels(findings, light).join(", "));
    let bottom = share("bottom_tearing").filter(|used| *used > 1.0).map(Amount::share);
    let limit_used = share("forming_limit");
    let limit_is_amber = is("forming_limit", Light::Amber);
    let thinning = share("thinning").unwrap_or_default();
    let thins = format!("it thins by {} {at}", Amount::share(thinning));
    match (failures.first(), bottom) {
        (Some(FailureMode::Tears), _) if is("bottom_tearing", Light::Red) => {
            "it tears at the bottom: the punch pulls harder than the wall can bear".into()
        }
        (Some(FailureMode::Tears), _) => joined(["it thins too far".into(), at], " "),
        (Some(FailureMode::Wrinkles), _) => "it wrinkles: the holder presses too little for this flange".into(),
        (Some(_), Some(_)) => format!("it may tear at the bottom, and is refused: {red}"),
        (Some(_), None) => format!("it does not tear, but is refused: {red}"),
        (None, Some(used)) => {
            format!("it may tear at the bottom: the punch needs {used} of what the wall surely carries")
        }
        (None, None) if limit_is_amber && limit_used.is_none() => {
            format!("whether it tears is not known: {thins}, and the forming limit ends before")
        }
        // Decided by the number: a row that only its error bar makes amber is one of the others.
        (None, None) if limit_is_amber && limit_used > Some(forming_limit::CAREFUL) => {
            joined(["it comes near to tearing".into(), at], " ")
        }
        (None, None) if is("thinning", Light::Amber) && thinning > tear::CAREFUL => {
            let limit = limit_used.map(|used| format!("the forming limit is used to {}", Amount::share(used)));
            let limit = limit.unwrap_or_else(|| "no forming limit is given".into());
            format!("{thins}, more than the {} rule of thumb; {limit}", Amount::given_share(tear::CAREFUL))
        }
        _ if !amber.is_empty() => format!("it does not tear; look at {amber}"),
        _ => "it does not tear, and nothing speaks against it".into(),
    }
}

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
        ["tears", "wrinkles", "press", "other", "no_answer"][self as usize]
    }

    /// Mode of a name in files.
    pub fn from_key(key: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|mode| mode.key() == key)
    }

    /// Name in text.
    pub fn label(self) -> &'static str {
        ["tears", "wrinkles", "press too small", "refused otherwise", "no result"][self as usize]
    }

    /// All modes of a solved case, the most important first; empty if the part is sound.
    pub fn all(stages: &[StageSolution], findings: &[Finding]) -> Vec<Self> {
        use StopKind::{Coalesced, LoadMaximum, Localised, PressureMaximum};
        let Some(stop) = stages.last().map(|stage| &stage.stop) else { return vec![Self::NoResult] };
        if !stop.is_complete() && !stop.is_physical() {
            return vec![Self::NoResult];
        }
        let is_tear = matches!(stop.kind, Localised | Coalesced | LoadMaximum | PressureMaximum);
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
