//! Operations after one another: what a stage takes over from the one before, and what its tools do to the sheet.

use crate::common::prelude::*;
use stampflow::{measure::stripping_force, solver::solve};

/// The quickstart's cup on a coarser mesh, drawn to `travel` [mm].
fn cup(travel: f64) -> Model {
    let mut model = shipped::shipped("quickstart", &["blank.elements=60", "blank.grading=uniform"]);
    drive_to(&mut model, travel);
    model
}

fn stage(name: &str, model: Model) -> Stage {
    Stage { name: name.into(), model, begin: Beginning::default() }
}

fn moving(model: &Model, role: Role, axial: f64, aside: f64) -> Model {
    let mut model = model.clone();
    for tool in &mut model.tools {
        if tool.role == role {
            tool.motion = Motion::Path(Point::new(aside, axial));
        } else if tool.motion == Motion::Travel {
            tool.motion = Motion::Fixed;
        }
    }
    drive_to(&mut model, axial.hypot(aside));
    model
}

fn solved(stages: &[Stage]) -> Vec<StageSolution> {
    let passes = solve(stages, &mut ());
    passes.iter().for_each(|pass| assert!(pass.stop.is_complete(), "{}", pass.stop));
    assert_eq!(passes.len(), stages.len());
    passes
}

/// Trust: nothing is computed between two stages, so every number is compared bit for bit; what begins anew is zero.
#[test]
fn a_stage_begins_with_the_sheet_that_the_one_before_left() {
    let draw = cup(10.0);
    let left = &run(&draw, &mut ()).end;
    let mut back = moving(&draw, Role::Punch, -5.0, 0.0);
    back.speed = 2.0 * draw.speed;
    let entered = enter(&stage("next", back), &draw, left.clone());
    assert!(left.points.iter().any(|p| p.strain > 0.05) && left.pressure.iter().any(|p| *p > 0.0));
    assert_eq!(entered.nodes, left.nodes);
    assert_eq!(entered.thickness, left.thickness);
    assert_eq!((&entered.volume, &entered.s0), (&left.volume, &left.s0));
    let mut at_rest = left.points.clone();
    at_rest.iter_mut().for_each(|point| point.equivalent_rate = 0.0);
    assert_eq!((&entered.membrane, &entered.points), (&left.membrane, &at_rest));
    assert_eq!(entered.temperature, left.temperature);
    assert_eq!((&entered.tools, &entered.pressure), (&left.tools, &left.pressure));
    assert_eq!((entered.time, entered.travel), (0.0, 0.0));
    // A first guess, which goes with the pace of the process.
    let twice: Vec<Node> = left.velocity.iter().map(|velocity| velocity.map(|v| 2.0 * v)).collect();
    assert!(entered.velocity == twice && twice.iter().flatten().any(|v| *v != 0.0));
    // A new punch begins where it is drawn, without pressure.
    let mut other = moving(&draw, Role::Punch, 1.0, 0.0);
    other.tools[0].profile = stampflow::geometry::Profile::hemispherical_punch(20.0, 1.0);
    let entered = enter(&stage("other", other), &draw, left.clone());
    assert!(entered.tools[0].norm() < 0.1 && entered.tools[1..] == left.tools[1..]);
    assert!(entered.pressure.row(0).iter().all(|p| *p == 0.0));
    assert!((1..left.tools.len()).all(|j| entered.pressure.row(j) == left.pressure.row(j)));
}

/// Trust: by the flow law nothing springs back, and the tools' springs move it by their penetration, hundredths of the thickness.
#[test]
fn a_sheet_rests_on_the_tools_that_are_left() {
    let draw = cup(15.0);
    let kept: [&[Role]; 3] = [&[Role::Die], &[Role::Punch], &[Role::Punch, Role::Die]];
    for roles in kept {
        let mut rest = moving(&draw, Role::Punch, 0.0, 0.0);
        rest.tools.retain(|tool| roles.contains(&tool.role));
        rest.tools.iter_mut().for_each(|tool| tool.motion = Motion::Fixed);
        (rest.travel, rest.speed, rest.duration, rest.frames) = (0.0, draw.speed, 1.0, vec![1.0]);
        let passes = solved(&[stage("draw", draw.clone()), stage("rest", rest)]);
        let (before, after) = (&passes[0].end, &passes[1].end);
        for (thickness, left) in before.thickness.iter().zip(&after.thickness) {
            assert!((thickness - left).abs() < 0.01, "{roles:?}: {thickness} {left}");
        }
    }
}

