//! Solution verification: the share of a number that mesh, step, points through the thickness and contact leave open. Laws,
//! friction and tools are the model, whose errors validation finds.
//!
//! Each [`Direction`] is refined on its own, twice and four times, because errors of different origin cancel when they are
//! refined together. Of the numbers f₁ (the run itself), f₂, f₄ of one direction:
//! ```text
//!   p = log₂((f₁ − f₂)/(f₂ − f₄))        observed order
//!   e = 1.25 |f₁ − f₂|/(1 − 2⁻ᵖ)         if both differences have one sign and p lies within half and twice the formal
//!                                        order: Richardson's extrapolation with a factor of safety
//!   e = 3 (max f − min f)                else, and if a direction has no formal order
//! ```
//! The bar is the sum over all directions. Measured on 60 random dies, with the root of the sum of squares the truth lies
//! outside in 4 % of the numbers, with the sum in 0.3 % (`cargo bench --bench coverage`). A bar is never less than the
//! solver's tolerance leaves. Places and travels, which are read off an element or a step, have none.
//!
//! # References
//! P. J. Roache, J. Fluids Eng. 116 (1994) 405–413 (not read: the factor 1.25 and the term); ASME V&V 20 (2009) (not read);
//! L. Eça, M. Hoekstra, J. Comput. Phys. 262 (2014) 104–130 (not read: the factor 3 on the spread of data that do not follow
//! a power).

mod direction;
mod estimate;
mod numbers;

#[cfg(test)]
mod tests;

pub use direction::Direction;
use estimate::with_bar;
pub use numbers::{End, Outcome};

use crate::case::{Case, Solution};
use crate::results::csv::{number, records};
use crate::results::error_bars::ErrorBars;
use crate::solver::Observer;
use crate::solver::state::nonlocal_average::NEIGHBOURHOOD;
use crate::units::{Amount, joined};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Refinement factors of [`verify`], and that of the coarser run of [`quick`] \[–\].
const LEVELS: [f64; 2] = [2.0, 4.0];
const COARSER: f64 = 0.5;

/// Longest expected duration of a finer run \[s\].
const LONGEST: f64 = 300.0;

/// Shortest elements, over the thickness, that a shell resolves \[–\]: its normal stays straight, which stress needs about a
/// thickness for (Saint-Venant).
const SHELL_LENGTH: f64 = 1.0;

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

/// Refines a solved case in every direction on its own.
pub fn verify(solution: &Solution, watch: &dyn Watch) -> Verification {
    let base = Outcome::of(solution, None);
    let all = Direction::ALL.iter().flat_map(|direction| LEVELS.map(|times| (*direction, times)));
    let wall = solution.wall.map_or(0.0, |wall| wall.as_secs_f64());
    let seconds = |(direction, times): &(Direction, f64)| wall * direction.cost(*times);
    let (long, mut jobs): (Vec<_>, Vec<_>) = all.filter(|_| !base.end.lost).partition(|job| seconds(job) > LONGEST);
    jobs.sort_by(|a, b| b.0.cost(b.1).total_cmp(&a.0.cost(a.1)));
    let mut verification = Verification::of(solution, base, &jobs, watch);
    verification.bars.notes.extend(long.iter().map(|job| {
        let (time, finer) = (Amount::time(seconds(job)), job.0.text(job.1));
        format!("left out, for it would take some {time}: {finer}")
    }));
    verification
}

/// Estimates the bars of a solved case from one run that is coarser in every direction, which takes a fraction of its time;
/// none if the sheet tore.
pub fn quick(solution: &Solution, watch: &dyn Watch) -> Verification {
    let base = Outcome::of(solution, None);
    let jobs: &[_] = if base.end.complete { &[(Direction::Together, COARSER)] } else { &[] };
    Verification::of(solution, base, jobs, watch)
}

