//! Every iteration of the corrector, for studying convergence: of a run, and of one step taken apart.

use super::csv::with_texts;
use crate::solver::solution::IterationRecord;
use crate::solver::trace::{Attempt, Iterated, Pass, Trace, Way, key};
use crate::table::{Column, Table, Unit};

/// One row per iteration, of rejected steps too.
pub fn table(iterations: &[IterationRecord]) -> Table {
    let column = |key, label, unit, value: fn(&IterationRecord) -> f64| {
        Column::new(key, label, unit, iterations.iter().map(value).collect())
    };
    Table::new(vec![
        column("step", "Step", Unit::None, |i| i.step as f64),
        column("travel", "Punch travel", Unit::Mm, |i| i.travel),
        column("iteration", "Iteration", Unit::None, |i| i.iteration as f64),
        column("velocity_norm", "Relative velocity increment", Unit::None, |i| i.velocity_norm),
        column("residual_norm", "Relative residual", Unit::None, |i| i.residual_norm),
        column("cut", "Share of the increment taken", Unit::None, |i| i.cut),
        column("active_contacts", "Active contacts", Unit::None, |i| i.active_contacts as f64),
    ])
}

/// An iteration, in which pass of which try of which way; tries and passes with their numbers from 0.
struct Row<'a> {
    way: &'a Way,
    attempt: (usize, &'a Attempt),
    pass: (usize, &'a Pass),
    iterated: &'a Iterated,
}

/// One row per iteration of a step taken apart, its first row what the pass starts from; of all tries and passes of every way.
pub fn step_csv(trace: Option<&Trace>) -> Vec<u8> {
    let ways = trace.iter().flat_map(|trace| &trace.ways);
    let rows: Vec<Row> = ways
        .flat_map(|way| way.attempts.iter().enumerate().map(move |attempt| (way, attempt)))
        .flat_map(|(way, attempt)| attempt.1.passes.iter().enumerate().map(move |pass| (way, attempt, pass)))
        .flat_map(|(way, attempt, pass)| {
            pass.1.iterated.iter().map(move |iterated| Row { way, attempt, pass, iterated })
        })
        .collect();
    let column = |key, label, unit, value: fn(&Iterated) -> f64| {
        Column::new(key, label, unit, rows.iter().map(|row| value(row.iterated)).collect())
    };
    let counted = |key, label, count: fn(usize, usize) -> usize| {
        Column::new(
            key,
            label,
            Unit::None,
            rows.iter().map(|row| count(row.attempt.0, row.pass.0) as f64 + 1.0).collect(),
        )
    };
    let table = Table::new(vec![
        counted("try", "Try", |attempt, _| attempt),
        counted("pass", "Pass of the corrector", |_, pass| pass),
        column("iteration", "Iteration", Unit::None, |i| i.iteration as f64),
        column("velocity_norm", "Relative velocity increment", Unit::None, |i| i.velocity_norm.unwrap_or(f64::NAN)),
        column("share", "Share of the increment taken", Unit::None, |i| i.share.unwrap_or(f64::NAN)),
        column("residual_norm", "Relative residual", Unit::None, |i| i.residual_norm),
        column("worst_r", "Radius of the largest residual", Unit::Mm, |i| i.nodes[i.worst_node][0]),
        column("cut_off_elements", "Elements in cut-off", Unit::None, |i| i.cut_off() as f64),
        column("contacts", "Points in contact", Unit::None, |i| i.touching.len() as f64),
        column("sticking", "Points that stick", Unit::None, |i| i.sticking() as f64),
    ]);
    let words = |word: fn(&Way, &Attempt, &Pass) -> &'static str| {
        rows.iter().map(|row| word(row.way, row.attempt.1, row.pass.1).to_owned()).collect()
    };
    let texts = [
        ("method", words(|way, _, _| key(way.matrix))),
        ("start", words(|_, attempt, _| attempt.key())),
        ("matrix", words(|_, _, pass| key(pass.matrix))),
    ];
    with_texts(&texts, &table)
}
