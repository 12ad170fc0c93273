//! The least or the most of a number over several keys, with a condition on every run.
//!
//! A coarse grid first, its runs side by side; then Powell's COBYLA from the best of them, one start a thread, with linear
//! models over a simplex as wide as half a step of the grid, which noise below that does not mislead. The answer is the best
//! run that keeps the condition, whatever the method has at its end.
//!
//! # References
//! M. J. D. Powell, A direct search optimization method that models the objective and constraint functions by linear
//! interpolation, in Advances in Optimization and Numerical Analysis (1994) 51–67 (not read; the crate `cobyla`).

use super::condition::{Condition, Said, usable};
use super::number::Named;
use super::trials::{Further, Keep, Trials, design};
use crate::study::verify::Watch;
use crate::study::{Bars, Columns, Row, Solved, Span, StudyError, Subject, base, one, side_by_side};
use cobyla::{Func, RhoBeg, StopTols, minimize};
use std::cell::RefCell;
use std::convert::Infallible;

/// Which end of a number is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sense {
    /// Its least.
    Least,
    /// Its most.
    Most,
}

/// The best run of several keys.
#[derive(Debug)]
pub struct Best {
    /// All runs: those of the grid, then those of each start.
    pub rows: Vec<Row>,
    /// How many of them are of the grid.
    pub grid: usize,
    /// The best run that keeps the condition; `None` where none does.
    pub best: Option<usize>,
    /// The parts of the condition, and the ends of spans, that the best run comes to within a hundredth.
    pub binding: Vec<String>,
    /// What the case as it stands came to.
    pub base: Solved,
    /// The table of all runs: its header and its lines.
    pub table: (Vec<String>, Vec<Vec<String>>),
    /// Whether it was ended before.
    pub interrupted: bool,
}

/// Runs of the grid, at most.
const GRID: usize = 64;
/// Runs of each start, at most, for every key.
const RUNS: usize = 15;
/// A part of the condition binds that is kept by less, over its limit, and an end of a span that is as near, over the span \[–\].
const BINDS: f64 = 0.01;
/// Starts, at most.
const STARTS: usize = 4;

/// Looks for the best run; `keep` has the runs as they come, those of a start when it has ended.
///
/// # Errors
/// When the case cannot be run, or a number is asked for that it does not have.
pub fn optimise(
    subject: &Subject,
    spans: &[Span],
    (number, sense): (&Named, Sense),
    condition: Option<&Condition>,
    threads: usize,
    (watch, keep): (&dyn Watch, Keep),
) -> Result<Best, StudyError> {
    let base = base(subject, Bars::Without, watch)?;
    number.find(&base)?;
    condition.map_or(Ok(()), |condition| condition.check(&base))?;
    let problem = Problem { subject, spans, number, sense, condition, watch };
    let per_key = ((GRID as f64).powf(1.0 / spans.len() as f64) + 1e-9).floor().clamp(2.0, 9.0) as usize;
    let starts = threads.clamp(1, STARTS);
    let expected = per_key.pow(spans.len() as u32) + starts * RUNS * spans.len();
    let mut trials = Trials::new(subject, spans, threads, watch, expected).keeping(&base, keep);
    trials.run(&grid(spans, per_key));
    let grid = trials.rows.len();
    let mut order: Vec<usize> = (0..grid).collect();
    let rank = |row: &Row| problem.cost(row).map_or((2, f64::INFINITY), |cost| (u8::from(!problem.holds(row)), cost));
    order.sort_by(|a, b| {
        let (a, b) = (rank(&trials.rows[*a]), rank(&trials.rows[*b]));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    });
    let from: Vec<(usize, Vec<f64>)> =
        order.iter().take(starts).map(|run| problem.shares(&trials.rows[*run])).enumerate().collect();
    if !watch.wants_to_stop() {
        let width = 0.5 / (per_key - 1) as f64;
        let further = Further { watch, before: grid, expected };
        let Ok(()) = side_by_side(
            &from,
            threads,
            &further,
            |(_, start)| problem.descend(start, width),
            |rows| {
                rows.into_iter().for_each(|row| trials.add(row));
                Ok::<_, Infallible>(())
            },
        );
    }
    let kept = (0..trials.rows.len()).filter(|run| problem.holds(&trials.rows[*run]));
    let best = kept.filter_map(|run| Some((run, problem.cost(&trials.rows[run])?))).min_by(|a, b| a.1.total_cmp(&b.1));
    let best = best.map(|(run, _)| run);
    let table = trials.table(&Columns::of(&trials, &base));
    Ok(Best {
        grid,
        best,
        binding: best.map_or_else(Vec::new, |run| problem.binding(&trials.rows[run])),
        table,
        rows: trials.rows,
        base,
        interrupted: watch.wants_to_stop(),
    })
}

