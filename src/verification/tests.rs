//! Verification of made-up runs.

use super::*;
use crate::assess::{Finding, Kind, Light};
use crate::units::{Limits, Quantity, Sense};
use approx::assert_relative_eq;

fn end(kind: &'static str, lost: bool) -> End {
    End { stages: 1, kind, why: kind.to_owned(), complete: kind == "full travel", lost }
}

/// A run with a thickness, a place on the sheet and a row of the verdict.
fn run(refined: Option<(Direction, f64)>, [thinnest, place, used]: [f64; 3]) -> Outcome {
    let number = |origin, key, value| Number::new(origin, Quantity::new(key, "Thinnest", Amount::place(value)));
    Outcome {
        direction: refined.map(|(direction, _)| direction),
        times: refined.map_or(1.0, |(_, times)| times),
        end: end("full travel", false),
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

const AS_IT_IS: [f64; 3] = [4.0, 30.0, 80.0];

/// Steps with the errors 1 of the thickness and 8 of the share, and elements, which nothing moves.
fn finer() -> Vec<Outcome> {
    vec![
        run(Some((Direction::Steps, 2.0)), [3.5, 30.5, 76.0]),
        run(Some((Direction::Steps, 4.0)), [3.25, 30.5, 74.0]),
        run(Some((Direction::Elements, 2.0)), AS_IT_IS),
        run(Some((Direction::Elements, 4.0)), AS_IT_IS),
    ]
}

fn verified_from(base: Outcome, finer: Vec<Outcome>) -> Verification {
    let estimate = |direction: Direction, levels: &[f64]| estimate(levels, direction.order());
    Verification::of(base, finer, 1e-5, estimate, &())
}

fn verified(change: impl FnOnce(&mut Vec<Outcome>)) -> Verification {
    let mut finer = finer();
    change(&mut finer);
    verified_from(run(None, AS_IT_IS), finer)
}

/// Reasons of numbers without a bar.
fn reasons(verification: &Verification) -> Vec<&str> {
    let why = |number: &'_ Number| number.half().is_none();
    let numbers = verification.numbers.iter().filter(|number| why(number));
    numbers.map(|n| if let ErrorBar::Missing(why) = &n.quantity.error { why } else { "" }).collect()
}

/// Trust: powers of the first order, by hand, times the factor of safety.
#[test]
fn a_bar_is_made_of_the_directions_that_move_its_number() {
    let found = verified(|_| {});
    let number = &found.numbers[0];
    assert_relative_eq!(number.half().expect("a bar"), 1.25, max_relative = 1e-12);
    let [steps, elements] = &number.contributions[..] else { panic!("two directions") };
    assert_eq!((steps.direction, steps.share, elements.share), (Direction::Steps, 1.0, 0.0));
    assert_relative_eq!(steps.estimate.order.expect("one sign"), 1.0, max_relative = 1e-12);
    assert_relative_eq!(found.load.expect("a curve").high[1], 2.0 * (4.0 + 1.25), max_relative = 1e-12);
    assert!(found.notes.is_empty(), "{:?}", found.notes);
    assert_eq!(found.numbers[1].half(), Some(1.5), "three times the spread");
    let still = vec![run(Some((Direction::Steps, 2.0)), [4.0, 30.1, 80.0])];
    let still = verified_from(run(None, AS_IT_IS), still);
    let halves: Vec<_> = still.numbers.iter().map(Number::half).collect();
    assert_eq!(halves, [Some(0.0), Some(1.0), Some(0.0)], "an input is exact, a place no finer than its element");
}

/// Trust: by hand: a run that tears takes all bars, one that the numerics ended only itself, a jump that of its number.
#[test]
fn runs_that_differ_and_numbers_that_jump_leave_no_bar() {
    let torn = verified(|finer| finer[3].end = end("localised", false));
    assert_eq!(reasons(&torn), ["other runs end otherwise"; 3]);
    assert!(torn.load.is_none() && torn.thickness.is_none());
    assert_eq!(torn.notes, ["with 4 times the elements the run ends otherwise: localised; as it is: full travel"]);
    assert_eq!(torn.sentences()[0], "no error bars: other runs end otherwise");
    let lost = verified(|finer| finer[1].end = end("no equilibrium", true));
    assert_relative_eq!(lost.numbers[0].half().expect("a bar"), 1.5);
    assert_eq!(lost.notes.len(), 1);
    let lost = verified(|finer| finer[..2].iter_mut().for_each(|run| run.end = end("no equilibrium", true)));
    assert_eq!(reasons(&lost), ["no run with finer steps came to its end"; 3]);
    let jump = verified(|finer| finer[3] = run(Some((Direction::Elements, 4.0)), [3.0, 12.0, 80.0]));
    let [thinnest, place] = reasons(&jump)[..] else { panic!("two numbers") };
    assert_eq!(thinnest, "jumps from 4.0 mm to 3.0 mm with 4 times the elements");
    assert_eq!(place, "jumps from 30.0 mm to 12.0 mm with 4 times the elements");
    let short = verified(|finer| finer[3].shortest = 0.5);
    assert!(short.notes[0].contains("4 times the elements. A shell resolves"), "{:?}", short.notes);
}

/// Trust: by hand: the worst place is another in the finer run, with half the share; where it was, nothing has changed.
#[test]
fn a_share_of_the_limit_is_held_against_that_of_the_same_place() {
    let at_ten = |mut run: Outcome| {
        run.numbers[2].s0 = Some(10.0);
        Outcome { used: vec![(10.0, 40.0), (20.0, 80.0)], ..run }
    };
    let finer = at_ten(run(Some((Direction::Steps, 2.0)), [4.0, 30.0, 80.0]));
    let found = verified_from(at_ten(run(None, [4.0, 30.0, 40.0])), vec![finer]);
    assert_eq!(found.numbers[2].half(), Some(0.0));
}

fn row(light: Light, value: f64) -> Finding {
    let limits = Some(Limits { sense: Sense::AtMost, amber: Some(90.0), red: Some(100.0) });
    let quantity = Quantity { limits, ..Quantity::new("forming_limit", "Forming limit", Amount::share(0.01 * value)) };
    let row = Finding::warning("forming_limit", "Forming limit", "{} at 7.0 mm");
    Finding { light, kind: Kind::Judgement, quantity: Some(quantity), ..row }
}

/// Trust: the bar is 1.25 times 8.
#[test]
fn a_light_is_green_only_where_its_whole_bar_is() {
    for (light, value, expected) in [
        (Light::Green, 79.0, (Light::Green, "79 ± 10 % at 7.0 mm")),
        (Light::Green, 81.0, (Light::Amber, "with its error bar it reaches the limit of 90 %: 81 ± 10 % at 7.0 mm")),
        (Light::Amber, 95.0, (Light::Amber, "with its error bar it reaches red at 100 %: 95 ± 10 % at 7.0 mm")),
        (Light::Red, 105.0, (Light::Red, "105 ± 10 % at 7.0 mm")),
    ] {
        let finding = verified(|_| {}).weigh(vec![row(light, value)]).remove(0);
        assert_eq!((finding.light, finding.found().as_str()), expected);
        assert_eq!(finding.advice.contains("smaller error bar"), light == Light::Green && value > 80.0);
    }
    let sentence = verified(|_| {}).moved(&[row(Light::Green, 81.0)]);
    assert_eq!(sentence, ["Forming limit: 81 ± 10 %, with its error bar it reaches the limit of 90 %"]);
    let torn = verified(|finer| finer[3].end = end("localised", false));
    let stop = Finding { key: "stop", quantity: None, text: "full travel".into(), ..row(Light::Green, 0.0) };
    let [stop, limit] = &torn.weigh(vec![stop, row(Light::Green, 85.0)])[..] else { panic!("two rows") };
    let found = stop.found();
    assert_eq!(
        (stop.light, found.as_str()),
        (Light::Amber, "with 4 times the elements it ends otherwise: full travel")
    );
    let error = &limit.quantity.as_ref().expect("a number").error;
    assert_eq!(*error, ErrorBar::Missing("other runs end otherwise".into()));
}
