//! A small part of the campaign of random dies (`cargo bench --bench campaign` runs it in full): kinds of outcome only.

use crate::common::random_die::{self, RandomDie, SECOND_SERIES};
use stampflow::law::Family;
use stampflow::material::{Elastic, Hardening};
use stampflow::model::{Mode, Theory};
use stampflow::solver;
use std::collections::BTreeSet;

/// Trust: a hundred draws of six laws miss one with a probability below 1e-7, of ten examples with one below 3e-4.
#[test]
fn every_hardening_law_and_process_occurs_in_the_random_dies() {
    let dies = |first: u64| (first..first + 100).map(random_die::random_die).collect::<Vec<_>>();
    let laws =
        |dies: &[RandomDie]| -> BTreeSet<_> { dies.iter().map(|die| die.model.material.hardening.name()).collect() };
    let (first, second) = (dies(0), dies(SECOND_SERIES));
    let published = ["hollomon", "ludwik", "piecewise_power", "swift", "table", "voce"];
    assert_eq!(laws(&first).into_iter().collect::<Vec<_>>(), published, "the first series has become another");
    assert_eq!(laws(&second), Hardening::NAMES.iter().copied().collect());
    for dies in [first, second] {
        assert_eq!(dies.iter().map(|die| die.process).collect::<BTreeSet<_>>().len(), 6);
    }
}

#[test]
fn eighty_random_dies_run_to_their_full_travel_or_a_physical_stop() {
    for seed in (40_000..40_060).chain(SECOND_SERIES..SECOND_SERIES + 20) {
        let die = random_die::random_die(seed);
        let run = solver::run(&die.model, &mut ());
        let ended = run.stop.is_complete() || run.stop.is_physical();
        assert!(ended, "seed {seed}: {}: {}", die.text, run.stop);
        let last = run.steps.last().expect("steps");
        // Trust: the full campaign's 99th percentile is 0.6 %; 5 % would be a wrong force somewhere.
        assert!(last.work.imbalance().abs() < 0.05, "seed {seed}: {}", die.text);
        assert!(last.thinnest > 0.0 && run.steps.iter().all(|r| r.punch_force.is_finite()));
    }
}

/// Trust: as above, with the metal elastic too; the elastoplastic law's usual number of points through the thickness.
#[test]
fn thirty_random_elastoplastic_dies_run_to_their_full_travel_or_a_physical_stop() {
    for seed in 0..30 {
        let mut die = random_die::random_die(40_000 + seed);
        die.model.mode = Mode::ElastoViscoplastic;
        die.model.material.elastic = Some(Elastic { young: 206_000.0, poisson: 0.3 });
        if die.model.blank.theory == Theory::Bending {
            die.model.blank.layers = 15;
        }
        let run = solver::run(&die.model, &mut ());
        let ended = run.stop.is_complete() || run.stop.is_physical();
        assert!(ended, "seed {}: {}: {}", 40_000 + seed, die.text, run.stop);
        let last = run.steps.last().expect("steps");
        assert!(last.work.imbalance().abs() < 0.05, "seed {}: {}", 40_000 + seed, die.text);
    }
}
