//! Advice: changes of one size, each solved before it is given.

use super::variable::{Variable, split_number, written};
use super::verdict::is_known;
use super::{BaseCase, Watch};
use crate::assess::{Finding, Light, after, judgements};
use crate::case::{self, Case, Solution};
use crate::solver::solution::StageSolution;
use crate::units::{Sense, significant};
use rayon::prelude::*;
use std::cmp::Reverse;

/// Most runs, and the work of all of them \[iterations × elements × points\]: some 5 s of two cores.
const RUNS: usize = 12;
const WORK: usize = 60_000_000;

/// Most changes that are given.
const MOST: usize = 3;

/// Least gain of a number that is worth a change \[–\]: declared.
const WORTH: f64 = 0.1;

/// Rows that no change of a size moves: input that is missing, and the solution itself.
const NO_DESIGN: [&str; 4] = ["friction", "hardening_range", "yield_condition", "solution_quality"];

/// New value of a size.
#[derive(Clone, Copy)]
enum Step {
    /// Times the old one \[–\].
    Times(f64),
    /// Larger by so many thicknesses \[–\].
    Wider(f64),
    /// A friction that is not above the old one \[–\].
    Lower(f64),
    /// A friction that is not below it \[–\].
    Higher(f64),
}

use Step::{Higher, Lower, Times, Wider};

