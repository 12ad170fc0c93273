//! Solution verification: what mesh, step, thickness points and contact leave open; models are for validation.
//!
//! Each [`Direction`] is made twice as fine on its own, because errors of different origin cancel; contact smoothing also four
//! times as fine. Of the numbers f₁ (the run itself), f₂, f₄ of one direction:
//! ```text
//!   p = log₂((f₁ − f₂)/(f₂ − f₄))        observed order
//!   e = 1.25 |f₁ − f₂|/(1 − 2⁻ᵖ)         if both differences have one sign and p lies within half and twice the formal
//!                                        order: Richardson's extrapolation with a factor of safety
//!   e = 2 (max f − min f)                else, and of f₁ and f₂ alone
//!   e = 3 |f₁ − f₂|                      of elements, one of the largest parts of most bars
//! ```
//! The bar is the sum over all directions; the root of the sum of squares misses more. Places and travels have none.
//!
//! # References
//! P. J. Roache, J. Fluids Eng. 116 (1994) 405–413 (not read: the factors 1.25 for three levels and 3 for two); ASME V&V 20
//! (2009) (not read); L. Eça, M. Hoekstra, J. Comput. Phys. 262 (2014) 104–130 (not read: a factor of 3 on the spread of
//! one direction alone). In a sum of seven 2 is enough; of elements too it holds 95 % of random dies' forming limits, but
//! only just, where 3 holds 96 % (`benches/coverage.rs`).

mod estimate;
mod numbers;

pub use crate::model::refinement::Direction;
use estimate::with_bar;
pub use numbers::{End, Outcome};

use crate::assess::error_bars::ErrorBars;
use crate::case::{Case, Solution};
use crate::results::csv::{number, records};
use crate::solver::Observer;
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Name of the file with the numbers of every run.
pub const FILE: &str = "verification.csv";

/// First columns of [`FILE`], by which it is recognised.
pub const BEGINNING: &str = "told_by,quantity,unit,value,error_bar";

/// Error bars of a solution with the runs that they come from.
#[derive(Clone, Debug, PartialEq)]
pub struct Verification {
    /// Every number with its error bar.
    pub bars: ErrorBars,
    /// All runs, the verified one first.
    pub outcomes: Vec<Outcome>,
}

/// Callback of runs that are solved side by side.
pub trait Watch: Sync {
    /// Decides whether all runs end now.
    fn wants_to_stop(&self) -> bool {
        false
    }

    /// Reports that `done` of `all` runs are solved.
    fn ran(&self, _done: usize, _all: usize) {}
}

impl Watch for () {}

impl Observer for &dyn Watch {
    fn wants_to_stop(&mut self) -> bool {
        Watch::wants_to_stop(*self)
    }
}

/// Refines a solved case in every direction on its own; no bars if the watch wants to stop.
pub fn verify(solution: &Solution, watch: &dyn Watch) -> Verification {
    let base = Outcome::of(solution, None);
    let all = [(Direction::Smoothing, 4.0)].into_iter().chain(Direction::ALL.map(|direction| (direction, 2.0)));
    let jobs: Vec<_> = all.filter(|_| !base.end.lost).collect();
    let (case, done) = (&solution.case, AtomicUsize::new(0));
    let one = |&(direction, times): &(Direction, f64)| {
        let solved = |case: Case| Outcome::of(&case.solve(&mut &*watch), Some((direction, times)));
        let outcome = direction.refined(&case.stages, times).map(|stages| solved(Case { stages, ..case.clone() }));
        watch.ran(1 + done.fetch_add(1, Ordering::Relaxed), jobs.len());
        outcome
    };
    let mut refined: Vec<Outcome> = jobs.par_iter().with_max_len(1).filter_map(one).collect();
    refined.sort_by(|a, b| a.times.total_cmp(&b.times));
    if watch.wants_to_stop() {
        refined.clear();
    }
    let runs = |direction| refined.iter().filter(move |run| run.direction == Some(direction));
    let solved = Direction::ALL.into_iter().filter(|direction| runs(*direction).next().is_some());
    let alike = |direction| (direction, runs(direction).filter(|run| run.end.is_like(&base.end)).collect());
    let directions: Vec<(Direction, Vec<&Outcome>)> = solved.map(alike).collect();
    let otherwise = || refined.iter().filter(|run| !run.end.lost && !run.end.is_like(&base.end));
    let reason = if watch.wants_to_stop() {
        Some("interrupted by the user".to_owned())
    } else if base.end.lost || directions.is_empty() {
        Some(base.end.why.clone())
    } else if otherwise().next().is_some() {
        Some("other runs end otherwise".to_owned())
    } else {
        let missing = directions.iter().find(|(_, runs)| runs.is_empty());
        missing.map(|(direction, _)| format!("no run with finer {} came to its end", direction.label()))
    };
    let tolerance = case.stages.iter().map(|s| s.model.settings.tolerance).fold(0.0, f64::max);
    let numbers = base.numbers.iter().map(|number| match &reason {
        Some(reason) => number.without_bar(reason),
        None => with_bar(number, &directions, tolerance),
    });
    let mut notes: Vec<String> = base.end.lost.then(|| base.end.why.clone()).into_iter().collect();
    let lost = refined.iter().filter(|run| run.end.lost);
    notes.extend(lost.map(|run| format!("with {} the run does not count: {}", run.refinement(), run.end.why)));
    notes.extend(otherwise().map(|run| {
        format!("with {} the run ends otherwise: {}; as it is: {}", run.refinement(), run.end.why, base.end.why)
    }));
    let (runs, finer_that_differs) = (refined.len(), otherwise().next().map(Outcome::refinement));
    let bars = ErrorBars { numbers: numbers.collect(), notes, runs, finer_that_differs, why: base.end.why.clone() };
    Verification { bars, outcomes: [vec![base], refined].concat() }
}

impl Verification {
    /// Content of [`FILE`]: a row per number with its error bar, and a column for every finer run.
    pub fn csv(&self) -> Vec<u8> {
        let runs = &self.outcomes[1..];
        let name = |run: &Outcome| format!("{}_{}", run.direction.map_or_else(String::new, Direction::key), run.times);
        let header = BEGINNING.split(',').map(str::to_owned).chain(runs.iter().map(name)).collect();
        let rows = self.bars.numbers.iter().map(|own| {
            let values = [Some(own.quantity.amount.value), own.half()].into_iter();
            let values = values.chain(runs.iter().map(|run| run.value(own)));
            let cells = values.map(|value| value.map_or_else(String::new, number));
            own.name().into_iter().map(str::to_owned).chain(cells).collect::<Vec<_>>()
        });
        records(std::iter::once(header).chain(rows))
    }
}
