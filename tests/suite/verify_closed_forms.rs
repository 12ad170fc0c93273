//! Verification: the program against solutions that can be written down.

use crate::common::prelude::*;
use stampflow::element::{Node, kinematics::Reference, surface::stations};
use stampflow::material::flow::Iterate;

/// Trust: plane-strain tension, T = t σ_s on each edge, and equi-biaxial stretching of a disc, F = 2πr t σ. By Hosford's factors,
/// which are Hill's for an exponent of 2, σ_s = c σ_y(c ε) with x^(a−1) = r̄ (1 − x)^(a−1), c^−a = (1 + x^a + r̄ (1 − x)^a)/(1 + r̄);
/// equi-biaxial σ = c σ_y(2c ε), c^a = (1 + r̄)/2. The strain is homogeneous, so neither mesh nor step enters; what is left is the
/// cut-off, (Δε₀/Δε̄)²/2 below 1e-6, and the corrector's tolerance 1e-5. The rate is that of the instant; steps of 1/500 of the
/// radius find it to their square.
#[test]
fn homogeneous_stretching_is_the_closed_form_with_rate_and_anisotropy() {
    let hill = |r: f64| (r, 2.0_f64, YieldCriterion::from(Hill48::new(r)));
    let hosford = |(r, a): (f64, f64)| (r, a, YieldCriterion::from(Hosford::new(r, a)));
    let plain = [Theory::Bending, Theory::Membrane].map(|theory| (theory, None, hill(1.0)));
    let rates: Vec<Rate> = Rate::examples().into_iter().map(|(_, rate)| rate).collect();
    let all_rates = rates.iter().flat_map(|rate| [0.6, 1.0, 1.8].map(|r| (Theory::Bending, Some(*rate), hill(r))));
    let corners = [(0.3, 8.0), (0.6, 2.0), (1.0, 6.0), (2.5, 8.0)];
    let one_rate = corners.map(|pair| (Theory::Bending, Some(rates[0]), hosford(pair)));
    for (theory, rate, (r, a, criterion)) in plain.into_iter().chain(all_rates).chain(one_rate) {
        for (geometry, travel) in [(Geometry::PlaneStrain, 12.0), (Geometry::Axisymmetric, 8.0)] {
            let mut model = simple::pulled(geometry, theory, travel);
            model.material.rate = rate;
            model.material.yield_criterion = criterion;
            let run = solve(&model);
            for record in run.steps.iter().skip(5) {
                let radius = 40.0 + record.travel;
                let strain = (radius / 40.0).ln();
                let (c, per_strain, thinning, around) = match geometry {
                    Geometry::PlaneStrain => {
                        let root = r.powf(1.0 / (a - 1.0));
                        let x = root / (1.0 + root);
                        let c = ((1.0 + x.powf(a) + r * (1.0 - x).powf(a)) / (1.0 + r)).powf(-1.0 / a);
                        (c, c, 1.0, 2.0)
                    }
                    Geometry::Axisymmetric => {
                        let c = (0.5 * (1.0 + r)).powf(1.0 / a);
                        (c, 2.0 * c, 2.0, TAU * radius)
                    }
                };
                let faster = rate.map_or(1.0, |rate| rate.at(per_strain * model.speed / radius).value);
                let flow = model.material.hardening.at(per_strain * strain).stress * faster;
                let force = around * (-thinning * strain).exp() * c * flow;
                let error = record.edge_force / force - 1.0;
                let name = format!("{theory:?}, {rate:?}, r {r}, a {a}, {geometry:?}");
                assert!(error.abs() < 2e-5, "{name} at {} mm: {error:e}", record.travel);
            }
            for element in &run.frames.last().expect("the last frame is kept").elements {
                let is_equal = (element.strain_meridional - element.strain_hoop).abs() < 1e-6;
                assert!(is_equal || geometry == Geometry::PlaneStrain, "{element:?}");
            }
        }
    }
}

/// A cup's wall thins less the more the sheet resists thinning: that is what deep-drawing grades are chosen for.
#[test]
fn a_higher_anisotropy_keeps_the_cup_thicker() {
    let thinnest = |r: &str| last(&solve(&shipped("quickstart", &[&format!("material.anisotropy={r}")]))).thinnest;
    let found = ["0.5", "1.0", "2.0"].map(thinnest);
    assert!(found.is_sorted_by(|a, b| a < b), "{found:?}");
}