impl Verification {
    /// Solves the refined runs, those with something to refine; no bars if the watch wants to stop.
    fn of(solution: &Solution, base: Outcome, jobs: &[(Direction, f64)], watch: &dyn Watch) -> Self {
        let (case, done) = (&solution.case, AtomicUsize::new(0));
        let one = |&(direction, times): &(Direction, f64)| {
            let outcome = direction.refined(&case.stages, times).map(|stages| {
                let case = Case { stages, ..case.clone() };
                Outcome::of(&case.solve(&mut &*watch), Some((direction, times)))
            });
            watch.ran(1 + done.fetch_add(1, Ordering::Relaxed), jobs.len());
            outcome
        };
        // A bridge starts them in their order: the most costly first.
        let refined = jobs.iter().par_bridge().filter_map(one).collect();
        let tolerance = case.stages.iter().map(|s| s.model.settings.tolerance).fold(0.0, f64::max);
        if watch.wants_to_stop() {
            return Self::from_runs(base, Vec::new(), tolerance, Some("interrupted by the user".to_owned()));
        }
        Self::from_runs(base, refined, tolerance, None)
    }

    /// Error bars of a run from refined ones, every step solved to a tolerance; or none for a reason.
    fn from_runs(base: Outcome, mut refined: Vec<Outcome>, tolerance: f64, reason: Option<String>) -> Self {
        refined.sort_by(|a, b| (a.times, a.direction).partial_cmp(&(b.times, b.direction)).expect("finite factors"));
        let of = |direction: Direction| refined.iter().filter(move |run| run.direction == Some(direction));
        let directions = Direction::ALL.into_iter().chain([Direction::Together]);
        let counted: Vec<(Direction, Vec<&Outcome>)> = directions
            .filter(|direction| of(*direction).next().is_some())
            .map(|direction| (direction, of(direction).filter(|run| run.end.is_like(&base.end)).collect()))
            .collect();
        let reason = reason.or_else(|| {
            if base.end.lost || counted.is_empty() {
                return Some(base.end.why.clone());
            }
            if refined.iter().any(|run| run.ends_otherwise(&base)) {
                return Some("other runs end otherwise".to_owned());
            }
            let (direction, _) = counted.iter().find(|(_, runs)| runs.is_empty())?;
            Some(format!("no run with finer {} came to its end", direction.label()))
        });
        let numbers = base.numbers.iter().map(|number| match &reason {
            Some(reason) => number.without_bar(reason),
            None => with_bar(number, &counted, tolerance),
        });
        let finer_that_differs = refined.iter().find(|run| run.times > 1.0 && run.ends_otherwise(&base));
        let bars = ErrorBars {
            numbers: numbers.collect(),
            notes: notes(&base, &refined),
            runs: refined.len(),
            is_quick: refined.iter().any(|run| run.direction == Some(Direction::Together)),
            finer_that_differs: finer_that_differs.map(Outcome::refinement),
            why: base.end.why.clone(),
        };
        Self { bars, outcomes: [vec![base], refined].concat() }
    }

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

/// Sentences on runs that do not count or end otherwise, and on elements that are too short.
fn notes(base: &Outcome, refined: &[Outcome]) -> Vec<String> {
    let mut notes: Vec<String> = base.end.lost.then(|| base.end.why.clone()).into_iter().collect();
    let lost = refined.iter().filter(|run| run.end.lost);
    notes.extend(lost.map(|run| format!("with {} the run does not count: {}", run.refinement(), run.end.why)));
    notes.extend(refined.iter().filter(|run| run.ends_otherwise(base)).map(|run| {
        format!("with {} the run ends otherwise: {}; as it is: {}", run.refinement(), run.end.why, base.end.why)
    }));
    let is_short = |run: &&Outcome| run.shortest < SHELL_LENGTH;
    if refined.iter().filter(is_short).any(|run| run.times > 1.0) {
        let shortest = refined.iter().chain([base]).map(|run| run.shortest).fold(f64::INFINITY, f64::min);
        let own = is_short(&base).then(|| "as it is".to_owned());
        let finer = refined.iter().filter(|run| run.direction == Some(Direction::Elements)).filter(is_short);
        notes.push(format!(
            "elements are shorter than the sheet is thick, down to {}: {}. A shell resolves nothing shorter, and the solver \
             gives each the mean section of {}",
            Amount::thicknesses(shortest),
            joined(own.into_iter().chain(finer.map(Outcome::refinement)), ", "),
            Amount::given_thicknesses(NEIGHBOURHOOD)
        ));
    }
    notes
}