/// Words, keys that are set together, new value.
type Change = (&'static str, &'static [&'static str], Step);

/// Changes in the order of trial: steps of a shop's try-out, good lubrication (0.05), a dry punch (0.15); declared.
const CHANGES: [Change; 20] = [
    ("die radius", &["tools.die.shoulder"], Times(4.0 / 3.0)),
    ("punch radius", &["tools.punch.flat.nose"], Times(4.0 / 3.0)),
    ("holder force", &["tools.holder.force"], Times(0.7)),
    ("holder force", &["tools.holder.force"], Times(1.5)),
    ("friction of die and holder", &["tools.die.friction", "tools.holder.friction"], Lower(0.05)),
    ("friction of all tools", &["friction"], Lower(0.05)),
    ("friction of the punch", &["tools.punch.friction"], Higher(0.15)),
    ("blank diameter", &["blank.diameter"], Times(0.97)),
    ("blank radius", &["blank.radius"], Times(0.97)),
    ("bead force", &["tools.beads.0.restraining"], Times(0.7)),
    ("bead force", &["tools.beads.0.restraining"], Times(1.4)),
    ("holder gap", &["tools.holder.gap"], Times(0.9)),
    ("die radius", &["tools.die.shoulder"], Times(5.0 / 3.0)),
    ("punch radius", &["tools.punch.flat.nose"], Times(5.0 / 3.0)),
    ("holder force", &["tools.holder.force"], Times(2.5)),
    ("holder force", &["tools.holder.force"], Times(0.5)),
    ("blank diameter", &["blank.diameter"], Times(0.94)),
    ("blank radius", &["blank.radius"], Times(0.94)),
    ("die throat", &["tools.die.throat"], Wider(0.1)),
    ("travel", &["tools.punch.travel"], Times(0.9)),
];

/// A change that was solved.
struct Tried {
    /// `die radius 8 mm`.
    words: String,
    /// Words of the size, of which one step is given.
    size: &'static str,
    findings: Vec<Finding>,
}

/// Replaces the advice on red and amber rows by the changes that help, the best first.
pub fn advise(solution: &Solution, findings: &mut [Finding], watch: &dyn Watch) {
    let is_open = |row: &Finding| row.light > Light::Green && !NO_DESIGN.contains(&row.key);
    if !is_known(solution) || !judgements(findings).any(is_open) {
        return;
    }
    let most = RUNS.min(WORK / work(solution).max(1));
    let changes = CHANGES.iter().filter_map(|change| settings(&solution.case, change)).take(most);
    let changes: Vec<(String, &'static str, Vec<String>)> = changes.collect();
    let tried = changes.into_par_iter().with_max_len(1).filter_map(|(words, size, settings)| {
        let Case { text, path, .. } = &solution.case;
        let case = case::parse(text, &path.to_string_lossy(), &settings).ok()?;
        let solution = BaseCase::solve(case, watch).ok().filter(is_known)?;
        Some(Tried { words, size, findings: after(&solution.case, &solution.stages) })
    });
    let tried: Vec<Tried> = tried.collect();
    if watch.wants_to_stop() {
        return;
    }
    let base = score(findings);
    let mut helpful: Vec<(&Tried, usize, f64)> = Vec::new();
    for one in tried.iter().filter(|one| score(&one.findings) <= base) {
        let gains = findings.iter().enumerate().filter(|(_, row)| is_open(row));
        let gains = gains.filter_map(|(i, row)| Some((i, gain(row, &one.findings)?)));
        // The worst row comes first.
        let best = gains.min_by(|a, b| (Reverse(findings[a.0].light), a.0).cmp(&(Reverse(findings[b.0].light), b.0)));
        helpful.extend(best.map(|(row, gain)| (one, row, gain)));
    }
    helpful.sort_by(|a, b| score(&a.0.findings).cmp(&score(&b.0.findings)).then(b.2.total_cmp(&a.2)));
    let mut given: Vec<&str> = Vec::new();
    helpful.retain(|(one, ..)| {
        let is_new = !given.contains(&one.size) && given.len() < MOST;
        given.extend(is_new.then_some(one.size));
        is_new
    });
    given.clear();
    let texts: Vec<(usize, String)> = helpful.iter().map(|(one, i, _)| (*i, one.text(&findings[*i]))).collect();
    for (i, text) in texts {
        let row = &mut findings[i];
        let is_first = !given.contains(&row.key);
        given.push(row.key);
        row.advice = if is_first { text } else { format!("{}; or {text}", row.advice) };
    }
}

impl Tried {
    /// `die radius 8 mm: 21 → 14 %, green`.
    fn text(&self, row: &Finding) -> String {
        let Self { words, findings, .. } = self;
        let Some(new) = judgements(findings).find(|new| new.key == row.key) else { return words.clone() };
        let amount = |row: &Finding| Some(row.quantity.as_ref().filter(|own| own.limits.is_some())?.amount);
        match amount(row).zip(amount(new)) {
            Some((from, to)) => format!("{words}: {} → {to}, {}", from.parts().0, new.light.name()),
            None => format!("{words}: {} → {}", row.light.name(), new.light.name()),
        }
    }
}

/// Words with the new value, and the overrides that set it; `None` if the case does not write the size, or has better.
fn settings(case: &Case, &(words, keys, step): &Change) -> Option<(String, &'static str, Vec<String>)> {
    let (mut shown, mut all) = (None, Vec::new());
    for (path, value) in keys.iter().flat_map(|key| case.written(key)) {
        let (old, unit) = split_number(&value)?;
        let new = match step {
            Times(by) => significant(old * by, if (0.8..1.2).contains(&by) { 3 } else { 2 }),
            Wider(by) if unit == "mm" => significant(old + by * case.model().blank.thickness, 4),
            Lower(most) if old > most => most,
            Higher(least) if old < least => least,
            _ => return None,
        };
        let variable = Variable::new(&path, unit.to_owned());
        all.push(variable.setting(&written(new)));
        shown = Some(variable.display(new));
    }
    Some((format!("{words} {}", shown?), words, all))
}

/// Work of a run, by which the time of others is known \[iterations × elements × points\].
fn work(solution: &Solution) -> usize {
    let of_stage = |stage: &StageSolution| {
        let blank = &stage.model.blank;
        blank.elements * blank.layers * stage.steps.iter().map(|step| step.iterations).sum::<usize>()
    };
    solution.stages.iter().map(of_stage).sum()
}

/// Worst light of the design, and how many rows are red and amber.
fn score(findings: &[Finding]) -> (Light, usize, usize) {
    let lights = || judgements(findings).filter(|row| !NO_DESIGN.contains(&row.key)).map(|row| row.light);
    let count = |light| lights().filter(|own| *own == light).count();
    (lights().max().unwrap_or(Light::Grey), count(Light::Red), count(Light::Amber))
}

/// Gain of a row in another verdict: lights, and less than one for its number alone; `None` if it is not worth a change.
fn gain(row: &Finding, others: &[Finding]) -> Option<f64> {
    let new = judgements(others).find(|new| new.key == row.key).filter(|new| new.light > Light::Grey)?;
    if new.light != row.light {
        return (new.light < row.light).then(|| (row.light as usize - new.light as usize) as f64);
    }
    let (from, to) = (row.value()?, new.value()?);
    let by = if row.limits()?.sense == Sense::AtMost { from - to } else { to - from } / from.abs();
    (by >= WORTH).then_some(by.min(0.99))
}
