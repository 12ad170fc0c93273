//! Shipped cases run otherwise than they stand: what book and comments tell of another friction, thickness, law or temperature.
//!
//! Trust: no reference, but what a page says is what comes out; each test has a tendency that is known besides.

use crate::common::prelude::*;

fn solved(name: &str, overrides: &[&str]) -> Solution {
    shipped_case(name, overrides).solve(&mut ())
}

/// The more friction holds the flange back, the wider it stays; with that of the source's own simulation the wall tears, because what
/// the holder alone keeps back, 2 μ F exp(μ π/2), is nearly what a wall in plane strain bears.
#[test]
fn the_brite_part_hangs_on_its_friction() {
    let with = |friction: &str| {
        let tools = ["punch", "die", "holder"].map(|tool| format!("tools.{tool}.friction={friction}"));
        solved("brite_cylindrical", &tools.each_ref().map(String::as_str))
    };
    let diameters = ["0.07", "0.05", "0.03"].map(|friction| {
        let solution = with(friction);
        let run = &solution.stages[0];
        assert!(run.stop.is_complete(), "{friction}: {}", run.stop);
        2.0 * run.frames.last().and_then(|frame| frame.nodes.last()).expect("an edge").r
    });
    assert!(diameters.is_sorted_by(|a, b| a > b), "{diameters:?}");
    agrees("{} mm with 0.07, {} with 0.05, {} with 0.03.", &plain(&diameters, 1));

    let torn = with("0.1");
    assert_eq!(torn.stages[0].stop.kind, StopKind::Localised);
    let ended = plain(&[wall(&torn.case), torn.stages[0].end.travel], 0);
    agrees("which tears at {} kN: the run ends localised at {} mm.", &ended);
    let held = 2.0 * 0.1 * 748.0 * (0.1 * FRAC_PI_2).exp();
    agrees("the holder alone holds back {} kN at the wall,", &plain(&[held], 0));
}

/// What a wall around the punch bears in plane strain \[kN\]: the largest c σ(c ε) exp(−ε) of its law.
fn wall(case: &Case) -> f64 {
    let (factor, model) = (2.0 / 3f64.sqrt(), case.model());
    let nominal = |strain: f64| factor * model.material.hardening.at(factor * strain).stress * (-strain).exp();
    let strength = (0..1000).map(|i| nominal(1e-3 * f64::from(i))).fold(0.0, f64::max);
    // The middle of the wall beside the punch of 149.9 mm.
    2e-3 * PI * (149.9 + 0.5 * model.blank.thickness) * model.blank.thickness * strength
}

/// The index does not know the thickness, hardly knows friction, and rises with what the sheet hardens by beyond the tension test.
#[test]
fn the_erichsen_index_of_other_sheets_thicknesses_and_laws() {
    let index_of = |solution: &Solution| {
        let run = &solution.stages[0];
        let peak = run.steps.iter().max_by(|a, b| a.punch_force.total_cmp(&b.punch_force)).expect("steps");
        assert!(peak.travel < last(run).travel, "the load has passed its maximum: {}", run.stop);
        peak.travel
    };
    let index = |overrides: &[&str]| index_of(&solved("erichsen_304l", overrides));
    let thicknesses = ["0.5 mm", "1 mm", "1.5 mm", "2 mm"].map(|t| index(&[&format!("blank.thickness={t}")]));
    assert!(thicknesses.iter().all(|index| (index / thicknesses[1] - 1.0).abs() < 0.05), "{thicknesses:?}");
    agrees("With 0.5, 1.0, 1.5 and 2.0 mm the index is {}, {}, {} and {} mm,", &plain(&thicknesses, 1));

    let friction = ["0.02", "0.15"].map(|mu| {
        index(&["tools.punch", "tools.die"].map(|tool| format!("{tool}.friction={mu}")).each_ref().map(String::as_str))
    });
    assert!(friction.iter().all(|index| (index / thicknesses[1] - 1.0).abs() < 0.1), "{friction:?}");
    agrees("Friction 0.02 gives {} mm, 0.15 gives {};", &plain(&friction, 1));

    let points = include_str!("../../reference_data/aisi304l_bar_flow_curve.csv");
    let curve = FlowCurve::read(points, "points.csv", &Reduction::default()).expect("a curve");
    let fits = fit_laws(vec![curve.clone()], Some(HardeningKind::Swift), &()).expect("a fit");
    let swift = fits.best();
    let Hardening::Swift(_) = swift.hardening else { panic!("{:?}", swift.hardening) };
    let off = curve.points.iter().map(|point| (swift.hardening.at(point.strain).stress / point.stress - 1.0).abs());
    let mut case = shipped_case("erichsen_304l", &[]);
    case.stages[0].model.material.hardening = swift.hardening.clone();
    let by_swift = index_of(&case.solve(&mut ()));
    assert!(by_swift < thicknesses[1], "Swift's hardens less beyond the points: {by_swift}");
    let figures = [plain(&[100.0 * off.fold(0.0, f64::max)], 0), plain(&[by_swift], 1)].concat();
    agrees("Swift's law through the same points, {} % off at most, {};", &figures);

    let others = [index(&["blank.elements=400"]), index(&["material.mode=elasto_viscoplastic"])];
    agrees("400 elements {}, the elastoplastic law {}.", &plain(&others, 1));
    let sheets = ["drawing-steel", "aa5754-o"].map(|name| index(&[&format!("material.name={name}")]));
    agrees("The deep-drawing steel of the library has an index of {} mm, AA5754-O {}.", &plain(&sheets, 1));
    // The book's table of sheets made from a band.
    for row in include_str!("../../benches/measured/made_sheets.csv").lines().skip(1) {
        let [name, shown, ..] = row.split(',').collect::<Vec<_>>()[..] else { panic!("{row}") };
        let case = made("erichsen", &[("material", name), ("thickness", "1 mm")], &[]);
        assert_eq!(plain(&[index_of(&case.solve(&mut ()))], 1), [shown], "{name}");
    }
}