/// Trust: a cup that is formed can always be formed on, let go a little or loaded anew. Where friction set in over a share
/// of so short a travel, a quarter of such stages found no equilibrium and the others rejected steps by the dozen.
#[test]
fn a_stage_much_shorter_than_the_sheet_is_thick_finds_equilibrium() {
    let draw = cup(10.0);
    for travel in [0.005, 0.02, 0.1, 0.3] {
        let moves: [&[(Role, f64)]; 3] =
            [&[(Role::Punch, travel)], &[(Role::Die, -travel)], &[(Role::Punch, -travel), (Role::Punch, 2.0 * travel)]];
        for moves in moves {
            let later = moves.iter().map(|(role, way)| stage(role.name(), moving(&draw, *role, *way, 0.0)));
            let stages: Vec<Stage> = [stage("draw", draw.clone())].into_iter().chain(later).collect();
            let rejected: usize = solved(&stages).iter().flat_map(|pass| &pass.steps).map(|step| step.rejected).sum();
            assert!(rejected <= 3, "{travel} mm {moves:?}: {rejected} rejected");
        }
    }
}

/// Trust: the same path in other steps. The second half begins from rest with the short first step of a run, and steps are
/// fractions of a travel half as long, so both differ by what the lengths of the steps make: a tenth of a percent of the
/// force, and less of the shape.
#[test]
fn a_draw_in_two_stages_is_the_draw_in_one() {
    let whole = solved(&[stage("whole", cup(20.0))]);
    let halves = solved(&[stage("first", cup(10.0)), stage("second", cup(10.0))]);
    let (one, two) = (&whole[0], &halves[1]);
    let apart = (last(two).punch_force / last(one).punch_force - 1.0).abs();
    let largest = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let thickness = largest(&one.end.thickness, &two.end.thickness);
    let shape = one.end.nodes.iter().zip(&two.end.nodes).map(|(a, b)| (a[1] - b[1]).abs()).fold(0.0, f64::max);
    assert!((one.end.tools[0] - two.end.tools[0]).norm() < 1e-9);
    assert!(apart < 5e-3 && thickness < 2e-3 && shape < 2e-2);
    let imbalance = two.steps.last().expect("steps").work.imbalance();
    assert!(imbalance.abs() < 0.01, "{imbalance}");
}

/// Trust: a rigid-plastic sheet does not follow a punch that goes back; the holder keeps the flange.
#[test]
fn a_punch_that_goes_back_leaves_the_sheet() {
    let draw = cup(15.0);
    let back = moving(&draw, Role::Punch, -16.0, 0.0);
    let passes = solved(&[stage("draw", draw), stage("back", back)]);
    let [drawn, left] = [0, 1].map(|i| &passes[i]);
    let [full, rest] = [drawn, left].map(|pass| last(pass).punch_force);
    assert!(full > 1e4 && rest.abs() < 1e-6 * full, "{full} {rest}");
    assert!(left.end.pressure.row(0).iter().all(|p| *p == 0.0));
    assert!((left.end.tools[0].y - drawn.end.tools[0].y + 16.0).abs() < 1e-9);
    let moves = drawn.end.nodes.iter().zip(&left.end.nodes).map(|(a, b)| (a[0] - b[0]).hypot(a[1] - b[1]));
    let moved = moves.fold(0.0, f64::max);
    assert!(moved < 0.05, "{moved}");
    let warnings = assess::of_stage(0, left);
    assert!(warnings.is_empty(), "{warnings:?}");
}

/// Trust: a segmented die that goes aside has no node within reach at the end, and the frame says where it stands.
#[test]
fn a_die_goes_aside() {
    let draw = cup(15.0);
    let mut aside = moving(&draw, Role::Die, 6.0, 8.0);
    aside.tools.retain(|tool| tool.role != Role::Holder);
    let passes = solved(&[stage("draw", draw), stage("aside", aside)]);
    let left = &passes[1];
    assert_eq!(left.model.travel, 10.0);
    let frame = left.frames.last().expect("a frame");
    assert_eq!(frame.tool_displacement[0].x, 0.0);
    assert!((frame.tool_displacement[1].x - 8.0).abs() < 1e-9, "{:?}", frame.tool_displacement);
    assert!((left.end.tools[1].y - passes[0].end.tools[1].y - 6.0).abs() < 1e-9);
    assert!((1..left.end.tools.len()).all(|j| left.end.pressure.row(j).iter().all(|p| *p == 0.0)));
}

