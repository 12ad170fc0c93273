//! Rows and geometric stiffness against differences, rigid motions, areas.

use super::*;
use approx::assert_relative_eq;

const A: Node = [11.0, 2.0, 0.2];
const B: Node = [12.1, 2.7, 0.5];

fn kinds() -> Vec<Reference> {
    let mut kinds = Vec::new();
    for geometry in [Geometry::Axisymmetric, Geometry::PlaneStrain] {
        for theory in [Theory::Bending, Theory::Membrane] {
            kinds.push(Reference::new(geometry, theory, A, B));
        }
    }
    kinds
}

fn moved(delta: &[f64; 6]) -> (Node, Node) {
    ([delta[0], delta[1], delta[2]], [delta[3], delta[4], delta[5]])
}

const STEP: [f64; 6] = [0.05, 0.11, 0.03, -0.02, 0.31, -0.05];

/// Trust: central differences, h = 1e-5: truncation near 1e-10.
#[test]
fn rows_and_geometric_stiffness_are_derivatives() {
    let h = 1e-5;
    for reference in kinds() {
        let at = |delta: &[f64; 6]| {
            let (a, b) = moved(delta);
            reference.moved(a, b).expect("sound")
        };
        let rows = at(&STEP).strain_displacement();
        let s = Generalised::from([3.0, -2.0, 0.7, 1.3, -0.9]);
        let k = at(&STEP).geometric_stiffness(&s);
        for j in 0..6 {
            let (mut plus, mut minus) = (STEP, STEP);
            plus[j] += h;
            minus[j] -= h;
            let (plus, minus) = (at(&plus), at(&minus));
            for i in 0..5 {
                assert_relative_eq!(rows[(i, j)], (plus.strain[i] - minus.strain[i]) / (2.0 * h), epsilon = 1e-8);
            }
            let (p, m) = (plus.strain_displacement(), minus.strain_displacement());
            for i in 0..6 {
                let second: f64 = (0..5).map(|a| s[a] * (p[(a, i)] - m[(a, i)]) / (2.0 * h)).sum();
                assert_relative_eq!(k[(i, j)], second, epsilon = 1e-7);
            }
        }
    }
}

/// Trust: a rigid motion strains nothing, to round-off, however large: along the axis for a body of
/// revolution, any turn and shift in plane strain.
#[test]
fn rigid_motions_strain_nothing() {
    for theory in [Theory::Bending, Theory::Membrane] {
        let lifted = |_: Node| [0.0, 37.0, 0.0];
        let strain =
            Reference::new(Geometry::Axisymmetric, theory, A, B).moved(lifted(A), lifted(B)).expect("sound").strain;
        assert!(strain.iter().all(|e| e.abs() < 1e-13));
        for angle in [0.3, 1.9, -2.5] {
            let (s, c) = f64::sin_cos(angle);
            let turned = |n: Node| [c * n[0] - s * n[1] + 3.0 - n[0], s * n[0] + c * n[1] - 8.0 - n[1], angle];
            let strain =
                Reference::new(Geometry::PlaneStrain, theory, A, B).moved(turned(A), turned(B)).expect("sound").strain;
            assert!(strain.iter().all(|e| e.abs() < 1e-13), "{strain:?}");
        }
    }
}

#[test]
fn contact_areas_integrate_over_the_element() {
    // Axis element of a disc of radius 1: 2π∫(1−r) r dr = π/3 for the node on the axis.
    for theory in [Theory::Bending, Theory::Membrane] {
        let reference = Reference::new(Geometry::Axisymmetric, theory, [0.0; 3], [1.0, 0.0, 0.0]);
        let areas = reference.contact_areas().into_iter().zip(stations(theory == Theory::Bending));
        let on_axis: f64 = areas.map(|(area, station)| area * station.shape[0]).sum();
        assert_relative_eq!(on_axis, std::f64::consts::PI / 3.0, max_relative = 1e-14);
    }
}
