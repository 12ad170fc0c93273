//! The flow law against its closed forms and its matrices against differences.

use super::*;
use crate::material::Hill48;
use crate::material::Surroundings;
use approx::assert_relative_eq;

const CUTOFF: f64 = 1e-6;

fn points() -> Vec<Triple> {
    vec![
        [1e-2, -5e-3, 0.0],
        [3e-3, 0.0, 1e-3],
        [2e-3, 2e-3, 0.0],
        [-4e-3, 1e-3, -2e-3],
        [2e-6, -1e-6, 1e-6],
        [-1e-4, -3e-4, 5e-4],
    ]
}

/// Hill's condition and Hosford's.
fn criteria() -> [YieldCriterion; 5] {
    let hill = |r| Hill48::new(r).into();
    [hill(1.0), Hosford::new(0.5, 8.0).into(), hill(0.5), Hosford::new(1.8, 6.0).into(), hill(1.8)]
}

fn flow(hardening: &Hardening, matrix: Iteration) -> FlowLaw<'_> {
    let criterion = YieldCriterion::default();
    let (softening, voids) = (None, None);
    FlowLaw { hardening, rate: None, softening, criterion, voids, matrix, cutoff: CUTOFF, duration: 0.1 }
}

fn at(law: &FlowLaw, e: Triple) -> StressUpdate {
    Iterate::start([0.0; 3]).advance(law, &PointState::at(0.05), e)
}

fn full(c: Symmetric) -> [[f64; 3]; 3] {
    [[c[0], c[1], c[3]], [c[1], c[2], c[4]], [c[3], c[4], c[5]]]
}

/// Trust: central differences with h = 1e-4 of the increment; truncation near 1e-8 of the entries.
#[test]
fn newton_matrix_is_the_derivative_of_the_stress_for_every_law() {
    let rates = Rate::examples();
    let rates = std::iter::once(("rate-free", None)).chain(rates.iter().map(|(name, rate)| (*name, Some(rate))));
    for (rate_name, rate) in rates {
        for ((name, hardening), criterion) in Hardening::examples().into_iter().zip(criteria().into_iter().cycle()) {
            let law = FlowLaw { rate, criterion, ..flow(&hardening, Iteration::Newton) };
            let surroundings = Surroundings { exponent: 0.005, increment: 2e-3, floor: 1e-4 };
            let point = PointState { surroundings, ..PointState::at(0.05) };
            let at = |law: &FlowLaw, e: Triple| Iterate::start([0.0; 3]).advance(law, &point, e);
            for e in points() {
                let c = full(at(&law, e).tangent);
                let h = 1e-4 * law.criterion.equivalent_increment(e);
                let largest = c[0][0].abs().max(c[1][1].abs());
                for j in 0..3 {
                    let shifted = |sign: f64| {
                        let mut e = e;
                        e[j] += sign * h;
                        at(&law, e).stress
                    };
                    let (plus, minus) = (shifted(1.0), shifted(-1.0));
                    for i in 0..3 {
                        let difference = (plus[i] - minus[i]) / (2.0 * h);
                        let wrong = (c[i][j] - difference).abs();
                        assert!(wrong < 1e-5 * largest, "{name}, {rate_name}, {criterion} {e:?} {i}{j}");
                    }
                }
            }
        }
    }
}

fn following(p: Triple, law: &FlowLaw) -> PointState {
    PointState::at(0.05).following(p, [0.0; 2], 0.4, law.criterion, law.voids)
}

/// Trust: as above, with a past.
#[test]
fn newton_matrix_is_the_derivative_where_the_flow_goes_on() {
    let rate = &Rate::examples()[0].1;
    for (name, hardening) in Hardening::examples() {
        let law = FlowLaw { rate: Some(rate), ..flow(&hardening, Iteration::Newton) };
        for e in points() {
            let point = following([1.2 * e[0], 0.9 * e[1], 0.7 * e[2]], &law);
            let at = |e: Triple| Iterate::start([0.0; 3]).advance(&law, &point, e);
            let c = full(at(e).tangent);
            let h = 1e-4 * law.criterion.equivalent_increment(e);
            for j in 0..3 {
                let shifted = |sign: f64| {
                    let mut e = e;
                    e[j] += sign * h;
                    at(e).stress
                };
                let (plus, minus) = (shifted(1.0), shifted(-1.0));
                for i in 0..3 {
                    let wrong = (c[i][j] - (plus[i] - minus[i]) / (2.0 * h)).abs();
                    assert!(wrong < 1e-5 * c[0][0].abs(), "{name} {e:?} {i}{j}");
                }
            }
        }
    }
}

