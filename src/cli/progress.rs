//! Progress of runs on the error stream: bars on a terminal, a line every few seconds elsewhere, or nothing.

use super::*;
use indicatif::{MultiProgress, ProgressBar, ProgressDrawTarget, ProgressStyle};
use stampflow::case::Solution;
use stampflow::model::Model;
use stampflow::plot::FrameRecorder;
use stampflow::solver::Iterate;
use stampflow::solver::solution::{IterationRecord, StepRecord};
use stampflow::{Observer, Stage, State};
use std::io::{self, IsTerminal};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Ticks of a full bar.
const FULL: f64 = 1000.0;
/// Time between two lines of progress.
const INTERVAL: Duration = Duration::from_secs(3);

/// Form of progress: bars are drawn on a terminal only.
pub struct Progress {
    bars: MultiProgress,
    has_lines: bool,
}

/// Progress of one run, or of many.
pub struct Meter {
    name: String,
    bar: ProgressBar,
    has_lines: bool,
    begin: Instant,
    last_line: Instant,
}

/// Progress of many runs.
pub struct Count(Mutex<Meter>);

/// Observer of one run: shows its progress, keeps frames, and iterations if there is a list of them.
pub struct Watch {
    pub trace: Option<Vec<IterationRecord>>,
    pub recorder: FrameRecorder,
    /// Names of the stages to come, the next one last.
    to_come: Vec<String>,
    duration: f64,
    thickness: f64,
    force_unit: &'static str,
    last: StepRecord,
    meter: Meter,
}

impl Progress {
    pub fn new(quiet: bool) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let has_lines = !quiet && !io::stderr().is_terminal();
        Self { bars: MultiProgress::with_draw_target(target), has_lines }
    }

    /// An observer of the run of a case.
    pub fn watch(&self, case: &Case) -> Watch {
        let (name, Model { duration, blank, .. }) = (&case.name, case.model());
        let mut to_come: Vec<String> = (0..).map_while(|i| Some(format!("{name}/{}", case.stage_label(i)?))).collect();
        to_come.reverse();
        Watch {
            trace: None,
            recorder: FrameRecorder::default(),
            to_come,
            duration: *duration,
            thickness: blank.thickness,
            force_unit: case.model().extent().force_unit().symbol(),
            last: StepRecord { thinnest: blank.thickness, ..StepRecord::default() },
            meter: self.meter(name.clone()),
        }
    }

    /// A count of many runs.
    pub fn count(&self, name: String) -> Count {
        Count(Mutex::new(self.meter(name)))
    }

    fn meter(&self, name: String) -> Meter {
        let style = ProgressStyle::with_template("{prefix:>16} {bar:24.cyan} {percent:>3} % {msg}");
        let bar = self.bars.add(ProgressBar::new(FULL as u64)).with_style(style.expect("the template is valid"));
        Meter { name, bar, has_lines: self.has_lines, begin: Instant::now(), last_line: Instant::now() }
    }
}

impl Meter {
    /// Shows the share that is done; a line comes if it is time for one or `now`.
    fn show(&mut self, share: f64, now: bool, message: String) {
        if self.has_lines && (now || self.last_line.elapsed() >= INTERVAL) {
            self.last_line = Instant::now();
            warn(format!("{}: {:.0} %, {message}", self.name, (100.0 * share).floor()));
        }
        self.bar.set_prefix(visible(&self.name).into_owned());
        self.bar.set_message(message);
        self.bar.set_position((share * FULL) as u64);
    }
}

impl stampflow::study::Watch for Count {
    fn wants_to_stop(&self) -> bool {
        is_interrupted()
    }

    fn ran(&self, done: usize, all: usize) {
        // A poisoned lock is a panic of another thread, which reports it.
        let Ok(mut meter) = self.0.lock() else { return };
        let left = meter.begin.elapsed().mul_f64((all - done) as f64 / done.max(1) as f64).as_secs();
        meter.show(done as f64 / all as f64, false, format!("{done} of {all} runs, {left} s left"));
        if done == all {
            meter.bar.finish();
        }
    }
}

impl Watch {
    /// Runs all stages of a case and takes the time.
    pub fn solve(&mut self, case: Case) -> Solution {
        let mut solution = case.solve(self);
        solution.wall = Some(self.meter.begin.elapsed());
        let end = if solution.is_complete() { ProgressBar::finish } else { ProgressBar::abandon };
        end(&self.meter.bar);
        solution
    }

    fn show(&mut self, is_step: bool) {
        let StepRecord { travel, pressure, .. } = self.last;
        let load = match self.last {
            last if travel > 0.0 => {
                format!("travel {travel:.2} mm, force {:.0} {}, ", last.punch_force, self.force_unit)
            }
            last if pressure != 0.0 => format!("height {:.2} mm, pressure {pressure:.3} MPa, ", last.pole_height),
            _ => String::new(),
        };
        let left = 100.0 * self.last.thinnest / self.thickness;
        // Round-off would leave the last step at 99 %.
        let share = self.last.time / self.duration + 1e-9;
        let message = format!("{load}step {}, {left:.0} % of the thickness left at the thinnest", self.last.step);
        self.meter.show(share, is_step && share >= 1.0, message);
    }
}

impl Observer for Watch {
    fn step(&mut self, record: &StepRecord) {
        self.last = *record;
        self.show(true);
    }

    fn stage(&mut self, stage: &Stage) {
        let Some(name) = self.to_come.pop() else { return };
        (self.duration, self.meter.name) = (stage.model.duration, name);
        self.last = StepRecord { thinnest: self.last.thinnest, ..StepRecord::default() };
    }

    fn iteration(&mut self, iterate: &Iterate) {
        self.trace.iter_mut().for_each(|trace| trace.push(iterate.record()));
        // Also while no step is accepted.
        if self.meter.has_lines {
            self.show(false);
        }
    }

    fn wants_to_stop(&mut self) -> bool {
        is_interrupted()
    }

    fn state(&mut self, model: &Model, state: &State) {
        self.recorder.state(model, state);
    }
}
