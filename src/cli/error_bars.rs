//! Error bars beside a run: the options that ask for them, and how far the runs for them have come.

use super::interrupt;
use super::progress::{PATIENCE, Progress};
use super::say::warn;
use indicatif::{ProgressBar, ProgressStyle};
use stampflow::case::Solution;
use stampflow::files::visible;
use stampflow::verification::{Verification, Watch, quick, verify};
use std::sync::Mutex;
use std::time::Instant;

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
            Self { error_bars: true, .. } => Some(verify(solution, &Refining::of(&solution.case.name, progress))),
            Self { no_error_bars: false, .. } if usual => Some(quick(solution, &Refining::silent())),
            _ => None,
        }
    }
}

/// Watches the finer runs of a case; Ctrl-C ends all of them.
pub struct Refining {
    name: String,
    shown: Shown,
}

enum Shown {
    Bar(ProgressBar),
    /// When the last line was written.
    Lines(Mutex<Instant>),
    Nothing,
}

impl Refining {
    /// Shown as the run itself.
    pub fn of(name: &str, progress: &Progress) -> Self {
        let shown = match progress {
            Progress::Bars(all) => {
                let bar = ProgressBar::new(1).with_style(style()).with_prefix(visible(name).into_owned());
                Shown::Bar(all.add(bar))
            }
            Progress::Lines => Shown::Lines(Mutex::new(Instant::now())),
            Progress::Silent => Shown::Nothing,
        };
        Self { name: name.to_owned(), shown }
    }

    fn silent() -> Self {
        Self { name: String::new(), shown: Shown::Nothing }
    }
}

impl Watch for Refining {
    fn wants_to_stop(&self) -> bool {
        interrupt::is_wanted()
    }

    fn ran(&self, done: usize, all: usize) {
        match &self.shown {
            Shown::Bar(bar) => {
                bar.set_length(all as u64);
                bar.set_position(done as u64);
                if done == all {
                    bar.finish();
                }
            }
            Shown::Lines(last) => {
                // A thread that panicked has left a time behind, and that is all there is to it.
                let mut last = last.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
                if done == all || last.elapsed() >= PATIENCE {
                    *last = Instant::now();
                    warn(format!("{}: error bars, {done} of {all} finer runs", self.name));
                }
            }
            Shown::Nothing => {}
        }
    }
}

fn style() -> ProgressStyle {
    ProgressStyle::with_template("{prefix:>16} {bar:24.cyan} {pos} of {len} finer runs").expect("the template is valid")
}
