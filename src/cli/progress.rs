//! Progress of runs on the error stream: bars on a terminal, a line every few seconds elsewhere, or nothing.

use super::interrupt;
use super::screen::warn;
use indicatif::{MultiProgress, ProgressBar, ProgressDrawTarget, ProgressStyle};
use stampflow::case::files::visible;
use stampflow::case::{Case, Solution};
use stampflow::model::Model;
use stampflow::plot::FrameRecorder;
use stampflow::solver::Iterate;
use stampflow::solver::solution::{IterationRecord, StepRecord};
use stampflow::study;
use stampflow::{Observer, Stage, State};
use std::io::{self, IsTerminal};
use std::sync::Mutex;
use std::time::{Duration, Instant};

/// Ticks of a full bar.
const FULL: f64 = 1000.0;
/// Time between two lines of progress.
const INTERVAL: Duration = Duration::from_secs(3);

/// Form of progress.
pub struct Progress {
    /// Drawn on a terminal only.
    bars: MultiProgress,
    has_lines: bool,
}

/// Progress of one run or of one count of runs.
struct Meter {
    name: String,
    bar: ProgressBar,
    has_lines: bool,
    last_line: Instant,
}

/// Observer of one run: shows its progress and records what is asked for.
pub struct Watch {
    /// Names of the stages to come.
    to_come: std::vec::IntoIter<String>,
    duration: f64,
    thickness: f64,
    force_unit: &'static str,
    last: StepRecord,
    meter: Meter,
    records: Records,
}

/// Progress of many runs.
pub struct Count {
    meter: Mutex<Meter>,
    begin: Instant,
}

/// Records of a run, each where it is asked for.
#[derive(Clone, Debug, Default)]
pub struct Records {
    pub trace: Option<Vec<IterationRecord>>,
    pub recorder: FrameRecorder,
}

impl Progress {
    pub fn new(quiet: bool) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let has_lines = !quiet && !io::stderr().is_terminal();
        Self { bars: MultiProgress::with_draw_target(target), has_lines }
    }

    /// An observer of the run of a case.
    pub fn watch(&self, case: &Case, records: Records) -> Watch {
        let (name, model) = (&case.name, case.model());
        let stages: Vec<String> = (0..).map_while(|i| Some(format!("{name}/{}", case.stage_label(i)?))).collect();
        Watch {
            to_come: stages.into_iter(),
            duration: model.duration,
            thickness: model.blank.thickness,
            force_unit: model.extent().force_unit().symbol(),
            last: StepRecord { thinnest: model.blank.thickness, ..StepRecord::default() },
            meter: self.meter(name.clone()),
            records,
        }
    }

    /// A count of many runs.
    pub fn count(&self, name: String) -> Count {
        Count { meter: Mutex::new(self.meter(name)), begin: Instant::now() }
    }

    fn meter(&self, name: String) -> Meter {
        let style = ProgressStyle::with_template("{prefix:>16} {bar:24.cyan} {percent:>3} % {msg}");
        let bar = self.bars.add(ProgressBar::new(FULL as u64));
        let bar = bar.with_style(style.expect("the template is valid"));
        Meter { name, bar, has_lines: self.has_lines, last_line: Instant::now() }
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

impl study::Watch for Count {
    fn wants_to_stop(&self) -> bool {
        interrupt::is_wanted()
    }

    fn ran(&self, done: usize, all: usize) {
        // A poisoned lock is a panic of another thread, which reports it.
        let Ok(mut meter) = self.meter.lock() else { return };
        let left = self.begin.elapsed().mul_f64((all - done) as f64 / done.max(1) as f64).as_secs();
        meter.show(done as f64 / all as f64, false, format!("{done} of {all} runs, {left} s left"));
        if done == all {
            meter.bar.finish();
        }
    }
}

impl Watch {
    /// Runs all stages of a case and takes the time.
    pub fn solve(mut self, case: Case) -> (Solution, Records) {
        let start = Instant::now();
        let mut solution = case.solve(&mut self);
        solution.wall = Some(start.elapsed());
        if solution.is_complete() {
            self.meter.bar.finish();
        } else {
            self.meter.bar.abandon();
        }
        (solution, self.records)
    }

    fn show(&mut self, is_step: bool) {
        let (record, unit) = (&self.last, self.force_unit);
        let load = if record.travel > 0.0 {
            format!("travel {:.2} mm, force {:.0} {unit}, ", record.travel, record.punch_force)
        } else if record.pressure != 0.0 {
            format!("height {:.2} mm, pressure {:.3} MPa, ", record.pole_height, record.pressure)
        } else {
            String::new()
        };
        let left = 100.0 * record.thinnest / self.thickness;
        // Round-off would leave the last step at 99 %.
        let share = record.time / self.duration + 1e-9;
        let message = format!("{load}step {}, {left:.0} % of the thickness left at the thinnest", record.step);
        self.meter.show(share, is_step && share >= 1.0, message);
    }
}

impl Observer for Watch {
    fn step(&mut self, record: &StepRecord) {
        self.last = *record;
        self.show(true);
    }

    fn stage(&mut self, stage: &Stage) {
        let Some(name) = self.to_come.next() else { return };
        self.duration = stage.model.duration;
        self.meter.name = name;
        self.last = StepRecord { thinnest: self.last.thinnest, ..StepRecord::default() };
    }

    fn iteration(&mut self, iterate: &Iterate) {
        if let Some(trace) = &mut self.records.trace {
            trace.push(iterate.record());
        }
        // Also while no step is accepted.
        if self.meter.has_lines {
            self.show(false);
        }
    }

    fn wants_to_stop(&mut self) -> bool {
        interrupt::is_wanted()
    }

    fn state(&mut self, model: &Model, state: &State) {
        self.records.recorder.state(model, state);
    }
}
