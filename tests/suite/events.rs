//! The events of a stage, and whether they explain what its load curve does.

use crate::common::prelude::*;
use stampflow::measure::{Event, EventKind, events};

fn solved(template: &str, overrides: &[&str]) -> Solution {
    shipped::made(template, &[], overrides).solve(&mut ())
}

fn kinds(found: &[Event]) -> Vec<EventKind> {
    found.iter().map(|event| event.kind).collect()
}

/// A cup on its way through the die.
const LEAVES: [EventKind; 3] = [EventKind::SheetLeaves(Role::Holder), EventKind::RimOnShoulder, EventKind::RimInThroat];

/// Steps of the load above this share of the peak: no smooth curve has them in a hundredth of the travel.
const JUMP: f64 = 0.1;

/// The travels between which the load jumps \[mm\].
fn jumps(stage: &StageSolution) -> Vec<[f64; 2]> {
    let peak = shipped::peak(stage);
    let late = |travel: f64| travel > 0.1 * stage.model.travel;
    let pairs = stage.steps.windows(2).filter(|pair| late(pair[0].travel));
    let jumps = pairs.filter(|pair| (pair[1].punch_force - pair[0].punch_force).abs() > JUMP * peak);
    jumps.map(|pair| [pair[0].travel, pair[1].travel]).collect()
}

/// Trust: the flare of a first cup is off the second die until drawn down to it; then the whole rim goes in at once.
#[test]
fn the_jump_of_a_redraws_force_is_the_rim_that_meets_the_die() {
    let solution = solved("redraw", &["stop.drawn_through=false", "tools.punch.travel=45 mm"]);
    let [first, second] = &solution.stages[..] else { panic!("two stages") };
    assert_eq!(kinds(&events(first)), LEAVES[..2]);
    assert!(jumps(first).is_empty());
    let found = events(second);
    let meets = found.iter().find(|event| event.kind == EventKind::RimMeetsDie).expect("the rim meets the die");
    let [jump] = jumps(second)[..] else { panic!("one jump") };
    assert!(meets.travel > jump[0] && meets.travel <= jump[1], "{meets:?} {jump:?}");
}

/// Trust: the second punch ends before the first cup's rim is down on the die, which is made too wide to be near it.
#[test]
fn a_rim_in_the_air_runs_onto_no_shoulder() {
    let text = made("redraw", &[("trim", "5 mm")], &[]).text;
    let [drawn, redrawn] = text.split("[stages.die]").collect::<Vec<_>>()[..] else { panic!("{text}") };
    let drawn = drawn.replace("name = \"redraw\"", "name = \"redraw\"\nremove = [\"holder\"]");
    assert!(redrawn.contains("[stages.holder]"));
    let text = format!("{drawn}[stages.die]\nthroat = \"32 mm\"\nshoulder = \"15 mm\"\nfriction = 0.08\n");
    let stages = parsed(&text, &["stages.0.punch.move=40 mm"]).solve(&mut ()).stages;
    assert!(stages[1].stop.is_complete() && stages[1].steps.last().unwrap().edge_gap[Role::Die.index()] > 3.0);
    assert!(!kinds(&events(&stages[1])).contains(&EventKind::RimOnShoulder));
}

/// Trust: of each event the number that another part of the program gives for it.
#[test]
fn events_stand_where_other_figures_have_them() {
    let cup = &solved("cup", &[]).stages[0];
    let found = events(cup);
    assert_eq!(kinds(&found), LEAVES);
    let holder = cup.model.tools.iter().position(|tool| tool.role == Role::Holder).unwrap();
    assert_eq!(Some(found[0].travel), cup.left_at[holder]);
    // The shoulder begins at throat + shoulder; 5° round it is R sin 5° = 0.6 mm further in, about a step.
    let begins = cup.model.tool(Role::Die).unwrap().profile.corners().map(|arc| arc.center.x).fold(0.0, f64::max);
    let edge = cup.model.blank.length - cup.steps.iter().find(|s| s.travel >= found[1].travel).unwrap().draw_in;
    assert!(edge < begins && edge > begins - 1.5, "{edge} {begins}");

    let stage = &shipped::solved("stretch_limit").stages[0];
    let reached = stampflow::forming_limit::assess(stage.model.forming_limit.as_ref().unwrap(), &stage.paths).unwrap();
    let found = events(stage);
    let at = found.iter().find(|event| event.kind == EventKind::LimitReached).map(|event| event.travel);
    assert_eq!(at, reached.reached.map(|reached| reached.travel));
    assert!(at.is_some());
    let tears = stage.stop.kind == StopKind::Localised;
    assert_eq!(found.iter().any(|event| event.kind == EventKind::Tears), tears);
}
