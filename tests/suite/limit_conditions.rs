//! Forming limits by the sheet's yield condition: Hill's of 1948 and Hosford's.

use crate::common::prelude::*;
use crate::forming_limit::{groove, sheet};
use stampflow::forming_limit::{Kind, Swift, assess};

/// A power law of n = 0.2; the offset of 1e-6 shifts limits by as much.
fn sheet_of(criterion: impl Into<YieldCriterion>) -> Material {
    let law = Hollomon::new(500.0, 0.2, Some(1e-6), None).expect("valid");
    Material { yield_criterion: criterion.into(), ..Material::plain(Hardening::Hollomon(law)) }
}

/// Every curve that follows from the yield condition.
fn computed(imperfection: f64) -> [Kind; 3] {
    [Kind::Hill(Hill { n: None }), Kind::Swift(Swift { n: None }), Kind::MarciniakKuczynski(groove(imperfection))]
}

/// Trust: Hosford's condition of exponent 2 is Hill's: the same curves to 1e-9, round-off of an integration.
#[test]
fn an_exponent_of_two_gives_the_curves_of_hill_1948() {
    for r in [1.0, 1.7] {
        let materials = [sheet_of(Hill48::new(r)), sheet_of(Hosford::new(r, 2.0))];
        for kind in computed(0.98) {
            let [one, other] = materials.each_ref().map(|material| kind.curve(&sheet(material)).expect("a curve"));
            assert_eq!(one.points.len(), other.points.len());
            for (a, b) in one.points.iter().flatten().zip(other.points.iter().flatten()) {
                assert!((a - b).abs() < 1e-9, "{} {r}: {a} {b}", one.name);
            }
        }
    }
}

/// Trust: in plane strain the stress is a fixed multiple of the yield stress whatever the condition, so that the limit of a
/// power law is that of its n alone; Swift's is n in equi-biaxial stretching too. There the corner of exponent 8 brings the
/// groove's limit down from von Mises' towards what fcc sheet bears, and that of 6 less (A. Graf, W. F. Hosford, Metall.
/// Trans. A 21 (1990) 87–94; R. W. Logan, W. F. Hosford, Int. J. Mech. Sci. 22 (1980) 419–430; both not read).
#[test]
fn the_corner_of_hosfords_condition_brings_the_biaxial_limit_down() {
    let mises = sheet_of(Hill48::default());
    let of = |a: f64| sheet_of(Hosford::new(1.0, a));
    let limit = |material: &Material, beta: f64| groove(0.995).limit(&sheet(material), beta).expect("a limit").major;
    for r in [0.5, 1.0, 2.0] {
        for other in [sheet_of(Hill48::new(r)), sheet_of(Hosford::new(r, 8.0))] {
            // Twice the integration's own tolerance, and the law's offset.
            assert_relative_eq!(limit(&other, 0.0), limit(&mises, 0.0), max_relative = 4e-3);
        }
    }
    for beta in [0.4, 0.7, 1.0] {
        let [two, six, eight] = [limit(&mises, beta), limit(&of(6.0), beta), limit(&of(8.0), beta)];
        assert!(two > 1.1 * six && six > eight && eight > 0.15, "{beta}: {two} {six} {eight}");
    }
    for kind in [Kind::Hill(Hill { n: None }), Kind::Swift(Swift { n: None })] {
        let curve = kind.curve(&sheet(&of(8.0))).expect("a curve");
        assert_relative_eq!(curve.plane_strain(), 0.2, epsilon = 3e-6);
        assert_relative_eq!(curve.points[curve.points.len() - 1][1], 0.2, epsilon = 3e-6);
    }
}

/// Trust: by the rule alone: of Hill 1948 below r̄ = 1 nothing is known to the right of plane strain; other curves go on.
#[test]
fn a_computed_curve_of_hill_1948_ends_where_r_is_below_one() {
    let [low, hosford] = [sheet_of(Hill48::new(0.6)), sheet_of(Hosford::new(0.6, 8.0))];
    let points = Points { points: vec![[-0.2, 0.4], [0.0, 0.25], [0.3, 0.3]], strain: Strain::Logarithmic };
    for kind in computed(0.99) {
        let ends = kind.curve(&sheet(&low)).expect("a curve");
        assert_eq!(ends.ends_at(), Some(0.0), "{}", ends.name);
        assert!(ends.knows(-0.3) && ends.knows(0.0) && !ends.knows(1e-6), "{}", ends.name);
        assert!(ends.notes.iter().any(|note| note.to_string().contains("ends in plane strain")), "{:?}", ends.notes);
        assert_eq!(ends.major_at(0.3), ends.plane_strain());
        assert!(kind.curve(&sheet(&hosford)).expect("a curve").knows(0.1));
        assert!(kind.curve(&sheet(&sheet_of(Hill48::default()))).expect("a curve").ends_at().is_none());
    }
    for kind in [Kind::Points(points), Kind::KeelerBrazier(KeelerBrazier { n: Some(0.2), thickness: None })] {
        assert!(kind.curve(&sheet(&low)).expect("a curve").ends_at().is_none());
    }
}

/// Trust: by hand. On a curve that ends at (0, 0.2): a place beyond its end and above that level is not judged, one below it
/// is, and one on its left that goes above it has reached the limit.
#[test]
fn beyond_the_end_of_a_curve_nothing_is_judged() {
    let curve = Kind::Hill(Hill { n: Some(0.2) }).curve(&sheet(&sheet_of(Hill48::new(0.6)))).expect("a curve");
    let found = |strains: &[[f64; 2]]| {
        let mut paths = Paths::starting((0..strains.len()).map(|i| i as f64).collect());
        paths.record(Instant { time: 0.0, travel: 0.0, strains: vec![[0.0, 0.0]; strains.len()] });
        paths.record(Instant { time: 1.0, travel: 1.0, strains: strains.to_vec() });
        assess(&curve, &paths).expect("paths")
    };
    let open = found(&[[0.3, 0.25], [0.1, 0.1], [0.1, -0.05]]);
    assert!(open.reached.is_none() && !open.is_kept());
    assert_eq!(open.open().map(|judged| judged.s0), Some(0.0));
    assert_eq!(open.worst().s0, 1.0, "the least margin of those that are judged");
    let kept = found(&[[0.19, 0.15], [0.1, -0.05]]);
    assert!(kept.is_kept() && kept.open().is_none());
    let reached = found(&[[0.3, 0.25], [0.3, -0.05]]);
    assert_eq!(reached.reached.map(|reached| reached.s0), Some(1.0));
    assert!(!reached.is_kept());
}
