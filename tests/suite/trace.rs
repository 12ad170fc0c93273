//! One step taken apart: its iterations are those of the run, matrices start from the same state and come to the same answer,
//! each at its own rate; and the verbs `trace` and `page` as a user calls them.

use crate::common::cli::{CUP, STAGES, folder, stampflow, text};
use crate::common::shipped::shipped_case;
use stampflow::Observer;
use stampflow::model::Iteration;
use stampflow::solver::Start;
use stampflow::solver::solution::IterationRecord;
use stampflow::solver::trace::{Asked, NoSuchStep, Rate, Trace, trace};
use std::fs;

/// The iterations of the last try of a step, and the end of the run behind it.
struct OfStep {
    step: usize,
    kept: Vec<IterationRecord>,
    is_over: bool,
}

impl Observer for OfStep {
    fn step(&mut self, record: &stampflow::StepRecord) {
        self.is_over = record.step == self.step;
    }

    fn iteration(&mut self, record: &IterationRecord) {
        if record.step == self.step {
            if record.iteration == 1 {
                self.kept.clear();
            }
            self.kept.push(*record);
        }
    }

    fn wants_to_stop(&mut self) -> bool {
        self.is_over
    }
}

fn of_quickstart(step: usize, matrices: &[Iteration], tolerance: Option<f64>) -> Trace {
    let asked = Asked { step, matrices: matrices.to_vec(), tolerance, ..Asked::default() };
    trace(&shipped_case("quickstart", &[]).stages, &asked, &mut ()).unwrap_or_else(|error| panic!("{error}"))
}

/// Trust: the run itself, seen by another observer. The same operations, so that nothing but round-off may differ.
#[test]
fn a_step_is_taken_apart_as_the_run_took_it() {
    for (case, step) in [("quickstart", 1), ("quickstart", 23), ("strip_draw", 9), ("superplastic_dome", 5)] {
        let case = shipped_case(case, &[]);
        let mut seen = OfStep { step, kept: Vec::new(), is_over: false };
        stampflow::solve(&case.stages, &mut seen);
        let traced = trace(&case.stages, &Asked { step, ..Asked::default() }, &mut ()).expect("a step");
        let [way] = traced.ways.as_slice() else { panic!("one way") };
        assert!(way.converged && traced.record.step == step, "{} {step}", case.name);
        let pairs: Vec<_> = way.iterations().windows(2).collect();
        assert_eq!(pairs.len(), seen.kept.len(), "{} {step}", case.name);
        for (pair, of_run) in pairs.iter().zip(&seen.kept) {
            let found = [pair[1].velocity_norm.expect("one"), pair[0].residual_norm, pair[1].share.expect("one")];
            for (found, expected) in found.iter().zip([of_run.velocity_norm, of_run.residual_norm, of_run.cut]) {
                let what = format!("{} {step}, iteration {}: {found} {expected}", case.name, of_run.iteration);
                assert!((found - expected).abs() <= 1e-9 * expected, "{what}");
            }
        }
    }
}

/// Trust: theory of the three matrices. Newton's method is quadratic near the answer and the primal-dual matrix goes over
/// into it; the secant leaves a fixed share. The residual is the same in all, and so is the answer, to what each is told to
/// come down to.
#[test]
fn each_matrix_comes_to_the_same_answer_at_its_own_rate() {
    let traced = of_quickstart(40, &[Iteration::PrimalDual, Iteration::Newton], Some(1e-9));
    let slow = of_quickstart(40, &[Iteration::Secant], None);
    let first = &traced.ways[0].iterations()[0];
    let answers = traced.ways.iter().map(|way| way.iterations().last().expect("an answer"));
    let answers: Vec<_> = answers.collect();
    let moved = |a: &[[f64; 3]], b: &[[f64; 3]]| {
        a.iter().zip(b).map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1])).fold(0.0, f64::max)
    };
    let way = moved(&answers[0].nodes, &traced.before.nodes);
    for (way_of, answer) in traced.ways.iter().zip(&answers) {
        assert!(way_of.converged && way_of.attempts[0].start == Start::Predictor, "{:?}", way_of.matrix);
        assert_eq!(way_of.attempts[0].passes[0].iterated[0].nodes, first.nodes, "the same predictor");
        assert!(moved(&answer.nodes, &answers[0].nodes) < 1e-6 * way, "{:?}", way_of.matrix);
    }
    let [primal_dual, newton] = [0, 1].map(|i| traced.ways[i].rate().expect("three whole increments"));
    let secant = slow.ways[0].rate().expect("three whole increments");
    let order = |rate: Rate| rate.order.expect("the asymptotic range");
    assert!(newton.is_faster_than_linear() && (order(newton) - 2.0).abs() < 0.4, "{newton:?}");
    assert!(primal_dual.left < 0.1, "as fast at its end, though few iterations show no order: {primal_dual:?}");
    assert!((order(secant) - 1.0).abs() < 0.1 && secant.left > 0.3, "{secant:?}");
    // What a geometric series leaves behind its last increment: 1e-5 of the velocities by left/(1 − left).
    let end = slow.ways[0].iterations().last().expect("an answer");
    let left = 1e-5 * secant.left / (1.0 - secant.left);
    assert!(moved(&end.nodes, &answers[0].nodes) < 3.0 * left.max(1e-4) * way, "{left}");
    assert!(slow.ways[0].count() > 3 * traced.ways[1].count());
}