/// Every combination of so many places of each span.
fn grid(spans: &[Span], per_key: usize) -> Vec<Vec<f64>> {
    let mut points = vec![Vec::new()];
    for span in spans {
        let places: Vec<f64> = (0..per_key).map(|i| span.at(i as f64 / (per_key - 1) as f64)).collect();
        points = points.iter().flat_map(|point| places.iter().map(|x| [point.as_slice(), &[*x]].concat())).collect();
    }
    points
}

struct Problem<'a> {
    subject: &'a Subject,
    spans: &'a [Span],
    number: &'a Named,
    sense: Sense,
    condition: Option<&'a Condition>,
    watch: &'a dyn Watch,
}

impl Problem<'_> {
    /// What is to be small: the number, or its negative; `None` of a run that failed or tore.
    fn cost(&self, row: &Row) -> Option<f64> {
        let solved = usable(row).ok().filter(|solved| !solved.tears)?;
        let value = self.number.find(solved).ok()?.amount.value;
        Some(if self.sense == Sense::Least { value } else { -value })
    }

    fn holds(&self, row: &Row) -> bool {
        self.cost(row).is_some() && self.condition.is_none_or(|condition| condition.judge(row) == Said::Holds)
    }

    /// Shares of the way of a run's keys.
    fn shares(&self, row: &Row) -> Vec<f64> {
        let mut values = row.design.values.iter();
        let first = |span: &Span| {
            let value = values.by_ref().take(span.keys().len()).next().and_then(|value| value.number);
            span.share(value.unwrap_or_default())
        };
        self.spans.iter().map(first).collect()
    }

    /// Runs from a start until no step brings it nearer: what was run.
    fn descend(&self, start: &[f64], width: f64) -> Vec<Row> {
        let made: RefCell<Vec<(Vec<f64>, Row)>> = RefCell::default();
        // The run at a point, made when it is first asked for.
        let with = |shares: &[f64], of: &dyn Fn(&Row) -> f64| {
            let point: Vec<f64> =
                self.spans.iter().zip(shares).map(|(span, share)| span.at(share.clamp(0.0, 1.0))).collect();
            let known = made.borrow().iter().position(|(known, _)| *known == point);
            let place = known.unwrap_or_else(|| {
                let row = one(self.subject, design(self.spans, 0, &point), Bars::Without, self.watch);
                made.borrow_mut().push((point, row));
                made.borrow().len() - 1
            });
            of(&made.borrow()[place].1)
        };
        // In sizes near 1; a run that failed is as bad as the start, and beyond every limit.
        let size = with(start, &|row| self.cost(row).unwrap_or(1.0)).abs().max(f64::MIN_POSITIVE);
        let objective = |x: &[f64], _: &mut ()| {
            if self.watch.wants_to_stop() {
                0.0
            } else {
                with(x, &|row| self.cost(row).map_or(2.0, |cost| cost / size))
            }
        };
        let parts = self.condition.map_or(0, |condition| condition.parts().count());
        let constraint = |part: usize| {
            move |x: &[f64], _: &mut ()| {
                let margin = |row: &Row| self.condition.map_or(1.0, |condition| condition.margins(row)[part]);
                if self.watch.wants_to_stop() { 0.0 } else { with(x, &margin) }
            }
        };
        let constraints: Vec<_> = (0..parts).map(constraint).collect();
        let constraints: Vec<&dyn Func<()>> = constraints.iter().map(|part| part as &dyn Func<()>).collect();
        let bounds = vec![(0.0, 1.0); start.len()];
        let stop = StopTols { xtol_abs: vec![super::super::span::SHARE; start.len()], ..StopTols::default() };
        let runs = RUNS * start.len();
        // Its answer is among the runs, and so is what it failed at.
        let _ = minimize(objective, start, &bounds, &constraints, (), runs, RhoBeg::All(width), Some(stop));
        let rows = made.into_inner().into_iter().map(|(_, row)| row);
        if self.watch.wants_to_stop() { rows.filter(|row| self.cost(row).is_some()).collect() } else { rows.collect() }
    }

    fn binding(&self, row: &Row) -> Vec<String> {
        let parts = self.condition.into_iter().flat_map(|condition| condition.parts().zip(condition.margins(row)));
        let limits = parts.filter(|(_, margin)| *margin <= BINDS).map(|(part, _)| part.to_owned());
        let ends = self.spans.iter().zip(self.shares(row)).filter_map(|(span, share)| {
            let end = if share <= BINDS {
                0
            } else if share >= 1.0 - BINDS {
                1
            } else {
                return None;
            };
            Some(format!("{} = {} {}", span.label(), span.ends()[end], span.unit()).trim_end().to_owned())
        });
        limits.chain(ends).collect()
    }
}
