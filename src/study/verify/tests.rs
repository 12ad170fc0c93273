//! Estimates in closed form, and verification of made-up runs.

use super::estimate::{envelope, estimate};
use super::*;
use crate::assess::{Finding, Kind, Light};
use crate::results::error_bars::{Number, Origin};
use crate::units::{Limits, Quantity, Sense};
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
    // Errors with knots 10 apart; the band reaches 4 % of 100 to each side and closes nowhere.
    let x: Vec<f64> = (0..=100).map(f64::from).collect();
    let half: Vec<f64> = x.iter().map(|x| (std::f64::consts::PI * x / 10.0).sin().abs()).collect();
    assert!(envelope(&x, &half).iter().zip(&half).all(|(wide, half)| wide >= half && (0.8..=1.0).contains(wide)));
}

/// A run with a thickness, a place on the sheet and a row of the verdict.
fn run(refined: Option<(Direction, f64)>, kind: &'static str, [thinnest, place, used]: [f64; 3]) -> Outcome {
    let number = |origin, key, value| Number::new(origin, Quantity::new(key, "Thinnest", Amount::place(value)));
    Outcome {
        direction: refined.map(|(direction, _)| direction),
        times: refined.map_or(1.0, |(_, times)| times),
        end: End { stages: 1, kind, why: kind.to_owned(), complete: true, lost: kind == "lost" },
        numbers: vec![
            number(Origin::Answer, "thinnest", thinnest),
            Number { resolution: 1.0, ..number(Origin::Part, "thinnest_place", place) },
            number(Origin::Verdict, "forming_limit", used),
        ],
        load: vec![(1.0, thinnest), (2.0, 2.0 * thinnest)],
        thickness: vec![(1.0, thinnest)],
        used: Vec::new(),
        shortest: 2.0,
    }
}

/// Error bars from finer steps, and twice as many elements.
fn bars(elements: (&'static str, [f64; 3])) -> ErrorBars {
    let steps = [(2.0, [3.5, 30.5, 76.0]), (4.0, [3.25, 30.5, 74.0])];
    let steps = steps.map(|(times, values)| run(Some((Direction::Steps, times)), "full", values));
    let finer = run(Some((Direction::Elements, 2.0)), elements.0, elements.1);
    let finer = steps.into_iter().chain([finer]).collect();
    Verification::from_runs(run(None, "full", [4.0, 30.0, 80.0]), finer, 1e-5).bars
}

/// Trust: powers of the first order by hand, times the factor of safety; the place moves by half an element.
#[test]
fn a_bar_sums_its_directions_and_is_missing_where_runs_differ_or_jump() {
    for (elements, halves, first) in [
        (("full", [4.0, 30.0, 80.0]), [Some(1.25), Some(1.5), Some(10.0)], "steps 100 % (1.0)"),
        (("full", [4.2, 30.0, 80.0]), [Some(1.85), Some(1.5), Some(10.0)], "steps 68 % (1.0), elements 32 %"),
        (("full", [4.0, 12.0, 80.0]), [Some(1.25), None, Some(10.0)], "steps 100 % (1.0)"),
        (("torn", [4.0, 30.0, 80.0]), [None; 3], "no bar: other runs end otherwise"),
        (("lost", [4.0, 30.0, 80.0]), [None; 3], "no bar: no run with finer elements came to its end"),
    ] {
        let bars = bars(elements);
        let found: Vec<_> = bars.numbers.iter().map(|n| n.half().map(|half| (1e9 * half).round() / 1e9)).collect();
        assert_eq!((&found[..], bars.numbers[0].made_of().as_str()), (&halves[..], first));
        assert_eq!(bars.load.is_empty(), halves == [None; 3]);
    }
}

/// Trust: the bar is 1.25 times 8.
#[test]
fn a_light_is_green_only_where_its_whole_bar_is() {
    let bars = bars(("full", [4.0, 30.0, 80.0]));
    for (light, value, expected) in [
        (Light::Green, 79.0, (Light::Green, "79 ± 10 % at 7.0 mm")),
        (Light::Green, 81.0, (Light::Amber, "with its error bar it reaches the limit of 90 %: 81 ± 10 % at 7.0 mm")),
        (Light::Amber, 95.0, (Light::Amber, "with its error bar it reaches red at 100 %: 95 ± 10 % at 7.0 mm")),
        (Light::Red, 105.0, (Light::Red, "105 ± 10 % at 7.0 mm")),
    ] {
        let limits = Some(Limits { sense: Sense::AtMost, amber: Some(90.0), red: Some(100.0) });
        let number = Quantity::new("forming_limit", "Forming limit", Amount::share(0.01 * value));
        let row = Finding::warning("forming_limit", "Forming limit", "{} at 7.0 mm");
        let quantity = Some(Quantity { limits, ..number });
        let finding = bars.weigh(vec![Finding { light, kind: Kind::Judgement, quantity, ..row }]).remove(0);
        assert_eq!((finding.light, finding.statement().as_str()), expected);
    }
}
