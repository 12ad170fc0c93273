//! How far runs have come: bars on a terminal, a line for every tenth of the travel elsewhere, or nothing.

use super::interrupt;
use super::say::warn;
use indicatif::{MultiProgress, ProgressBar, ProgressStyle};
use stampflow::case::{Case, Solution};
use stampflow::files::visible;
use stampflow::model::Model;
use stampflow::output::FrameRecorder;
use stampflow::solution::{IterationRecord, StepRecord};
use stampflow::table::force_unit;
use stampflow::{Observer, Stage, State};
use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};

/// Ticks of a bar for the whole travel.
const FULL: u64 = 1000;
/// Least time between two lines of progress.
const PATIENCE: Duration = Duration::from_secs(1);

/// Where progress is shown; always on the error stream, so that results can be piped.
pub enum Progress {
    Bars(MultiProgress),
    Lines,
    Silent,
}

/// Watches one run.
pub struct Watch {
    name: String,
    /// What results of the stages to come are called; nothing in a case of one stage.
    to_come: std::vec::IntoIter<String>,
    duration: f64,
    thickness: f64,
    force_unit: &'static str,
    shown: Shown,
    kept: Kept,
}

/// What a watch keeps, each where it is asked for.
#[derive(Clone, Debug, Default)]
pub struct Kept {
    /// Every iteration.
    pub trace: Option<Vec<IterationRecord>>,
    /// Frames for what is asked for of the moving section.
    pub recorder: FrameRecorder,
}

enum Shown {
    Bar(ProgressBar),
    /// Tenths of the travel that were announced, and when.
    Lines(u64, Instant),
    Nothing,
}

impl Progress {
    /// Bars where a human looks on, lines where a file does, nothing when `quiet`.
    pub fn new(quiet: bool) -> Self {
        match quiet {
            true => Self::Silent,
            false if io::stderr().is_terminal() => Self::Bars(MultiProgress::new()),
            false => Self::Lines,
        }
    }

    /// A watch over the run of a case, and what it keeps.
    pub fn watch(&self, case: &Case, kept: Kept) -> Watch {
        let (name, model) = (&case.name, case.model());
        let shown = match self {
            Self::Bars(all) => {
                let bar = ProgressBar::new(FULL).with_style(style()).with_prefix(visible(name).into_owned());
                Shown::Bar(all.add(bar))
            }
            Self::Lines => Shown::Lines(0, Instant::now()),
            Self::Silent => Shown::Nothing,
        };
        let labels = (0..).map_while(|i| case.stage_label(i));
        let force_unit = force_unit(model.geometry).symbol();
        Watch {
            name: name.clone(),
            to_come: labels.map(|label| format!("{name}/{label}")).collect::<Vec<_>>().into_iter(),
            duration: model.duration,
            thickness: model.blank.thickness,
            force_unit,
            shown,
            kept,
        }
    }
}

impl Watch {
    /// Runs all stages of a case against the clock; also what was kept.
    pub fn solve(mut self, case: Case) -> (Solution, Kept) {
        let start = Instant::now();
        let mut solution = case.solve(&mut self);
        solution.wall = Some(start.elapsed());
        if let Shown::Bar(bar) = self.shown {
            if solution.is_complete() { bar.finish() } else { bar.abandon() }
        }
        (solution, self.kept)
    }
}

impl Observer for Watch {
    fn step(&mut self, record: &StepRecord) {
        let done = record.time / self.duration;
        let load = if record.travel > 0.0 {
            format!("travel {:.2} mm, force {:.0} {}", record.travel, record.punch_force, self.force_unit)
        } else if record.pressure != 0.0 {
            format!("height {:.2} mm, pressure {:.3} MPa", record.pole_height, record.pressure)
        } else {
            format!("time {:.2} s", record.time)
        };
        let state = format!(
            "{load}, step {}, {:.0} % of the thickness left at the thinnest",
            record.step,
            100.0 * record.thinnest / self.thickness
        );
        match &mut self.shown {
            Shown::Bar(bar) => {
                bar.set_message(state);
                bar.set_position((done * FULL as f64) as u64);
            }
            Shown::Lines(tenths, last) => {
                let now = (10.0 * done + 1e-9) as u64;
                if now > *tenths && (now == 10 || last.elapsed() >= PATIENCE) {
                    (*tenths, *last) = (now, Instant::now());
                    warn(format!("{}: {} %, {state}", self.name, 10 * now));
                }
            }
            Shown::Nothing => {}
        }
    }

    fn stage(&mut self, stage: &Stage) {
        let Some(name) = self.to_come.next() else { return };
        self.duration = stage.model.duration;
        self.name = name;
        match &mut self.shown {
            Shown::Bar(bar) => {
                bar.set_prefix(visible(&self.name).into_owned());
                bar.set_position(0);
            }
            Shown::Lines(tenths, _) => *tenths = 0,
            Shown::Nothing => {}
        }
    }

    fn iteration(&mut self, record: &IterationRecord) {
        if let Some(trace) = &mut self.kept.trace {
            trace.push(*record);
        }
    }

    fn wants_to_stop(&mut self) -> bool {
        interrupt::is_wanted()
    }

    fn state(&mut self, model: &Model, state: &State) {
        self.kept.recorder.state(model, state);
    }
}

fn style() -> ProgressStyle {
    ProgressStyle::with_template("{prefix:>16} {bar:24.cyan} {percent:>3} % {msg}").expect("the template is valid")
}
