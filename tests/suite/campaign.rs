//! A small part of the campaign of random dies (`cargo bench --bench campaign` runs it in full): kinds of outcome only.

use crate::common::prelude::*;
use crate::common::random_die::{SECOND_SERIES, THIRD_SERIES};
use crate::common::random_template::{KINDS, random_template};
use crate::common::random_work::{self, Kind, make_elastic};

/// A hundred by the flow law, thirty with the metal elastic too.
#[test]
fn random_dies_run_to_their_full_travel_or_a_physical_stop() {
    let plain = (40_000..40_060).chain(SECOND_SERIES..SECOND_SERIES + 20).chain(THIRD_SERIES..THIRD_SERIES + 20);
    for (seed, is_elastic) in plain.map(|seed| (seed, false)).chain((40_000..40_030).map(|seed| (seed, true))) {
        let mut die = random_die::random_die(seed);
        if is_elastic {
            make_elastic(&mut die.model);
        }
        let run = solver::run(&die.model, &mut ());
        assert!(run.stop.is_complete() || run.stop.is_physical(), "seed {seed}: {}: {}", die.text, run.stop);
        let last = run.steps.last().expect("steps");
        // Trust: the full campaign's 99th percentile is 0.6 %; 5 % would be a wrong force somewhere.
        assert!(last.work.imbalance().abs() < 0.05, "seed {seed}: {}", die.text);
        assert!(last.thinnest > 0.0 && run.steps.iter().all(|r| r.punch_force.is_finite()));
    }
}

/// Trust: fifty draws of seven kinds miss one with a probability below 4e-3, and these are always the same fifty.
#[test]
fn fifty_pieces_of_other_work_run_to_their_full_travel_or_a_physical_stop() {
    let mut kinds = BTreeSet::new();
    for (i, seed) in (50_000..50_050).enumerate() {
        let work = random_work::random_work(seed, i % 2 == 1);
        let solved = solver::solve(&work.stages, &mut ());
        for run in &solved {
            assert!(run.stop.is_complete() || run.stop.is_physical(), "seed {seed}: {}: {}", work.text, run.stop);
        }
        let drawn = solved[0].steps.last().expect("steps");
        assert!(drawn.work.imbalance().abs() < 0.05, "seed {seed}: {}", work.text);
        kinds.insert(work.kind);
    }
    assert_eq!(kinds.len(), Kind::ALL.len());
}

/// Trimmed sheets, at rest and rigid nearly everywhere, that are drawn on; the first comes to equilibrium by an answer with a
/// softer and softer cut-off, the last with the velocities of the stage before, as its friction had set in.
///
/// Trust: the same sheets were drawn without difficulty up to the trim, and nothing has changed at their tools.
#[test]
fn the_first_step_after_a_trim_finds_its_equilibrium() {
    for (seed, elastic) in [(31_000_449, false), (23_000_780, false), (23_000_814, true)] {
        let work = random_work::random_work(seed, elastic);
        assert_eq!(work.kind, Kind::Trimmed);
        let solved = solver::solve(&work.stages, &mut ());
        let run = solved.last().expect("stages");
        assert_eq!(solved.len(), 2, "seed {seed}: {}", run.stop);
        // The last ends after 47 steps, as an arch.
        assert!(run.steps.len() > 45, "seed {seed}: {}: {}", work.text, run.stop);
        assert!(run.stop.is_complete() || run.stop.is_physical(), "seed {seed}: {}: {}", work.text, run.stop);
    }
}

/// A force that stayed until the edge had passed would press the last of the sheet over the die's shoulder in one step: 3 to
/// 14 % of the work of these hats.
///
/// Trust: the force falls by what is left of three thicknesses, of which a step passes a tenth or two; the balance of work
/// is that of the campaign, 0.4 % in its worst hundredth.
#[test]
fn a_holder_lets_go_little_by_little_of_a_sheet_that_runs_out_from_under_it() {
    for seed in [7_000_022, 7_000_049, 7_000_158, 7_000_210] {
        let die = random_die::random_die(seed);
        let holder = die.model.tools.iter().position(|tool| tool.role == Role::Holder).expect("a holder");
        let run = solver::run(&die.model, &mut ());
        assert!(run.stop.is_complete(), "seed {seed}: {}", run.stop);
        let left = run.left_at[holder].expect("the sheet leaves the holder");
        let pressing: Vec<f64> = run.steps.iter().filter(|r| r.travel <= left).map(|r| r.holder_force).collect();
        let full = pressing[pressing.len() / 2];
        let fall = pressing.windows(2).map(|pair| pair[0] - pair[1]).fold(0.0, f64::max);
        assert!(fall < 0.3 * full, "seed {seed}: falls by {fall} of {full} in one step");
        assert!(pressing[pressing.len() - 1].abs() < 0.01 * full, "seed {seed}: {}", pressing[pressing.len() - 1]);
        let last = run.steps.last().expect("steps");
        assert!(last.work.imbalance().abs() < 0.005, "seed {seed}: {}", last.work.imbalance());
    }
}

/// Trust: as above, of every kind; its numbers are finite.
#[test]
fn random_tubes_holes_pads_and_reverse_redraws_end_well() {
    let mut kinds = BTreeSet::new();
    for seed in 60_000..60_040 {
        let (kind, stages, text) = random_template(seed, seed % 2 == 1);
        for run in &solver::solve(&stages, &mut ()) {
            assert!(run.stop.is_complete() || run.stop.is_physical(), "seed {seed}: {text}: {}", run.stop);
            assert!(run.steps.iter().all(|step| step.punch_force.is_finite() && step.thinnest > 0.0), "{text}");
        }
        kinds.insert(kind);
    }
    assert_eq!(kinds.len(), KINDS.len());
}
