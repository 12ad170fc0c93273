use super::*;
use crate::material::chaboche::shifting;
use crate::material::hosford::tests::flow_direction;
use crate::material::{BackStress, Elastic, Hill48, Hosford, YieldCriterion};
use approx::assert_relative_eq;

const STEEL: Elastic = Elastic { young: 206_000.0, poisson: 0.3 };

const KINEMATICS: [BackStresses; 3] = [
    [BackStress { modulus: 0.0, dynamic_recovery: 0.0 }; 2],
    [BackStress { modulus: 2500.0, dynamic_recovery: 0.0 }, BackStress { modulus: 0.0, dynamic_recovery: 0.0 }],
    [BackStress { modulus: 12_000.0, dynamic_recovery: 110.0 }, BackStress { modulus: 900.0, dynamic_recovery: 6.0 }],
];

fn law(hardening: &Hardening) -> ElastoplasticLaw<'_> {
    ElastoplasticLaw {
        hardening: Some(hardening),
        operators: Operators::new(STEEL, YieldCriterion::default()),
        kinematic: shifting(KINEMATICS[0]),
        rate: None,
        softening: None,
        secant: false,
        duration: 0.1,
    }
}

fn start(law: &ElastoplasticLaw) -> Carried {
    let shifts = if law.kinematic.is_none() { 0.0 } else { 1.0 };
    let at = Carried {
        strain: 0.03,
        temperature: crate::material::flow::ROOM_TEMPERATURE,
        stress: [60.0, -25.0, 8.0],
        dilation: 4e-3,
        back: [[20.0, 5.0, -3.0], [4.0, -6.0, 1.0]].map(|back| back.map(|a| shifts * a)),
        yield_stress: 0.0,
        surroundings: Surroundings { exponent: 0.005, increment: 5e-3, floor: 1e-4 },
    };
    Carried { yield_stress: law.yield_stress(&at), ..at }
}

const INCREMENTS: [Triple; 5] =
    [[1e-2, -5e-3, 0.0], [3e-3, 0.0, 1e-3], [-2e-3, -2e-3, 4e-4], [-4e-2, 1e-2, -2e-3], [2.5e-3, 3e-3, -5e-3]];

/// Ingredients of a law of [`for_every_law`].
#[derive(Debug)]
struct Setting {
    name: &'static str,
    kinematic: BackStresses,
    criterion: YieldCriterion,
}

/// Hill's condition and Hosford's.
fn criteria() -> [YieldCriterion; 6] {
    let hill = |r| Hill48::new(r).into();
    let hosford = |r, a| Hosford::new(r, a).into();
    [hill(1.0), hill(0.6), hill(2.0), hosford(0.4, 8.0), hosford(1.6, 6.0), hosford(0.8, 12.5)]
}

/// Every hardening law with every set of back-stresses and yield condition and every rate law, or none.
fn for_every_law(look: impl Fn(&Setting, &ElastoplasticLaw)) {
    let rates = Rate::examples();
    for (name, hardening) in Hardening::examples() {
        for (kinematic, criterion) in KINEMATICS.into_iter().cycle().zip(criteria()) {
            for rate in rates.iter().map(|(_, rate)| Some(rate)).chain([None]) {
                let law = ElastoplasticLaw {
                    kinematic: shifting(kinematic),
                    rate,
                    operators: Operators::new(STEEL, criterion),
                    ..law(&hardening)
                };
                look(&Setting { name, kinematic, criterion }, &law);
            }
        }
    }
}

/// Trust: the definition, to the round-off of an elastic trial stress of some GPa.
#[test]
fn stress_lies_on_the_yield_surface_and_follows_from_the_elastic_strain() {
    for_every_law(|setting, law| {
        for e in INCREMENTS {
            let mut trial = Trial::default();
            let (response, _) = law.respond(&start(law), &mut trial, e, [0.0; 2]);
            let volume = 1.0 + start(law).dilation;
            let back: Triple = std::array::from_fn(|j| volume * (trial.back[0][j] + trial.back[1][j]));
            let xi: Triple = std::array::from_fn(|j| response.stress[j] - back[j]);
            let size = law.radius(law.hardening.expect("yields"), &start(law), response.increment).stress;
            assert!(response.increment > 0.0, "{}", setting.name);
            // What the last round of Newton's method, linear in Δp, leaves.
            assert_relative_eq!(setting.criterion.equivalent_stress(xi), size, max_relative = 1e-8);
        }
    });
}

