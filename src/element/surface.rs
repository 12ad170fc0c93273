//! The mid-surface between the nodes of an element: where tools touch it.
//!
//! ```text
//! x(ξ) = ½(1−ξ) x₁ + ½(1+ξ) x₂ − ⅛(1−ξ²)(θ₂ − θ₁) n l,   n l = (−Δz, Δr)
//! ```
//!
//! The nodes' rotations bow it: a chord of 1.1 mm sags 6 µm from an arc of 25 mm; the bow is level in its middle.
//!
//! Source: Linked interpolation of Mindlin beams: O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, vol. 2.

use super::{Node, Vector6, kinematics::Matrix6};
use crate::geometry::Point;

/// A place on an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// ξ, −1 at the first node and 1 at the second.
    pub xi: f64,
    /// ½(1−ξ), ½(1+ξ).
    pub shape: [f64; 2],
    /// ⅛(1−ξ²).
    pub bow: f64,
    /// Excess of its share of the area over a half, over (r₂−r₁)/r \[–\].
    pub skew: f64,
}

/// Contact points of an element.
pub const STATIONS: usize = 2;

/// Contact points of an element that bends, Gauss's: they integrate pressures that vary like a cubic along it.
const INSIDE: [Station; STATIONS] = [Station::at(-GAUSS, -0.25 * GAUSS), Station::at(GAUSS, 0.25 * GAUSS)];
/// Contact points of a membrane: its nodes, because only the ends of its chord lie where the sheet does.
const ENDS: [Station; STATIONS] = [Station::at(-1.0, -1.0 / 12.0), Station::at(1.0, 1.0 / 12.0)];
/// 1/√3.
const GAUSS: f64 = 0.577_350_269_189_625_8;

/// The contact points of an element that bends or is a membrane.
pub fn stations(bends: bool) -> &'static [Station; STATIONS] {
    if bends { &INSIDE } else { &ENDS }
}

impl Station {
    const fn at(xi: f64, skew: f64) -> Self {
        Self { xi, skew, shape: [0.5 * (1.0 - xi), 0.5 * (1.0 + xi)], bow: 0.125 * (1.0 - xi * xi) }
    }

    /// Its position on the element between `a` and `b` \[mm\].
    pub fn position(&self, a: &Node, b: &Node) -> Point {
        let bow = self.bow * (b[2] - a[2]);
        let [p, q] = self.shape;
        Point::new(p * a[0] + q * b[0] + bow * (b[1] - a[1]), p * a[1] + q * b[1] - bow * (b[0] - a[0]))
    }

    /// Derivatives of r and of z by the element's freedoms.
    pub fn slopes(&self, a: &Node, b: &Node) -> [Vector6; 2] {
        let ([p, q], turn) = (self.shape, self.bow * (b[2] - a[2]));
        let (dr, dz) = (self.bow * (b[0] - a[0]), self.bow * (b[1] - a[1]));
        [[p, -turn, -dz, q, turn, dz].into(), [turn, p, dr, -turn, q, -dr].into()]
    }
}

/// Adds Σ F·∂²x by the element's freedoms to a matrix, from `bowed` = Σ ⅛(1−ξ²) F.
pub fn add_position_second(matrix: &mut Matrix6, bowed: Point) {
    let (r, z) = (bowed.x, bowed.y);
    for (turn, r, z) in [(2, r, z), (5, -r, -z)] {
        for (move_, value) in [(0, -z), (1, r), (3, z), (4, -r)] {
            matrix[(turn, move_)] += value;
            matrix[(move_, turn)] += value;
        }
    }
}

/// Adds q (∂²t − ∂t ∂tᵀ/t) of the thickness t by the element's freedoms to a matrix, from its first derivatives.
///
/// ```text
/// ∂²t = ∂t ∂tᵀ/t − t ∂²(ε_s + ε_θ),   ∂t = −t ∂(ε_s + ε_θ)
/// ```
pub fn add_thickness_second(matrix: &mut Matrix6, first: &Vector6, thickness: f64, q: f64) {
    // By r₁+r₂, r₂−r₁ and z₂−z₁.
    let [hoop, r, z] = [0.5 * (first[0] + first[3]), 0.5 * (first[3] - first[0]), first[4]];
    let share = q / thickness;
    let (hoop, own, mixed) = (share * hoop * hoop, share * (r * r - z * z), share * 2.0 * r * z);
    for (i, j, sign) in [(0, 0, 1.0), (0, 3, -1.0), (3, 0, -1.0), (3, 3, 1.0)] {
        matrix[(i, j)] += hoop + sign * own;
        matrix[(i, j + 1)] += sign * mixed;
        matrix[(i + 1, j)] += sign * mixed;
        matrix[(i + 1, j + 1)] -= sign * own;
    }
}