/// Trust: capstan, T₂ = T₁ exp(μπ/2). Nodes on the arc stand for a rope of chords: with 2 and 4 elements a quarter the error
/// falls with the square of the spacing or faster. Then other errors rule, the ticks of single nodes at the lip and the
/// contact's soft foot: 0.2 % is left, 0.02 % with a foot of a sixth.
#[test]
fn capstan_converges_to_the_exponential() {
    let holder = 600.0;
    let error = |mu: f64, per_quarter: usize, foot: f64| {
        let mut model = simple::capstan(mu, holder, per_quarter);
        model.settings.contact_smoothing = foot;
        let run = solve(&model);
        // The wall leans: wrap angle α from the common tangent of the two circles that the mid-surface follows,
        // Δr sin α − Δz cos α = 2 (R + t/2). Mean over the last 10 mm: single values tick as nodes pass the lip.
        let ratios = run.steps.iter().filter(|r| r.travel > 40.0).map(|record| {
            let (dr, dz) = (41.3 - 20.0, record.travel - 21.0);
            let wrap = (21.0 / f64::hypot(dr, dz)).asin() + dz.atan2(dr);
            record.punch_force / (0.2 * holder * (mu * wrap).exp() * wrap.sin())
        });
        mean(ratios) - 1.0
    };
    let mut coarse_and_fine = Vec::new();
    for mu in [0.05, 0.15] {
        let foot = Settings::default().contact_smoothing;
        let errors: Vec<f64> = [5, 10, 20].iter().map(|&n| error(mu, n, foot)).collect();
        let sharp: Vec<f64> = [2, 4, 20].iter().map(|&n| error(mu, n, foot / 6.0)).collect();
        let order = orders(&[2.0, 1.0], &sharp[..2])[0];
        assert!(errors.iter().all(|e| e.abs() < 2e-3) && sharp[2].abs() < 2e-4, "{errors:?} {sharp:?}");
        assert!(order > 1.8, "{order}");
        coarse_and_fine.push([errors[0], errors[2]]);
    }
    let [coarse, fine] = [0, 1].map(|i| signed(&[coarse_and_fine[0][i], coarse_and_fine[1][i]], 2));
    agrees(
        "| capstan over a die shoulder, μ 0.05 and 0.15 | {} and {} % at 5 elements per 90°, {} and {} % at 20 |",
        &[coarse, fine].concat(),
    );
}

/// Trust: the closed form of Z. Marciniak, J. L. Duncan, S. J. Hu (2002), figure 4.3: the tension of the wall, which leans by a third of
/// a degree in the run, so that the punch feels all of it to 2e-5. The sheet that is drawn over the shoulder brings its history along.
#[test]
fn the_draw_die_s_punch_force_is_that_of_its_closed_form() {
    let text = include_str!("../../reference_data/plane_strain_draw_die.csv");
    let wall = text.lines().find_map(|line| line.strip_prefix("B,")).expect("the wall");
    let tension: f64 = wall.split(',').next().and_then(|cell| cell.parse().ok()).expect("a number");
    let error = peak(&solve(&shipped("strip_draw", &[]))) / (2.0 * tension) - 1.0;
    let row = "| draw die (`strip_draw`), punch force {} N/mm on each half, {} N/mm in all | {} % |";
    agrees(row, &[plain(&[tension, 2.0 * tension], 1), signed(&[error], 1)].concat());
    assert!(error.abs() < 1e-2, "{error}");
    // By the capstan equation any law carries that tension; the holder's pressure leaves an elastic membrane slack at first.
    for mode in ["elastic", "elasto_viscoplastic"] {
        let mode = format!("material.mode={mode}");
        let run = solve(&shipped("strip_draw", &["material.young=210 GPa", "material.poisson=0.3", &mode]));
        assert!((peak(&run) / (2.0 * tension) - 1.0).abs() < 1e-2, "{mode}: {}", peak(&run));
    }
}

/// Yield stress [MPa], thickness and length [mm], and turn [rad] of a bent element.
const YIELD: f64 = 200.0;
const T: f64 = 1.3;
const LENGTH: f64 = 0.8;
const TURN: f64 = 0.02;

/// Force and moment of a plane-strain element that does not harden, as it is bent and drawn out by `stretch` [N/mm, N].
fn bent(rule: &[ThicknessPoint], stretch: f64) -> [f64; 2] {
    let hardening = &Hardening::Ludwik(Ludwik::new(YIELD, 0.0, 1.0).expect("valid"));
    let (rate, softening, voids) = (None, None, None);
    let (criterion, matrix) = (Hill48::default().into(), Iteration::Newton);
    let law = FlowLaw { hardening, rate, softening, criterion, voids, matrix, cutoff: 1e-7, duration: 1.0 };
    let start = Reference::new(Geometry::PlaneStrain, Theory::Bending, [3.0, 0.0, 0.0], [3.0 + LENGTH, 0.0, 0.0]);
    let end = start.moved([0.0, 0.0, -0.5 * TURN], [stretch, 0.0, 0.5 * TURN]).expect("sound");
    let section = Section { law: &law, rule, slack_tension: 0.0, last_move: 0.0, forces_alone: false };
    let points = vec![PointState::at(0.0); rule.len()];
    let (mut iterates, mut updates) = (vec![Iterate::default(); rule.len()], vec![StressUpdate::default(); rule.len()]);
    let (force, _) = section.internal(&end, start.area() * T, T, &points, &mut iterates, &mut updates);
    [force[3], force[5]]
}

