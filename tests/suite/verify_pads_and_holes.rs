//! A pad under a bottom, and the free edge of a hole.

use crate::common::prelude::*;

/// Trust: the pad's position is an unknown of its own equation, which converges with the others to 1e-5 of the largest force.
/// The bow without a pad is what a strip keeps that leaves the nose at its curvature.
#[test]
fn a_pad_presses_with_its_force_and_holds_the_bottom_flat() {
    let [free, held] =
        [&[][..], &[("pad-pressure", "1 MPa")]].map(|given| made("u-bend", given, &[]).solve(&mut ()).stages.remove(0));
    held.steps.iter().for_each(|step| assert_relative_eq!(step.pad_force, 28.0, max_relative = 1e-3));
    let bow = |stage: &StageSolution| stage.steps.last().map_or(0.0, |last| last.pole_height - last.travel);
    assert!(bow(&free) > 1.0 && bow(&held).abs() < 0.05, "{} {}", bow(&free), bow(&held));
}

/// Trust: the free edge of a hole bears the hoop stress alone, so that it thins as a tension test, t = t₀ (d₀/d)^½ for r̄ = 1; its
/// hoop strain is ln(d/d₀) by definition. Both are extrapolated from the first elements' middles, half an element away.
#[test]
fn the_edge_of_a_hole_thins_as_a_tension_test() {
    let errors = [20, 40, 80].map(|elements| {
        let mut model = simple::pulled(Geometry::Axisymmetric, Theory::Membrane, 6.0);
        model.blank = Blank { hole: 10.0, elements, ..model.blank };
        let stage = solve(&model);
        let last = stage.frames.last().expect("a frame");
        let at_edge = |of: fn(&ElementRecord) -> f64| 1.5 * of(&last.elements[0]) - 0.5 * of(&last.elements[1]);
        let grown = last.nodes[0].r / 10.0;
        // Flat, so that its faces end where its middle does.
        assert_eq!(stage.steps.last().expect("a step").hole, 2.0 * last.nodes[0].r);
        assert!(grown > 1.2, "{grown}");
        let ratios = [at_edge(|e| e.strain_hoop) / grown.ln(), at_edge(|e| e.thickness) * grown.sqrt()];
        ratios.map(|ratio| (ratio - 1.0).abs())
    });
    assert!(errors[2].iter().all(|error| *error < 1e-3), "{errors:?}");
    for rate in [0, 1].map(|k| (errors[1][k] / errors[2][k]).log2()) {
        assert!(rate > 1.7, "second order in the element's length: {errors:?}");
    }
}

/// Trust: the hole at the limit by hand, Ø 10 (1 + λ); its instant is found to a thousandth of a step. Without the rule of stop the
/// same course passes the limit at the same travel.
#[test]
fn a_hole_expands_to_the_limit_of_its_edge() {
    let edge = |run: &Solution| {
        let found = findings(run);
        let answer = Answer::of(&run.case, &run.stages, &found);
        let row = row(&found, "edge");
        (row.light, row.statement(), answer.sentence)
    };
    let limit = |expansion: f64, scatter: f64| {
        let set = format!("blank.edge_limit={{ expansion = \"{expansion} %\", scatter = \"{scatter} %\" }}");
        edge(&made("hole-expansion", &[], &[&set]).solve(&mut ()))
    };
    let run = made("hole-expansion", &[("edge-limit", "40 %")], &[]).solve(&mut ());
    let (stop, end) = (&run.stages[0].stop, last(&run.stages[0]));
    assert_eq!(stop.kind, StopKind::EdgeLimit);
    assert_relative_eq!(end.hole, 14.0, max_relative = 1e-4);
    let (light, row, sentence) = edge(&run);
    assert!(light == Light::Green && row.contains("to Ø 14.0 mm, expansion ratio 40 %"), "{row}");
    assert!(sentence.contains("expansion ratio 40 %; it cracks at the edge of its hole, after "), "{sentence}");
    let (light, row, _) = limit(40.0, 0.0);
    let cracks = format!("cracks at {:.1} mm of travel", end.travel);
    assert!(light == Light::Red && row.contains(&cracks), "{cracks}: {row}");
    assert_eq!([limit(55.0, 10.0), limit(55.0, 1.0)].map(|(light, ..)| light), [Light::Amber, Light::Green]);
    assert_eq!(edge(&made("hole-expansion", &[], &[]).solve(&mut ())).0, Light::Grey);
    // What is measured at the edge comes before what a computed curve says beside it.
    let (_, row, sentence) = edge(&made("hole-expansion", &[("edge-limit", "100 %")], &[]).solve(&mut ()));
    assert!(row.contains("expansion ratio 100 %") && sentence.contains("; it cracks"), "{sentence}");
}

/// Trust: 0.2 mm are promised of the height, the diameter is that of the punch. The rim of 11 mm is still widened where the sheet
/// beside it has come to rest, which is no neck.
#[test]
fn a_collar_is_as_high_and_as_wide_as_was_wanted() {
    let ironed: &[_] = &[("clearance", "0.75 mm")];
    let [flat, conical, spherical] = ["flat", "conical", "spherical"].map(|punch| [("punch", punch)]);
    for given in [&flat[..], &conical, &spherical, ironed] {
        let run = made("collar", &[given, &[("height", "11 mm")]].concat(), &[]).solve(&mut ());
        let (stage, frame) = (&run.stages[0], run.stages[0].frames.last().expect("a frame"));
        let (height, wide) = (part_height(frame).expect("a height"), last(stage).hole);
        assert!(run.is_complete() && (height - 11.0).abs() < 0.2, "{given:?}: {height}");
        assert!((wide - 40.0).abs() < 0.2, "{given:?}: {wide}");
        assert_eq!(stage.steps.iter().any(|step| step.ironing > 0.05), given == ironed, "{given:?}");
    }
}
