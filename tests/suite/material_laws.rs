//! Laws of hardening, rate and temperature over the whole list of examples, and Hill's yield condition.

use crate::common::prelude::*;
use stampflow::contact::friction::Sliding;
use stampflow::material::RValues;

/// Trust: central differences, h = 1e-4 ε: truncation near 1e-8 of the slope, cancellation below 1e-6.
#[test]
fn slope_is_the_derivative_of_the_stress_for_every_law() {
    for (name, law) in Hardening::examples() {
        for strain in [1e-7, 3e-5, 1e-3, 0.013, 0.09, 0.21, 0.37, 0.75, 1.4] {
            let h = 1e-4 * strain;
            let difference = (law.at(strain + h).stress - law.at(strain - h).stress) / (2.0 * h);
            assert_relative_eq!(law.at(strain).slope, difference, max_relative = 1e-5, epsilon = 1e-4);
            assert!(law.at(strain).stress.is_finite(), "{name}");
        }
    }
}

#[test]
fn every_law_is_positive_continuous_and_never_softens() {
    for (name, law) in Hardening::examples() {
        let mut last = law.at(0.0).stress;
        assert!(last >= 0.0, "{name}");
        for i in 1..40_000 {
            let now = law.at(i as f64 * 5e-5);
            assert!(now.stress >= last - 1e-9 && now.slope >= -1e-9, "{name} softens at {}", i as f64 * 5e-5);
            assert!(i < 20 || now.stress - last < 0.05 * now.stress, "{name} jumps at {}", i as f64 * 5e-5);
            last = now.stress;
        }
    }
}

/// Trust: Hill's closed forms. Plane strain (ε_θ = 0): σ_s/σ̄ = (1 + r̄)/√(1 + 2r̄), σ_θ/σ_s = r̄/(1 + r̄);
/// equi-biaxial: σ/σ̄ = √((1 + r̄)/2).
#[test]
fn plane_strain_and_equi_biaxial_factors_are_hills() {
    for r in [0.5_f64, 1.0, 2.0] {
        let law = Hill48::new(r);
        let stress = |e: [f64; 3]| law.apply(e).map(|a| a / law.equivalent_increment(e));
        let plane = stress([0.01, 0.0, 0.0]);
        assert_relative_eq!(plane[0], (1.0 + r) / (1.0 + 2.0 * r).sqrt(), max_relative = 1e-12);
        assert_relative_eq!(plane[1] / plane[0], r / (1.0 + r), max_relative = 1e-12);
        let biaxial = stress([0.01, 0.01, 0.0]);
        assert_relative_eq!(biaxial[0], ((1.0 + r) / 2.0).sqrt(), max_relative = 1e-12);
        // Tension: the width thins r̄ times as fast as the thickness.
        let uniaxial = stress([1.0 + r, -r, 0.0]);
        assert_relative_eq!(uniaxial[0], 1.0, max_relative = 1e-12);
        assert!(uniaxial[1].abs() < 1e-12);
        for s in [plane, biaxial, uniaxial] {
            assert_relative_eq!(law.equivalent_stress(s), 1.0, max_relative = 1e-12);
        }
    }
}

/// Trust: central differences over ten decades of rate, h = 1e-5 of the rate: truncation near 1e-10.
#[test]
fn slopes_are_the_derivatives_of_the_factors() {
    for (name, law) in Rate::examples() {
        for decade in -8..=2 {
            let rate = 3.0 * 10f64.powi(decade);
            let h = 1e-5 * rate;
            let difference = (law.at(rate + h).value - law.at(rate - h).value) / (2.0 * h);
            let factor = law.at(rate);
            assert!((difference - factor.slope).abs() < 1e-6 * factor.value / rate, "{name} at {rate}");
            assert!(factor.value >= 0.0 && factor.slope >= 0.0, "{name} at {rate}");
        }
    }
}

/// Trust: the published forms by hand.
#[test]
fn factors_are_the_published_ones() {
    let laws: Vec<Rate> = Rate::examples().into_iter().map(|(_, law)| law).collect();
    assert_relative_eq!(laws[0].at(1.0).value, 1000f64.powf(0.02), max_relative = 1e-12);
    assert_relative_eq!(laws[1].at(40.0).value, 2.0, max_relative = 1e-12);
    // Its smooth foot is felt by (ε̇₀/ε̄̇)²/2 of a logarithm's unit.
    assert_relative_eq!(laws[2].at(1.0).value, 1.0 + 0.015 * 1000f64.ln(), max_relative = 1e-7);
}

