//! Error bars of a run, and the options that choose them.

use super::progress::Progress;
use stampflow::case::Solution;
use stampflow::verification::{Verification, quick, verify};

#[derive(Debug, clap::Args)]
pub struct ErrorBars {
    /// Compute error bars from finer runs, as `stampflow verify`
    #[arg(long)]
    pub error_bars: bool,
    /// Give no error bars: skip the coarser run for their estimate
    #[arg(long, conflicts_with = "error_bars", hide_short_help = true)]
    no_error_bars: bool,
}

impl ErrorBars {
    /// Error bars from finer runs with `--error-bars`, else from one coarser run if that is the verb's `default`.
    pub fn of(&self, solution: &Solution, progress: &Progress, default: bool) -> Option<Verification> {
        if self.error_bars {
            return Some(verify(solution, &progress.count(format!("{}, finer", solution.case.name))));
        }
        (default && !self.no_error_bars).then(|| quick(solution, &Progress::Silent.count(String::new())))
    }
}
