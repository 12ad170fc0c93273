//! Friction, and hardening beyond the range of its fit: which lines of the verdict hang on them.

use super::{advice::NO_DESIGN, *};

/// Change of every tool's friction that a verdict should bear \[–\]: declared, lubrication varies by so much.
const CHANGE: f64 = 0.02;
/// Share of its hardening that a sheet keeps beyond the range of its law's fit, which a verdict should bear \[–\]: declared.
const WEAKER: f64 = 0.5;

pub(super) fn row(run: &Run) -> Option<Finding> {
    let most = largest_coefficient(run.case.model())?;
    let judged = Finding::judged("friction", "Friction", "{}; less and more were not solved").light(Light::Grey);
    let judged = judged.number(Amount::number(most)).limit("no other light changes");
    let judged = judged.source("declared: lubrication varies by so much");
    Some(judged.advice("without `--no-advice` it is solved with less and more friction"))
}

pub(super) fn assumed(case: &Case) -> Option<Finding> {
    let most = largest_coefficient(case.model())?;
    let text = "friction of {} at most is assumed: the case's [friction] has no `source`";
    case.sources.friction.is_none().then(|| Finding::assumed(text).number(Amount::number(most)))
}

fn largest_coefficient(model: &Model) -> Option<f64> {
    model.tools.iter().map(|tool| tool.friction.largest_coefficient()).reduce(f64::max)
}

/// Row of the verdict that a changed case judges, and the change.
pub type Neighbour = (&'static str, String);

/// Cases with less and more friction on every tool, and one that hardens less beyond a range of fit that matters.
pub fn neighbours(case: &Case, findings: &[Finding]) -> Vec<(Neighbour, Case)> {
    let changed = |change: &dyn Fn(&mut Model)| {
        let mut case = case.clone();
        case.stages.iter_mut().for_each(|stage| change(&mut stage.model));
        case
    };
    let friction = [-CHANGE, CHANGE].map(|by| {
        let other = changed(&|model| model.tools.iter_mut().for_each(|tool| tool.friction = tool.friction.changed(by)));
        (("friction", format!("at {}", Amount::number(largest_coefficient(other.model()).unwrap_or(0.0)))), other)
    });
    let is_beyond = |row: &Finding| row.key == "hardening_range" && row.light == Light::Grey;
    let end = case.model().material.measured_up_to().filter(|_| findings.iter().any(is_beyond));
    let weaker = end.map(|end| {
        let other = changed(&|model| {
            let hardening = &mut model.material.hardening;
            *hardening = hardening.clone().weakened(WEAKER, end);
        });
        (("hardening_range", format!("with half the hardening beyond {}", Amount::number(end))), other)
    });
    friction.into_iter().chain(weaker).filter(|(_, other)| other.stages != case.stages).collect()
}

/// Judges friction and hardening by the solved [`neighbours`].
pub fn judge(solution: &Solution, others: &[(Neighbour, Solution)], findings: &mut [Finding]) {
    let after: Vec<_> = others.iter().map(|(other, run)| (other, changed(solution, findings, run))).collect();
    let is_test = solution.case.model().stop.load_drop.is_some();
    for (key, advice) in [
        ("friction", if is_test { "measure it" } else { "measure it, or leave more margin there" }),
        ("hardening_range", "add points at larger strains, from a bulge test"),
    ] {
        let of_row: Vec<_> = after.iter().filter(|((row, _), _)| *row == key).collect();
        let Some(row) = findings.iter_mut().find(|row| row.key == key && !of_row.is_empty()) else { continue };
        let is_worse = of_row.iter().any(|(_, (worse, _))| *worse);
        let changes = of_row.iter().filter(|(_, (_, text))| !text.is_empty());
        let changes = joined(changes.map(|((_, change), (_, text))| format!("{change} {text}")), ", ");
        let found = row.text.split("; ").next().unwrap_or_default();
        row.text = match (changes.is_empty(), key) {
            (false, _) => format!("{found}; {changes}"),
            (true, "friction") => format!("{found} ± {CHANGE}; changes no line of the verdict"),
            (true, _) => format!("{found}; half the hardening beyond changes no line of the verdict"),
        };
        row.light = if is_worse { Light::Amber } else { Light::Green };
        row.advice = if is_worse { advice.into() } else { String::new() };
    }
}

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
    let own = judgements(findings).filter(|own| !NO_DESIGN.contains(&own.key));
    let pairs = own.filter_map(|own| Some((own, theirs.iter().find(|row| row.key == own.key)?)));
    let pairs = pairs.filter(|(own, row)| row.light.min(own.light) > Light::Grey && row.light != own.light);
    let pairs: Vec<_> = pairs.collect();
    let text = pairs.iter().map(|(own, row)| format!("{} is {}", own.label, row.light.name()));
    (pairs.iter().any(|(own, row)| row.light > own.light), joined(text, " and "))
}