/// Trust: a path that turns, ε = (0.3 t, 0.2 t²) with t up to 1, has its end's rate (0.3, 0.4), and its ε̄ by an
/// integration with a hundred thousand chords, which miss 1e-10. The order of the error in stress is that of the rate:
/// 2 where a step follows the last one, 1 where it does not.
#[test]
fn stress_is_second_order_in_the_step_where_the_flow_goes_on() {
    let hardening = &Hardening::examples()[0].1;
    let rate = &Rate::examples()[0].1;
    let path = |t: f64| [0.3 * t, 0.2 * t * t, 0.0];
    let chord = |from: f64, to: f64| [0, 1, 2].map(|i| path(to)[i] - path(from)[i]);
    let metal = Hill48::default();
    let fine = 100_000;
    let strain: f64 = (0..fine)
        .map(|k| metal.equivalent_increment(chord(f64::from(k) / f64::from(fine), f64::from(k + 1) / f64::from(fine))))
        .sum();
    let speed = [0.3, 0.4, 0.0];
    let yield_stress = hardening.at(strain).stress * rate.at(metal.equivalent_increment(speed)).value;
    let exact = metal.apply(speed).map(|a| a * yield_stress / metal.equivalent_increment(speed));
    let error = |steps: u32, weight: f64| {
        let dt = 1.0 / f64::from(steps);
        let law = FlowLaw { rate: Some(rate), duration: dt, ..flow(hardening, Iteration::Newton) };
        let (mut total, mut stress) = (0.0, [0.0; 3]);
        for k in 0..steps {
            let t = dt * f64::from(k);
            let mut point = PointState::at(total);
            if k > 0 {
                point = point.following(chord(t - dt, t), [0.0; 2], weight, metal.into(), None);
            }
            let update = Iterate::start([0.0; 3]).advance(&law, &point, chord(t, t + dt));
            (total, stress) = (total + update.increment, update.stress);
        }
        (stress[0] - exact[0]).hypot(stress[1] - exact[1]) / yield_stress
    };
    for (weight, order) in [(0.5, 2.0), (0.0, 1.0)] {
        let found = (error(40, weight) / error(80, weight)).log2();
        assert!((found - order).abs() < 0.1, "weight {weight}: order {found}");
    }
}

/// Trust: the definition. Stress is σ_s(ε̄) g(ε̄̇) in tension; the cut-off changes the rate by 5e-9 of itself.
#[test]
fn rate_multiplies_the_yield_stress() {
    for (_, hardening) in Hardening::examples() {
        for (name, rate) in Rate::examples() {
            let law = FlowLaw { rate: Some(&rate), ..flow(&hardening, Iteration::Newton) };
            let response = at(&law, [1e-2, -5e-3, 0.0]);
            let expected = hardening.at(0.05 + 1e-2).stress * rate.at(1e-2 / law.duration).value;
            assert_relative_eq!(response.stress[0], expected, max_relative = 1e-7);
            assert!(response.yield_stress > 0.0, "{name}");
        }
    }
}

/// Trust: with w = σ the primal-dual matrix is Newton's, to round-off.
#[test]
fn primal_dual_matrix_is_newtons_when_the_carried_stress_is_the_stress() {
    for (_, hardening) in Hardening::examples() {
        for (e, criterion) in points().into_iter().flat_map(|e| criteria().map(|criterion| (e, criterion))) {
            let law = |matrix| FlowLaw { criterion, ..flow(&hardening, matrix) };
            let newton = at(&law(Iteration::Newton), e);
            let dual = Iterate::start(newton.stress).advance(&law(Iteration::PrimalDual), &PointState::at(0.05), e);
            let largest = newton.tangent[0].abs().max(newton.tangent[2].abs());
            for i in 0..6 {
                assert_relative_eq!(newton.tangent[i], dual.tangent[i], epsilon = 1e-9 * largest);
            }
        }
    }
}

/// Trust: closed form (uniaxial σ_y, plane strain 2/√3 σ_y, equi-biaxial σ_y); the cut-off changes 1e-7.
#[test]
fn stress_states_match_their_closed_forms() {
    for (_, law) in Hardening::examples() {
        for (e, expected) in [
            ([1e-2, -5e-3, 0.0], [1.0, 0.0]),
            ([1e-2, 0.0, 0.0], [2.0 / 3f64.sqrt(), 1.0 / 3f64.sqrt()]),
            ([1e-2, 1e-2, 0.0], [1.0, 1.0]),
        ] {
            let response = at(&flow(&law, Iteration::PrimalDual), e);
            let sy = law.at(0.05 + response.increment).stress;
            assert_relative_eq!(response.stress[0], expected[0] * sy, max_relative = 1e-7);
            assert_relative_eq!(response.stress[1], expected[1] * sy, max_relative = 1e-7, epsilon = 1e-6);
            assert_relative_eq!(Hill48::default().equivalent_stress(response.stress), sy, max_relative = 1e-7);
        }
    }
}

