//! Progress of runs: bars on the error stream where that is a terminal, gone at the end; else nothing.

use super::*;
use indicatif::{MultiProgress, ProgressBar, ProgressDrawTarget, ProgressStyle};
use stampflow::{Observer, Stage, State, solver::Iterate};

const FULL: f64 = 1000.0;
const DELAY: Duration = Duration::from_millis(400);

pub struct Progress(MultiProgress);

pub struct Count(ProgressBar);

/// Observer of one run: shows its progress, keeps frames, and iterations if there is a list of them.
pub struct Watch {
    pub trace: Option<Vec<Vec<IterationRecord>>>,
    pub recorder: FrameRecorder,
    names: std::vec::IntoIter<String>,
    model: Model,
    bar: ProgressBar,
}

impl Progress {
    pub fn new(quiet: bool) -> Self {
        let target = if quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
        let bars = MultiProgress::with_draw_target(ProgressDrawTarget::hidden());
        let shown = bars.clone();
        std::thread::spawn(move || {
            std::thread::sleep(DELAY);
            shown.set_draw_target(target);
        });
        Self(bars)
    }

    pub fn watch(&self, case: &Case) -> Watch {
        let names: Vec<String> = (0..).map_while(|i| Some(format!("{}/{}", case.name, case.stage_label(i)?))).collect();
        let (names, model, bar) = (names.into_iter(), case.model().clone(), self.bar(&case.name));
        Watch { trace: None, recorder: FrameRecorder::default(), names, model, bar }
    }

    pub fn count(&self, name: String) -> Count {
        Count(self.bar(&name))
    }

    fn bar(&self, name: &str) -> ProgressBar {
        let style = ProgressStyle::with_template("{spinner} {prefix:>16} {bar:24.cyan} {percent:>3} % {msg}");
        let bar = self.0.add(ProgressBar::new(FULL as u64)).with_style(style.expect("the template is valid"));
        let bar = bar.with_prefix(visible(name).into_owned()).with_message("solving …");
        bar.enable_steady_tick(DELAY / 4);
        bar
    }
}

impl stampflow::study::Watch for Count {
    fn wants_to_stop(&self) -> bool {
        is_interrupted()
    }

    fn ran(&self, done: usize, all: usize) {
        self.0.set_length(all as u64);
        self.0.set_position(done as u64);
        self.0.set_message(format!("{done} of {all}, {} s left", self.0.eta().as_secs()));
    }
}

impl Watch {
    pub fn solve(&mut self, case: Case) -> Solution {
        let begin = Instant::now();
        let mut solution = case.solve(self);
        solution.wall = Some(begin.elapsed());
        solution
    }
}

impl Observer for Watch {
    fn step(&mut self, record: &StepRecord) {
        let StepRecord { step, travel, punch_force, pole_height, pressure, .. } = *record;
        let unit = self.model.extent().force_unit().symbol();
        let load = match (travel > 0.0, pressure != 0.0) {
            (true, _) => format!("travel {travel:.2} mm, force {punch_force:.0} {unit}, "),
            (_, true) => format!("height {pole_height:.2} mm, pressure {pressure:.3} MPa, "),
            _ => String::new(),
        };
        let left = 100.0 * record.thinnest / self.model.blank.thickness;
        self.bar.set_message(format!("{load}step {step}, {left:.0} % of the thickness left at the thinnest"));
        self.bar.set_position((record.time / self.model.duration * FULL).round() as u64);
    }

    fn restart(&mut self, model: &Model, state: &State, step: usize) {
        let rows = self.trace.iter_mut().flat_map(|trace| trace.last_mut());
        rows.for_each(|rows| rows.truncate(rows.partition_point(|row| row.step <= step)));
        self.recorder.restart(model, state, step);
    }

    fn stage(&mut self, stage: &Stage) {
        self.trace.iter_mut().for_each(|trace| trace.push(Vec::new()));
        self.model = stage.model.clone();
        self.names.next().iter().for_each(|name| self.bar.set_prefix(visible(name).into_owned()));
    }

    fn iteration(&mut self, iterate: &Iterate) {
        self.trace.iter_mut().flat_map(|trace| trace.last_mut()).for_each(|rows| rows.push(iterate.record()));
    }

    fn wants_to_stop(&mut self) -> bool {
        is_interrupted()
    }

    fn state(&mut self, model: &Model, state: &State) {
        self.recorder.state(model, state);
    }
}
