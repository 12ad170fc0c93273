//! A small part of the campaign of random dies (`cargo bench --bench campaign` runs it in full): kinds of outcome only.

#[path = "common/random_die.rs"]
#[allow(dead_code, reason = "the campaign also prints the process")]
mod random_die;

use stampflow::material::Elastic;
use stampflow::model::{Mode, Theory};
use stampflow::solver;
use std::collections::BTreeSet;
use std::mem::{Discriminant, discriminant};

/// Trust: the generator draws the law first-come; a hundred draws of six miss one with a probability below 1e-7.
#[test]
fn every_hardening_law_and_process_occurs_in_the_random_dies() {
    let dies: Vec<_> = (0..100).map(random_die::random_die).collect();
    let of = |law: &stampflow::material::Hardening| discriminant(law);
    let mut found: Vec<Discriminant<_>> = Vec::new();
    for die in &dies {
        let law = of(&die.model.material.hardening);
        if !found.contains(&law) {
            found.push(law);
        }
    }
    // Isotherms are tables to a sheet of one temperature.
    for (name, law) in stampflow::material::Hardening::examples().into_iter().filter(|(name, _)| *name != "isotherms") {
        assert!(found.contains(&of(&law)), "{name} does not occur");
    }
    assert_eq!(dies.iter().map(|die| die.process).collect::<BTreeSet<_>>().len(), 6);
}

#[test]
fn sixty_random_dies_run_to_their_full_travel_or_a_physical_stop() {
    for seed in 0..60 {
        let die = random_die::random_die(40_000 + seed);
        let run = solver::run(&die.model, &mut ());
        let ended = run.stop.is_complete() || run.stop.is_physical();
        assert!(ended, "seed {}: {}: {}", 40_000 + seed, die.text, run.stop);
        let last = run.steps.last().expect("steps");
        // Trust: the full campaign's 99th percentile is 0.6 %; 5 % would be a wrong force somewhere.
        assert!(last.work.imbalance().abs() < 0.05, "seed {}: {}", 40_000 + seed, die.text);
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
