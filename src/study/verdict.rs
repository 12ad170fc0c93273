//! Verdict for the user of one case: findings, what hangs on friction, and advice that was tried.

use super::Watch;
use super::advice::advise;
use crate::assess::error_bars::{ErrorBars, weighed};
use crate::assess::{Answer, FailureMode, Finding, Light, after, judgements};
use crate::case::{Case, Solution};
use crate::model::Model;
use crate::units::{Amount, joined};
use rayon::prelude::*;

/// Change of every tool's friction that a verdict should bear \[–\]: declared, lubrication varies by so much.
const CHANGE: f64 = 0.02;

/// Judges a solution: friction is solved at ± 0.02, advice on red and amber rows if it is wanted.
pub fn judge(
    solution: &Solution,
    bars: Option<&ErrorBars>,
    has_advice: bool,
    watch: &dyn Watch,
) -> (Answer, Vec<Finding>) {
    let mut findings = after(&solution.case, &solution.stages);
    judge_friction(solution, &mut findings, watch);
    if has_advice {
        advise(solution, &mut findings, watch);
    }
    weighed(solution, findings, bars)
}

/// Whether a run says something of the part: it was not ended by the numerics or by the user.
pub(super) fn is_known(solution: &Solution) -> bool {
    !FailureMode::all(&solution.stages, &[]).contains(&FailureMode::NoResult)
}

fn judge_friction(solution: &Solution, findings: &mut [Finding], watch: &dyn Watch) {
    let Some(row) = findings.iter().position(|row| row.key == "friction").filter(|_| is_known(solution)) else { return };
    let others = [-CHANGE, CHANGE].into_par_iter().filter_map(|by| {
        let case = with_friction(&solution.case, by);
        (case.stages != solution.case.stages).then(|| case.solve(&mut &*watch))
    });
    let others: Vec<Solution> = others.collect();
    if watch.wants_to_stop() || !others.iter().all(is_known) {
        return;
    }
    let (mut light, mut changes) = (Light::Green, Vec::new());
    for other in &others {
        let (worse, text) = changed(solution, findings, other);
        light = light.max(if worse { Light::Amber } else { Light::Green });
        let at = Amount::number(largest_coefficient(other.case.model()));
        changes.extend((!text.is_empty()).then(|| format!("at {at} {text}")));
    }
    let row = &mut findings[row];
    row.text = match changes.is_empty() {
        true => format!("{{}} ± {CHANGE} changes no line of the verdict"),
        false => format!("{{}}; {}", joined(changes, ", ")),
    };
    row.light = light;
    row.advice = if light > Light::Green { "measure it, or leave more margin there".into() } else { String::new() };
}

/// Case with the friction of every tool changed, at least 0 and at most 1.
fn with_friction(case: &Case, by: f64) -> Case {
    let mut case = case.clone();
    let tools = case.stages.iter_mut().flat_map(|stage| &mut stage.model.tools);
    tools.for_each(|tool| tool.friction = tool.friction.changed(by));
    case
}

fn largest_coefficient(model: &Model) -> f64 {
    model.tools.iter().map(|tool| tool.friction.largest_coefficient()).fold(0.0, f64::max)
}

/// Whether another run's verdict is worse somewhere, or no longer torn, and its lines that differ.
fn changed(solution: &Solution, findings: &[Finding], other: &Solution) -> (bool, String) {
    let theirs = after(&other.case, &other.stages);
    let tears = |solution: &Solution, findings: &[Finding]| {
        FailureMode::all(&solution.stages, findings).contains(&FailureMode::Tears)
    };
    match (tears(solution, findings), tears(other, &theirs)) {
        (false, true) => return (true, "it tears".into()),
        (true, false) => return (true, "it does not tear".into()),
        _ => {}
    }
    let pairs = judgements(findings).filter_map(|own| Some((own, theirs.iter().find(|row| row.key == own.key)?)));
    let pairs = pairs.filter(|(own, row)| row.light.min(own.light) > Light::Grey && row.light != own.light);
    let pairs: Vec<_> = pairs.collect();
    let text = pairs.iter().map(|(own, row)| format!("{} is {}", own.label, row.light.name()));
    (pairs.iter().any(|(own, row)| row.light > own.light), joined(text, " and "))
}
