//! Estimates in closed form, and verification of made-up runs.

use super::estimate::estimate;
use super::*;
use crate::results::error_bars::{Number, Origin};
use crate::units::Quantity;
use approx::assert_relative_eq;

/// Trust: f = 7 + c hᵖ with h = 1, 1/2, 1/4 has the error c on its first level; the others by hand.
#[test]
fn a_power_law_is_extrapolated_and_anything_else_has_its_spread() {
    use Direction::{Elements, Points, Steps, Together};
    for (direction, p) in [(Steps, 0.6), (Steps, 1.0), (Steps, 1.9), (Elements, 1.1), (Elements, 3.9)] {
        let estimate = estimate(direction, &[1.0_f64, 0.5, 0.25].map(|h| 7.0 - 2.0 * h.powf(p)));
        assert_relative_eq!(estimate.order.expect("one sign"), p, max_relative = 1e-9);
        assert_relative_eq!(estimate.error, 1.25 * 2.0, max_relative = 1e-9);
    }
    for (direction, levels, error, order) in [
        (Steps, &[10.0, 7.0, 8.0][..], 9.0, None),
        (Steps, &[10.0, 9.0, 6.0], 12.0, Some((1.0_f64 / 3.0).log2())),
        (Elements, &[10.0, 9.0, 9.0], 3.0, None),
        (Points, &[10.0, 9.0, 8.5], 4.5, Some(1.0)),
        (Together, &[5.0, 4.0], 5.0, None),
    ] {
        let estimate = estimate(direction, levels);
        assert_eq!((estimate.error, estimate.order, estimate.extrapolated), (error, order, false), "{levels:?}");
    }
}

/// A run with a thickness and a row of the verdict.
fn run(refined: Option<(Direction, f64)>, kind: &'static str, [thinnest, used]: [f64; 2]) -> Outcome {
    let number = |origin, key, value| Number::new(origin, Quantity::new(key, "Thinnest", Amount::place(value)));
    Outcome {
        direction: refined.map(|(direction, _)| direction),
        times: refined.map_or(1.0, |(_, times)| times),
        end: End { stages: 1, kind, why: kind.to_owned(), complete: true, lost: kind == "lost" },
        numbers: vec![
            number(Origin::Answer, "thinnest", thinnest),
            number(Origin::Part, "thinnest_place", 30.0).without_bar("a place"),
            number(Origin::Verdict, "forming_limit", used),
        ],
        load: vec![(1.0, thinnest), (2.0, 2.0 * thinnest)],
        thickness: vec![(1.0, thinnest)],
        used: Vec::new(),
        shortest: 2.0,
    }
}

/// Trust: powers of the first order by hand, times the factor of safety; a place has no bar.
#[test]
fn a_bar_sums_its_directions_and_is_missing_where_runs_differ() {
    for (end, thinnest, halves, first) in [
        ("full", 4.0, [Some(1.25), None, Some(10.0)], "steps 100 % (1.0)"),
        ("full", 4.2, [Some(1.85), None, Some(10.0)], "steps 68 % (1.0), elements 32 %"),
        ("torn", 4.0, [None; 3], "no bar: other runs end otherwise"),
        ("lost", 4.0, [None; 3], "no bar: no run with finer elements came to its end"),
    ] {
        let steps = [(2.0, [3.5, 76.0]), (4.0, [3.25, 74.0])];
        let steps = steps.map(|(times, values)| run(Some((Direction::Steps, times)), "full", values));
        let finer = run(Some((Direction::Elements, 2.0)), end, [thinnest, 80.0]);
        let finer = steps.into_iter().chain([finer]).collect();
        let bars = Verification::from_runs(run(None, "full", [4.0, 80.0]), finer, 1e-5, None).bars;
        let found: Vec<_> = bars.numbers.iter().map(|n| n.half().map(|half| (1e9 * half).round() / 1e9)).collect();
        assert_eq!((&found[..], bars.numbers[0].made_of().as_str()), (&halves[..], first));
    }
}
