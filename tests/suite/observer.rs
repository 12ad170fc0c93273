//! What an observer sees of a run and can do to it, and that the solver allocates nothing while it iterates.

use crate::common::prelude::*;
use stampflow::model::ContactMethod;
use stampflow::plot::{Extra, FrameRecorder};
use stampflow::solver::trace::{TraceRequest, trace};
use std::{alloc::GlobalAlloc, alloc::Layout, alloc::System, cell::Cell};

thread_local! {
    /// Allocations of this thread.
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

struct Counted;

// SAFETY: every call goes to the system's allocator as it is.
unsafe impl GlobalAlloc for Counted {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.set(ALLOCATIONS.get() + 1);
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, at: *mut u8, layout: Layout) {
        unsafe { System.dealloc(at, layout) }
    }
}

#[global_allocator]
static COUNTED: Counted = Counted;

/// Quickstart's cup, a tenth of it.
fn cup() -> Model {
    let mut model = shipped::shipped("quickstart", &[]);
    let travel = 0.1 * model.travel;
    drive_to(&mut model, travel);
    model
}

/// Counts what is allocated from one iteration of a try to the next.
#[derive(Default)]
struct Allocations {
    last: Option<(IterationRecord, usize)>,
    compared: usize,
}

impl Observer for Allocations {
    fn iteration(&mut self, iterate: &stampflow::solver::Iterate) {
        let record = &iterate.record();
        let now = ALLOCATIONS.get();
        if let Some((last, before)) = self.last.filter(|(last, _)| last.step == record.step)
            && record.iteration > last.iteration
        {
            assert_eq!(now - before, 0, "allocated in iteration {} of step {}", record.iteration, record.step);
            self.compared += 1;
        }
        self.last = Some((*record, ALLOCATIONS.get()));
    }
}

/// Trust: every allocation of the thread is counted.
#[test]
fn an_iteration_allocates_nothing() {
    const STEEL: Elastic = Elastic { young: 206_000.0, poisson: 0.3 };
    type Change = fn(&mut Model);
    let changes: [(&str, Change); 4] = [
        ("primal-dual", |_| {}),
        ("secant", |m| m.settings.iteration = Iteration::Secant),
        ("augmented Lagrangian", |m| m.settings.contact = ContactMethod::AugmentedLagrangian),
        ("elastoplastic", |m| (m.mode, m.material.elastic) = (Mode::ElastoViscoplastic, Some(STEEL))),
    ];
    for (name, change) in changes {
        let mut model = cup();
        change(&mut model);
        let mut seen = Allocations::default();
        let run = solver::run(&model, &mut seen);
        assert!(run.stop.is_complete(), "{name}: {}", run.stop);
        assert!(seen.compared > run.steps.len(), "{name}: {} pairs of iterations", seen.compared);
    }
}

/// Ends a run after so many steps and iterations.
pub struct Stopper {
    pub steps: usize,
    pub iterations: usize,
}

impl Observer for Stopper {
    fn step(&mut self, _record: &StepRecord) {
        self.steps -= 1;
    }
    fn iteration(&mut self, iterate: &stampflow::solver::Iterate) {
        self.iterations -= usize::from(iterate.record().iteration > 0);
    }
    fn wants_to_stop(&mut self) -> bool {
        self.steps == 0 || self.iterations == 0
    }
}

/// Trust: the same program on the same numbers, so what was computed is the beginning of the whole run bit for bit.
#[test]
fn an_interrupted_run_keeps_what_it_has_computed() {
    let model = cup();
    let whole = solver::run(&model, &mut ());
    assert!(whole.stop.is_complete(), "{}", whole.stop);
    let of_steps = |n: usize| whole.steps[..n].iter().map(|step| step.iterations).sum::<usize>();
    let check = |run: StageSolution, steps: usize| {
        assert!(!run.stop.is_complete() && !run.stop.is_physical() && run.stop.kind == StopKind::Interrupted);
        assert_eq!(run.steps, whole.steps[..steps]);
        assert_eq!(run.frames.last().map(|frame| frame.time), run.steps.last().map(|step| step.time));
    };
    check(solver::run(&model, &mut Stopper { steps: 5, iterations: usize::MAX }), 5);
    // In the middle of the fourth step, and of the first.
    check(solver::run(&model, &mut Stopper { steps: usize::MAX, iterations: of_steps(3) + 2 }), 3);
    check(solver::run(&model, &mut Stopper { steps: usize::MAX, iterations: 1 }), 0);
}

struct Seen {
    recorder: FrameRecorder,
    steps: Vec<StepRecord>,
    iterations: Vec<IterationRecord>,
    states: Vec<f64>,
    restarts: usize,
}

impl Observer for Seen {
    fn step(&mut self, record: &StepRecord) {
        self.steps.push(*record);
    }
    fn state(&mut self, model: &Model, state: &State) {
        self.states.push(state.time);
        self.recorder.state(model, state);
    }
    fn iteration(&mut self, iterate: &stampflow::solver::Iterate) {
        self.iterations.push(iterate.record());
    }
    fn restart(&mut self, model: &Model, state: &State, step: usize) {
        self.restarts += 1;
        self.steps.truncate(step);
        self.states.truncate(step + 1);
        self.iterations.retain(|row| row.step <= step);
        self.recorder.restart(model, state, step);
    }
}

/// Trust: the results of the run; its last stretch is lost and taken with other settings.
#[test]
fn an_observer_sees_a_remedied_run_as_its_results_have_it() {
    let case = loaded("tests/suite/stops/w_bend.toml", &["blank.elements=36", "tools.punch.travel=36.8 mm"]);
    let recorder = FrameRecorder::new(vec![Extra::Vtu]);
    let mut seen = Seen { recorder, steps: vec![], iterations: vec![], states: vec![], restarts: 0 };
    let run = &solver::solve(&case.stages, &mut seen)[0];
    assert!(seen.restarts > 0 && seen.restarts == run.remedied.len());
    assert_eq!(seen.steps, run.steps);
    let times: Vec<f64> = run.steps.iter().map(|step| step.time).collect();
    assert_eq!(seen.states[1..], times);
    let frames: Vec<f64> = seen.recorder.of_stage(0, run).iter().map(|frame| frame.time).collect();
    assert!(frames.is_sorted_by(|a, b| a < b) && frames[1..].iter().all(|time| times.contains(time)), "{frames:?}");
    let of_step = |n: usize| seen.iterations.iter().filter(move |row| row.step == n);
    assert!(run.steps.iter().all(|step| of_step(step.step).count() >= step.iterations));
    let last = run.steps[run.steps.len() - 1];
    let request = TraceRequest { stage: 1, step: last.step, matrices: vec![], tolerance: None };
    let traced = trace(&case.stages, &request, &mut ()).expect("a step");
    let end = traced.histories[0].end.as_ref().expect("equilibrium");
    assert_eq!((traced.record, end.time), (last, last.time));
}
