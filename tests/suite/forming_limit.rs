use crate::common::prelude::*;
use stampflow::forming_limit::{Kind, Swift, assess, uniform_strain};
use stampflow::material::hardening::Swift as SwiftLaw;

/// A power law; the offset of 1e-6 shifts limits by as much.
fn power(n: f64, r: f64) -> Material {
    let law = Hollomon::new(500.0, n, Some(1e-6), None).expect("valid");
    Material { yield_criterion: Hill48::new(r).into(), ..Material::plain(Hardening::Hollomon(law)) }
}

pub fn sheet(material: &Material) -> Sheet<'_> {
    Sheet { material, thickness: 1.0, temperature: 293.15 }
}

pub fn groove(imperfection: f64) -> MarciniakKuczynski {
    MarciniakKuczynski { imperfection, strain_rate: 1.0 }
}

/// Trust: by hand. Hill: ε₁ + ε₂ = n for every r̄, so n in plane strain and n (1 + r̄) in tension.
#[test]
fn hill_is_a_line_of_constant_thickness_strain_on_the_left() {
    for r in [0.6, 1.0, 1.8] {
        let material = power(0.22, r);
        for n in [None, Some(0.22)] {
            let curve = Kind::Hill(Hill { n }).curve(&sheet(&material)).expect("a curve");
            for [minor, major] in curve.points.iter().filter(|p| p[0] <= 0.0) {
                assert_relative_eq!(minor + major, 0.22, epsilon = 3e-6);
            }
            assert_relative_eq!(curve.plane_strain(), 0.22, epsilon = 3e-6);
            let [minor, major] = curve.points[0];
            assert_relative_eq!(major, 0.22 * (1.0 + r), epsilon = 1e-5);
            assert_relative_eq!(minor / major, -r / (1.0 + r), epsilon = 1e-12);
        }
    }
}

/// Trust: by hand for r̄ = 1: ε₁ = n in tension, in plane strain and in equi-biaxial stretching; between them
/// 2n (2 − α)(1 − α + α²)/(4 − 3α − 3α² + 4α³) with α = σ₂/σ₁ = (1 + 2β)/(2 + β), as textbooks have it.
#[test]
fn swift_is_its_textbook_formula() {
    let curve = Kind::Swift(Swift { n: Some(0.2) }).curve(&sheet(&power(0.2, 1.0))).expect("a curve");
    for &[minor, major] in &curve.points {
        let beta = minor / major;
        let a = (1.0 + 2.0 * beta) / (2.0 + beta);
        let by_hand = 0.4 * (2.0 - a) * (1.0 - a + a * a) / (4.0 - 3.0 * a - 3.0 * a * a + 4.0 * a * a * a);
        assert_relative_eq!(major, by_hand, max_relative = 1e-12);
    }
    for major in [curve.points[0][1], curve.plane_strain(), curve.points[40][1]] {
        assert_relative_eq!(major, 0.2, max_relative = 1e-12);
    }
}

/// Trust: closed forms, n − ε₀ of Swift's law, and a root found by hand of Voce's: σ' = σ.
#[test]
fn the_uniform_strain_is_that_of_the_load_maximum() {
    let swift = Material::plain(Hardening::Swift(SwiftLaw::new(500.0, 0.25, 0.01).expect("valid")));
    assert_relative_eq!(uniform_strain(&sheet(&swift)).expect("a strain"), 0.25 - 0.01, epsilon = 1e-9);
    // 10 × 200 e = 400 − 200 e  at  e = exp(−10 ε) = 400/2200.
    let voce = Material::plain(Hardening::Voce(Voce::new(200.0, 400.0, 10.0, 1.0).expect("valid")));
    assert_relative_eq!(uniform_strain(&sheet(&voce)).unwrap(), 0.1 * (2200.0_f64 / 400.0).ln(), epsilon = 1e-9);
    let soft = Material::plain(Hardening::Voce(Voce::new(200.0, 200.0, 10.0, 1.0).expect("valid")));
    assert!(uniform_strain(&sheet(&soft)).is_err());
}

