//! The split-ring test: rings of known moments, the mean of their curling, and where a ring is cut from a wall.

use crate::common::prelude::*;

const METAL: Elastic = Elastic { young: 70e3, poisson: 0.33 };
const R: f64 = 17.0;
const T: f64 = 1.1;

/// E and D of a strip of thickness [`T`].
fn stiffness() -> (f64, f64) {
    let bar = METAL.young * T.powi(3) / 12.0;
    (bar, bar / (1.0 - METAL.poisson * METAL.poisson))
}

fn ring(height: f64, [moment_hoop, moment_meridional]: [f64; 2]) -> CutRing {
    CutRing { radius: R, thickness: T, height, moment_hoop, moment_meridional }
}

/// Trust: a straight elastic strip that is bent to a closed ring and joined goes back to a straight line: opened by 2πr. Held
/// straight along the axis it has the moments D/r and ν D/r whatever its height; free to curl, EI/r and none.
#[test]
fn an_elastic_strip_bent_to_a_ring_opens_by_its_whole_length() {
    let (bar, plate) = stiffness();
    for height in [1e-6, 0.5, 2.0, 5.0, 20.0, 200.0, 1e6] {
        let opening = ring(height, [plate / R, METAL.poisson * plate / R]).opening(METAL);
        assert!((opening / (TAU * R) - 1.0).abs() < 1e-9, "{height}: {opening}");
    }
    let low = ring(1e-6, [bar / R, 0.0]).opening(METAL);
    assert!((low / (TAU * R) - 1.0).abs() < 1e-9, "{low}");
    // A bar's modulus of a low ring, a plate's of a high one: δ = 2π r² M/(E′ I), a moment the other way closes it.
    for (height, modulus) in [(1e-6, METAL.young), (1e12, METAL.young / (1.0 - METAL.poisson.powi(2)))] {
        let closed = TAU * R * R * -40.0 / (modulus * T.powi(3) / 12.0);
        let found = ring(height, [-40.0, 0.0]).opening(METAL);
        assert!((found / closed - 1.0).abs() < 1e-9, "{height}: {found} {closed}");
    }
}

/// Trust: the shell equation D w⁗ + E t w/r² = 0 solved by hand for a ring whose edges bear a moment: w = A cosh ay cos ay +
/// B sinh ay sin ay with 4 a⁴ = E t/(D r²), w″ = 1 and w‴ = 0 at y = h/2; the mean of w″ is 2 w′/h there.
#[test]
fn the_share_of_curling_is_that_of_the_shell_equation() {
    let (_, plate) = stiffness();
    let a = (METAL.young * T / (4.0 * plate * R * R)).powf(0.25);
    for height in [0.3, 1.0, 3.0, 5.0, 8.0, 15.0, 40.0] {
        let y = 0.5 * a * height;
        let (ch, sh, c, s) = (y.cosh(), y.sinh(), y.cos(), y.sin());
        // Derivatives of cosh cos and sinh sin over those of a y.
        let second = [-2.0 * sh * s, 2.0 * ch * c];
        let third = [-2.0 * (ch * s + sh * c), 2.0 * (sh * c - ch * s)];
        let det = second[0] * third[1] - second[1] * third[0];
        let [p, q] = [third[1] / det, -third[0] / det];
        let slope = p * (sh * c - ch * s) + q * (ch * s + sh * c);
        let mean = slope / y;
        let found = ring(height, [0.0; 2]).curling(METAL.poisson);
        assert!((found - mean).abs() < 1e-9, "{height}: {found} {mean}");
    }
    let shares = [0.0, 1.0, 3.0, 10.0, 30.0, 99.0, 101.0, 1e4].map(|h| ring(h, [0.0; 2]).curling(0.3));
    assert!(shares.windows(2).all(|pair| pair[1] <= pair[0]) && shares[0] == 1.0, "{shares:?}");
}

/// A wall of eight elements of 3 mm that goes from its bottom along the punch travel, or against it, leaning by an angle [rad];
/// stress σ = c ζ in the hoop and half of it along, tension outside.
fn wall(towards: f64, lean: f64, slope: f64) -> Frame {
    let layers = lobatto(9);
    let at = |i: usize| {
        let way = 3.0 * i as f64;
        NodeRecord { r: R + way * lean.sin(), z: towards * way * lean.cos(), theta: 0.0, thickness: T }
    };
    let nodes: Vec<NodeRecord> = (0..=8).map(at).collect();
    let element = |i: usize| ElementRecord {
        r: 0.5 * (nodes[i].r + nodes[i + 1].r),
        z: 0.5 * (nodes[i].z + nodes[i + 1].z),
        thickness: T,
        ..ElementRecord::default()
    };
    let elements: Vec<ElementRecord> = (0..8).map(element).collect();
    // The layers run towards the punch's face: inward in a wall whose rim lies behind the punch.
    let point = |layer: &ThicknessPoint| {
        let outward = 0.5 * T * layer.xi * towards;
        PointRecord { stress_hoop: slope * outward, stress_meridional: 0.5 * slope * outward, ..PointRecord::default() }
    };
    let points = (0..8).flat_map(|_| layers.iter().map(point)).collect();
    let through = ThroughThickness { points, layers };
    Frame { time: 0.0, travel: 0.0, elements, nodes, through, tool_displacement: Vec::new() }
}

/// Trust: ∫ c ζ² dζ = c t³/12, which the rule integrates exactly; ends of the ring inside of elements.
#[test]
fn a_ring_is_cut_over_the_bottom_and_has_the_wall_s_moments() {
    let exact = 100.0 * T.powi(3) / 12.0;
    for towards in [-1.0, 1.0] {
        let found = Ring { from: 4.0, height: 7.3 }.cut(&wall(towards, 0.0, 100.0)).expect("a wall");
        for (found, expected) in [
            (found.radius, R),
            (found.thickness, T),
            (found.height, 7.3),
            (found.moment_hoop, exact),
            (found.moment_meridional, 0.5 * exact),
        ] {
            assert!((found / expected - 1.0).abs() < 1e-9, "{towards}: {found} {expected}");
        }
    }
    // A wall that leans has its radius in the middle of the ring.
    let leaning = Ring { from: 0.55 + 3.0, height: 6.0 }.cut(&wall(-1.0, 0.1, 100.0)).expect("a wall");
    let middle = R + 6.0 * 0.1f64.tan();
    assert!((leaning.radius - middle).abs() < 0.02, "{} {middle}", leaning.radius);
    assert_eq!(Ring { from: 20.0, height: 5.0 }.cut(&wall(-1.0, 0.0, 100.0)), None, "beyond the rim");
    assert_eq!(Ring { from: 0.1, height: 5.0 }.cut(&wall(-1.0, 0.0, 100.0)), None, "in the bottom");
    assert_eq!(Ring { from: 4.0, height: 5.0 }.cut(&wall(-1.0, 0.6, 100.0)), None, "no wall");
}
