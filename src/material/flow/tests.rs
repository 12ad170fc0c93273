//! The flow law against its closed forms and its matrices against differences.

use super::*;
use crate::material::{Hill48, Hosford, yield_condition::differences};
use approx::assert_relative_eq;
use nalgebra::{SMatrix, SVector};

const INCREMENTS: [Layer; 6] = [
    [1e-2, -5e-3, 0.0, 0.0, 0.0],
    [3e-3, 0.0, 4e-3, 1e-3, 1e-3],
    [2e-3, 2e-3, 0.0, 0.0, 0.0],
    [-4e-3, 1e-3, -2e-3, 0.0, -2e-3],
    [2e-6, -1e-6, 0.0, 0.0, 1e-6],
    [-1e-4, -3e-4, 4e-3, 1e-3, 5e-4],
];

fn criteria() -> [YieldCriterion; 5] {
    let hill = |r| Hill48::new(r).into();
    [hill(1.0), Hosford::new(0.5, 8.0).into(), hill(0.5), Hosford::new(1.8, 6.0).into(), hill(1.8)]
}

fn flow(hardening: &Hardening, criterion: YieldCriterion, matrix: Iteration) -> FlowLaw<'_> {
    let (softening, voids) = (None, None);
    FlowLaw { hardening, rate: None, softening, criterion, voids, matrix, cutoff: 1e-6, duration: 0.1 }
}

/// C by the strains in the plane, their spread and the shear.
pub(crate) fn matrix(tangent: &Tangent) -> SMatrix<f64, 5, 5> {
    let Tangent { own: [ss, st, tt, sg, tg, gg], coupling: [xx, xy, yy], across: a, outer } = *tangent;
    let [first, second, third] = [[ss, st, xx, xy, sg], [st, tt, xy, yy, tg], [xx, xy, a * ss, a * st, 0.0]];
    let [g, h] = outer.map(SVector::from);
    let c = SMatrix::from([first, second, third, [xy, yy, a * st, a * tt, 0.0], [sg, tg, 0.0, 0.0, gg]]);
    c + g * h.transpose() + h * g.transpose()
}

fn at(law: &FlowLaw, iterate: &mut Iterate, point: &PointState, u: Layer) -> (Layer, [Layer; 5]) {
    let (update, tangent) = law.respond(point, iterate, [u[0], u[1], u[4]], [u[2], u[3]]);
    let ([s, t, shear], [ms, mt]) = (update.stress, update.moment);
    ([s, t, ms, mt, shear], matrix(&tangent).into())
}

/// Trust: central differences with h = 1e-5 of the increment; truncation near 1e-10 of the entries, 1e-7 on a flat of Hosford's.
#[test]
fn newton_matrix_is_the_derivative_of_stress_and_moment_for_every_law() {
    let rates = Rate::examples();
    let rates: Vec<_> = std::iter::once(None).chain(rates.iter().map(|(_, rate)| Some(rate))).collect();
    let surroundings = Surroundings { exponent: 0.005, increment: 2e-3, floor: 1e-4 };
    let start = PointState { surroundings, ..PointState::at(0.05) };
    for (name, hardening) in &Hardening::examples() {
        for (criterion, rate) in criteria().into_iter().zip(rates.iter().cycle()) {
            let law = FlowLaw { rate: *rate, ..flow(hardening, criterion, Iteration::Newton) };
            for (u, goes_on) in INCREMENTS.into_iter().flat_map(|u| [(u, false), (u, true)]) {
                let (p, spread) = ([1.2 * u[0], 0.9 * u[1], 0.7 * u[4]], [0.8 * u[2], u[3]]);
                let point = if goes_on { start.following(p, spread, 0.4, criterion, None) } else { start };
                let at = |u: Layer| at(&law, &mut Iterate::default(), &point, u);
                let c = at(u).1;
                let accuracy = 1e-5 * c[0][0].abs().max(c[1][1].abs());
                let h = 1e-5 * u.iter().fold(0.0, |largest: f64, u| largest.max(u.abs()));
                let difference = differences(u, h, |u| at(u).0);
                for (c, difference) in c.as_flattened().iter().zip(difference.as_flattened()) {
                    assert!((c - difference).abs() < accuracy, "{name}, {rate:?}, {criterion} {u:?} {goes_on}");
                }
            }
        }
    }
}

/// Trust: with w = σ the primal-dual matrix is Newton's, to round-off; with w inside the yield surface no eigenvalue is negative.
#[test]
fn primal_dual_matrix_is_newtons_at_the_stress_and_positive_semidefinite_along_any_path() {
    let point = PointState::at(0.05);
    for ((name, hardening), criterion) in
        Hardening::examples().into_iter().flat_map(|law| criteria().map(|criterion| (law.clone(), criterion)))
    {
        let [newton, dual] = [Iteration::Newton, Iteration::PrimalDual].map(|by| flow(&hardening, criterion, by));
        let mut iterate = Iterate::default();
        for u in INCREMENTS {
            let (stress, newton) = at(&newton, &mut Iterate::default(), &point, u);
            let own = at(&dual, &mut Iterate { carried: stress, ..Iterate::default() }, &point, u).1;
            for (newton, own) in newton.as_flattened().iter().zip(own.as_flattened()) {
                assert_relative_eq!(newton, own, epsilon = 1e-9 * stress[0].hypot(stress[1]) / u[0].hypot(u[1]));
            }
            let m = SMatrix::<f64, 5, 5>::from(at(&dual, &mut iterate, &point, u).1);
            let smallest = m.symmetric_eigenvalues().min();
            assert!(smallest > -1e-9 * m.norm(), "{name}, {criterion} {smallest}");
        }
    }
}
