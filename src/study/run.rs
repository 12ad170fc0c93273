//! Runs the designs of a study on all cores, and hands on what came of them in order.

use super::bars::Bars;
use super::plan::{Design, Designs};
use super::row::{Row, Solved};
use super::{StudyError, Subject, side_by_side};
use crate::case::Solution;
use crate::study::verify::Watch;
use std::time::Instant;

/// Runs designs by their indices on so many threads and hands each row to `each`, in the order of the indices. Once
/// `watch` wants to stop no row is handed on of which the run was cut short.
///
/// # Errors
/// The first that `each` returns, which ends the study.
pub fn run<E>(
    designs: &dyn Designs,
    indices: &[u64],
    threads: usize,
    bars: Bars,
    watch: &dyn Watch,
    each: impl FnMut(Row) -> Result<(), E>,
) -> Result<(), E> {
    side_by_side(indices, threads, watch, |index| one(designs.subject(), designs.design(*index), bars, watch), each)
}

/// What comes of the case as it stands, which says what columns the table has.
///
/// # Errors
/// When a mistake of this program ends it.
pub fn base(subject: &Subject, bars: Bars, watch: &dyn Watch) -> Result<Solved, StudyError> {
    let case = subject.case(&[])?;
    Subject::solution(case, watch)
        .map(|solution| bars.of(&solution, watch))
        .map_err(|why| StudyError::new(format!("the case as it stands cannot be run: {why}"), "try `stampflow check`"))
}

/// What comes of one design.
pub fn one(subject: &Subject, design: Design, bars: Bars, watch: &dyn Watch) -> Row {
    let start = Instant::now();
    let mut inputs = String::new();
    let result = subject.case(&design.settings).map_err(|error| error.to_string()).and_then(|case| {
        inputs = Subject::hash(&case);
        Subject::solution(case, watch).map(|solution| bars.of(&solution, watch))
    });
    Row { design, inputs, result, seconds: start.elapsed().as_secs_f64() }
}

impl Bars {
    fn of(self, solution: &Solution, watch: &dyn Watch) -> Solved {
        match self {
            Self::Without => Solved::of(solution),
            Self::Quick => Solved::with_bars(solution, watch),
        }
    }
}
