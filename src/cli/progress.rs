//! How far runs have come: bars on a terminal, a line every few seconds elsewhere, or nothing.

use super::interrupt;
use super::say::warn;
use indicatif::{MultiProgress, ProgressBar, ProgressStyle};
use stampflow::case::files::visible;
use stampflow::case::{Case, Solution};
use stampflow::model::Model;
use stampflow::results::FrameRecorder;
use stampflow::solver::solution::{IterationRecord, StepRecord};
use stampflow::study::verify as verification;
use stampflow::{Observer, Stage, State};
use std::io::{self, IsTerminal};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Ticks of a bar for the whole travel.
const FULL: u64 = 1000;
/// Time between two lines of progress; the end of a run has one of its own.
const PATIENCE: Duration = Duration::from_secs(3);

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
    /// The last accepted step.
    last: StepRecord,
    shown: Shown,
    kept: Kept,
}

/// Counts many runs.
pub struct Count {
    name: String,
    shown: Mutex<Shown>,
    begin: Instant,
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
    /// When the last line was written.
    Lines(Instant),
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
            Self::Lines => Shown::Lines(Instant::now()),
            Self::Silent => Shown::Nothing,
        };
        let labels = (0..).map_while(|i| case.stage_label(i));
        let force_unit = model.extent().force_unit().symbol();
        Watch {
            name: name.clone(),
            to_come: labels.map(|label| format!("{name}/{label}")).collect::<Vec<_>>().into_iter(),
            duration: model.duration,
            thickness: model.blank.thickness,
            force_unit,
            last: StepRecord { thinnest: model.blank.thickness, ..StepRecord::default() },
            shown,
            kept,
        }
    }
}

impl Progress {
    /// Counts many runs, of that name.
    pub fn count(&self, name: String) -> Count {
        let shown = match self {
            Self::Bars(all) => {
                let bar = ProgressBar::new(FULL).with_style(style()).with_prefix(visible(&name).into_owned());
                Shown::Bar(all.add(bar))
            }
            Self::Lines => Shown::Lines(Instant::now()),
            Self::Silent => Shown::Nothing,
        };
        Count { name, shown: Mutex::new(shown), begin: Instant::now() }
    }
}

impl verification::Watch for Count {
    fn wants_to_stop(&self) -> bool {
        interrupt::is_wanted()
    }

    fn ran(&self, done: usize, all: usize) {
        // A panic of another thread is told by that one.
        let Ok(mut shown) = self.shown.lock() else { return };
        let left = self.begin.elapsed().mul_f64((all - done) as f64 / done.max(1) as f64).as_secs();
        match &mut *shown {
            Shown::Bar(bar) if done == all => bar.finish(),
            Shown::Bar(bar) => {
                bar.set_message(format!("{done} of {all} runs, {left} s left"));
                bar.set_position(FULL * done as u64 / all as u64);
            }
            Shown::Lines(last) if last.elapsed() >= PATIENCE => {
                *last = Instant::now();
                warn(format!("{}: {done} of {all} runs, {left} s left", self.name));
            }
            Shown::Lines(_) | Shown::Nothing => {}
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

    /// Share of the stage's time that is done, but for round-off \[–\].
    fn done(&self) -> f64 {
        self.last.time / self.duration + 1e-9
    }

    /// What the last accepted step came to.
    fn reached(&self) -> String {
        let record = &self.last;
        let load = if record.travel > 0.0 {
            format!("travel {:.2} mm, force {:.0} {}, ", record.travel, record.punch_force, self.force_unit)
        } else if record.pressure != 0.0 {
            format!("height {:.2} mm, pressure {:.3} MPa, ", record.pole_height, record.pressure)
        } else {
            String::new()
        };
        let left = 100.0 * record.thinnest / self.thickness;
        format!("{load}step {}, {left:.0} % of the thickness left at the thinnest", record.step)
    }

    /// Writes a line where it is time for one, or the stage `is_over`.
    fn tell(&mut self, is_over: bool) {
        let Shown::Lines(last) = &mut self.shown else { return };
        if is_over || last.elapsed() >= PATIENCE {
            *last = Instant::now();
            warn(format!("{}: {:.0} %, {}", self.name, (100.0 * self.done()).floor(), self.reached()));
        }
    }
}

impl Observer for Watch {
    fn step(&mut self, record: &StepRecord) {
        self.last = *record;
        let done = self.done();
        if let Shown::Bar(bar) = &self.shown {
            bar.set_message(self.reached());
            bar.set_position((done * FULL as f64) as u64);
        }
        self.tell(done >= 1.0);
    }

    fn stage(&mut self, stage: &Stage) {
        let Some(name) = self.to_come.next() else { return };
        self.duration = stage.model.duration;
        self.name = name;
        self.last = StepRecord { thinnest: self.last.thinnest, ..StepRecord::default() };
        if let Shown::Bar(bar) = &self.shown {
            bar.set_prefix(visible(&self.name).into_owned());
            bar.set_position(0);
        }
    }

    fn iteration(&mut self, record: &IterationRecord, _: &stampflow::solver::Iterate) {
        if let Some(trace) = &mut self.kept.trace {
            trace.push(*record);
        }
        // Also while no step is accepted.
        self.tell(false);
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
