//! Rows and geometric stiffness against differences, rigid motions, areas.

use super::*;
use approx::assert_relative_eq;

const A: Node = [11.0, 2.0, 0.2];
const B: Node = [12.1, 2.7, 0.5];

/// Trust: central differences, h = 1e-5: truncation near 1e-10.
#[test]
fn rows_and_geometric_stiffness_are_derivatives() {
    let (step, h) = ([0.05, 0.11, 0.03, -0.02, 0.31, -0.05], 1e-5);
    let s = Generalised::from([3.0, -2.0, 0.7, 1.3, -0.9]);
    for (geometry, theory) in [Geometry::Axisymmetric, Geometry::PlaneStrain]
        .into_iter()
        .flat_map(|geometry| [(geometry, Theory::Bending), (geometry, Theory::Membrane)])
    {
        let reference = Reference::new(geometry, theory, A, B);
        let at = |j: usize, h: f64| {
            let mut d = step;
            d[j] += h;
            reference.moved([d[0], d[1], d[2]], [d[3], d[4], d[5]]).expect("sound")
        };
        let (rows, k) = (at(0, 0.0).strain_displacement(), at(0, 0.0).geometric_stiffness(&s));
        for j in 0..6 {
            let (plus, minus) = (at(j, h), at(j, -h));
            let by = (plus.strain - minus.strain) / (2.0 * h);
            assert_relative_eq!(rows.column(j).into_owned(), by, epsilon = 1e-8);
            let second = (plus.strain_displacement() - minus.strain_displacement()).tr_mul(&s) / (2.0 * h);
            assert_relative_eq!(k.column(j).into_owned(), second, epsilon = 1e-7);
        }
    }
}

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