/// Trust: by hand, 37.43 % for n = 0.21 and 1 mm, half of it for half of n; an inch is 25.4 mm elsewhere.
#[test]
fn keeler_brazier_takes_millimetres_and_gives_true_strain() {
    let material = power(0.21, 1.0);
    let at = |n: f64, thickness: f64| {
        let sheet = Sheet { thickness, ..sheet(&material) };
        Kind::KeelerBrazier(KeelerBrazier { n: Some(n), thickness: None }).curve(&sheet)
    };
    let curve = at(0.21, 1.0).expect("a curve");
    assert_relative_eq!(curve.plane_strain(), 1.3743_f64.ln(), epsilon = 1e-12);
    assert_relative_eq!(at(0.105, 1.0).expect("a curve").plane_strain(), 1.187_15_f64.ln(), epsilon = 1e-12);
    assert_eq!(at(0.3, 1.0).expect("a curve").plane_strain(), curve.plane_strain(), "n counts as 0.21 at most");
    assert_relative_eq!(curve.major_at(-0.1), curve.plane_strain() + 0.1, epsilon = 1e-12);
    assert_relative_eq!(curve.major_at(0.1), curve.plane_strain() + 0.06, epsilon = 1e-12);
    let rise = 0.1 * 1.2_f64.ln() + 0.5 * 1.4_f64.ln();
    assert_relative_eq!(curve.major_at(1.4_f64.ln()), curve.plane_strain() + rise, epsilon = 1e-12);
    assert_eq!(curve.major_at(0.5), curve.major_at(1.5_f64.ln()));
    assert!(at(0.21, 3.2).is_err());
}

/// Trust: the ranges of Keeler and Brazier: mild ferritic steel of at most 3.1 mm and 590 MPa.
#[test]
fn a_sheet_without_a_limit_gets_the_curve_of_its_metal() {
    let elastic = |young: f64| Some(Elastic { young, poisson: 0.3 });
    let [ferrite, aluminium] = [6.0, 8.0].map(|a| Hosford::new(1.0, a).into());
    let hill: YieldCriterion = Hill48::new(1.0).into();
    for (k, thickness, yield_criterion, elastic, name) in [
        (500.0, 1.0, ferrite, None, "Keeler-Brazier"),
        (500.0, 1.0, hill, elastic(206e3), "Keeler-Brazier"),
        (500.0, 3.2, ferrite, None, "Hill and Swift"),
        (1200.0, 1.0, ferrite, None, "Hill and Swift"),
        (500.0, 1.0, aluminium, elastic(193e3), "Hill and Swift"),
        (500.0, 1.0, hill, elastic(70e3), "Hill and Swift"),
        (500.0, 1.0, hill, None, "Hill and Swift"),
    ] {
        let law = Hollomon::new(k, 0.2, Some(1e-6), None).expect("valid");
        let material = Material { yield_criterion, elastic, ..Material::plain(Hardening::Hollomon(law)) };
        let curve = Kind::usual(&Sheet { thickness, ..sheet(&material) }).expect("a curve");
        assert!(curve.is_usual && curve.name == name, "{k} MPa, {thickness} mm: {}", curve.name);
        assert!(curve.notes[0].starts_with("declared: "), "{:?}", curve.notes);
    }
}

/// Trust: by hand, logarithms of lengths; left of the points at constant thickness strain, right of them level.
#[test]
fn points_are_made_logarithmic_and_continued() {
    let points = vec![[-0.2, 0.5], [0.0, 0.3], [0.3, 0.4]];
    let curve = |strain, points: &[[f64; 2]]| Kind::Points(Points { points: points.to_vec(), strain });
    let material = power(0.2, 1.0);
    let engineering = curve(Strain::Engineering, &points).curve(&sheet(&material)).expect("a curve");
    assert_relative_eq!(engineering.plane_strain(), 1.3_f64.ln(), epsilon = 1e-15);
    let given = curve(Strain::Logarithmic, &points).curve(&sheet(&material)).expect("a curve");
    for (minor, major) in [(-0.3, 0.6), (-0.2, 0.5), (-0.1, 0.4), (0.15, 0.35), (0.3, 0.4), (0.5, 0.4)] {
        assert_relative_eq!(given.major_at(minor), major, epsilon = 1e-15);
    }
    for wrong in [&points[..1], &[[0.1, 0.3], [0.0, 0.4]], &[[0.0, -0.1], [0.1, 0.3]], &[[0.0, f64::NAN], [0.1, 0.3]]] {
        assert!(curve(Strain::Logarithmic, wrong).curve(&sheet(&material)).is_err(), "{wrong:?}");
    }
}

/// Trust: by hand. In plane strain both regions stay in plane strain, σ ∝ ε^n and t ∝ exp(−ε), so that
/// a^n e^(−a) = f₀ b^n e^(−b) and, ten times as fast, n/a − 1 = 10 (n/b − 1). Twice the integration's own tolerance.
#[test]
fn the_groove_in_plane_strain_is_the_closed_form() {
    for (n, f) in [(0.2_f64, 0.99_f64), (0.2, 0.995), (0.35, 0.98), (0.03, 0.995)] {
        let a_of = |b: f64| n / (1.0 + 10.0 * (n / b - 1.0));
        let missing = |b: f64| {
            let a = a_of(b);
            n * a.ln() - a - f.ln() - n * b.ln() + b
        };
        let [low, _] = bisect(0.6 * n, n, 100, |b| missing(b) * missing(n) <= 0.0);
        let found = groove(f).limit(&sheet(&power(n, 1.0)), 0.0).expect("a limit").major;
        assert_relative_eq!(found, a_of(low), max_relative = 2.0 * 2e-3);
    }
}