/// Trust: the published forms by hand.
#[test]
fn factors_are_one_at_the_reference_and_the_published_ones_elsewhere() {
    let laws: Vec<ThermalLaw> = ThermalLaw::examples().into_iter().map(|(_, law)| law).collect();
    for (law, reference) in laws.iter().zip([293.15, 293.15, 693.15]) {
        assert_relative_eq!(law.at(reference), 1.0, max_relative = 1e-15);
    }
    assert_relative_eq!(laws[0].at(583.15), 1.0 - 0.5f64.powf(1.03), max_relative = 1e-12);
    assert_relative_eq!(laws[1].at(493.15), (-0.6f64).exp(), max_relative = 1e-12);
    let hotter = (0.1 * 150e6 / 8_314.462_618 * (1.0 / 793.15 - 1.0 / 693.15_f64)).exp();
    assert_relative_eq!(laws[2].at(793.15), hotter, max_relative = 1e-12);
}

/// Hotter is never stronger, and the stress stays positive up to melting and beyond.
#[test]
fn every_law_softens() {
    for (name, law) in ThermalLaw::examples() {
        let factors: Vec<f64> = (250..1200).map(|t| law.at(f64::from(t))).collect();
        assert!(factors.windows(2).all(|w| w[1] <= w[0] && w[1] > 0.0), "{name}");
    }
}

/// Trust: central differences; h = 1e-5 of the smallest length in the law, truncation near 1e-9 of the entry. Friction takes
/// power, is odd in the slip and stays below the law's largest coefficient.
#[test]
fn friction_opposes_sliding_and_its_derivatives_agree_with_differences() {
    let mut rng = fastrand::Rng::with_seed(7);
    let mut between = |low: f64, high: f64| low + (high - low) * rng.f64();
    for (name, law) in (0..256).flat_map(|_| Friction::examples()) {
        let (pressure, slip, scale) = (between(1e-3, 500.0), between(-0.3, 0.3), between(1e-4, 1e-2));
        let at = Sliding { pressure, slip, scale, duration: between(1e-3, 1.0), shear_yield: between(20.0, 400.0) };
        let drag = law.at(&at);
        let value = |slip: f64, pressure: f64| law.at(&Sliding { slip, pressure, ..at }).value;
        let (h, k) = (1e-5 * scale, 1e-5 * pressure);
        let by_slip = (value(slip + h, pressure) - value(slip - h, pressure)) / (2.0 * h);
        assert!((by_slip - drag.by_slip).abs() < 1e-6 * drag.value.abs() / scale, "{name} by slip, {at:?}");
        let by_pressure = (value(slip, pressure + k) - value(slip, pressure - k)) / (2.0 * k);
        assert!((by_pressure - drag.by_pressure).abs() < 1e-6 * drag.value.abs() / pressure, "{name}, {at:?}");
        assert!(drag.value * slip >= 0.0 && value(-slip, pressure) == -drag.value, "{name}, {at:?}");
        let viscous = if let Friction::Stribeck(law) = law { law.viscous * slip.abs() / at.duration } else { 0.0 };
        let most = (law.largest_coefficient() + viscous) * pressure;
        assert!(drag.value.abs() <= most * (1.0 + 1e-12), "{name}, {at:?}");
    }
}

/// Trust: the closed form of a flange drawn into a wall of radius a from a blank of radius b: a part at ρ becomes (ρ/a)^m long
/// by its own, ∫ (ρ/a)^m dρ = a/(m + 1) [(b/a)^(m+1) − 1], here less that of m̄; 2000 parts, second order in their length.
#[test]
fn ears_of_a_flange_are_those_of_the_closed_form() {
    let sheet = RValues { r0: 0.525, r45: 0.248, r90: 0.429 };
    assert_eq!((sheet.mean(), sheet.planar()), (0.3625, 0.229));
    let (a, b, count) = (30.0_f64, 55.0_f64, 2000);
    let wall = |m: f64| a / (m + 1.0) * ((b / a).powf(m + 1.0) - 1.0);
    let share = |r: f64| r / (1.0 + r);
    let mean = share(sheet.mean());
    let width = (b - a) / f64::from(count);
    let places = (0..count).map(|i| a + width * (f64::from(i) + 0.5));
    let ears = sheet.rim_heights(places.map(|at| (width * (at / a).powf(mean), (a / at).ln())));
    for (ear, r) in ears.into_iter().zip([sheet.r90, sheet.r45, sheet.r0]) {
        assert!((ear - (wall(share(r)) - wall(mean))).abs() < 1e-5, "{ears:?}");
    }
}
