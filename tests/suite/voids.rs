//! The voided law against closed forms, differences and an integration of its own.

use crate::common::prelude::*;
use stampflow::material::{PointLaw, flow::Iterate, gtn::Evolution};

type Triple = [f64; 3];

fn points() -> Vec<Triple> {
    vec![
        [1e-2, -5e-3, 0.0],
        [3e-3, 0.0, 1e-3],
        [2e-3, 2e-3, 0.0],
        [2e-3, -2e-3, 1e-4],
        [-4e-3, 1e-3, -2e-3],
        [-2e-3, -2e-3, 0.0],
        [2e-6, -1e-6, 1e-6],
        [-1e-4, -3e-4, 5e-4],
    ]
}

/// Gurson's own model: no interaction of voids, none that open, none that join.
fn gurson(initial: f64) -> Gtn {
    Gtn { q1: 1.0, q2: 1.0, q3: 1.0, initial, nucleation: None, coalescence: None }
}

fn hardening() -> Hardening {
    Hardening::Swift(Swift::new(500.0, 0.2, 0.01).expect("valid"))
}

fn law<'a>(hardening: &'a Hardening, voids: Option<&'a Gtn>, matrix: Iteration) -> FlowLaw<'a> {
    let criterion = Hill48::default().into();
    FlowLaw { hardening, rate: None, softening: None, criterion, voids, matrix, cutoff: 1e-7, duration: 0.1 }
}

fn at(law: &FlowLaw, porosity: f64, e: Triple) -> StressUpdate {
    law.respond(&PointState { porosity, ..PointState::at(0.05) }, &mut Iterate::default(), e, [0.0; 2]).0
}

fn tangent(law: &FlowLaw, iterate: &mut Iterate, porosity: f64, e: Triple) -> [Triple; 3] {
    law.respond(&PointState { porosity, ..PointState::at(0.05) }, iterate, e, [0.0; 2]).1.rows()
}

/// The yield condition itself, as printed.
fn phi(voids: &Gtn, r: f64, f: f64, s: Triple) -> f64 {
    let q = r / (1.0 + r);
    let square = s[0] * s[0] - 2.0 * q * s[0] * s[1] + s[1] * s[1] + 3.0 / (5.0 / 6.0) * s[2] * s[2];
    let f = voids.effective(f);
    square + 2.0 * voids.q1 * f * (0.5 * voids.q2 * (s[0] + s[1])).cosh() - 1.0 - voids.q3 * f * f
}

/// Trust: the definition. The stress lies on Φ = 0, the increment is normal to it (by differences of Φ, h = 1e-5), and
/// no other point of Φ = 0 near it does more work.
#[test]
fn stress_lies_on_the_yield_surface_and_the_increment_is_normal_to_it() {
    for r in [0.5, 1.0, 2.0] {
        for f in [0.0, 1e-4, 0.01, 0.1, 0.2] {
            let condition = Gtn::example().condition(Hill48::new(r), f);
            for e in points() {
                let metric = condition.metric(e);
                let s = metric.gradient.map(|a| a / metric.square.sqrt());
                let shifted = |i: usize, h: f64| {
                    let mut s = s;
                    s[i] += h;
                    phi(&Gtn::example(), r, f, s)
                };
                assert!(shifted(0, 0.0).abs() < 1e-12, "r {r} f {f} {e:?}: {}", shifted(0, 0.0));
                let gradient = [0, 1, 2].map(|i| (shifted(i, 1e-5) - shifted(i, -1e-5)) / 2e-5);
                let norm = |v: &[f64]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
                let cosine = (0..3).map(|i| gradient[i] * e[i]).sum::<f64>() / (norm(&gradient) * norm(&e));
                assert!((cosine - 1.0).abs() < 1e-9, "r {r} f {f} {e:?}: {cosine}");
            }
        }
    }
}

