//! Verification of made-up runs.

use super::*;
use crate::assess::{Finding, Kind, Light, When};
use crate::units::Amount;
use crate::units::{ErrorBar, Limits, Quantity, Sense};
use approx::assert_relative_eq;

fn end(kind: &'static str, lost: bool) -> End {
    End { stages: 1, kind, why: kind.to_owned(), complete: kind == "full travel", lost }
}

fn number(of: Of, key: &'static str, value: f64, resolution: f64) -> Number {
    Number { of, key, label: "Thinnest", amount: Amount::place(value), resolution, place: None }
}

/// A run with a thickness, a place on the sheet and a row of the verdict.
fn run(refined: Option<(Direction, f64)>, [thinnest, place, used]: [f64; 3]) -> Outcome {
    Outcome {
        direction: refined.map(|(direction, _)| direction),
        times: refined.map_or(1.0, |(_, times)| times),
        end: end("full travel", false),
        numbers: vec![
            number(Of::Answer, "thinnest", thinnest, 0.0),
            number(Of::Part, "thinnest_place", place, 1.0),
            number(Of::Verdict, "forming_limit", used, 0.0),
        ],
        load: vec![(1.0, thinnest), (2.0, 2.0 * thinnest)],
        thickness: vec![(1.0, thinnest)],
        used: Vec::new(),
        shortest: 2.0,
    }
}

const AS_IT_IS: [f64; 3] = [4.0, 30.0, 80.0];

/// Steps with the errors 1 of the thickness and 8 of the share, and the rest, which nothing moves.
fn finer() -> Vec<Outcome> {
    vec![
        run(Some((Direction::Steps, 2.0)), [3.5, 30.5, 76.0]),
        run(Some((Direction::Steps, 4.0)), [3.25, 30.5, 74.0]),
        run(Some((Direction::Elements, 2.0)), AS_IT_IS),
        run(Some((Direction::Elements, 4.0)), AS_IT_IS),
    ]
}

fn verified(finer: Vec<Outcome>) -> Verification {
    let estimate = |direction: Direction, levels: &[f64]| estimate(levels, direction.order());
    Verification::of(run(None, AS_IT_IS), finer, 1e-5, estimate)
}

/// Trust: powers of the first order, by hand, times the factor of safety.
#[test]
fn a_bar_is_made_of_the_directions_that_move_its_number() {
    let found = verified(finer());
    let bar = found.bar(Of::Answer, "thinnest").expect("a number");
    assert_relative_eq!(bar.half.expect("a bar"), 1.25, max_relative = 1e-12);
    assert_eq!((bar.parts[0].direction, bar.parts[0].share, bar.parts[1].share), (Direction::Steps, 1.0, 0.0));
    assert_relative_eq!(bar.parts[0].estimate.order.expect("one sign"), 1.0, max_relative = 1e-12);
    let load = found.load.expect("a curve");
    assert_relative_eq!(load.high[1], 2.0 * (4.0 + 1.25), max_relative = 1e-12);
    assert!(found.told.is_empty(), "{:?}", found.told);
}

#[test]
fn where_a_run_ends_otherwise_no_number_has_a_bar() {
    let mut finer = finer();
    finer[3].end = end("localised", false);
    let found = verified(finer);
    assert!(found.bars.iter().all(|bar| bar.half.is_none() && !bar.why.is_empty()));
    assert!(found.load.is_none() && found.thickness.is_none());
    let told: Vec<String> = found.told.iter().map(ToString::to_string).collect();
    assert_eq!(told, ["with 4 times the elements the run ends otherwise: localised; as it is: full travel"]);
}

/// Trust: of the two levels that are left the spread is 0.5, three times which is the bar.
#[test]
fn a_run_that_the_numerics_ended_does_not_count() {
    let mut finer = finer();
    finer[1].end = end("no equilibrium", true);
    let found = verified(finer.clone());
    assert_relative_eq!(found.bar(Of::Answer, "thinnest").expect("a number").half.expect("a bar"), 1.5);
    assert_eq!(found.told.len(), 1, "{:?}", found.told);
    finer[0].end = end("no equilibrium", true);
    let found = verified(finer);
    assert!(found.bars.iter().all(|bar| bar.half.is_none()));
    assert_eq!(found.bars[0].why.to_string(), "no run with finer steps came to its end");
}

/// Trust: by hand: the worst place is another in the finer runs, with half the share; where it was, nothing has changed.
#[test]
fn a_share_of_the_limit_is_held_against_that_of_the_same_place() {
    let used = |worst: f64| vec![(10.0, 40.0), (20.0, worst)];
    let at_ten = |mut run: Outcome| {
        run.numbers[2].place = Some(10.0);
        Outcome { used: used(80.0), ..run }
    };
    let finer = vec![at_ten(run(Some((Direction::Steps, 2.0)), [4.0, 30.0, 80.0]))];
    let base = at_ten(run(None, [4.0, 30.0, 40.0]));
    let found = Verification::of(base, finer, 1e-5, |_, levels| estimate(levels, Some(1.0)));
    assert_eq!(found.bar(Of::Verdict, "forming_limit").expect("a number").half, Some(0.0));
}