/// Trust: a sheet without voids keeps its volume, so what is left is what the flat blank had within the last node.
#[test]
fn trimming_takes_the_rim_and_nothing_else() {
    let draw = cup(10.0);
    let left = &run(&draw, &mut ()).end;
    let mut cut = stage("cut", moving(&draw, Role::Punch, 1.0, 0.0));
    cut.begin.trim = Some(45.0);
    let state = enter(&cut, &draw, left.clone());
    let (kept, all) = (state.thickness.len(), left.thickness.len());
    assert!(kept < all && state.nodes.len() == kept + 1);
    assert_eq!(state.points.len(), kept * draw.blank.layers);
    assert_eq!(state.pressure.len(), state.contact_points() * draw.tools.len());
    for (j, of_tool) in state.pressure.rows().enumerate() {
        assert_eq!(of_tool, &left.pressure.row(j)[..state.contact_points()]);
    }
    let middle = |e: usize| 0.5 * (left.nodes[e][0] + left.nodes[e + 1][0]);
    assert!(middle(kept - 1) <= 45.0 && middle(kept) > 45.0);
    let volume: f64 = state.volume.iter().sum();
    let flat = PI * state.s0[kept].powi(2) * draw.blank.thickness;
    assert!((volume / flat - 1.0).abs() < 1e-12, "{volume} {flat}");
    let gone: f64 = left.volume[kept..].iter().sum();
    let whole = PI * draw.blank.length.powi(2) * draw.blank.thickness;
    assert!(((volume + gone) / whole - 1.0).abs() < 1e-12);

    let passes = solved(&[stage("draw", draw), cut]);
    assert_eq!((passes[1].model.blank.elements, passes[1].model.blank.length), (kept, state.s0[kept]));
    let warnings = assess::sentences(&assess::of_stage(1, &passes[1]), assess::Kind::Warning);
    assert!(warnings.iter().any(|w| w.to_string().contains("cut to r = ")), "{warnings:?}");
}

/// Trust: by definition; the shape and its strains stay, and the annealed sheet is softer.
#[test]
fn annealing_takes_strain_and_stress_and_leaves_the_shape() {
    let draw = cup(10.0);
    let mut soft = stage("soft", cup(2.0));
    let hard = soft.clone();
    soft.begin.anneal = true;
    let force = |next: &Stage| last(&solved(&[stage("draw", draw.clone()), next.clone()])[1]).punch_force;
    let left = &run(&draw, &mut ()).end;
    let state = enter(&soft, &draw, left.clone());
    assert!(state.points.iter().all(|p| p.strain == 0.0 && p.stress == [0.0; 3] && p.carried == [0.0; 3]));
    assert_eq!((&state.nodes, &state.membrane, &state.thickness), (&left.nodes, &left.membrane, &left.thickness));
    let (annealed, as_drawn) = (force(&soft), force(&hard));
    assert!(annealed < 0.9 * as_drawn, "{annealed} {as_drawn}");
}

/// Trust: the gap of a tool that has been brought up is looked at node by node.
#[test]
fn a_new_tool_is_brought_up_to_where_it_touches_the_sheet() {
    let draw = cup(15.0);
    let mut redraw = stage("redraw", cup(5.0));
    redraw.model.tools[0].profile = stampflow::geometry::Profile::flat_punch(20.0, 5.0, 1.0);
    redraw.begin.meets = vec![Role::Punch];
    let passes = solved(&[stage("draw", draw.clone()), redraw.clone()]);
    let left = &passes[0].end;
    let state = enter(&redraw, &draw, left.clone());
    let punch = &redraw.model.tools[0].profile;
    let gaps = left.nodes.iter().enumerate().map(|(i, x)| {
        let position = stampflow::geometry::Point::new(x[0], x[1] - state.tools[0].y);
        punch.closest(position).distance - 0.5 * left.thickness_at(i)
    });
    let gap = gaps.fold(f64::INFINITY, f64::min);
    assert!(gap > 0.0 && gap < 0.05, "{gap}");
    assert!(passes[1].steps.last().expect("steps").punch_force > 1e3);
}

