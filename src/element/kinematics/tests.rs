//! Rigid motions, and areas.

use super::*;
use approx::assert_relative_eq;

const A: Node = [11.0, 2.0, 0.2];
const B: Node = [12.1, 2.7, 0.5];

/// Trust: a rigid motion strains nothing, to round-off, however large: along the axis for a body of
/// revolution, any turn and shift in plane strain.
#[test]
fn rigid_motions_strain_nothing() {
    for theory in [Theory::Bending, Theory::Membrane] {
        for (geometry, angle) in
            [(Geometry::Axisymmetric, 0.0), (Geometry::PlaneStrain, 1.9), (Geometry::PlaneStrain, -2.5)]
        {
            let ((s, c), out) = (f64::sin_cos(angle), if angle == 0.0 { 0.0 } else { 3.0 });
            let turned = |n: Node| [c * n[0] - s * n[1] + out - n[0], s * n[0] + c * n[1] - 8.0 - n[1], angle];
            let strain = Reference::new(geometry, theory, A, B).moved(turned(A), turned(B)).expect("sound").strain;
            assert!(strain.amax() < 1e-13, "{strain:?}");
        }
    }
}

/// Trust: by hand, 2π∫(1−r) r dr = π/3 for the node on the axis of a disc of radius 1.
#[test]
fn contact_areas_integrate_over_the_element() {
    for theory in [Theory::Bending, Theory::Membrane] {
        let reference = Reference::new(Geometry::Axisymmetric, theory, [0.0; 3], [1.0, 0.0, 0.0]);
        let areas = reference.contact_areas().into_iter().zip(stations(theory == Theory::Bending));
        let on_axis: f64 = areas.map(|(area, station)| area * station.shape[0]).sum();
        assert_relative_eq!(on_axis, std::f64::consts::PI / 3.0, max_relative = 1e-14);
    }
}
