//! A pad under a bottom, and the free edge of a hole.

use crate::common::prelude::*;
use stampflow::{model::Blank, solver::solution::ElementRecord};

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
        assert!(grown > 1.2, "{grown}");
        let ratios = [at_edge(|e| e.strain_hoop) / grown.ln(), at_edge(|e| e.thickness) * grown.sqrt()];
        ratios.map(|ratio| (ratio - 1.0).abs())
    });
    assert!(errors[2].iter().all(|error| *error < 1e-3), "{errors:?}");
    for rate in [0, 1].map(|k| (errors[1][k] / errors[2][k]).log2()) {
        assert!(rate > 1.7, "second order in the element's length: {errors:?}");
    }
}