/// Trust: central differences with h = 1e-5 of the increment; truncation and round-off below 1e-5 of Young's modulus.
/// With recall the derivative is not symmetric, and its symmetric part is what is given.
#[test]
fn tangent_is_the_derivative_of_the_stress_for_every_law() {
    for_every_law(|setting, law| {
        for e in INCREMENTS.into_iter().chain([[1e-5, 2e-5, -1e-5]]) {
            let c = law.respond(&start(law), &mut Trial::default(), e, [0.0; 2]).1.own;
            let h = 1e-5 * e[0].abs().max(e[1].abs());
            let columns: Vec<Triple> = (0..3)
                .map(|j| {
                    let at = |sign: f64| {
                        let mut e = e;
                        e[j] += sign * h;
                        law.respond(&start(law), &mut Trial::default(), e, [0.0; 2]).0.stress
                    };
                    let (plus, minus) = (at(1.0), at(-1.0));
                    std::array::from_fn(|i| (plus[i] - minus[i]) / (2.0 * h))
                })
                .collect();
            let scale = STEEL.young;
            for (k, (i, j)) in [(0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2)].into_iter().enumerate() {
                let difference = 0.5 * (columns[j][i] + columns[i][j]);
                let wrong = (c[k] - difference).abs();
                assert!(wrong < 1e-5 * scale, "{setting:?} {:?} {e:?} {i}{j}: {} {difference}", law.rate, c[k]);
                let skew = (columns[j][i] - columns[i][j]).abs();
                assert!(
                    setting.kinematic[0].dynamic_recovery > 0.0 || skew < 1e-5 * scale,
                    "{setting:?}: not symmetric without recall"
                );
            }
        }
    });
}

/// Trust: the surface itself, and the law of flow. However far the trial stress lies, whichever way it points, cold or from a
/// guess that is a thousand times off, the stress is on the surface and its plastic strain along the normal, to 1e-9.
#[test]
fn return_finds_the_surface_from_everywhere() {
    let hardening = &Hardening::examples()[0].1;
    for (r, a) in [(0.3, 8.0), (1.0, 6.0), (2.5, 20.0), (10.0, 8.0), (0.1, 2.4)] {
        let condition = Hosford::new(r, a);
        let law = ElastoplasticLaw { operators: Operators::new(STEEL, condition.into()), ..law(hardening) };
        let elastic = ElastoplasticLaw { hardening: None, ..law };
        let point = Carried { stress: [0.0; 3], ..start(&law) };
        for (size, shear) in [(0.002, 0.0), (0.02, 0.0), (0.02, 0.03), (0.5, 0.0), (0.5, 1e-3), (0.0, 0.3)] {
            for i in 0..180 {
                let angle = std::f64::consts::TAU * f64::from(i) / 180.0;
                let e = [size * angle.cos(), size * angle.sin(), shear];
                for guess in [0.0, 1e-5, 10.0] {
                    let mut trial = Trial { increment: guess, ..Trial::default() };
                    let (answer, _) = law.respond(&point, &mut trial, e, [0.0; 2]);
                    if answer.increment == 0.0 {
                        continue;
                    }
                    let radius = law.radius(hardening, &point, answer.increment).stress;
                    assert_relative_eq!(condition.equivalent_stress(answer.stress), radius, max_relative = 1e-9);
                    let normal = flow_direction(&condition, answer.stress);
                    let left: Triple = std::array::from_fn(|j| e[j] - answer.increment * normal[j]);
                    let stress = elastic.respond(&point, &mut Trial::default(), left, [0.0; 2]).0.stress;
                    for j in 0..3 {
                        assert!((stress[j] - answer.stress[j]).abs() < 1e-9 * STEEL.young * answer.increment.max(1e-3));
                    }
                }
            }
        }
    }
}