#[test]
fn a_number_that_jumps_has_no_bar_and_says_so() {
    let mut finer = finer();
    finer[3].numbers[1].amount = Amount::place(12.0);
    finer[3].numbers[0].amount = Amount::place(3.0);
    let found = verified(finer);
    let [thinnest, place, used] = &found.bars[..] else { panic!("three numbers") };
    assert_eq!(place.why.to_string().replace('\u{a0}', " "), "jumps from 30.0 mm to 12.0 mm with 4 times the elements");
    assert_eq!(
        thinnest.why.to_string().replace('\u{a0}', " "),
        "jumps from 4.0 mm to 3.0 mm with 4 times the elements"
    );
    assert!(used.half.is_some());
}

/// Trust: by hand; an input that no run moves has no error.
#[test]
fn a_place_is_no_finer_than_its_element_and_an_input_is_exact() {
    let still = vec![run(Some((Direction::Steps, 2.0)), [4.0, 30.1, 80.0])];
    let found = verified(still);
    let halves: Vec<Option<f64>> = found.bars.iter().map(|bar| bar.half).collect();
    assert_eq!(halves, [Some(0.0), Some(1.0), Some(0.0)]);
}

#[test]
fn elements_below_the_thickness_are_told() {
    let mut finer = finer();
    finer[3].shortest = 0.5;
    let found = verified(finer);
    assert!(found.told[0].to_string().contains("4 times the elements. A shell resolves"), "{:?}", found.told);
}

fn percent(value: f64) -> Amount {
    Amount::share(0.01 * value)
}

fn row(light: Light, value: f64) -> Finding {
    let limits = Limits { sense: Sense::AtMost, amber: Some(90.0), red: Some(100.0) };
    Finding {
        key: "forming_limit",
        label: "Forming limit",
        light,
        quantity: Some(Quantity {
            limits: Some(limits),
            ..Quantity::new("forming_limit", "Forming limit", percent(value))
        }),
        text: String::new(),
        limit: String::new(),
        source: String::new(),
        advice: String::new(),
        when: When::After,
        kind: Kind::Judgement,
        stage: None,
    }
}

/// Trust: the bar is 1.25 times 8.
#[test]
fn a_light_is_green_only_where_its_whole_bar_is() {
    let found = verified(finer());
    for (light, value, expected) in [
        (Light::Green, 79.0, None),
        (Light::Green, 81.0, Some((Light::Amber, "81 ± 10 %, with its error bar it reaches the limit of 90 %"))),
        (Light::Amber, 95.0, Some((Light::Amber, "95 ± 10 %, with its error bar it reaches red at 100 %"))),
        (Light::Red, 105.0, None),
    ] {
        let moved = moved(&[row(light, value)], &found);
        let told = moved.first().map(|moved| (moved.light, moved.sentence.to_string().replace('\u{a0}', " ")));
        match expected {
            None => assert_eq!(told, None),
            Some((light, says)) => {
                let (found, sentence) = told.expect("a sentence");
                assert!(found == light && sentence.ends_with(says), "{sentence}");
            }
        }
    }
}

/// Trust: by hand, as above; what the found words tell of the number has its bar, other numbers none.
#[test]
fn a_finding_is_told_with_its_bar_and_what_to_do_about_it() {
    let finding = |value: f64| Finding { text: "{} at 7.0 mm".into(), ..row(Light::Green, value) };
    let weighed = |value: f64| {
        let mut finer = finer();
        finer.iter_mut().for_each(|run| run.numbers[2].amount.value += value - 80.0);
        let base = run(None, [4.0, 30.0, value]);
        let estimate = |direction: Direction, levels: &[f64]| estimate(levels, direction.order());
        Verification::of(base, finer, 1e-5, estimate).weigh(vec![finding(value)]).remove(0)
    };
    let told = |finding: &Finding| finding.found().replace('\u{a0}', " ");
    let low = weighed(79.0);
    assert_eq!((low.light, told(&low).as_str()), (Light::Green, "79 ± 10 % at 7.0 mm"));
    assert!(
        low.quantity.as_ref().is_some_and(|number| number.error == ErrorBar::Half(10.0)) && low.advice.is_empty(),
        "{low:?}"
    );
    let high = weighed(81.0);
    let expected = "with its error bar it reaches the limit of 90 %: 81 ± 10 % at 7.0 mm";
    assert_eq!((high.light, told(&high).as_str()), (Light::Amber, expected));
    assert!(high.advice.to_string().contains("smaller error bar"), "{high:?}");
}

/// The run that tears has no say in a number, and the run as it is no longer a green light.
#[test]
fn where_a_finer_run_tears_the_run_is_amber() {
    let mut finer = finer();
    finer[3].end = end("localised", false);
    let found = verified(finer);
    let stop = Finding { key: "stop", quantity: None, text: "full travel".into(), ..row(Light::Green, 0.0) };
    let stop = found.weigh(vec![stop]).remove(0);
    let told = stop.found();
    assert_eq!((stop.light, told.as_str()), (Light::Amber, "with 4 times the elements it ends otherwise: full travel"));
    let sentences: Vec<String> = found.sentences().iter().map(ToString::to_string).collect();
    assert_eq!(sentences[0], "no error bars: other runs end otherwise");
    assert!(sentences.len() == 2 && sentences[1].contains("localised"), "{sentences:?}");
    let weighed = found.weigh(vec![row(Light::Green, 85.0)]).remove(0);
    assert_eq!(weighed.quantity.expect("a number").error, ErrorBar::Missing("other runs end otherwise".into()));
}
