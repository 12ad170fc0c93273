//! Scatter: the sample, the distributions, probabilities and influences.

use crate::common::prelude::*;
use crate::study::run;
use stampflow::study::Scatter;

fn scatter_of(set: &[&str], vary: &[&str], runs: u64, seed: u32) -> Result<Scatter, StudyError> {
    let set = owned(&[&["blank.elements=24", "solver.max_step=0.06"], set].concat());
    Scatter::new(BaseCase::load("cases/quickstart.toml", set).expect("a case"), &owned(vary), runs, seed)
}

fn values(scatter: &mut Scatter) -> Vec<Vec<f64>> {
    let table = begin(scatter, &Evaluation { threads: 2, shard: Shard::WHOLE, watch: &() }).expect("a run");
    let designs = (0..scatter.known(&table)).map(|index| scatter.design(index));
    designs.map(|design| design.values.iter().map(|text| text.parse().expect("a number")).collect()).collect()
}

/// Trust: of 2^k points of a scrambled Sobol sequence each of 2^k slices of a coordinate has exactly one; seeds differ.
#[test]
fn the_sample_fills_each_variable_evenly() {
    let vary = ["friction=uniform 0..0.64", "blank.thickness=uniform 0.8..1.2 mm"];
    let sample = |seed| values(&mut scatter_of(&[], &vary, 64, seed).expect("a scatter"));
    let one = sample(7);
    for (coordinate, (low, width)) in [(0.0, 0.01), (0.8, 0.4 / 64.0)].into_iter().enumerate() {
        let mut slices: Vec<usize> = one.iter().map(|v| ((v[coordinate] - low) / width) as usize).collect();
        slices.sort_unstable();
        assert_eq!(slices, (0..64).collect::<Vec<_>>());
    }
    assert!(one == sample(7) && one != sample(8));
}

/// Trust: a force that rises with the friction alone is ranked as the friction is; its median is that of the middle.
#[test]
fn a_number_that_follows_one_variable_has_its_ranks_and_its_median() {
    let mut scatter = scatter_of(&[], &["friction=uniform 0.05..0.11"], 32, 1).expect("a scatter");
    let table = run(&mut scatter, 2, &());
    let (events, spreads) = scatter.result(&table);
    let force = table.response("punch_force").expect("a force");
    let spread = spreads.iter().find(|spread| spread.response == force).expect("a spread");
    assert!(spread.correlations[0].is_some_and(|c| c > 0.999), "{:?}", spread.correlations);
    let median = stampflow::study::quantile(&spread.values, 0.5);
    assert!((median / table.base.numbers[force] - 1.0).abs() < 0.01, "{median}");
    let tear = &events[0];
    assert_eq!((tear.label.as_str(), tear.hits, tear.probability[1]), ("Tears", 0, 0.0));
    assert!(tear.probability[2] > 0.05 && tear.probability[2] < 0.15, "{:?}", tear.probability);
}

/// Trust: one iteration finds no equilibrium, so that no run counts.
#[test]
fn a_scatter_without_a_result_says_why() {
    let mut scatter = scatter_of(&["solver.max_iterations=1"], &["friction=uniform 0.05..0.11"], 8, 1).expect("one");
    let table = run(&mut scatter, 2, &());
    let report = scatter.report(&table);
    assert!(report.headline.starts_with("None of 8 runs came to a result: no equilibrium"), "{}", report.headline);
    assert!(!report.found && report.notes.is_empty(), "{:?}", report.notes);
}

/// Trust: a middle that the case has is its own; a distribution without one replaces what is set.
#[test]
fn what_is_set_and_replaced_is_refused() {
    for (set, vary, is_refused) in [
        ("friction=0.12", "friction=uniform 0.05..0.11", true),
        ("tools.die.friction=0.12", "friction=uniform 0.05..0.11", true),
        ("friction=0.12", "friction=uniform ± 0.01", false),
        ("tools.die.shoulder=7 mm", "friction=uniform 0.05..0.11", false),
    ] {
        let refused = scatter_of(&[set], &[vary], 8, 1).err().map(|error| error.to_string());
        assert_eq!(refused.is_some_and(|error| error.contains("has no effect")), is_refused, "{set}, {vary}");
    }
}

/// Trust: EN 10131 as copied into `src/grade/thickness_tolerances.toml`: ± 0.05 mm at 1 mm. The quickstart's sheet has no standard.
#[test]
fn the_thickness_scatters_within_the_tolerance_of_the_sheet() {
    let sheet = "material={ name = \"dc04\" }";
    let mut scatter = scatter_of(&[sheet], &[], 64, 1).expect("a tolerance");
    let values: Vec<f64> = values(&mut scatter).concat();
    assert!(values.iter().all(|value| (0.95..1.05).contains(value)), "{values:?}");
    let table = run(&mut scatter, 2, &());
    let report = scatter.report(&table);
    assert!(report.notes.iter().any(|note| note.contains("± 0.05 mm by EN 10131:2006")), "{:?}", report.notes);
    let unknown = scatter_of(&[], &["blank.thickness=tolerance"], 8, 1).expect_err("no standard").to_string();
    assert!(unknown.contains("no standard's tolerance is known"), "{unknown}");
}
