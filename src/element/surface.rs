//! The mid-surface between the nodes of an element: where tools touch it.
//!
//! ```text
//! x(ξ) = ½(1−ξ) x₁ + ½(1+ξ) x₂ − ⅛(1−ξ²)(θ₂ − θ₁) n l,   n l = (−Δz, Δr)
//! ```
//!
//! The nodes' rotations bow it: a chord of 1.1 mm sags from an arc of 25 mm by 6 µm, more than the contact penalty's foot.
//! The bow's slope vanishes in the middle, so that the strains at the element's one point do not change. It is linear in
//! the rotations and in the positions, and so are its derivatives.
//!
//! # References
//! Linked interpolation of Mindlin beams: O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, vol. 2.

use super::Node;
use crate::geometry::Point;

/// A place on an element.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// ξ, −1 at the first node and 1 at the second.
    pub xi: f64,
    /// ½(1−ξ), ½(1+ξ).
    pub shape: [f64; 2],
    /// ⅛(1−ξ²).
    bow: f64,
    /// By how much its share of the area exceeds a half, over (r₂−r₁)/r \[–\].
    pub skew: f64,
}

/// Contact points of an element.
pub const STATIONS: usize = 2;

/// Contact points of an element that bends, Gauss's: they integrate pressures that vary like a cubic along it.
const INSIDE: [Station; STATIONS] = [Station::at(-GAUSS, -0.25 * GAUSS), Station::at(GAUSS, 0.25 * GAUSS)];

/// Contact points of a membrane, its nodes with the areas of linear shape functions: what cannot bend is a chain of chords,
/// and only their ends lie where the sheet does.
const ENDS: [Station; STATIONS] = [Station::at(-1.0, -1.0 / 12.0), Station::at(1.0, 1.0 / 12.0)];

/// 1/√3.
const GAUSS: f64 = 0.577_350_269_189_625_8;

/// The contact points of an element that bends or is a membrane.
#[inline]
pub fn stations(bends: bool) -> &'static [Station; STATIONS] {
    if bends { &INSIDE } else { &ENDS }
}

/// Derivatives of a place's position by the element's motions: the sums s = (r₁+r₂, z₁+z₂), by which it is half the unit
/// matrix; the differences d = (r₂−r₁, z₂−z₁); and θ₂−θ₁.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// ∂x/∂(r₂−r₁) and ∂x/∂(z₂−z₁).
    pub by_difference: [[f64; 2]; 2],
    /// ∂x/∂(θ₂−θ₁).
    pub by_bend: [f64; 2],
}

impl Slope {
    /// ∂(v·x) of a vector v by the motions: sums, differences, θ₂−θ₁.
    #[inline(always)]
    pub fn of(&self, [r, z]: [f64; 2]) -> [f64; 5] {
        let ([by_r, by_z], by_bend) = (self.by_difference, self.by_bend);
        let bend = by_bend[0] * r + by_bend[1] * z;
        [r * 0.5, z * 0.5, by_r[0] * r + by_r[1] * z, by_z[0] * r + by_z[1] * z, bend]
    }
}

/// The differences of an element's nodes: r₂−r₁, z₂−z₁, θ₂−θ₁.
#[inline(always)]
pub fn difference(a: &Node, b: &Node) -> [f64; 3] {
    [b[0] - a[0], b[1] - a[1], b[2] - a[2]]
}

impl Station {
    const fn at(xi: f64, skew: f64) -> Self {
        Self { xi, skew, shape: [0.5 * (1.0 - xi), 0.5 * (1.0 + xi)], bow: 0.125 * (1.0 - xi * xi) }
    }

    /// Its position on the element between `a` and `b` \[mm\].
    #[inline]
    pub fn position(&self, a: &Node, b: &Node) -> Point {
        let bow = self.bow * (b[2] - a[2]);
        let [p, q] = self.shape;
        Point::new(p * a[0] + q * b[0] + bow * (b[1] - a[1]), p * a[1] + q * b[1] - bow * (b[0] - a[0]))
    }

    /// Derivatives of the position by the [`difference`] of the nodes.
    #[inline(always)]
    pub fn slope(&self, [dr, dz, turn]: [f64; 3]) -> Slope {
        let (along, bow) = (0.5 * self.xi, turn * self.bow);
        Slope { by_difference: [[along, -bow], [bow, along]], by_bend: [dz * self.bow, -(dr * self.bow)] }
    }