/// Why it is sturdy: with w inside the yield surface the matrix has no negative eigenvalue, from whatever
/// iterate it comes. (Newton's own has none either; its flat directions are what makes it jump.)
#[test]
fn primal_dual_matrix_is_positive_semidefinite_along_any_path() {
    for ((name, hardening), criterion) in
        Hardening::examples().into_iter().flat_map(|law| criteria().map(|criterion| (law.clone(), criterion)))
    {
        let law = FlowLaw { criterion, ..flow(&hardening, Iteration::PrimalDual) };
        let mut iterate = Iterate::start([0.0; 3]);
        for e in points() {
            let c = full(iterate.advance(&law, &PointState::at(0.05), e).tangent);
            let m = nalgebra::Matrix3::from_fn(|i, j| c[i][j]);
            let smallest = m.symmetric_eigenvalues().min();
            assert!(smallest > -1e-9 * m.norm(), "{name}, {criterion} {smallest}");
        }
    }
}

/// The matrix of a part, by the strains in the plane, their spread and the shear.
fn whole(part: &Across) -> [[f64; 5]; 5] {
    let ([ss, st, tt, shear], [g, h]) = (part.metric, part.outer);
    let mut c = std::array::from_fn(|i| std::array::from_fn(|j| g[i] * h[j] + h[i] * g[j]));
    for (i, j, k) in [(0, 0, 0), (0, 1, 1), (1, 0, 1), (1, 1, 2)] {
        let (own, coupling) = ([ss, st, tt][k], part.coupling.unwrap_or_default()[k]);
        c[i][j] += own;
        c[2 + i][2 + j] += MEAN_SQUARE * own;
        c[i][2 + j] += coupling;
        c[2 + i][j] += coupling;
    }
    c[4][4] += shear;
    c
}

/// Trust: central differences with h = 1e-5 of the increment, for strain and spread; truncation near 1e-10 of the entries,
/// some thousand times that where Hosford's curve is flat.
#[test]
fn newton_matrix_of_a_part_is_the_derivative_of_its_stress_and_moment() {
    for (name, hardening) in Hardening::examples() {
        for (criterion, rate) in criteria().into_iter().zip([None, Some(Rate::examples()[0].1)].into_iter().cycle()) {
            let law = FlowLaw { rate: rate.as_ref(), criterion, ..flow(&hardening, Iteration::Newton) };
            for ([s, t, shear], [ks, kt]) in points().into_iter().zip([[4e-3, 1e-3], [-2e-3, 0.0]].into_iter().cycle())
            {
                let u = [s, t, ks, kt, shear];
                let at = |u: [f64; 5]| {
                    let across = Iterate::default().advance_across(
                        &law,
                        &PointState::at(0.05),
                        [u[0], u[1], u[4]],
                        [u[2], u[3]],
                    );
                    across.expect("without voids")
                };
                let c = whole(&at(u));
                let largest = c[0][0].abs().max(c[1][1].abs());
                let h = 1e-5 * u.iter().fold(0.0, |largest: f64, u| largest.max(u.abs()));
                for j in 0..5 {
                    let shifted = |sign: f64| {
                        let mut u = u;
                        u[j] += sign * h;
                        let Across { update, moment, .. } = at(u);
                        [update.stress[0], update.stress[1], moment[0], moment[1], update.stress[2]]
                    };
                    let (plus, minus) = (shifted(1.0), shifted(-1.0));
                    for i in 0..5 {
                        let difference = (plus[i] - minus[i]) / (2.0 * h);
                        let wrong = (c[i][j] - difference).abs();
                        assert!(wrong < 1e-5 * largest, "{name}, {criterion} {u:?} {i}{j}");
                    }
                }
            }
        }
    }
}

/// Trust: with w the stress and the moment the primal-dual matrix is Newton's, and without a spread a part is a point, to
/// round-off.
#[test]
fn a_part_with_its_own_stress_carried_has_newtons_matrix_and_one_without_spread_is_a_point() {
    let hardening = &Hardening::examples()[0].1;
    let (point, spread) = (PointState::at(0.05), [3e-3, -1e-3]);
    for (e, criterion) in points().into_iter().flat_map(|e| criteria().map(|criterion| (e, criterion))) {
        let law = |matrix| FlowLaw { criterion, ..flow(hardening, matrix) };
        let (newton, dual) = (law(Iteration::Newton), law(Iteration::PrimalDual));
        let across = |law: &FlowLaw, start: &mut Iterate, spread: [f64; 2]| {
            start.advance_across(law, &point, e, spread).expect("without voids")
        };
        let by_newton = across(&newton, &mut Iterate::default(), spread);
        let mut own = Iterate { carried_moment: by_newton.moment, ..Iterate::start(by_newton.update.stress) };
        let by_dual = across(&dual, &mut own, spread);
        let (c, dual) = (whole(&by_newton), whole(&by_dual));
        for (newton, dual) in c.iter().flatten().zip(dual.iter().flatten()) {
            assert_relative_eq!(newton, dual, epsilon = 1e-9 * c[0][0].max(c[1][1]));
        }
        let flat = across(&newton, &mut Iterate::default(), [0.0; 2]);
        let alone = at(&newton, e);
        for i in 0..3 {
            assert_relative_eq!(flat.update.stress[i], alone.stress[i], max_relative = 1e-14, epsilon = 1e-12);
        }
    }
}
