use super::*;
use crate::material::yield_condition::{differences, rows};
use crate::material::{BackStress, Hill48, chaboche::shifting, hosford::tests::flow_direction};
use approx::assert_relative_eq;

const STEEL: Elastic = Elastic { young: 206_000.0, poisson: 0.3 };

const KINEMATICS: [BackStresses; 3] = [
    [BackStress { modulus: 0.0, dynamic_recovery: 0.0 }; 2],
    [BackStress { modulus: 2500.0, dynamic_recovery: 0.0 }, BackStress { modulus: 0.0, dynamic_recovery: 0.0 }],
    [BackStress { modulus: 12_000.0, dynamic_recovery: 110.0 }, BackStress { modulus: 900.0, dynamic_recovery: 6.0 }],
];

fn law(hardening: &Hardening) -> ElastoplasticLaw<'_> {
    let (operators, kinematic) = (Operators::new(STEEL, YieldCriterion::default()), shifting(KINEMATICS[0]));
    let (hardening, rate, softening) = (Some(hardening), None, None);
    ElastoplasticLaw { hardening, operators, kinematic, rate, softening, secant: false, duration: 0.1 }
}

fn start(law: &ElastoplasticLaw) -> Carried {
    let shifts = if law.kinematic.is_none() { 0.0 } else { 1.0 };
    let (strain, temperature, stress) = (0.03, crate::material::flow::ROOM_TEMPERATURE, [60.0, -25.0, 8.0]);
    let back = [[20.0, 5.0, -3.0], [4.0, -6.0, 1.0]].map(|back| back.map(|a| shifts * a));
    let surroundings = Surroundings { exponent: 0.005, increment: 5e-3, floor: 1e-4 };
    let at = Carried { strain, temperature, stress, dilation: 4e-3, back, surroundings, yield_stress: 0.0 };
    Carried { yield_stress: law.yield_stress(&at), ..at }
}

const INCREMENTS: [Triple; 5] =
    [[1e-2, -5e-3, 0.0], [3e-3, 0.0, 1e-3], [-2e-3, -2e-3, 4e-4], [-4e-2, 1e-2, -2e-3], [2.5e-3, 3e-3, -5e-3]];

fn criteria() -> [YieldCriterion; 6] {
    let hill = |r| Hill48::new(r).into();
    let hosford = |r, a| Hosford::new(r, a).into();
    [hill(1.0), hill(0.6), hill(2.0), hosford(0.4, 8.0), hosford(1.6, 6.0), hosford(0.8, 12.5)]
}

fn for_every_law(look: impl Fn(&str, BackStresses, YieldCriterion, &ElastoplasticLaw)) {
    for (name, hardening) in Hardening::examples() {
        for (kinematic, criterion) in KINEMATICS.into_iter().cycle().zip(criteria()) {
            for rate in Rate::examples().iter().map(|(_, rate)| Some(rate)).chain([None]) {
                let (operators, shifts) = (Operators::new(STEEL, criterion), shifting(kinematic));
                let law = ElastoplasticLaw { kinematic: shifts, rate, operators, ..law(&hardening) };
                look(&format!("{name}, {criterion}, {kinematic:?}, {rate:?}"), kinematic, criterion, &law);
            }
        }
    }
}