/// Rates of the three-dimensional law in principal directions s, θ, n, integrated on its own.
struct Metal<'a> {
    hardening: &'a Hardening,
    kinematic: BackStresses,
    /// Perzyna: C and p of the overstress.
    viscous: Option<(f64, f64)>,
}

/// Stress and two back-stresses by s, θ, n, and ε̄.
type Tensors = nalgebra::SVector<f64, 10>;

impl Metal<'_> {
    /// Rates for in-plane strain rates; the normal strain rate keeps the normal stress zero.
    fn rates(&self, at: &Tensors, strain: [f64; 2]) -> Tensors {
        let Elastic { young, poisson } = STEEL;
        let (g, lame) = (young / (2.0 * (1.0 + poisson)), young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)));
        let tensor = |k: usize| at.fixed_rows::<3>(3 * k).into_owned();
        let xi = tensor(0) - tensor(1) - tensor(2);
        let s = xi.add_scalar(-xi.mean());
        let size = (1.5 * s.dot(&s)).sqrt();
        let n = if size > 0.0 { 1.5 / size * s } else { s };
        let yielding = self.hardening.at(at[9]);
        let rate = |p: f64| {
            let along = |normal: f64| {
                let e = nalgebra::Vector3::new(strain[0], strain[1], normal);
                (2.0 * g * (e - p * n)).add_scalar(lame * e.sum())
            };
            let stress = along(-along(0.0).z / (along(1.0).z - along(0.0).z));
            let back = |k: usize| {
                let law = &self.kinematic[k];
                p * (2.0 / 3.0 * law.modulus * n - law.dynamic_recovery * tensor(k + 1))
            };
            (stress, back(0), back(1))
        };
        let beyond = size / yielding.stress - 1.0;
        let p = match self.viscous {
            Some((c, exponent)) => c * beyond.max(0.0).powf(exponent),
            None if beyond < 0.0 => 0.0,
            None => {
                // Consistency, d/dt(size − σ_y) = 0, is linear in p; an overshoot fades at 40/s.
                let drift = |p: f64| {
                    let (stress, a, b) = rate(p);
                    n.dot(&(stress - a - b)) - yielding.slope * p
                };
                (drift(0.0) / (drift(0.0) - drift(1.0))).max(0.0) + 40.0 * beyond
            }
        };
        let (stress, a, b) = rate(p);
        Tensors::from_iterator(stress.iter().chain(&a).chain(&b).copied().chain([p]))
    }

    /// End of straight strain paths between corners, by the classical Runge-Kutta rule.
    fn follow(&self, corners: &[[f64; 2]], duration: f64, steps: usize) -> Tensors {
        let (mut at, dt) = (Tensors::zeros(), duration / steps as f64);
        for leg in corners.windows(2) {
            let strain = [0, 1].map(|i| (leg[1][i] - leg[0][i]) / duration);
            for _ in 0..steps {
                let a = self.rates(&at, strain);
                let b = self.rates(&(at + 0.5 * dt * a), strain);
                let c = self.rates(&(at + 0.5 * dt * b), strain);
                let d = self.rates(&(at + dt * c), strain);
                at += dt / 6.0 * (a + 2.0 * (b + c) + d);
            }
        }
        at
    }
}

/// The elastoplastic law along the same path, in equal steps.
fn follow(law: &ElastoplasticLaw, corners: &[[f64; 2]], steps: usize) -> Carried {
    let mut at = Carried { temperature: crate::material::flow::ROOM_TEMPERATURE, ..Carried::default() };
    for leg in corners.windows(2) {
        let e = [0, 1].map(|i| (leg[1][i] - leg[0][i]) / steps as f64);
        for _ in 0..steps {
            let mut trial = Trial::default();
            at.yield_stress = law.yield_stress(&at);
            let (response, _) = law.respond(&at, &mut trial, [e[0], e[1], 0.0], [0.0; 2]);
            at.stress = response.stress;
            at.strain += response.increment;
            at.back = trial.back;
        }
    }
    at
}