/// Trust: on the left and in plane strain a shallower and shallower groove comes to Hill's neck from below, along the line
/// that does not stretch, tan² φ = −β; on the right there is no such neck and the limit goes on growing past Swift's.
#[test]
fn a_shallow_groove_necks_as_hill_says() {
    let material = power(0.2, 1.0);
    for beta in [-0.4_f64, -0.2, 0.0] {
        let hill = 0.2 / (1.0 + beta);
        let limits = [0.98, 0.995, 0.9995].map(|f| groove(f).limit(&sheet(&material), beta).expect("a limit"));
        assert!(limits.windows(2).all(|w| w[0].major < w[1].major) && limits[2].major < hill * 1.01, "{limits:?}");
        // The missing strain goes with the square root of 1 − f₀: √(2 n (1 − f₀)) = 0.014 in plane strain.
        assert!(limits[2].major > hill - 0.03, "{limits:?} {hill}");
        if beta < 0.0 {
            let turned = (limits[2].angle.tan() * (limits[2].major * (1.0 - beta)).exp()).atan();
            // It turns into that line as it necks; the angle is searched to 0.02 rad.
            assert!((turned - (-beta).sqrt().atan()).abs() < 0.03, "{limits:?}");
        }
    }
    let right = [0.98, 0.99, 0.995].map(|f| groove(f).limit(&sheet(&material), 0.6).expect("a limit").major);
    assert!(right[0] < right[1] && right[1] < right[2] && right[2] > 0.25, "{right:?}");
}

/// The groove across the major strain of an isotropic Swift sheet, as textbooks step it: for small increments of the groove
/// its stress ratio follows from equal minor strains and from the force across it.
fn stepped(stress: impl Fn(f64) -> f64, imperfection: f64, alpha: f64, step: f64) -> f64 {
    let factors = |a: f64| {
        let size = (1.0 - a + a * a).sqrt();
        (size, (2.0 - a) / (2.0 * size), (2.0 * a - 1.0) / (2.0 * size))
    };
    let (size, major, minor) = factors(alpha);
    let (mut sheet, mut groove, mut thickness) = (0.0, 0.0, imperfection);
    loop {
        let tried = |a: f64| {
            let (of_groove, along, across) = factors(a);
            let increment = across / minor * step;
            let thinner = thickness * (major * increment - along * step).exp();
            (stress(sheet + increment) / size - thinner * stress(groove + step) / of_groove, increment, thinner)
        };
        // Force falls as the groove turns to plane strain, where its minor strain and the sheet's increment vanish.
        let [ratio, _] = bisect(0.5, alpha + 0.3, 60, |a| tried(a).0 < 0.0);
        let (_, increment, thinner) = tried(ratio);
        (sheet, groove, thickness) = (sheet + increment, groove + step, thinner);
        if increment * MarciniakKuczynski::CRITICAL < step {
            return major * sheet;
        }
    }
}

/// Trust: another integration of the same equations, of first order: three times the 0.2 % of the limit.
#[test]
fn the_groove_in_biaxial_stretching_is_what_small_steps_give() {
    let material = Material::plain(Hardening::Swift(SwiftLaw::new(500.0, 0.2, 0.01).expect("valid")));
    let stress = |strain: f64| 500.0 * (0.01 + strain).powf(0.2);
    for (alpha, imperfection) in [(0.75, 0.98), (0.9, 0.99), (1.0, 0.98)] {
        let beta = (2.0 * alpha - 1.0) / (2.0 - alpha);
        let limit = groove(imperfection).limit(&sheet(&material), beta).expect("a limit");
        assert_relative_eq!(limit.major, stepped(stress, imperfection, alpha, 1e-4), max_relative = 6e-3);
    }
}

#[test]
fn the_groove_is_monotone_and_has_its_rate_free_limit() {
    let limit = |n: f64, m: f64, f: f64, beta: f64| {
        let rate = (m > 0.0).then_some(Rate::PowerRate(PowerRate { exponent: m, reference: 1e-3 }));
        groove(f).limit(&sheet(&Material { rate, ..power(n, 1.3) }), beta).expect("a limit").major
    };
    for beta in [-0.3, 0.0, 0.5] {
        assert!(limit(0.15, 0.0, 0.99, beta) < limit(0.2, 0.0, 0.99, beta));
        assert!(limit(0.2, 0.0, 0.98, beta) < limit(0.2, 0.0, 0.99, beta));
        let rates = [0.0, 0.01, 0.03].map(|m| limit(0.2, m, 0.99, beta));
        assert!(rates[0] < rates[1] && rates[1] < rates[2], "{rates:?}");
        // Both answers carry the integration's own tolerance.
        assert_relative_eq!(limit(0.2, 1e-6, 0.99, beta), rates[0], max_relative = 2.0 * 2e-3);
    }
}