/// Stages of a reverse redraw on a coarse mesh, the sheet elastic or not.
fn reverse_redraw(mode: Mode) -> Vec<Stage> {
    let given = [("reverse", "yes"), ("blank-radius", "69.35 mm")];
    let text = stampflow::author::templates::find("redraw").and_then(|template| template.fill(&given)).expect("text");
    let mut stages = parse(&text, "reverse.toml", &["blank.elements=90".into()]).expect("a case").stages;
    for stage in &mut stages {
        stage.model.mode = mode;
        stage.model.material.elastic = Some(Elastic { young: 210e3, poisson: 0.3 });
    }
    stages
}

/// Trust: to turn over twice changes no number. The same motion seen from the other side, a pad that pushes the sheet down over
/// a ring below it, is the same motion: sums through the thickness run the other way, so both agree within what iterations leave.
#[test]
fn a_sheet_turned_over_is_its_mirror_image() {
    for mode in [Mode::Flow, Mode::ElastoViscoplastic] {
        let [draw, mut turned] = reverse_redraw(mode).try_into().expect("two stages");
        turned.model.stop = stampflow::model::StopRules::default();
        drive_to(&mut turned.model, 12.0);
        turned.model.tools[0].motion = Motion::Path(Point::new(0.0, 12.0));
        let mut mirrored = turned.clone();
        mirrored.begin.turn_over = false;
        for (tool, role) in mirrored.model.tools.iter_mut().zip([Role::Pad, Role::Holder]) {
            tool.profile = tool.profile.mirrored();
            tool.role = role;
        }
        mirrored.model.tools[0].motion = Motion::Path(Point::new(0.0, -12.0));
        mirrored.model.tools.reverse();
        mirrored.begin.meets = vec![Role::Pad, Role::Holder];

        let first = solved(std::slice::from_ref(&draw)).remove(0);
        let plain = Stage { begin: Beginning::default(), ..turned.clone() };
        let once = enter(&turned, &draw.model, first.end.clone());
        let twice = enter(&turned, &turned.model, once.clone());
        let left = enter(&plain, &draw.model, first.end.clone());
        assert!(twice.nodes == left.nodes && twice.velocity == left.velocity && once.nodes != left.nodes);
        assert!(twice.points == left.points && twice.face_damage == left.face_damage && once.points != left.points);

        let [a, b] = [turned, mirrored].map(|next| solved(&[draw.clone(), next]).remove(1));
        let nodes = a.end.nodes.iter().zip(&b.end.nodes);
        let apart = nodes.map(|(a, b)| (a[0] - b[0]).abs().max((a[1] + b[1]).abs()).max((a[2] + b[2]).abs()));
        let apart = apart.fold(0.0, f64::max);
        let [push, pull] = [last(&a).punch_force, last(&b).pad_force];
        assert!(apart < 1e-9 && (push / pull - 1.0).abs() < 1e-9, "{mode:?}: {apart:e} mm, {push} {pull} N");
    }
}

/// Trust: the cup comes out inside out, with the bottom ahead of its rim, as high as its volume makes it in a direct redraw.
#[test]
fn a_reverse_redraw_draws_the_cup_inside_out() {
    for mode in [Mode::Flow, Mode::ElastoViscoplastic] {
        let passes = solved(&reverse_redraw(mode));
        let [bottom, rim] = [0, passes[1].end.nodes.len() - 1].map(|i| passes[1].end.nodes[i]);
        assert!(bottom[1] - rim[1] > 60.0 && rim[0] < 31.5, "{mode:?}: {bottom:?} {rim:?}");
        assert!(last(&passes[1]).work.imbalance().abs() < 0.01);

        let mut cup = passes[1].clone();
        assert_eq!(stripping_force(&cup).map(|force| force > 0.0), (mode != Mode::Flow).then_some(true));
        // By hand: 1 MPa on a tube of 30 mm, friction 0.08.
        let length = (cup.end.nodes.len() - 1) as f64;
        let tube = |i: usize| [30.0, -(i as f64), -0.5 * PI];
        cup.end.nodes.iter_mut().enumerate().for_each(|(i, node)| *node = tube(i));
        cup.end.pressure.row_mut(0).fill(1.0);
        let force = stripping_force(&cup).unwrap_or(0.08 * 2.0 * PI * 30.0 * length);
        assert!((force / (0.08 * 2.0 * PI * 30.0 * length) - 1.0).abs() < 1e-12, "{force}");
    }
}