/// Trust: closed form of a bar that does not harden, σ = τ/J = Y with J = exp((1 − 2ν) τ/E): the force Y A on a section
/// A = A₀ exp(2 ε_θ) that contracts alike in width and thickness, so that ε_t = −ε_s − ε_θ + ln J is ε_θ. J lags by one step,
/// which a stress that stays does not feel.
#[test]
fn a_bar_in_tension_yields_by_the_force_on_its_section() {
    let yields = 900.0;
    let perfect = Hardening::Ludwik(crate::material::hardening::Ludwik::new(yields, 0.0, 1.0).expect("valid"));
    let law = law(&perfect);
    let mut at = Carried { temperature: crate::material::flow::ROOM_TEMPERATURE, ..Carried::default() };
    let mut strain = [0.0; 2];
    for _ in 0..20 {
        at.dilation = STEEL.volume_strain(at.stress).exp_m1();
        at.yield_stress = law.yield_stress(&at);
        let along = 1e-3;
        let try_across = |across: f64| {
            let mut trial = Trial::default();
            let (response, _) = law.respond(&at, &mut trial, [along, across, 0.0], [0.0; 2]);
            (response.stress, response.increment)
        };
        let [across, _] = crate::numerics::bisect(-along, 0.0, 60, |across| try_across(across).0[1] < 0.0);
        let (stress, increment) = try_across(across);
        (at.stress, at.strain) = (stress, at.strain + increment);
        strain = [strain[0] + along, strain[1] + across];
    }
    let volume = STEEL.volume_strain(at.stress);
    assert_relative_eq!(-strain[0] - strain[1] + volume, strain[1], max_relative = 1e-10);
    let section = (2.0 * strain[1]).exp();
    // Work of the force on the lengthening bar is that of σ here on the strain.
    assert_relative_eq!(at.stress[0] / strain[0].exp(), yields * section, max_relative = 1e-10);
    assert_relative_eq!(at.stress[0], yields * volume.exp(), max_relative = 1e-10);
    assert!(volume > 1e-3, "felt: {volume}");
}

/// Trust: an integration of the rates of the 3D tensors with steps so short that yielding in the middle of one is felt by
/// less than 1e-7; its backward Euler is first order, so two step lengths are extrapolated to none.
#[test]
fn a_closed_strain_cycle_is_that_of_the_rates_of_the_tensors() {
    let voce = Hardening::Voce(crate::material::hardening::Voce::new(180.0, 400.0, 9.0, 1.0).expect("valid"));
    let corners = [[0.0, 0.0], [0.02, 0.005], [-0.015, 0.01], [0.0, -0.02], [0.0, 0.0]];
    let perzyna = Rate::CowperSymonds(crate::material::rate::CowperSymonds { rate: 40.0, exponent: 3.0 });
    for kinematic in KINEMATICS {
        for rate in [None, Some(&perzyna)] {
            let steps = 40_000;
            let duration = 0.5;
            let viscous = rate.map(|_| (40.0, 3.0));
            let metal = Metal { hardening: &voce, kinematic, viscous };
            let expected = metal.follow(&corners, duration, 5 * steps);
            let stepped = |steps: usize| {
                follow(
                    &ElastoplasticLaw {
                        kinematic: shifting(kinematic),
                        rate,
                        duration: duration / steps as f64,
                        ..law(&voce)
                    },
                    &corners,
                    steps,
                )
            };
            let (coarse, fine) = (stepped(steps / 2), stepped(steps));
            let limit = |of: fn(&Carried) -> f64| 2.0 * of(&fine) - of(&coarse);
            let scale = 400.0;
            let stress = [limit(|c| c.stress[0]), limit(|c| c.stress[1])];
            // The plane-stress back-stress is 2 α'_s + α'_θ of the deviator.
            let back = [limit(|c| c.back[0][0]), limit(|c| c.back[1][1])];
            let back_expected = [2.0 * expected[3] + expected[4], 2.0 * expected[7] + expected[6]];
            for i in 0..2 {
                assert!((stress[i] - expected[i]).abs() < 1e-6 * scale, "{kinematic:?} {i}");
                assert!((back[i] - back_expected[i]).abs() < 1e-6 * scale, "{kinematic:?} {i}");
            }
            assert!((limit(|c| c.strain) - expected[9]).abs() < 1e-6 * expected[9]);
        }
    }
}
