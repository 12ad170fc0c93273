//! Studies: designs in order, rows whole, mistakes told before anything is run.

use stampflow::study::{Bars, Columns, Designs, Plan, Row, StudyError, Subject, Vary, run};
use std::convert::Infallible;

const CASE: &str = "cases/quickstart.toml";

fn plan(varied: &[&str]) -> Result<Plan, StudyError> {
    let axes = varied.iter().map(|text| Vary::together(text)).collect::<Result<_, _>>()?;
    Plan::new(CASE, vec!["blank.elements=30".into(), "solver.max_step=0.05".into()], axes)
}

fn rows(plan: &Plan, indices: &[u64], threads: usize) -> Vec<Row> {
    let mut rows = Vec::new();
    let ended = run(plan, indices, threads, Bars::Without, &(), |row| {
        rows.push(row);
        Ok::<_, Infallible>(())
    });
    assert!(ended.is_ok());
    rows
}

/// Trust: two grids by hand, the last key fastest.
#[test]
fn designs_are_counted_with_the_last_key_fastest_and_pairs_together() {
    let plan = plan(&["friction=0.05,0.1", "tools.die.shoulder=5,6 mm & tools.punch.friction=0.1,0.2"]);
    // The punch's friction is set by both, the later one last.
    let plan = plan.expect("a plan");
    assert_eq!(plan.count(), 4);
    let texts = |i: u64| plan.design(i).values.iter().map(|value| value.text.clone()).collect::<Vec<_>>();
    assert_eq!(
        [0, 1, 2, 3].map(texts),
        [["0.05", "5", "0.1"], ["0.05", "6", "0.2"], ["0.1", "5", "0.1"], ["0.1", "6", "0.2"]]
    );
}

/// Trust: the plan of the file itself.
#[test]
fn a_plan_of_a_text_is_that_of_its_file() {
    let text = std::fs::read_to_string(CASE).expect("shipped");
    let base = vec!["blank.elements=30".into(), "solver.max_step=0.05".into()];
    let of_text = |text: &str| Subject::of_text(text.into(), CASE, base.clone());
    let axes = vec![Vary::together("friction=0.05,0.1").expect("values")];
    let of_text_and_axes = Plan::of(of_text(&text).expect("a case"), axes).expect("a plan");
    assert_eq!(of_text_and_axes, plan(&["friction=0.05,0.1"]).expect("a plan"));
    assert!(of_text("").is_err());
}

/// Trust: what is the same however many threads run it; friction raises the force.
#[test]
fn rows_come_in_order_and_are_the_same_on_any_number_of_threads() {
    let plan = plan(&["friction=0.04..0.2/5"]).expect("a plan");
    let all: Vec<u64> = (0..plan.count()).collect();
    let [one, three] = [1, 3].map(|threads| rows(&plan, &all, threads));
    let base = one[0].result.as_ref().expect("solved");
    let columns = Columns::of(&plan, base);
    let lines = |rows: &[Row]| rows.iter().map(|row| columns.line(&plan, row)).collect::<Vec<_>>();
    assert_eq!(lines(&one), lines(&three));
    assert!(lines(&one).iter().all(|line| line.len() == columns.header().len()));
    let force = |row: &Row| row.result.as_ref().expect("solved").number("punch_force_N").expect("a force");
    assert!(one.windows(2).all(|pair| force(&pair[0]) < force(&pair[1])));
}

/// Trust: a die whose throat is narrower than its punch cannot be built, the others can.
#[test]
fn a_design_that_cannot_be_built_is_a_row_that_says_why() {
    let plan = plan(&["tools.die.throat=20,31.25 mm"]).expect("a plan");
    let rows = rows(&plan, &[0, 1], 2);
    assert!(rows[0].result.as_ref().is_err_and(|why| why.contains("throat")), "{:?}", rows[0].result);
    assert!(rows[1].result.is_ok());
}

/// Trust: none of its values makes a case.
#[test]
fn a_key_that_no_value_fits_is_told_before_anything_is_run() {
    for (varied, said) in [
        ("tools.die.sholder=4..6 mm/3", "sholder"),
        ("tools.die.shoulder=4..6/3", "needs a unit"),
        ("tools.dye.shoulder=4,5 mm", "dye"),
        ("material=dc99,dc98", "dc99"),
    ] {
        let error = plan(&[varied]).expect_err(varied).to_string();
        assert!(error.contains(said), "{varied}: {error}");
    }
}