/// Trust: at rest nothing flows; the flange of a cup in mid-draw does, and lies between die and holder.
#[test]
fn cut_off_and_contact_are_counted() {
    let first = of_quickstart(1, &[], None);
    let Some(attempt) = first.ways[0].attempts.first() else { panic!("a try") };
    assert_eq!(attempt.start, Start::Secant);
    assert_eq!(attempt.passes[0].matrix, Iteration::Secant);
    let begin = &attempt.passes[0].iterated[0];
    assert_eq!(begin.cut_off(), first.before.thickness.len(), "a sheet at rest");
    let midst = of_quickstart(40, &[], None);
    let end = midst.ways[0].iterations().last().expect("an answer");
    assert!(end.cut_off() < midst.before.thickness.len() / 10 && end.touching.len() > 20, "{}", end.cut_off());
    // Every force of tools on the sheet: with the residual they are in balance along z but for what the edge holds.
    let sum: f64 = end.touching.iter().map(|point| point.force.y).sum();
    let largest = end.touching.iter().map(|point| point.force.norm()).fold(0.0, f64::max);
    assert!(sum.abs() < 1e-3 * largest.max(midst.record.punch_force), "{sum} of {}", midst.record.punch_force);
}

#[test]
fn a_step_that_is_not_there_says_how_many_there_are() {
    let case = shipped_case("quickstart", &["blank.elements=30", "tools.punch.travel=3 mm"]);
    let of = |stage, step| trace(&case.stages, &Asked { stage, step, ..Asked::default() }, &mut ()).unwrap_err();
    let NoSuchStep::Step { steps, .. } = of(1, 9999) else { panic!("a step") };
    assert!(of(1, steps + 1).to_string().contains(&format!("the run has {steps}")));
    assert!(trace(&case.stages, &Asked { step: steps, ..Asked::default() }, &mut ()).is_ok());
    assert!(matches!(of(1, 0), NoSuchStep::Step { .. }) && matches!(of(2, 1), NoSuchStep::Stage { stages: 1, .. }));
}

#[test]
fn the_verb_shows_a_table_a_plot_and_the_rate() {
    let dir = folder(&format!("{CUP}{STAGES}"));
    let run = |args: &[&str]| stampflow(dir.path(), &[&["trace", "cases/cup.toml"], args].concat());
    let one = run(&["--step", "5", "--out", "step.csv"]);
    let said = text(&one.stdout);
    assert!(one.status.success(), "{}", text(&one.stderr));
    assert!(
        said.contains("cup 1-draw, step 5") && said.contains("From the predictor") && said.contains("1e-5 ┤"),
        "{said}"
    );
    assert!(said.contains("In equilibrium after"), "{said}");
    assert!(said.lines().all(|line| line.chars().count() <= 80), "{said}");
    let table = fs::read_to_string(dir.path().join("step.csv")).unwrap();
    let header = "try,method,start,matrix,pass,iteration,velocity_norm,share,residual_norm,worst_r_mm,";
    assert!(table.starts_with(header) && table.contains("\n1,primal_dual,predictor,primal_dual,1,0,,,"), "{table}");
    assert!(run(&["--step", "5", "--out", "step.csv"]).status.success(), "its own kind is replaced");
    let other = run(&["--step", "5", "--out", "cases/cup.toml"]);
    assert_eq!(other.status.code(), Some(2), "the case is not");
    let all = run(&["--step", "5", "--methods", "all"]);
    let said = text(&all.stdout);
    assert!(["primal-dual", "Newton", "secant"].iter().all(|method| said.contains(method)), "{said}");
    assert!(said.lines().all(|line| line.chars().count() <= 80), "{said}");
    let german = run(&["--stage", "2", "--step", "1", "--method", "newton", "--lang", "de"]);
    assert!(text(&german.stdout).contains("Geschw.") && text(&german.stdout).contains("Gleichgewicht"), "{german:?}");
    let json: serde_json::Value = serde_json::from_slice(&run(&["--step", "5", "--json"]).stdout).unwrap();
    assert_eq!(json["methods"][0]["method"], "primal_dual");
    assert_eq!(json["methods"][0]["tries"][0]["passes"][0]["iterations"][0]["iteration"], 0);
    for (args, wanted) in [
        (&["--step", "5000"][..], "there is no step 5000: the run has"),
        (&["--step", "0"], "there is no step 0"),
        (&["--step", "1", "--stage", "3"], "there is no stage 3: the case has 2"),
        (&["--step", "1", "--tolerance", "1e-15"], "1e-12 to 0.1"),
        (&["--step", "1", "--methods", "picard"], "primal-dual"),
    ] {
        let failed = run(args);
        assert_eq!(failed.status.code(), Some(2), "{args:?}");
        assert!(text(&failed.stderr).contains(wanted), "{args:?}: {}", text(&failed.stderr));
    }
}