    /// ∂²(F·x)/∂(θ₂−θ₁)∂d; all other second derivatives are zero.
    #[inline(always)]
    pub fn second(&self, [r, z]: [f64; 2]) -> [f64; 2] {
        [-(z * self.bow), r * self.bow]
    }
}

/// Forces on an element's motions \[N, N mm\] and their derivatives: sums of r and z, differences of r and z, difference of θ.
#[derive(Clone, Copy, Debug)]
pub struct MotionForces {
    /// Force by motion.
    pub force: [f64; 5],
    /// Its derivatives: rows by forces, columns by motions.
    pub matrix: [[f64; 5]; 5],
}

impl MotionForces {
    /// The block of the matrix of nodes `i` and `j`, −1 the first and +1 the second, column after column.
    #[inline(always)]
    pub fn block(&self, i: f64, j: f64) -> [f64; 9] {
        let m = &self.matrix;
        let (mut r, mut z, mut bend) = (m[0], m[1], m[4]);
        for k in 0..5 {
            (r[k], z[k], bend[k]) = (r[k] + m[2][k] * i, z[k] + m[3][k] * i, bend[k] * i);
        }
        let (r, z, bend) = (of_node(j, &r), of_node(j, &z), of_node(j, &bend));
        [r[0], z[0], bend[0], r[1], z[1], bend[1], r[2], z[2], bend[2]]
    }
}

/// What goes with node `i`, −1 the first and +1 the second, of values by motion: differences count −1 at the first and +1
/// at the second, sums +1 at both.
#[inline(always)]
pub fn of_node(i: f64, v: &[f64; 5]) -> [f64; 3] {
    [v[0] + v[2] * i, v[1] + v[3] * i, v[4] * i]
}

#[cfg(test)]
mod tests {
    use super::*;
    use approx::assert_relative_eq;

    const A: Node = [11.0, 2.0, 0.2];
    const B: Node = [12.1, 2.7, 0.5];

    /// Trust: the arc itself; what is left of the sag is of fourth order in the angle, here 0.1 rad.
    #[test]
    fn nodes_on_an_arc_put_the_points_between_on_it() {
        let on = |angle: f64| [25.0 * angle.sin(), 25.0 * angle.cos(), -angle];
        let sag = 25.0 * (1.0 - 0.05_f64.cos());
        for station in INSIDE {
            let off = station.position(&on(0.3), &on(0.4)).norm() - 25.0;
            assert!(off.abs() < 0.01 * sag, "{off} of a sag of {sag}");
        }
    }

    /// Trust: central differences of a bilinear function: round-off only, 1e-15 h⁻¹ of positions of 10 mm.
    #[test]
    fn slopes_and_second_derivatives_are_those_of_the_position() {
        let h = 1e-4;
        let moved = |sum: [f64; 2], difference: [f64; 2], bend: f64| {
            let node = |x: Node, i: f64| {
                let [r, z] = [0, 1].map(|d| x[d] + 0.5 * (sum[d] + i * difference[d]));
                [r, z, x[2] + 0.5 * i * bend]
            };
            (node(A, -1.0), node(B, 1.0))
        };
        let force = Point::new(3.0, -2.0);
        for station in INSIDE {
            let slope = station.slope(difference(&A, &B));
            let by = |plus: (Node, Node), minus: (Node, Node)| {
                (station.position(&plus.0, &plus.1) - station.position(&minus.0, &minus.1)) / (2.0 * h)
            };
            for d in 0..2 {
                let unit = |v: f64| if d == 0 { [v, 0.0] } else { [0.0, v] };
                let sum = by(moved(unit(h), [0.0; 2], 0.0), moved(unit(-h), [0.0; 2], 0.0));
                assert_relative_eq!(sum, Point::from(unit(0.5)), epsilon = 1e-10);
                let (plus, minus) = (moved([0.0; 2], unit(h), 0.0), moved([0.0; 2], unit(-h), 0.0));
                assert_relative_eq!(by(plus, minus), Point::from(slope.by_difference[d]), epsilon = 1e-10);
                let bend = |(a, b): (Node, Node)| Point::from(station.slope(difference(&a, &b)).by_bend).dot(&force);
                assert_relative_eq!(
                    (bend(plus) - bend(minus)) / (2.0 * h),
                    station.second([force.x, force.y])[d],
                    epsilon = 1e-10
                );
            }
            let bend = by(moved([0.0; 2], [0.0; 2], h), moved([0.0; 2], [0.0; 2], -h));
            assert_relative_eq!(bend, Point::from(slope.by_bend), epsilon = 1e-10);
        }
    }
}
