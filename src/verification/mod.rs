//! Solution verification: the share of a number that mesh, step, points through the thickness and contact leave open. Laws,
//! friction and tools are the model, whose errors validation finds.
//!
//! # Method
//! Each [`Direction`] is refined on its own, twice and four times, because errors of different origin cancel when they are
//! refined together. Of the numbers f₁ (the run itself), f₂, f₄ of one direction:
//! ```text
//!   p = log₂((f₁ − f₂)/(f₂ − f₄))        observed order
//!   e = 1.25 |f₁ − f₂|/(1 − 2⁻ᵖ)         if both differences have one sign and p lies within half and twice the formal
//!                                        order: Richardson's extrapolation with a factor of safety
//!   e = 3 (max f − min f)                else, and if a direction has no formal order
//! ```
//! The bar is the sum over all directions. Measured on 60 random dies, with the root of the sum of squares the truth lies
//! outside in 4 % of the numbers, with the sum in 0.3 %. A bar is never less than the solver's tolerance leaves, nor, for a
//! place or a travel, than the element or step that it is read off by. Runs that end otherwise, numbers that jump, and
//! elements below what a shell resolves are listed, not averaged. `cargo bench --bench coverage` measures how often the truth
//! lies inside.
//!
//! # References
//! P. J. Roache, Perspective: a method for uniform reporting of grid refinement studies, J. Fluids Eng. 116 (1994) 405–413
//! (not read: the factor 1.25 and the term); ASME V&V 20, Standard for verification and validation in computational fluid
//! dynamics and heat transfer (2009) (not read); L. Eça, M. Hoekstra, A procedure for the estimation of the numerical
//! uncertainty of CFD calculations based on grid refinement studies, J. Comput. Phys. 262 (2014) 104–130 (not read: the
//! factor 3 on the spread of data that do not follow a power).

mod band;
mod direction;
mod estimate;
mod numbers;
mod outcome;
mod verdict;

#[cfg(test)]
mod tests;

pub use band::Band;
pub use direction::Direction;
pub use estimate::{Estimate, estimate};
pub use numbers::{Contribution, Number, Origin, numbers};
pub use outcome::{End, Outcome};
pub use verdict::answered;

use crate::case::{Case, Solution};
use crate::solver::Observer;
use crate::solver::state::nonlocal_average::NEIGHBOURHOOD;
use crate::units::{Amount, ErrorBar, Unit, joined};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Refinement factors of [`verify`] \[–\].
const LEVELS: [f64; 2] = [2.0, 4.0];

/// Longest expected duration of a finer run \[s\].
const LONGEST: f64 = 300.0;

/// Refinement factor of the coarser run of [`quick`] \[–\].
const COARSER: f64 = 0.5;

/// Error over the difference to the coarser run \[–\]: 1 by the first order; what is coarser in all directions has errors that
/// cancel by chance, and of 60 random dies 19 numbers in 20 keep within five times.
const FACTOR: f64 = 5.0;

/// Least bars of [`quick`], likewise measured: of the number \[–\], of one in percent \[%\], and of a place in elements or steps.
const LEAST: f64 = 3e-3;
const LEAST_PERCENT: f64 = 1.5;
const LEAST_PLACE: f64 = 3.0;

/// Shortest elements, over the thickness, that a shell resolves \[–\]: its normal stays straight, which stress needs about a
/// thickness for (Saint-Venant).
const SHELL_LENGTH: f64 = 1.0;