/// Trust: by hand. Two elements, one along a line and one around a corner, on a level curve.
#[test]
fn paths_are_judged_by_their_ends_their_bends_and_when_they_cross() {
    let level = Points { points: vec![[-1.0, 0.3], [0.3, 0.3]], strain: Strain::Logarithmic };
    let curve = Kind::Points(level).curve(&sheet(&power(0.2, 1.0))).expect("a curve");
    let at = |time: f64, strains: [[f64; 2]; 2]| Instant { time, travel: 10.0 * time, strains: strains.to_vec() };
    let mut paths = Paths::starting(vec![1.0, 2.0]);
    paths.record(at(0.0, [[0.0, 0.0], [0.0, 0.0]]));
    paths.record(at(1.0, [[0.1, 0.05], [0.0, 0.1]]));
    paths.record(at(2.0, [[0.4, 0.2], [0.1, 0.1]]));
    let found = assess(&curve, &paths).expect("paths");
    let [straight, bent] = [found.elements[0], found.elements[1]];
    assert_relative_eq!(straight.margin(), -0.1, epsilon = 1e-15);
    assert_relative_eq!(straight.ratio(), 4.0 / 3.0, epsilon = 1e-15);
    assert!(!straight.is_crooked() && straight.crookedness < 1e-12 && !straight.hoop_is_major);
    // A corner of 0.1 by 0.1: half a diagonal off a diagonal.
    assert_relative_eq!(bent.crookedness, 0.5, epsilon = 1e-12);
    assert_eq!((found.crooked(), found.worst().s0), (1, 1.0));
    let reached = found.reached.expect("crossed");
    assert_relative_eq!(reached.time, 1.0 + 2.0 / 3.0, epsilon = 1e-12);
    assert_relative_eq!(reached.travel, 10.0 * reached.time, epsilon = 1e-12);
    assert_eq!(reached.s0, 1.0);
    assert!(assess(&curve, &Paths::default()).is_none());
}

/// Trust: counted: the start, the end and evenly spaced instants between are held, every one up to the limit.
#[test]
fn paths_of_any_length_are_thinned_evenly() {
    for steps in [1, 7, Paths::MOST, Paths::MOST + 1, 3 * Paths::MOST + 5, 100_000] {
        let mut paths = Paths::starting(vec![1.0]);
        (0..steps).for_each(|i| paths.record(Instant { time: i as f64, travel: 0.0, strains: vec![[0.0, 0.0]] }));
        let times: Vec<f64> = paths.instants.iter().map(|instant| instant.time).collect();
        let few = paths.thinned(200).instants;
        assert!(few.len() <= 201 && few.first() == paths.instants.first() && few.last() == paths.instants.last());
        assert!(times.len() == steps || (Paths::MOST / 2..=Paths::MOST).contains(&times.len()), "{steps}");
        assert_eq!((times[0], times[times.len() - 1]), (0.0, steps as f64 - 1.0));
        if let [first, second, .., last] = times[..] {
            let even = times[..times.len() - 1].windows(2).all(|pair| pair[1] - pair[0] == second - first);
            assert!(even && last - times[times.len() - 2] <= second - first, "{steps}");
        }
    }
}

/// Trust: the same instants recorded without a way back.
#[test]
fn paths_taken_back_and_recorded_again_are_the_same() {
    let instant = |i: usize| Instant { time: i as f64, travel: i as f64, strains: vec![[i as f64; 2]] };
    let recorded = |mut paths: Paths, numbers: std::ops::Range<usize>| {
        numbers.for_each(|i| paths.record(instant(i)));
        paths
    };
    let begun = || Paths::starting(vec![0.5]);
    for (all, count) in [(6, 1), (6, 5), (1999, 1990), (2100, 2001), (2100, 1900), (9000, 8100), (9000, 7900)] {
        let whole = recorded(begun(), 0..all);
        let mut cut = whole.clone();
        cut.truncate(count, instant(count - 1));
        let straight = recorded(begun(), 0..count);
        assert!(cut.stride() != straight.stride() || cut == straight, "{all} {count}");
        assert_eq!(cut.instants.last(), straight.instants.last());
        assert_eq!(recorded(cut, count..all), whole, "{all} {count}");
    }
}