/// Trust: the plain law. Without voids in a voided law the stresses and matrices are the same to round-off.
#[test]
fn without_voids_it_is_the_plain_law() {
    let hardening = hardening();
    for voids in [gurson(0.0), Gtn { initial: 0.0, ..Gtn::example() }] {
        for matrix in [Iteration::Secant, Iteration::Newton, Iteration::PrimalDual] {
            for e in points() {
                let laws = [None, Some(&voids)].map(|voids| law(&hardening, voids, matrix));
                let [plain, voided] = laws.each_ref().map(|law| at(law, 0.0, e));
                let [c, with_voids] = laws.each_ref().map(|law| tangent(law, &mut Iterate::default(), 0.0, e));
                assert_relative_eq!(plain.increment, voided.increment, max_relative = 1e-12);
                for i in 0..3 {
                    assert!((plain.stress[i] - voided.stress[i]).abs() < 1e-12 * plain.yield_stress);
                }
                for (plain, voided) in c.as_flattened().iter().zip(with_voids.as_flattened()) {
                    assert!((plain - voided).abs() < 1e-11 * c[0][0].abs(), "{e:?}");
                }
            }
        }
    }
}

/// Trust: central differences with h = 1e-4 of the increment; truncation near 1e-8 of the entries.
#[test]
fn newton_matrix_is_the_derivative_of_the_stress() {
    let (hardening, voids, rates) = (hardening(), Gtn::example(), Rate::examples());
    for rate in std::iter::once(None).chain(rates.iter().map(|(_, rate)| Some(rate))) {
        for (f, r) in [(0.001, 1.0), (0.05, 0.5), (0.1, 1.0), (0.2, 2.0)] {
            let law =
                FlowLaw { rate, criterion: Hill48::new(r).into(), ..law(&hardening, Some(&voids), Iteration::Newton) };
            for e in points() {
                let c = tangent(&law, &mut Iterate::default(), f, e);
                let h = 1e-4 * law.criterion.equivalent_increment(e);
                for j in 0..3 {
                    let shifted = |sign: f64| {
                        let mut e = e;
                        e[j] += sign * h;
                        at(&law, f, e).stress
                    };
                    let (plus, minus) = (shifted(1.0), shifted(-1.0));
                    for i in 0..3 {
                        let difference = (plus[i] - minus[i]) / (2.0 * h);
                        assert!((c[i][j] - difference).abs() < 1e-5 * c[0][0].abs(), "f {f} r {r} {e:?} {i}{j}");
                    }
                }
            }
        }
    }
}

/// With the carried stress inside the yield surface the primal-dual matrix has no negative eigenvalue.
#[test]
fn primal_dual_matrix_is_positive_semidefinite_along_any_path() {
    let (hardening, voids) = (hardening(), Gtn::example());
    let law = law(&hardening, Some(&voids), Iteration::PrimalDual);
    for f in [0.0, 0.05, 0.2] {
        let mut iterate = Iterate::start([0.0; 3]);
        for e in points() {
            let m = nalgebra::Matrix3::from(tangent(&law, &mut iterate, f, e));
            let smallest = m.symmetric_eigenvalues().min();
            assert!(smallest > -1e-9 * m.norm(), "f {f} {e:?} {smallest}");
        }
    }
}

