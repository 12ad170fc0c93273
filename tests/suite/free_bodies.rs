//! Tools as free bodies: what they do to the sheet is in balance, and what presses them is what they press with.

use crate::common::prelude::*;

/// Trust: nothing else holds a sheet with a free edge up: along z all tools and the gas, by the flat area in its seal, sum to
/// nothing, to what a corrector to 1e-5 leaves, 0.1 % of the largest force. What fades of tools gone is in balance by itself.
#[test]
fn the_tools_of_every_stage_hold_the_sheet_in_balance() {
    let all = TEMPLATES.iter().map(|template| made(template.name, &[], &[]));
    let shipped = ["quickstart", "chalmers_cup", "stages_cup", "strip_draw"].map(|name| shipped_case(name, &[]));
    let restruck = made("hat-section", &[("springback", "3 deg"), ("restrike", "3 mm")], &[]);
    let cup = made("cup", &[], &[]).text;
    let pressed = ["lower", "upper"].map(|f| parsed(&format!("{cup}\n[gas]\n{f} = {{ pressure = \"2 MPa\" }}\n"), &[]));
    let [mut judged, mut with_gas, mut fading] = [0; 3];
    for case in all.chain(shipped).chain(pressed).chain([restruck]) {
        for (i, stage) in solved_once(&case).stages.iter().enumerate() {
            let Model { blank, gas, release, .. } = &stage.model;
            if blank.edge != Edge::Free || blank.meridian.is_some() || release.is_some() {
                continue;
            }
            let largest = stage.tool_forces.iter().flatten().map(|force| force.abs()).fold(0.0, f64::max);
            for (step, forces) in stage.steps.iter().zip(&stage.tool_forces) {
                let inside = gas.first().map_or(0.0, |gas| gas.within.min(blank.edge_radius() - step.draw_in));
                let sum = forces.iter().sum::<f64>() + step.pressure * PI * inside.powi(2);
                assert!(sum.abs() <= 1e-3 * largest, "{} {i}, {}: {sum} of {largest}", stage.model.title, step.travel);
                judged += 1;
                with_gas += usize::from(inside > 0.0);
                fading += usize::from(!stage.end.unloading.is_empty());
            }
        }
    }
    assert!(judged > 1500 && with_gas > 100 && fading > 50, "{judged}, {with_gas}, {fading}");
}

/// Trust: a pad by another name is the same tool; a gas spring presses with F + (F_end − F) w/stroke after it was pushed back by w;
/// a tool with a path is where the path has it, to the gap at which tools wait.
#[test]
fn further_tools_have_drives_of_their_own() {
    const FLAT: &str = "profile = [{ from = [\"12 mm\", \"0 mm\"] }, { to = [\"0 mm\", \"0 mm\"] }]\nfriction = 0.1";
    let bend = made("u-bend", &[("pad-pressure", "1 MPa")], &[]);
    let (before, pad) = bend.text.split_once("[tools.pad]").expect("a pad");
    let after = pad.split_once("\n[").map_or_else(String::new, |(_, rest)| format!("\n[{rest}"));
    let other = |drive: &str| {
        let tool = format!("[[tools.further]]\nname = \"ejector\"\nabove = true\n{FLAT}\n{drive}\n");
        parsed(&format!("{before}{tool}{after}"), &[]).solve(&mut ()).stages.remove(0)
    };
    let pressed = |stage: &StageSolution| stage.further_forces().next().expect("a tool").1;
    let constant = other("force = \"28 N/mm\"");
    pressed(&constant).iter().for_each(|force| assert_relative_eq!(*force, 28.0, max_relative = 1e-3));
    let flat = last(&constant).pole_height - last(&constant).travel;
    assert!(flat.abs() < 0.05, "{flat}");
    let gas = other("gas_spring = { force = \"20 N/mm\", end_force = \"30 N/mm\", stroke = \"40 mm\" }");
    let moved = |run: &StageSolution| run.frames.last().expect("a frame").tool_displacement.last().expect("tools").y;
    assert_relative_eq!(*pressed(&gas).last().expect("steps"), 20.0 + 0.25 * moved(&gas), max_relative = 1e-3);
    let led = other("gap = \"9 mm\"\npath = [[\"0 mm\", \"0 mm\"], [\"5 mm\", \"5 mm\"], [\"10 mm\", \"30 mm\"]]");
    let travel = led.frames.last().expect("a frame").travel;
    let wanted = if travel < 5.0 { travel } else { (5.0 + 5.0 * (travel - 5.0)).min(30.0) };
    assert_relative_eq!(moved(&led), wanted, max_relative = 1e-3);
    assert!(pressed(&led).iter().all(|force| force.abs() < 1e-9), "it stays ahead of the sheet");
}

/// Trust: the punch is a thickness below a tool that stands on the flat sheet, and touches it after that travel.
#[test]
fn a_further_tool_that_stands_by_mistake_is_named() {
    let bend = made("u-bend", &[], &[]);
    let sentences = |gap: &str| {
        let tool = "[[tools.further]]\nname = \"ejector\"\nabove = true\nfriction = 0.1\n\
                    profile = [{ from = [\"12 mm\", \"0 mm\"] }, { to = [\"0 mm\", \"0 mm\"] }]";
        let case = parsed(&format!("{}\n{tool}\ngap = \"{gap}\"\n", bend.text), &[]);
        let stands = check::report(&case).lines.into_iter().any(|line| line.meaning.contains("die's side, stands"));
        assert!(stands, "the table says that it stands");
        assess::sentences(&assess::after(&case, &case.clone().solve(&mut ()).stages), Kind::Judgement).join("\n")
    };
    let meets = sentences("0 mm");
    assert!(meets.contains("punch and ejector are 90 % of the sheet's thickness apart"), "{meets}");
    assert!(meets.contains("the ejector and the punch run into each other from 1.0 mm of travel on"), "{meets}");
    let idle = sentences("90 mm");
    assert!(idle.contains("the sheet never presses on the ejector") && !idle.contains("run into"), "{idle}");
}

/// Trust: in its stage the inner punch alone moves, and stretches the sheet over itself until it necks; no holder is there.
#[test]
fn words_are_of_the_tool_that_works() {
    let stretched = loaded("tests/suite/common/inner_punch.toml", &["stages.0.further.0.move=12 mm"]);
    let solution = stretched.solve(&mut ());
    let answer = Answer::of(&solution.case, &solution.stages, &findings(&solution));
    let place = |key: &str| answer.numbers.iter().find(|number| number.key == key).expect("a number").place.clone();
    assert!(place("thinnest").contains("at the tool 'inner punch'"), "{}", place("thinnest"));
    assert!(place("punch_force").contains("in stage 2 of the inner punch"), "{}", place("punch_force"));
    let summary = solution.summary().to_string();
    let wanted = ["Inner punch travel reached", "punch's side, goes 12 mm", "on the inner punch", "Less friction, or"];
    wanted.iter().for_each(|words| assert!(summary.contains(*words), "{words}: {summary}"));
}
