//! Scatter: the sample, the distributions, probabilities and influences.

use crate::study::run;
use stampflow::study::{BaseCase, Evaluation, Scatter, Shard, Study, StudyError, begin};

fn scatter(vary: &[&str], runs: u64, seed: u32) -> Result<Scatter, StudyError> {
    let set = vec!["blank.elements=24".into(), "solver.max_step=0.06".into()];
    let base = BaseCase::load("cases/quickstart.toml", set).expect("a case");
    Scatter::new(base, &vary.iter().map(|text| (*text).to_owned()).collect::<Vec<_>>(), runs, seed)
}

fn values(scatter: &mut Scatter) -> Vec<Vec<f64>> {
    let settings = Evaluation { threads: 2, shard: Shard::WHOLE, watch: &() };
    let table = begin(scatter, &settings).expect("a run");
    let designs = scatter.next(&table).into_iter();
    designs.map(|design| design.values.iter().map(|text| text.parse().expect("a number")).collect()).collect()
}

/// Trust: of 2^k points of a scrambled Sobol sequence each of 2^k slices of a coordinate has exactly one; seeds differ.
#[test]
fn the_sample_fills_each_variable_evenly() {
    let vary = ["friction=uniform 0..0.64", "blank.thickness=uniform 0.8..1.2 mm"];
    let sample = |seed| values(&mut scatter(&vary, 64, seed).expect("a scatter"));
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
    let mut scatter = scatter(&["friction=uniform 0.05..0.11"], 32, 1).expect("a scatter");
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