/// Rates of f, ε̄ and volume per meridional strain, written down from the three-dimensional flow
/// rule in principal stresses, with nothing of the code above: ε̇_ij ∝ 3 s_ij + q₁ q₂ f* sinh(…) δ_ij.
pub fn rates(voids: &Gtn, f: f64, strain: f64, sigma: [f64; 3]) -> [f64; 3] {
    let star = match voids.coalescence {
        Some(c) if f > c.critical => {
            c.critical + (1.0 / voids.q1 - c.critical) / (c.fracture - c.critical) * (f - c.critical)
        }
        _ => f,
    };
    let unit = |k: f64| {
        let s = sigma.map(|s| k * s);
        let mean = (s[0] + s[1] + s[2]) / 3.0;
        let mises = 0.5 * ((s[0] - s[1]).powi(2) + (s[1] - s[2]).powi(2) + (s[2] - s[0]).powi(2));
        mises + 2.0 * voids.q1 * star * (1.5 * voids.q2 * mean).cosh() - 1.0 - voids.q3 * star * star
    };
    let [size, _] = bisect(0.0, 2.0, 200, |size| unit(size) < 0.0);
    let s = sigma.map(|x| size * x);
    let mean = (s[0] + s[1] + s[2]) / 3.0;
    let swell = voids.q1 * voids.q2 * star * (1.5 * voids.q2 * mean).sinh();
    let e = s.map(|s| 3.0 * (s - mean) + swell);
    let work: f64 = (0..3).map(|i| s[i] * e[i]).sum();
    let metal = work / (1.0 - f) / e[0];
    let volume = (e[0] + e[1] + e[2]) / e[0];
    let nucleating = voids.nucleation.map_or(0.0, |n| {
        n.fraction / (n.deviation * TAU.sqrt()) * (-0.5 * ((strain - n.strain) / n.deviation).powi(2)).exp()
    });
    [(1.0 - f) * volume + nucleating * metal, metal, volume]
}

/// Trust: the ordinary differential equation integrated on its own from the three-dimensional flow rule, in uniaxial and
/// equi-biaxial stress, 20 000 midpoint steps (own error 1e-9 of f). The law gets to 1e-6 with steps of 0.0005.
#[test]
fn porosity_follows_the_integrated_equation_in_uniaxial_and_equi_biaxial_tension() {
    let anisotropy = Hill48::default();
    for voids in [gurson(0.01), Gtn::example()] {
        for (name, sigma) in [("uniaxial", [1.0, 0.0, 0.0]), ("equi-biaxial", [1.0, 1.0, 0.0])] {
            const END: f64 = 0.4;
            let steps = 20_000;
            let h = END / f64::from(steps);
            let (mut f, mut strain) = (voids.initial, 0.0);
            for _ in 0..steps {
                let [df, de, _] = rates(&voids, f, strain, sigma);
                let [df, de, _] = rates(&voids, f + 0.5 * h * df, strain + 0.5 * h * de, sigma);
                f += h * df;
                strain += h * de;
            }
            // The law is driven by strains; the hoop strain is the one that leaves the hoop stress as given.
            let coarse = 800;
            let step = END / f64::from(coarse);
            let mut now = Evolution { porosity: voids.initial, strain: 0.0, volume: 0.0 };
            let mut rate = 0.0;
            for _ in 0..coarse {
                let middle = now.porosity + 0.5 * rate * step;
                let hoop = match name {
                    "uniaxial" => {
                        let condition = voids.condition(anisotropy, middle);
                        let is_pressed = |hoop| condition.metric([step, hoop, 0.0]).gradient[1] <= 0.0;
                        bisect(-step, 0.0, 100, is_pressed)[0]
                    }
                    _ => step,
                };
                let next = voids.evolve(anisotropy, now.porosity, now.strain, [step, hoop, 0.0]);
                rate = (next.porosity - now.porosity) / step;
                now = next;
            }
            assert!((now.porosity - f).abs() < 1e-6, "{name}: {} for {f}", now.porosity);
            assert!((now.strain - strain).abs() < 1e-6 * (1.0 + strain), "{name}: {} for {strain}", now.strain);
        }
    }
}

/// Trust: by hand. f* meets f at f_c and 1/q₁ at f_F (q₃ = q₁²), where the metal bears nothing.
#[test]
fn coalescence_leads_from_the_critical_porosity_to_fracture() {
    let voids = Gtn::example();
    assert_eq!(voids.effective(0.15), 0.15);
    assert_relative_eq!(voids.effective(0.2), 0.15 + (1.0 / 1.5 - 0.15) / 0.1 * 0.05, max_relative = 1e-12);
    assert_relative_eq!(voids.effective(0.3), 0.99 / 1.5, max_relative = 1e-12);
    assert_eq!(voids.fracture(), 0.25);
    let weak = voids.condition(Hill48::default(), 0.25).metric([1.0, 0.0, 0.0]);
    assert!(weak.square.sqrt() < 0.02, "{}", weak.square.sqrt());
}
