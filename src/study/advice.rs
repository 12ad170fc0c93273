//! Advice: changes of one size, each solved before it is given.

use super::{variable::split_number, verdict::is_known, *};
use crate::assess::advice::{self, Tried, is_open};
use crate::assess::{Finding, error_bars::ErrorBars, error_bars::answered, judgements};
use crate::model::{Edge, Role, tool_sizes::throat};
use crate::solver::solution::StageSolution;
use rayon::prelude::*;

/// Most runs, and the work of all of them \[iterations × elements × points\]: some 5 s of two cores.
const RUNS: usize = 12;
const WORK: usize = 30_000_000;

type Change = (&'static str, &'static [&'static str], fn(f64) -> f64);

/// Changes in the order of trial: steps of a shop's try-out, good lubrication (0.05), a dry punch (0.15); declared.
const CHANGES: [Change; 25] = [
    ("pressure", &["gas.lower.pressure.last.1"], |x| 1.4 * x),
    ("pressure", &["gas.lower.pressure.last.1"], |x| 2.0 * x),
    ("pressure", &["gas.lower.pressure.last.1"], |x| 3.5 * x),
    ("pressure", &["gas.lower.pressure.last.1"], |x| 7.0 * x),
    ("die radius", &["tools.die.shoulder"], |x| x * 4.0 / 3.0),
    ("punch nose", &["tools.punch.flat.nose"], |x| x * 4.0 / 3.0),
    ("hole diameter", &["blank.hole_diameter"], |x| 1.1 * x),
    ("holder force", &["tools.holder.force"], |x| 0.7 * x),
    ("holder force", &["tools.holder.force"], |x| 1.5 * x),
    ("friction of die and holder", &["tools.die.friction", "tools.holder.friction"], |x| x.min(0.05)),
    ("friction of all tools", &["friction"], |x| x.min(0.05)),
    ("friction of the punch", &["tools.punch.friction"], |x| x.max(0.15)),
    ("blank diameter", &["blank.diameter"], |x| 0.97 * x),
    ("blank radius", &["blank.radius"], |x| 0.97 * x),
    ("bead force", &["tools.beads.0.restraining"], |x| 0.7 * x),
    ("bead force", &["tools.beads.0.restraining"], |x| 1.4 * x),
    ("holder gap", &["tools.holder.gap"], |x| 0.9 * x),
    ("die radius", &["tools.die.shoulder"], |x| x * 5.0 / 3.0),
    ("punch nose", &["tools.punch.flat.nose"], |x| x * 5.0 / 3.0),
    ("holder force", &["tools.holder.force"], |x| 2.5 * x),
    ("holder force", &["tools.holder.force"], |x| 0.5 * x),
    ("blank diameter", &["blank.diameter"], |x| 0.94 * x),
    ("blank radius", &["blank.radius"], |x| 0.94 * x),
    ("die throat", &["tools.die.throat"], |x| 1.005 * x),
    ("travel", &["tools.punch.travel"], |x| 0.9 * x),
];

pub(super) fn advise(solution: &Solution, bars: Option<&ErrorBars>, findings: &mut [Finding], watch: &dyn Watch) {
    // A test that ends at its load maximum is meant to.
    if solution.case.model().stop.load_drop.is_some() || !is_known(solution) || !judgements(findings).any(is_open) {
        return;
    }
    let changes = CHANGES.iter().filter_map(|change| Some((change.2(1.0) > 1.0, settings(&solution.case, change)?)));
    let mut changes: Vec<_> = changes.collect();
    // One tool alone has the friction of all.
    changes.dedup_by(|b, a| a.1.2 == b.1.2);
    changes.truncate(RUNS.min(WORK / work(solution).max(1)));
    let tried = changes.into_par_iter().with_max_len(1).filter_map(|(is_more, (words, size, settings))| {
        let case = case::parse(&solution.case.text, &solution.case.path.to_string_lossy(), &settings).ok()?;
        let (answer, findings) = answered(&BaseCase::solve(case, watch).ok().filter(Solution::is_complete)?, bars);
        let fails = matches!(answer.failures.first(), Some(FailureMode::Tears | FailureMode::Wrinkles));
        (!fails).then_some(Tried { words, size, is_more, findings })
    });
    let tried: Vec<Tried> = tried.collect();
    if !watch.wants_to_stop() {
        advice::advise(findings, &tried);
    }
}

/// Words with the new value, and the overrides that set it; `None` if the case does not write the size, or has better.
fn settings(case: &Case, &(words, keys, change): &Change) -> Option<(String, &'static str, Vec<String>)> {
    let (mut shown, mut all) = (None, Vec::new());
    for (path, value) in keys.iter().flat_map(|key| case.written(key)) {
        let (old, unit) = split_number(&value)?;
        let new = significant(change(old), if (0.8..1.2).contains(&(change(old) / old)) { 3 } else { 2 });
        // A finished part needs its blank, a clamped one the die's edge, tools that close their travel.
        let is_held = case.model().blank.edge == Edge::Clamped && path != "blank.hole_diameter";
        let is_kept = path.starts_with("blank.") && (case.finished.height.is_some() || is_held);
        let is_closed = words == "travel" && case.model().tool(Role::Die).is_some_and(|die| throat(die).is_none());
        (new != old && !is_kept && !is_closed).then_some(())?;
        let variable = Variable::new(&path, unit.to_owned());
        all.push(variable.setting(&written(new)));
        shown = Some(variable.display(new));
    }
    let has_holder = case.model().tool(Role::Holder).is_some();
    let named = if has_holder { words.to_owned() } else { words.replace("die and holder", "the die") };
    Some((format!("{named} {}", shown?), words, all))
}

/// Work of a run, by which the time of others is known \[iterations × elements × points\].
fn work(solution: &Solution) -> usize {
    let of_stage = |StageSolution { model, steps, .. }: &StageSolution| {
        model.blank.elements * model.blank.layers * steps.iter().map(|step| step.iterations).sum::<usize>()
    };
    solution.stages.iter().map(of_stage).sum()
}
