//! Verification: a rate-sensitive bar in plane-strain tension, against the one-dimensional analysis of its neck.
//!
//! A bar of uniform section A₀ has a short stretch of section (1 − η) A₀. It carries one force, so with σ_y = K (ε₀ + ε̄)^n ε̄̇^m
//! and ε̄ = c ε, c = 2/√3, the strains in the neck and outside it follow from
//!
//! ```text
//! (1 − η) exp(−ε_n) (ε₀ + c ε_n)^n ε̇_n^m = exp(−ε_o) (ε₀ + c ε_o)^n ε̇_o^m
//! (1 − η)^(1/m) ∫₀^ε_n g dε = ∫₀^ε_o g dε,   g = exp(−ε/m) (ε₀ + c ε)^(n/m)
//! ```
//!
//! whatever the lengths of the two and the speed. As ε_n grows without bound ε_o comes to a limit, the necking strain; without
//! rate sensitivity the limit is reached when the neck passes its load maximum at ε_n = n − ε₀/c.
//!
//! # References
//! The long-wavelength analysis: J. W. Hutchinson, K. W. Neale, Acta Metallurgica 25 (1977) 839–846; that rate sensitivity
//! delays necking: E. W. Hart, Acta Metallurgica 15 (1967) 351–355 (both not read; the analysis is derived here).

use crate::common::prelude::*;

const N: f64 = 0.2;
const OFFSET: f64 = 1e-3;
/// η, by which the neck is thinner.
const IMPERFECTION: f64 = 0.01;
/// Equivalent strain per strain along the bar, 2/√3.
const C: f64 = 1.154_700_538_379_251_7;
/// Rate sensitivities m, rising.
const EXPONENTS: [f64; 6] = [0.0, 0.005, 0.01, 0.02, 0.05, 0.1];

/// A bar of 400 mm half length in 40 membrane elements, ten thicknesses long each, pulled to more than twice its length.
fn bar(m: f64) -> Model {
    let mut model = simple::pulled(Geometry::PlaneStrain, Theory::Membrane, 500.0);
    model.blank.length = 400.0;
    model.blank.elements = 40;
    let hardening = Hardening::Swift(Swift::new(500.0, N, OFFSET).expect("valid"));
    let rate = (m > 0.0).then_some(Rate::PowerRate(PowerRate { exponent: m, reference: 1e-3 }));
    model.material = Material { rate, ..Material::plain(hardening) };
    model.stop.localised = false;
    model.settings.max_step = 2.5e-4;
    model.settings.first_step = 1e-4;
    model.settings.strain_step = 0.002;
    // The bar unloads below its yield stress once the neck has taken over, and creeps there by this much in a largest step.
    model.settings.cutoff_strain = 1e-7;
    // What each step leaves of the corrector's error adds up over thousands of them, and a neck grows it: by 0.2 % of the
    // strain outside at the usual tolerance. It is the step that is looked at here.
    model.settings.tolerance = 1e-7;
    model.frames = (1..=200).map(|i| model.duration * f64::from(i) / 200.0).collect();
    model
}

fn pulled(m: f64, model: &Model) -> Vec<(f64, f64)> {
    let mut state = State::initial(model, mesh::nodes(model));
    state.thickness[0] *= 1.0 - IMPERFECTION;
    state.volume[0] *= 1.0 - IMPERFECTION;
    let run = solver::run_from(model, state, &mut ());
    assert!(run.stop.is_complete(), "m {m}: {}", run.stop);
    let strains = run.frames.iter().map(|frame| {
        let outside = frame.elements[1..].iter().map(|e| e.strain_meridional);
        let (least, most) = outside.fold((f64::INFINITY, 0.0_f64), |(a, b), e| (a.min(e), b.max(e)));
        // Trust: outside the neck the bar is uniform, up to the corrector's tolerance.
        assert!(most - least < 1e-3 * most, "m {m}: {least} to {most} outside the neck");
        (frame.elements[0].strain_meridional, 0.5 * (least + most))
    });
    strains.collect()
}

/// ε_o over ε_n of the one-dimensional analysis, on a grid of ε_n with this spacing.
const SPACING: f64 = 1e-5;