/// Trust: the definition; the last round of Newton's method is linear in Δp and leaves 1e-8. The tangent by central differences
/// with h = 1e-5 of the increment; truncation and round-off below 1e-5 of Young's modulus. With dynamic recovery the
/// derivative is not symmetric, and its symmetric part is what is given.
#[test]
fn stress_lies_on_the_yield_surface_and_the_tangent_is_its_derivative_for_every_law() {
    for_every_law(|name, kinematic, criterion, law| {
        let point = start(law);
        for e in INCREMENTS.into_iter().chain([[1e-5, 2e-5, -1e-5]]) {
            let mut trial = Trial::default();
            let (update, tangent) = law.respond(&point, &mut trial, e, [0.0; 2]);
            if update.increment > 0.0 {
                let volume = 1.0 + point.dilation;
                let xi = each(|j| update.stress[j] - volume * (trial.back[0][j] + trial.back[1][j]));
                let size = law.radius(law.hardening.expect("yields"), &point, update.increment).stress;
                assert_relative_eq!(criterion.equivalent_stress(xi), size, max_relative = 1e-8);
            }
            assert!(update.increment > 0.0 || e[0] == 1e-5, "{name} {e:?}: does not yield");
            let h = 1e-5 * e[0].abs().max(e[1].abs());
            let difference = differences(e, h, |e| law.respond(&point, &mut Trial::default(), e, [0.0; 2]).0.stress);
            let c = rows(tangent.own);
            for (i, j) in [(0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2)] {
                let (this, other) = (difference[i][j], difference[j][i]);
                assert!((c[i][j] - 0.5 * (this + other)).abs() < 1e-5 * STEEL.young, "{name} {e:?} {i}{j}");
                let is_symmetric = (this - other).abs() < 1e-5 * STEEL.young;
                assert!(is_symmetric || kinematic[0].dynamic_recovery > 0.0, "{name} {e:?} {i}{j}: not symmetric");
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
        let point = Carried { stress: [0.0; 3], ..start(&law) };
        for (size, shear) in [(0.002, 0.0), (0.02, 0.0), (0.02, 0.03), (0.5, 0.0), (0.5, 1e-3), (0.0, 0.3)] {
            for (i, increment) in (0..180).flat_map(|i| [(i, 0.0), (i, 1e-5), (i, 10.0)]) {
                let angle = std::f64::consts::TAU * f64::from(i) / 180.0;
                let e = [size * angle.cos(), size * angle.sin(), shear];
                let update = law.respond(&point, &mut Trial { increment, ..Trial::default() }, e, [0.0; 2]).0;
                if update.increment == 0.0 {
                    continue;
                }
                let radius = law.radius(hardening, &point, update.increment).stress;
                assert_relative_eq!(condition.equivalent_stress(update.stress), radius, max_relative = 1e-9);
                let normal = flow_direction(&condition, update.stress);
                let stress = times(law.operators.stiffness, each(|j| e[j] - update.increment * normal[j]));
                let wrong = each(|j| (stress[j] - update.stress[j]).abs());
                assert!(wrong.iter().all(|wrong| *wrong < 1e-9 * STEEL.young * update.increment.max(1e-3)));
            }
        }
    }
}

/// Trust: closed form of a sheet stretched alike in both directions and back, σ = ±σ_y(p) + Σ α, with α on its way to ±C/γ as
/// exp(−γ p); backward Euler's method is first order, so two step lengths are extrapolated to none.
#[test]
fn reversed_stretching_follows_the_exponential_back_stresses() {
    let voce = Hardening::Voce(crate::material::hardening::Voce::new(180.0, 400.0, 9.0, 1.0).expect("valid"));
    for kinematic in KINEMATICS {
        let law = ElastoplasticLaw { kinematic: shifting(kinematic), ..law(&voce) };
        let miss = |steps: u32| {
            let (mut at, mut back) = (Carried::default(), [0.0; 2]);
            [1.0, -1.0].map(|sign| {
                for _ in 0..steps {
                    let mut trial = Trial::default();
                    at.yield_stress = law.yield_stress(&at);
                    let e = sign * 0.03 / f64::from(steps);
                    let (StressUpdate { stress, increment, .. }, _) =
                        law.respond(&at, &mut trial, [e, e, 0.0], [0.0; 2]);
                    at = Carried { stress, strain: at.strain + increment, back: trial.back, ..at };
                    for (back, law) in back.iter_mut().zip(kinematic) {
                        let left = (-law.dynamic_recovery * increment).exp();
                        *back = *back * left + sign * law.in_tension(increment).stress;
                    }
                }
                at.stress[0] - sign * voce.at(at.strain).stress - back[0] - back[1]
            })
        };
        let (coarse, fine) = (miss(2000), miss(4000));
        for (coarse, fine) in coarse.into_iter().zip(fine) {
            assert!((2.0 * fine - coarse).abs() < 4e-3, "{kinematic:?}: {coarse} {fine} MPa");
        }
    }
}