/// Discretisation errors of a solution.
#[derive(Clone, Debug, PartialEq)]
pub struct Verification {
    /// Every number with its error bar.
    pub numbers: Vec<Number>,
    /// Sentences on whatever is no small error.
    pub notes: Vec<String>,
    /// All runs, the verified one first.
    pub outcomes: Vec<Outcome>,
    /// Band of the punch force \[N, or N/mm\] over the travel \[mm\], of the stage with the largest.
    pub load: Option<Band>,
    /// Band of the part's thickness \[mm\] over the initial distance from the axis \[mm\].
    pub thickness: Option<Band>,
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
    let mut jobs: Vec<(Direction, f64)> =
        Direction::ALL.iter().flat_map(|direction| LEVELS.map(|times| (*direction, times))).collect();
    if base.end.lost {
        jobs.clear();
    }
    let wall = solution.wall.map_or(0.0, |wall| wall.as_secs_f64());
    let seconds = |(direction, times): &(Direction, f64)| wall * direction.cost(*times);
    let long: Vec<_> = jobs.extract_if(.., |job| seconds(job) > LONGEST).collect();
    jobs.sort_by(|a, b| b.0.cost(b.1).total_cmp(&a.0.cost(a.1)));
    let refined = solved(&solution.case, &jobs, watch);
    let estimated = |direction: Direction, levels: &[f64]| estimate(levels, direction.order());
    let mut verification = Verification::of(base, refined, tolerance(&solution.case), estimated, watch);
    verification.notes.extend(long.iter().map(|job| {
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
    let coarser = solved(&solution.case, jobs, watch);
    let estimate = |_: Direction, levels: &[f64]| Estimate {
        error: FACTOR * levels.get(1).map_or(0.0, |coarser| (coarser - levels[0]).abs()),
        order: None,
        extrapolated: false,
    };
    let mut verification = Verification::of(base, coarser, tolerance(&solution.case), estimate, watch);
    for number in &mut verification.numbers {
        let least = match (number.resolution, number.quantity.amount.unit) {
            (resolution, _) if resolution > 0.0 => LEAST_PLACE * resolution,
            (_, Unit::Percent) => LEAST_PERCENT,
            _ => LEAST * number.quantity.value().abs(),
        };
        if let Some(half) = number.half().filter(|half| *half > 0.0) {
            number.quantity = number.quantity.clone().with_error(ErrorBar::Half(half.max(least)));
        }
    }
    verification
}

/// Tolerance to which every step is solved \[–\].
fn tolerance(case: &Case) -> f64 {
    case.stages.iter().map(|stage| stage.model.settings.tolerance).fold(0.0, f64::max)
}

/// Runs of a case, each refined in one direction by a factor; without those that have nothing to refine.
fn solved(case: &Case, jobs: &[(Direction, f64)], watch: &dyn Watch) -> Vec<Outcome> {
    let done = AtomicUsize::new(0);
    let one = |&(direction, times): &(Direction, f64)| {
        let outcome = direction.refined(&case.stages, times).map(|stages| {
            let case = Case { stages, ..case.clone() };
            Outcome::of(&case.solve(&mut &*watch), Some((direction, times)))
        });
        watch.ran(1 + done.fetch_add(1, Ordering::Relaxed), jobs.len());
        outcome
    };
    // A bridge starts them in their order: the most costly first.
    jobs.iter().par_bridge().filter_map(one).collect()
}

impl Verification {
    /// Error bars of a run, solved to a tolerance, from refined ones; none if the watch wants to stop.
    fn of(
        base: Outcome,
        mut refined: Vec<Outcome>,
        tolerance: f64,
        estimate: impl Fn(Direction, &[f64]) -> Estimate + Copy,
        watch: &dyn Watch,
    ) -> Self {
        if watch.wants_to_stop() {
            let numbers = base.numbers.iter().map(|number| number.without_bar("interrupted by the user"));
            let (numbers, outcomes) = (numbers.collect(), vec![base]);
            return Self { numbers, notes: Vec::new(), outcomes, load: None, thickness: None };
        }
        refined.sort_by(|a, b| (a.times, a.direction).partial_cmp(&(b.times, b.direction)).expect("finite factors"));
        let of = |direction: Direction| refined.iter().filter(move |run| run.direction == Some(direction));
        let directions = Direction::ALL.into_iter().chain([Direction::Together]);
        let counted: Vec<(Direction, Vec<&Outcome>)> = directions
            .filter(|direction| of(*direction).next().is_some())
            .map(|direction| (direction, of(direction).filter(|run| run.end.is_like(&base.end)).collect()))
            .collect();
        let differs = refined.iter().any(|run| run.ends_otherwise(&base));
        let why_none = if base.end.lost || counted.is_empty() {
            Some(base.end.why.clone())
        } else if differs {
            Some("other runs end otherwise".to_owned())
        } else {
            let missing = counted.iter().find(|(_, runs)| runs.is_empty());
            missing.map(|(direction, _)| format!("no run with finer {} came to its end", direction.label()))
        };
        let numbers = base.numbers.iter().map(|number| match &why_none {
            Some(why) => number.without_bar(why),
            None => number.with_bar(&counted, tolerance, estimate),
        });
        let band = |curve: fn(&Outcome) -> &[(f64, f64)]| {
            let finer =
                counted.iter().map(|(direction, runs)| (*direction, runs.iter().map(|run| curve(run)).collect()));
            let finer: Vec<(Direction, Vec<_>)> = finer.collect();
            Band::around(curve(&base), &finer, estimate).filter(|_| why_none.is_none())
        };
        let (numbers, load, thickness) = (numbers.collect(), band(|run| &run.load), band(|run| &run.thickness));
        let notes = notes(&base, &refined);
        refined.insert(0, base);
        Self { numbers, notes, outcomes: refined, load, thickness }
    }

    /// Finer run that came to another end, for a reason of the part's.
    fn finer_that_ends_otherwise(&self) -> Option<&Outcome> {
        let (base, refined) = self.outcomes.split_first()?;
        refined.iter().find(|run| run.times > 1.0 && run.ends_otherwise(base))
    }

    /// Number by its origin and key.
    pub fn number(&self, origin: Origin, key: &str) -> Option<&Number> {
        self.numbers.iter().find(|number| number.origin == origin && number.quantity.key == key)
    }
}

/// Sentences on runs that do not count or end otherwise, and on elements that are too short.
fn notes(base: &Outcome, refined: &[Outcome]) -> Vec<String> {
    let finer = |run: &Outcome| run.direction.map_or_else(String::new, |direction| direction.text(run.times));
    let lost = refined.iter().filter(|run| run.end.lost);
    let lost = lost.map(|run| format!("with {} the run does not count: {}", finer(run), run.end.why));
    let other = refined.iter().filter(|run| run.ends_otherwise(base));
    let other = other
        .map(|run| format!("with {} the run ends otherwise: {}; as it is: {}", finer(run), run.end.why, base.end.why));
    let own = base.end.lost.then(|| base.end.why.clone());
    own.into_iter().chain(lost).chain(other).chain(below_shell_length(base, refined)).collect()
}

fn below_shell_length(base: &Outcome, refined: &[Outcome]) -> Option<String> {
    let is_short = |run: &&Outcome| run.shortest < SHELL_LENGTH;
    let short = || refined.iter().filter(is_short);
    short().find(|run| run.times > 1.0)?;
    let shortest = short().chain([base]).map(|run| run.shortest).fold(f64::INFINITY, f64::min);
    let own = if is_short(&base) { "as it is".to_owned() } else { String::new() };
    let levels = short().filter(|run| run.direction == Some(Direction::Elements));
    let levels = levels.map(|run| Direction::Elements.text(run.times));
    Some(format!(
        "elements are shorter than the sheet is thick, down to {}: {}. A shell resolves nothing shorter, and the solver gives \
         each the mean section of {}",
        Amount::thicknesses(shortest),
        joined([own].into_iter().chain(levels), ", "),
        Amount::given_thicknesses(NEIGHBOURHOOD)
    ))
}