/// Trust: moment of a fully plastic plane-strain section, M = S t²/4 with S = (2/√3) Y. The Lobatto rule integrates
/// a jump of the stress with an error of the order 1/n².
#[test]
fn plastic_moment_converges_with_the_layers() {
    let exact = 2.0 / 3f64.sqrt() * YIELD * T * T / 4.0;
    let layers = [5, 7, 11, 21, 51];
    let errors = layers.map(|n| (bent(&lobatto(n), 0.0)[1] / exact - 1.0).abs());
    let orders = orders(&layers.map(|n| 1.0 / n as f64), &errors);
    let told = layers.iter().zip(errors).map(|(layers, error)| match error {
        error if error < 1e-3 => format!("{:.2} % with {layers}", 100.0 * error),
        error => format!("{:.1} % with {layers}", 100.0 * error),
    });
    let told = told.collect::<Vec<_>>().join(", ");
    agreement("fully plastic moment S t²/4", &[format!("{told} layers: use more where bending rules")]);
    assert!(orders.iter().all(|p| (1.95..2.35).contains(p)), "{orders:?}");
    assert!(errors[4] < 1e-3, "{errors:?}");
}

/// Trust: bending under tension of a sheet that does not harden, in plane strain: the neutral fibre stands at ξ₀ = −τ for a
/// tension of τ times the yield force, and M = S t²/4 (1 − τ²). Equal parts come to both as their height falls: τ within
/// 0.044 and M within 5.8 % of that without tension with five, where points by themselves miss 0.36 and 8.7 %, and both with
/// the first power of their number.
#[test]
fn tension_that_bends_moves_the_neutral_fibre() {
    let s = 2.0 / 3f64.sqrt() * YIELD;
    // Largest errors of τ, and of M over that without tension, with the neutral fibre anywhere in the inner half.
    let errors = |n: usize| {
        let (mut tension, mut moment) = (0.0_f64, 0.0_f64);
        for tau in (0..=100).map(|i| 0.005 * f64::from(i)) {
            let stretch = LENGTH * ((0.5 * T * tau * TURN / LENGTH).exp() - 1.0);
            let [force, turning] = bent(&midpoint(n), stretch);
            // The force is that of the section as it is drawn out.
            tension = tension.max((force * (LENGTH + stretch) / LENGTH / (s * T) - tau).abs());
            moment = moment.max((turning / (s * T * T / 4.0) - (1.0 - tau * tau)).abs());
        }
        [tension, moment]
    };
    let found = [5, 10, 20, 40].map(errors);
    assert!(found[0][0] < 0.05 && found[0][1] < 0.06, "{found:?}");
    for pair in found.windows(2) {
        // Half as much with twice the parts, but for where in a part the fibre stands.
        assert!(pair[1][0] < 0.6 * pair[0][0] && pair[1][1] < 0.6 * pair[0][1], "{found:?}");
    }
}

/// Trust: with no physical length in the problem, the flow form must not feel the step (logarithmic increments).
#[test]
fn homogeneous_stretch_does_not_depend_on_the_step() {
    let mut coarse = simple::pulled(Geometry::Axisymmetric, Theory::Bending, 8.0);
    coarse.settings = Settings { max_step: 0.25, first_step: 0.25, ..Settings::default() };
    let fine = simple::pulled(Geometry::Axisymmetric, Theory::Bending, 8.0);
    let last = |model| solve(model).steps.last().expect("steps").edge_force;
    let (a, b) = (last(&coarse), last(&fine));
    assert!((a / b - 1.0).abs() < 1e-5, "{a} {b}");
}

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

/// Trust: the arc itself; what is left of the sag is of fourth order in the angle, here 0.1 rad.
#[test]
fn nodes_on_an_arc_put_the_points_between_on_it() {
    let on = |angle: f64| [25.0 * angle.sin(), 25.0 * angle.cos(), -angle];
    let sag = 25.0 * (1.0 - 0.05_f64.cos());
    for station in stations(true) {
        assert_relative_eq!(station.position(&on(0.3), &on(0.4)).norm(), 25.0, epsilon = 0.01 * sag);
    }
}
