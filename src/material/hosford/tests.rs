//! Hosford's condition against closed forms, against Hill's, and against its own derivatives.

use super::*;
use crate::material::yield_condition::{differences, dot, rows};
use approx::assert_relative_eq;
use std::f64::consts::TAU;

const RATIOS: [f64; 6] = [0.3, 0.6, 1.0, 1.5, 2.0, 2.5];
const EXPONENTS: [f64; 7] = [2.0, 2.3, 3.0, 6.0, 7.5, 8.0, 20.0];

fn conditions() -> impl Iterator<Item = Hosford> {
    RATIOS.into_iter().flat_map(|r| EXPONENTS.into_iter().map(move |a| Hosford::new(r, a)))
}

fn directions() -> impl Iterator<Item = Triple> {
    let angles = (0..720).map(|i| TAU * f64::from(i) / 720.0);
    angles.flat_map(|angle| [0.0, 0.4].map(|shear| [angle.cos(), angle.sin(), shear]))
}

/// ∂σ̄/∂σ.
pub(in crate::material) fn flow_direction(law: &Hosford, s: Triple) -> Triple {
    let (major, minor, swapped) = ordered(s);
    let [ss, st, tt] = law.curvature(if major == 0.0 { 0.0 } else { minor / major });
    let [ss, tt] = if swapped { [tt, ss] } else { [ss, tt] };
    [ss * s[0] + st * s[1], st * s[0] + tt * s[1], SHEAR_INVERSE * s[2]].map(|g| g / law.equivalent_stress(s))
}

/// Trust: the flow rule, and Euler's and Legendre's identities. A stress of the strain e lies on the surface, does the work
/// Δε̄ on e, and its direction of flow is e/Δε̄.
#[test]
fn stress_lies_on_the_surface_with_the_strain_as_its_normal() {
    for law in conditions() {
        for e in directions() {
            let (stress, increment) = (law.stress(e), law.equivalent_increment(e));
            assert_relative_eq!(law.equivalent_stress(stress), 1.0, max_relative = 1e-12);
            assert_relative_eq!(dot(stress, e), increment, max_relative = 1e-12);
            let normal = flow_direction(&law, stress);
            for i in 0..3 {
                assert!((increment * normal[i] - e[i]).abs() < 1e-9, "{law:?} {e:?}");
            }
        }
    }
}

/// Trust: central differences of the gradient with h = 1e-6: truncation h² times the third derivative, which the sharp
/// corners make large, and 1e-10 of round-off. Between 2 and 3 the matrix itself has kinks.
#[test]
fn matrix_is_the_derivative_of_the_gradient_and_gives_it_back() {
    for law in conditions().filter(|law| law.exponent() <= 8.0 && law.exponent() != 2.3) {
        for e in directions() {
            let Metric { gradient, matrix, square } = law.metric(e);
            let largest = matrix[0].max(matrix[2]);
            assert_relative_eq!(dot(gradient, e), square, max_relative = 1e-12);
            let difference = differences(e, 1e-6, |e| law.metric(e).gradient);
            for ((row, gradient), difference) in rows(matrix).into_iter().zip(gradient).zip(difference) {
                assert_relative_eq!(dot(row, e), gradient, epsilon = 1e-12 * largest);
                for (entry, difference) in row.into_iter().zip(difference) {
                    assert!((entry - difference).abs() < 1e-5 * largest, "{law:?} {e:?}");
                }
            }
        }
    }
}
