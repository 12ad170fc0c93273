//! A small part of the campaign of random dies (`cargo bench --bench campaign` runs it in full): kinds of outcome only.

#[path = "common/random_die.rs"]
#[allow(dead_code, reason = "the campaign also prints the kind and the description")]
mod random_die;

use stampflow::solver;

#[test]
fn sixty_random_dies_run_to_their_full_travel_or_a_physical_stop() {
    for seed in 0..60 {
        let die = random_die::random_die(40_000 + seed);
        let run = solver::run(&die.model, &mut ());
        assert!(run.stop.is_complete() || run.stop.is_physical(), "seed {}: {}: {}", 40_000 + seed, die.text, run.stop);
        let last = run.history.last().expect("steps");
        // Trust: the full campaign's 99th percentile is 0.6 %; 5 % would be a wrong force somewhere.
        assert!(last.work.imbalance().abs() < 0.05, "seed {}: {}", 40_000 + seed, die.text);
        assert!(last.thinnest > 0.0 && run.history.iter().all(|r| r.punch_force.is_finite()));
    }
}
