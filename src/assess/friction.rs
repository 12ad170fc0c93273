//! Friction: which lines of the verdict hang on it.

use super::{FailureMode, Finding, Light, Run, advice::NO_DESIGN, after, judgements};
use crate::case::{Case, Solution};
use crate::model::Model;
use crate::units::{Amount, joined};

/// Change of every tool's friction that a verdict should bear \[–\]: declared, lubrication varies by so much.
const CHANGE: f64 = 0.02;

/// Friction, judged once runs with less and more of it are solved.
pub(super) fn row(run: &Run) -> Option<Finding> {
    let most = largest_coefficient(run.case.model())?;
    Finding::judged("friction", "Friction", "{} at most; less and more were not solved")
        .number(Amount::number(most))
        .light(Light::Grey)
        .limit("changes no other line")
        .source("declared: lubrication varies by so much")
        .advice("without `--no-advice` it is solved with less and more")
        .into()
}

/// Friction without a source.
pub(super) fn assumed(case: &Case) -> Option<Finding> {
    let most = largest_coefficient(case.model())?;
    let text = "friction of {} at most is assumed: [friction] names no `source`";
    case.sources.friction.is_none().then(|| Finding::assumed(text).number(Amount::number(most)))
}

fn largest_coefficient(model: &Model) -> Option<f64> {
    model.tools.iter().map(|tool| tool.friction.largest_coefficient()).reduce(f64::max)
}

/// Cases with less and more friction on every tool, at least 0 and at most 1; none without friction.
pub fn neighbours(case: &Case) -> Vec<Case> {
    let changed = [-CHANGE, CHANGE].map(|by| {
        let mut case = case.clone();
        let tools = case.stages.iter_mut().flat_map(|stage| &mut stage.model.tools);
        tools.for_each(|tool| tool.friction = tool.friction.changed(by));
        case
    });
    changed.into_iter().filter(|other| other.stages != case.stages).collect()
}

/// Judges friction by the solved [`neighbours`].
pub fn judge(solution: &Solution, others: &[Solution], findings: &mut [Finding]) {
    let Some(place) = findings.iter().position(|row| row.key == "friction") else { return };
    let (mut light, mut changes) = (Light::Green, Vec::new());
    for other in others {
        let (worse, text) = changed(solution, findings, other);
        light = light.max(if worse { Light::Amber } else { Light::Green });
        let at = Amount::number(largest_coefficient(other.case.model()).unwrap_or(0.0));
        changes.extend((!text.is_empty()).then(|| format!("at {at} {text}")));
    }
    let row = &mut findings[place];
    row.text = match changes.is_empty() {
        true => format!("{{}} ± {CHANGE}; changes no line of the verdict"),
        false => format!("{{}}; {}", joined(changes, ", ")),
    };
    row.light = light;
    row.advice = if light > Light::Green { "measure it, or leave more margin there".into() } else { String::new() };
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
    let pairs = pairs.filter(|(own, _)| !NO_DESIGN.contains(&own.key));
    let pairs = pairs.filter(|(own, row)| row.light.min(own.light) > Light::Grey && row.light != own.light);
    let pairs: Vec<_> = pairs.collect();
    let text = pairs.iter().map(|(own, row)| format!("{} is {}", own.label, row.light.name()));
    (pairs.iter().any(|(own, row)| row.light > own.light), joined(text, " and "))
}
