//! Error bars beside a run: the options that ask for them.

use super::progress::Progress;
use stampflow::case::Solution;
use stampflow::study::verify::{Verification, quick, verify};

/// The options of every verb that answers from a run.
#[derive(Debug, clap::Args)]
pub struct ErrorBars {
    /// Tell every number with its error bar from finer runs, as `stampflow verify`: mesh, points, steps and contact
    /// refined each on its own, twice and four times
    #[arg(long)]
    pub error_bars: bool,
    /// Tell no error bars: solve no coarser run for their quick estimate
    #[arg(long, conflicts_with = "error_bars")]
    no_error_bars: bool,
}

impl ErrorBars {
    /// Of a solved case: from finer runs where they are asked for, else from one coarser run where that is `usual`.
    pub fn of(&self, solution: &Solution, progress: &Progress, usual: bool) -> Option<Verification> {
        match self {
            Self { error_bars: true, .. } => {
                Some(verify(solution, &progress.count(format!("{}, finer", solution.case.name))))
            }
            Self { no_error_bars: false, .. } if usual => Some(quick(solution, &Progress::Silent.count(String::new()))),
            _ => None,
        }
    }
}