/// ε_o at ε_n = 0, 1, 2 … spacings.
fn analysis(m: f64, largest: f64) -> Vec<f64> {
    let steps = (largest / SPACING).ceil() as usize + 1;
    let at = |i: usize| i as f64 * SPACING;
    // ln of exp(−ε) (ε₀ + c ε)^n: the force over its constant.
    let force = |strain: f64| N * (OFFSET + C * strain).ln() - strain;
    let top = force(N - OFFSET / C);
    let mut outside = Vec::with_capacity(steps);
    let mut j = 0;
    if m == 0.0 {
        // The bar follows the neck's force up to its maximum and stops.
        for i in 0..steps {
            let load = force(at(i).min(N - OFFSET / C)) + (1.0 - IMPERFECTION).ln();
            while force(at(j + 1)) < load {
                j += 1;
            }
            outside.push(at(j));
        }
        return outside;
    }
    // Both integrals by the trapezoidal rule, in units of their integrand's maximum.
    let g = |i: usize| ((force(at(i)) - top) / m).exp();
    let share = (1.0 - IMPERFECTION).powf(1.0 / m);
    let (mut neck, mut bar) = (0.0, 0.0);
    for i in 0..steps {
        neck += if i > 0 { 0.5 * share * SPACING * (g(i - 1) + g(i)) } else { 0.0 };
        while bar + 0.5 * SPACING * (g(j) + g(j + 1)) < neck {
            bar += 0.5 * SPACING * (g(j) + g(j + 1));
            j += 1;
        }
        outside.push(at(j));
    }
    outside
}

/// Trust: elements ten thicknesses long know the force alone, as the analysis does; the rest is the implicit step.
#[test]
fn necking_strain_rises_with_the_rate_sensitivity_as_the_long_wavelength_analysis_says() {
    let (mut before, mut told) = (0.0, [Vec::new(), Vec::new()]);
    for m in EXPONENTS {
        let strains = pulled(m, &bar(m));
        let (neck, limit) = strains[strains.len() - 1];
        let expected = analysis(m, neck);
        let at = |neck: f64| expected[(neck / SPACING).round() as usize];
        let worst = strains.iter().map(|&(neck, outside)| (outside - at(neck)).abs()).fold(0.0, f64::max);
        let (error, worst) = (limit / at(neck) - 1.0, worst / limit);
        assert!(error.abs() < 0.003, "m {m}: {limit} for {}", at(neck));
        assert!(worst < 0.003, "m {m}: {worst} on the way");
        // The neck has run away: what it still stretches hardly reaches the rest of the bar.
        assert!(neck > 1.5 && limit - at(1.5) < 0.01 * limit, "m {m}: neck {neck}");
        assert!(limit > 1.01 * before, "m {m}: {limit} after {before}");
        before = limit;
        for (row, strain) in told.iter_mut().zip([limit, at(neck)]) {
            row.push(format!("{strain:.4}"));
        }
    }
    agreement("necking strain, computed", &told[0]);
    agreement("analysis", &told[1]);
}

/// Trust: the strain rate of the second-order backward difference; where the neck runs away, which is the end, its steps follow
/// the largest strain and are shorter still.
#[test]
fn necking_strain_converges_with_the_square_of_the_step() {
    for m in [0.01, 0.05] {
        let errors = [4.0, 2.0, 1.0].map(|longer| {
            let mut model = bar(m);
            model.settings.max_step *= longer;
            model.settings.first_step *= longer;
            model.settings.strain_step *= longer;
            let (neck, limit) = *pulled(m, &model).last().expect("instants");
            limit / analysis(m, neck)[(neck / SPACING).round() as usize] - 1.0
        });
        let orders = orders(&[4.0, 2.0, 1.0], &errors);
        assert!(errors[0].abs() < 1e-3 && errors[2].abs() < 1e-4, "m {m}: {errors:?}");
        // With m = 0.05 the error goes through nothing.
        assert!(m == 0.05 || orders.iter().all(|p| *p > 1.8), "m {m}: {orders:?}");
    }
}
