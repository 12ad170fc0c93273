//! One step repeated: its iterations are those of the run, matrices start from the same state and come to the same answer,
//! each at its own rate; and the verb `trace`.

use crate::common::prelude::*;
use stampflow::solver::trace::{ConvergenceRate, Trace, TraceRequest, trace};

struct OfStep {
    step: usize,
    kept: Vec<IterationRecord>,
    is_over: bool,
}

impl Observer for OfStep {
    fn step(&mut self, record: &stampflow::StepRecord) {
        self.is_over = record.step == self.step;
    }

    fn iteration(&mut self, iterate: &stampflow::solver::Iterate) {
        let record = &iterate.record();
        self.kept.extend((record.step == self.step).then_some(*record));
    }

    fn wants_to_stop(&mut self) -> bool {
        self.is_over
    }
}

fn quickstart(step: usize, matrices: &[Iteration], tolerance: Option<f64>) -> Trace {
    let request = TraceRequest { stage: 1, step, matrices: matrices.to_vec(), tolerance };
    trace(&shipped_case("quickstart", &[]).stages, &request, &mut ()).unwrap_or_else(|error| panic!("{error}"))
}

/// Trust: the run itself, seen by another observer. The same operations, so that nothing but round-off may differ.
#[test]
fn a_step_is_repeated_as_the_run_took_it() {
    for (case, step) in [("quickstart", 1), ("quickstart", 23), ("strip_draw", 9), ("superplastic_dome", 5)] {
        let case = shipped_case(case, &[]);
        let mut seen = OfStep { step, kept: Vec::new(), is_over: false };
        stampflow::solve(&case.stages, &mut seen);
        let request = TraceRequest { stage: 1, step, matrices: vec![], tolerance: None };
        let traced = trace(&case.stages, &request, &mut ()).expect("a step");
        let [history] = traced.histories.as_slice() else { panic!("one history") };
        assert!(history.end.is_some() && traced.record.step == step, "{} {step}", case.name);
        // The tries of a step that was halved first come before it.
        for (found, expected) in history.rows.iter().zip(&seen.kept[seen.kept.len() - history.rows.len()..]) {
            assert_eq!((found.iteration, found.start), (expected.iteration, expected.start), "{} {step}", case.name);
            let norms = |row: &IterationRecord| [row.velocity_norm, row.residual_norm, row.share];
            for (found, expected) in norms(found).into_iter().zip(norms(expected)) {
                assert!((found - expected).abs() <= 1e-9 * expected, "{} {step}: {found} {expected}", case.name);
            }
        }
    }
}

/// Trust: theory of the three matrices. Newton's method is quadratic near the answer and the primal-dual matrix goes over
/// into it; the secant leaves a fixed share. The residual is the same in all, and so is the answer, to the tolerance.
#[test]
fn each_matrix_comes_to_the_same_answer_at_its_own_rate() {
    let traced = quickstart(40, &[Iteration::PrimalDual, Iteration::Newton], Some(1e-9));
    let slow = quickstart(40, &[Iteration::Secant], None);
    let moved =
        |a: &[Node], b: &[Node]| a.iter().zip(b).map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1])).fold(0.0, f64::max);
    let answers = traced.histories.iter().map(|history| history.end.as_ref().expect("an answer"));
    let answers: Vec<_> = answers.collect();
    let way = moved(&answers[0].nodes, &traced.before.nodes);
    for (history, answer) in traced.histories.iter().zip(&answers) {
        let first = &history.rows[0];
        assert_eq!((first.start, first.iteration), (solver::Start::Predictor, 0), "{:?}", history.matrix);
        assert_eq!(first.residual_norm, traced.histories[0].rows[0].residual_norm, "the same predictor");
        assert!(moved(&answer.nodes, &answers[0].nodes) < 1e-6 * way, "{:?}", history.matrix);
    }
    let [primal_dual, newton] = [0, 1].map(|i| traced.histories[i].rate().expect("three whole increments"));
    let secant = slow.histories[0].rate().expect("three whole increments");
    let order = |rate: ConvergenceRate| rate.order.expect("the asymptotic range");
    assert!((order(newton) - 2.0).abs() < 0.4, "{newton:?}");
    assert!(primal_dual.left < 0.1, "as fast at its end, though few iterations show no order: {primal_dual:?}");
    assert!((order(secant) - 1.0).abs() < 0.1 && secant.left > 0.3, "{secant:?}");
    // A geometric series leaves behind its last increment: 1e-5 of the velocities by left/(1 − left).
    let end = slow.histories[0].end.as_ref().expect("an answer");
    let left = 1e-5 * secant.left / (1.0 - secant.left);
    assert!(moved(&end.nodes, &answers[0].nodes) < 3.0 * left.max(1e-4) * way, "{left}");
    assert!(slow.histories[0].count() > 3 * traced.histories[1].count());
}

/// Trust: at rest nothing flows; the flange of a cup in mid-draw does, and lies between die and holder.
#[test]
fn cut_off_and_contact_are_counted() {
    let first = quickstart(1, &[], None);
    let begin = &first.histories[0].rows[0];
    assert_eq!((begin.start, begin.matrix), (solver::Start::Secant, Iteration::Secant));
    assert_eq!(begin.cut_off, first.before.thickness.len(), "a sheet at rest");
    let midst = quickstart(40, &[], None);
    let end = midst.histories[0].rows.last().expect("an answer");
    assert!(end.cut_off < midst.before.thickness.len() / 10 && end.touching > 20, "{end:?}");
    assert!(end.sticking < end.touching && end.velocity_norm > 0.0 && end.share == 1.0, "{end:?}");
    let iterate = midst.histories[0].iterates.last().expect("an answer");
    assert_eq!(iterate.contacts.len(), end.touching);
    // Every force of tools on the sheet: with the residual they are in balance along z but for what the edge holds.
    let sum: f64 = iterate.contacts.iter().map(|contact| contact.force[1]).sum();
    assert!(sum.abs() < 1e-3 * midst.record.punch_force, "{sum} of {}", midst.record.punch_force);
}

/// Trust: sequences by their definitions.
#[test]
fn the_order_of_a_sequence_is_found() {
    for (order, left, increments) in
        [(2.0, 0.0625, [0.5, 0.25, 0.0625, 0.003_906_25]), (1.0, 0.9, [1.0, 0.9, 0.81, 0.729])]
    {
        let rate = ConvergenceRate::new(&increments.map(Some)).expect("a rate");
        assert!((rate.order.expect("an order") - order).abs() < 1e-9 && (rate.left - left).abs() < 1e-9);
    }
    assert_eq!(ConvergenceRate::new(&[Some(1.0), None, Some(0.1), Some(0.01)]), None);
}