/// A wall that is ironed keeps less of its moment: a ring from the rim opens less.
#[test]
fn the_split_ring_hangs_on_the_yield_condition_and_on_where_it_is_cut() {
    let solution = solved("split_ring", &[]);
    let ring = solution.case.springback.ring.expect("a ring");
    let opening = |solution: &Solution, ring: Ring| ring.opening(&solution.stages).expect("an opening");
    let hill = opening(&solved("split_ring", &["material.yield_condition=hill48"]), ring);
    let both = [opening(&solution, ring), hill];
    agrees("its ring opens by {} mm (by Hill's by {}),", &plain(&both, 2));
    let cut = [4.0, 6.0, 12.0].map(|from| opening(&solution, Ring { from, ..ring }));
    assert!(cut[2] < cut[1] && cut[2] < both[0], "{cut:?}");
    agrees(
        "by {} mm if it is cut 4 mm over the bottom, by {} at 6 mm and by {} at 12 mm, where the rim is ironed.",
        &plain(&cut, 1),
    );
}

/// The wall of a hat is bent over the shoulder and back: only a law that knows of it on the way gives it the curl.
#[test]
fn the_hat_springs_back_by_what_the_law_remembers() {
    let let_go = |solution: &Solution| {
        let stage = solution.stages.last().expect("stages");
        assert!(stage.model.release.is_some() && stage.stop.is_complete(), "{}", stage.stop);
        let shape = Shape::of(stage.frames.last().expect("the end"));
        [shape.wall_angle(), shape.flange_angle(), shape.curl_radius()].map(|value| value.expect("a hat"))
    };
    let throughout = let_go(shipped::solved("hat_springback"));
    let flow = let_go(&solved("hat_springback", &["material.mode=flow"]));
    let constant = let_go(&solved("hat_springback", &["material.mode=flow", "stages.0.release=constant"]));
    assert!((0..2).all(|i| (flow[i] - constant[i]).abs() < 0.05), "{flow:?} {constant:?}");
    let text = include_str!("../../cases/hat_springback.toml").replace("travel = \"70 mm\"", "travel = \"60 mm\"");
    let end = "[[stages]]\nname = \"finish\"\nmode = \"elasto_viscoplastic\"\npunch.move = \"10 mm\"\n\n[[stages]]\n";
    let two = parsed(&text.replacen("[[stages]]\n", end, 1), &["material.mode=flow", "blank.layers=15"]);
    assert!(two.stages[0].model.mode == Mode::Flow && two.stages[1].model.mode == Mode::ElastoViscoplastic);
    let at_last = let_go(&two.solve(&mut ()));
    for i in 0..2 {
        assert!(flow[i] < at_last[i] && at_last[i] < throughout[i], "{flow:?} {at_last:?} {throughout:?}");
    }
    let figures =
        [throughout, flow, at_last].map(|[wall, flange, curl]| [plain(&[wall, flange], 1), plain(&[curl], 0)].concat());
    agrees(
        "elastoplastic throughout {}°, {}°, {} mm; flow and then D(E, ν) {}°, {}°, {} mm (the same with a constant stiffness); \
         flow to 60 of 70 mm, then elastoplastic: {}°, {}°, {} mm",
        &figures.concat(),
    );
}

#[test]
fn the_warm_cup_tears_when_it_is_cold() {
    let cold = ["heat.initial", "heat.die.temperature", "heat.holder.temperature"].map(|key| format!("{key}=25 °C"));
    let solution = solved("warm_cup", &cold.each_ref().map(String::as_str));
    assert_eq!(solution.stages[0].stop.kind, StopKind::Localised);
    let travel = solution.stages[0].end.travel;
    told("cases/warm_cup.toml", "A run that goes on there ends by a neck at {} mm.", &plain(&[travel], 0));
}

#[test]
fn the_voids_of_the_porous_cup_join_on_a_longer_way() {
    let solution = solved("woo_porous", &["tools.punch.travel=45 mm"]);
    assert_eq!(solution.stages[0].stop.kind, StopKind::Coalesced);
    let travel = last(&solution.stages[0]).travel;
    told("cases/woo_porous.toml", "the voids join at {} mm and the run ends there.", &plain(&[travel], 0));
}
