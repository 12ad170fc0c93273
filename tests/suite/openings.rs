//! Openings of dies: cone, tractrix, land and relief.

use crate::common::prelude::*;
use std::f64::consts::FRAC_PI_6;

fn opening(entry: Entry) -> Opening {
    Opening { throat: 30.0, shoulder: 4.0, entry, land: Some([6.0, 0.05]) }
}

/// Trust: the closed form x = a cos φ, z = a [ln(sec φ + tan φ) − sin φ] of where the curve has turned by φ; arcs are within 0.02 mm.
#[test]
fn a_tractrix_is_the_closed_form() {
    for mouth in [36.0, 45.0, 60.0] {
        let die = Profile::die_with(&opening(Entry::Tractrix { mouth }), 1.0);
        assert!(die.vertices().filter(|v| v.turn.abs() > 1e-6).count() == 1, "only the land has an edge");
        assert!((die.pieces()[1].first().x - mouth).abs() < 1e-6);
        assert!(die.land().is_some_and(|[land, _]| (land - 6.0).abs() < 1e-9));
        let arcs: Vec<&Piece> = die.pieces().iter().filter(|piece| matches!(piece, Piece::Arc(_))).collect();
        let places = arcs[1..].iter().map(|arc| {
            let Piece::Arc(arc) = arc else { unreachable!() };
            (arc.at(0.0), (-(arc.at(0.0) - arc.center).x / arc.radius).asin())
        });
        let places: Vec<(Point, f64)> = places.collect();
        let [(from, first), .., (to, last)] = places[..] else { panic!("arcs") };
        let length = (from.x - to.x) / (first.cos() - last.cos());
        let depth = |turn: f64| length * ((1.0 / turn.cos() + turn.tan()).ln() - turn.sin());
        for (at, turn) in &places {
            assert_relative_eq!(from.x - at.x, length * (first.cos() - turn.cos()), epsilon = 1e-9);
            assert_relative_eq!(at.y - from.y, depth(*turn) - depth(first), epsilon = 0.02);
        }
    }
}

/// Trust: by hand; the cone is as wide as mouth, throat and shoulder leave.
#[test]
fn a_cone_leads_tangentially_into_the_throat() {
    let die = Profile::die_with(&opening(Entry::Cone { angle: FRAC_PI_6, mouth: 50.0 }), 1.0);
    assert_relative_eq!(die.cone().expect("a cone"), FRAC_PI_6, epsilon = 1e-9);
    assert!(die.vertices().filter(|v| v.turn.abs() > 1e-9).count() == 1);
    let lines: Vec<f64> = die.pieces().iter().map(Piece::length).collect();
    assert_relative_eq!(lines[2], (20.0 - 4.0) / 0.5, epsilon = 1e-9);
}

/// Thick sheets without a holder go through cone and tractrix as through a shoulder, round and straight, by both laws.
///
/// Trust: known practice; a cup of 3 mm and β = 1.8 does not tear; the tractrix takes less force than the cone.
#[test]
fn thick_sheets_are_drawn_without_a_holder() {
    for (kind, size, wide) in [("axisymmetric", "radius", "radius"), ("plane_strain", "half_length", "half_width")] {
        let mut forces = Vec::new();
        for (entry, mode) in
            [("cone=30 deg", "flow"), ("tractrix=true", "flow"), ("tractrix=true", "elasto_viscoplastic")]
        {
            let text = format!(
                "title = \"Cup\"\ngeometry = \"{kind}\"\n[blank]\n{size} = \"54 mm\"\nthickness = \"3 mm\"\n\
                 [material]\nname = \"drawing-steel\"\n[tools]\n\
                 punch = {{ flat = {{ {wide} = \"30 mm\", nose = \"10 mm\" }}, friction = 0.08, travel = \"50 mm\" }}\n\
                 die = {{ throat = \"33.4 mm\", shoulder = \"8 mm\", friction = 0.08, land = \"6 mm\" }}\n"
            );
            let set = [format!("tools.die.{entry}"), format!("material.mode={mode}"), "blank.layers=9".into()];
            let run = solver::run(parsed(&text, &set.each_ref().map(String::as_str)).model(), &mut ());
            assert!(run.stop.is_complete() || run.stop.is_physical(), "{kind} {entry} {mode}: {}", run.stop);
            let end = run.steps.last().expect("steps");
            assert!(end.thinnest > 0.8 * 3.0, "{kind} {entry} {mode}: {} mm", end.thinnest);
            forces.push(peak(&run));
        }
        assert!(forces[1] < forces[0] && (forces[2] / forces[1] - 1.0).abs() < 0.1, "{kind}: {forces:?}");
    }
}
