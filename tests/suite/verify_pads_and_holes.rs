//! A pad under a bottom, and the free edge of a hole.

use crate::common::prelude::*;
use stampflow::model::Blank;
use stampflow::solver::solution::ElementRecord;

/// Trust: the pad's position is an unknown of its own equation, which converges with the others to 1e-5 of the largest force.
/// The bow without a pad is what a strip keeps that leaves the nose at its curvature.
#[test]
fn a_pad_presses_with_its_force_and_holds_the_bottom_flat() {
    let bend = templates::find("u-bend").expect("there").fill(&[]).expect("valid");
    let pad = "[tools.pad]\nhalf_width = \"12 mm\"\nforce = \"20 N/mm\"\nfriction = 0.08\n\n[[stages]]";
    let [free, held] = [bend.clone(), bend.replacen("[[stages]]", pad, 1)].map(|text| {
        let solution = parsed(&text, &[]).solve(&mut ());
        solution.stages.into_iter().next().expect("the bend")
    });
    for step in &held.steps {
        approx::assert_relative_eq!(step.pad_force, 20.0, max_relative = 1e-3);
    }
    let bow = |stage: &StageSolution| {
        let last = stage.frames.last().expect("a frame");
        last.nodes[0].z - last.travel
    };
    assert!(bow(&free) > 1.0 && bow(&held).abs() < 0.05, "{} {}", bow(&free), bow(&held));
    let [free, held] = [&free, &held].map(|stage| stage.steps.last().expect("a step").punch_force);
    approx::assert_relative_eq!(held, free + 20.0, max_relative = 0.1);
}

/// Trust: the free edge of a hole bears the hoop stress alone, so that it thins as a tension test, t = t₀ (d₀/d)^½ for r̄ = 1; its
/// hoop strain is ln(d/d₀) by definition. Both are extrapolated from the first elements' middles, half an element away.
#[test]
fn the_edge_of_a_hole_thins_as_a_tension_test() {
    let run = |elements: usize| {
        let mut model = simple::pulled(Geometry::Axisymmetric, Theory::Membrane, 6.0);
        model.blank = Blank { hole: 10.0, elements, ..model.blank };
        let stage = solve(&model);
        let last = stage.frames.last().expect("a frame");
        let grown = last.nodes[0].r / 10.0;
        let at_edge =
            |value: fn(&ElementRecord) -> f64| 1.5 * value(&last.elements[0]) - 0.5 * value(&last.elements[1]);
        let strain = at_edge(|element| element.strain_hoop) / grown.ln();
        [strain, at_edge(|element| element.thickness) * grown.sqrt(), grown]
    };
    let errors = [20, 40, 80].map(|elements| {
        let [strain, thickness, grown] = run(elements);
        assert!(grown > 1.2, "{grown}");
        [(strain - 1.0).abs(), (thickness - 1.0).abs()]
    });
    assert!(errors[2].iter().all(|error| *error < 1e-3), "{errors:?}");
    for rate in [0, 1].map(|k| (errors[1][k] / errors[2][k]).log2()) {
        assert!(rate > 1.7, "second order in the element's length: {errors:?}");
    }
}
