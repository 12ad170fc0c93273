//! Strain increments of a finite step and their first and second derivatives.
//!
//! With one meridional point there is neither locking nor a hourglass mode: the axisymmetric element has five
//! strains for six freedoms less one rigid motion, the plane-strain element three for six less three.
//!
//! ```text
//! Δε_s = ln(l₁/l₀)          Δκ_s = Δ(θ₂ − θ₁)/l₀
//! Δε_θ = ln(r₁/r₀)          Δκ_θ = Δ sin θ_m / r₀        (r at the middle; both 0 in plane strain)
//! Δγ   = Δ(φ − θ_m)                                     φ: slope of the meridian
//! ```
//!
//! A thickness point sits at ζ from the mid-surface along −n, n = (−sin φ, cos φ): then ε(ζ) = ε + ζ κ in both directions.
//!
//! # References
//! Oñate, Agelet de Saracibar, Int. J. Num. Meth. Engng. 30 (1990) 1577–1593; Zienkiewicz, Taylor,
//! The Finite Element Method (1989).

use super::surface::{STATIONS, stations};
use super::{Geometry, Node, Theory};
use crate::numerics::{Real, small};

/// Generalised strains or stress resultants: meridional and hoop membrane, meridional and hoop bending, shear.
pub type Generalised<T = f64> = [T; 5];

/// Place of the meridional membrane strain in [`Generalised`]; the others follow.
pub const EPS_S: usize = 0;
/// Hoop membrane strain.
pub const EPS_T: usize = 1;
/// Meridional bending.
pub const KAPPA_S: usize = 2;
/// Hoop bending.
pub const KAPPA_T: usize = 3;
/// Transverse shear.
pub const GAMMA: usize = 4;

/// Least area of a face over that of the mid-surface \[–\]: a radius of half the thickness, where there is no inner face, is
/// no bend of a shell.
const SMALLEST_FACE: f64 = 0.25;

/// An element in its reference configuration: as a step begins.
#[derive(Clone, Copy, Debug)]
pub struct Reference {
    hoop: bool,
    bending: bool,
    dr: f64,
    dz: f64,
    fibre: Fibre,
    /// Length of the meridian \[mm\].
    pub length: f64,
    /// Radius of the middle \[mm\].
    pub radius: f64,
}

/// Cosine and sine of the mean rotation θ_m.
#[derive(Clone, Copy, Debug)]
struct Fibre {
    cos: f64,
    sin: f64,
}

impl Fibre {
    fn new(angle: f64) -> Self {
        let (sin, cos) = small::sin_cos(angle);
        Self { cos, sin }
    }

    /// Turned on.
    #[inline]
    fn turned(&self, by: &Self) -> Self {
        Self { cos: self.cos * by.cos - self.sin * by.sin, sin: self.sin * by.cos + self.cos * by.sin }
    }
}

/// The element in its current configuration: as it is tried at the end of the step.
#[derive(Clone, Copy, Debug)]
pub struct Current {
    reference: Reference,
    cos: f64,
    sin: f64,
    length: f64,
    radius: f64,
    fibre: Fibre,
    /// Strain increments of the step.
    pub strain: Generalised,
}

impl Reference {
    /// The element between `a` (nearer the axis) and `b`, of its own theory: bending or membrane.
    pub fn new(geometry: Geometry, theory: Theory, a: Node, b: Node) -> Self {
        let (dr, dz) = (b[0] - a[0], b[1] - a[1]);
        Self {
            hoop: geometry == Geometry::Axisymmetric,
            bending: theory == Theory::Bending,
            dr,
            dz,
            fibre: Fibre::new(0.5 * (a[2] + b[2])),
            length: dr.hypot(dz),
            radius: 0.5 * (a[0] + b[0]),
        }
    }

    /// Mid-surface area \[mm², or mm per mm of depth\].
    pub fn area(&self) -> f64 {
        if self.hoop { std::f64::consts::TAU * self.radius * self.length } else { self.length }
    }

    /// The parts of the area that belong to the [contact points](stations); they sum to the area.
    pub fn contact_areas(&self) -> [f64; STATIONS] {
        stations(self.bending).map(|station| {
            let skew = if self.hoop { station.skew * self.dr / self.radius } else { 0.0 };
            self.area() * (0.5 + skew)
        })
    }

    /// Areas of the lower and the upper face of a sheet of this `thickness` \[mm\] over that of its mid-surface \[–\]; the
    /// lower face lies along −n, on the outside of a sheet that turns to the left; equal in a membrane, which has no turn.
    ///
    /// ```text
    /// (1 ∓ ½ t dθ/ds)(1 ∓ ½ t sin θ/r), − for the upper face
    /// ```
    pub fn faces(&self, turn: f64, thickness: f64) -> [f64; 2] {
        if !self.bending {
            return [1.0; 2];
        }
        let around = if self.hoop { self.fibre.sin / self.radius } else { 0.0 };
        [1.0, -1.0].map(|side| {
            let h = 0.5 * side * thickness;
            ((1.0 + h * turn / self.length) * (1.0 + h * around)).max(SMALLEST_FACE)
        })
    }

    /// The same element after its nodes have moved by `a` and `b` in the step; `None` when it has collapsed or crossed
    /// the axis.
    ///
    /// Strains are formed from the moves, not from positions: where the sheet hardly flows, stress is a strain of 1e-10
    /// times a viscosity of 1e8 MPa, and the difference of two positions would be round-off.
    #[inline(always)]
    pub fn moved(&self, a: Node, b: Node) -> Option<Current> {
        let (ur, uz, turn) = (b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        let (dr, dz) = (self.dr + ur, self.dz + uz);
        let length = (dr * dr + dz * dz).sqrt();
        let outward = 0.5 * (a[0] + b[0]);
        let radius = self.radius + outward;
        // The comparison is also false for NaN.
        let sound = length > 1e-6 * self.length && (!self.hoop || radius > 1e-6 * self.radius);
        if !sound {
            return None;
        }
        let rotation = 0.5 * (a[2] + b[2]);
        let mut fibre = self.fibre;
        let mut strain = [0.0; 5];
        let stretch = (2.0 * (self.dr * ur + self.dz * uz) + ur * ur + uz * uz) / (self.length * self.length);
        strain[EPS_S] = 0.5 * small::ln_1p(stretch);
        if self.hoop {
            strain[EPS_T] = small::ln_1p(outward / self.radius);
        }
        if self.bending {
            strain[KAPPA_S] = turn / self.length;
            if self.hoop {
                // sin(θ + δ) − sin θ = 2 cos(θ + δ/2) sin(δ/2)
                let half = Fibre::new(0.5 * rotation);
                let middle = fibre.turned(&half);
                strain[KAPPA_T] = 2.0 * middle.cos * half.sin / self.radius;
                fibre = middle.turned(&half);
            }
            strain[GAMMA] = small::angle(self.dr * uz - self.dz * ur, self.dr * dr + self.dz * dz) - rotation;
        }
        Some(Current { reference: *self, cos: dr / length, sin: dz / length, length, radius, fibre, strain })
    }
}

/// First derivatives of the strains by the element's own five motions: the differences r₂−r₁, z₂−z₁, θ₂−θ₁ and the
/// sums r₁+r₂, θ₁+θ₂ of its nodes. Every strain depends on one or two of them: B with its zeros left out.
#[derive(Clone, Copy, Debug)]
pub struct StrainDisplacement<T = f64> {
    /// ∂ε_s/∂(r₂−r₁, z₂−z₁) = t/l.
    pub along: [T; 2],
    /// ∂γ/∂(r₂−r₁, z₂−z₁) = n/l.
    pub across: [T; 2],
    /// ∂ε_θ/∂(r₁+r₂).
    pub hoop: T,
    /// ∂κ_s/∂(θ₂−θ₁).
    pub bend: T,
    /// ∂κ_θ/∂(θ₁+θ₂).
    pub turn: T,
    /// ∂γ/∂(θ₁+θ₂).
    pub shear: T,
    /// ∂²κ_θ/∂(θ₁+θ₂)².
    pub swing: T,
}

/// Σ S ∂²strain of some resultants S by the same motions: the geometric stiffness.
#[derive(Clone, Copy, Debug)]
pub struct GeometricStiffness<T = f64> {
    /// By the differences r₂−r₁, z₂−z₁: rr, rz, zz.
    pub difference: [T; 3],
    /// By r₁+r₂ twice.
    pub hoop: T,
    /// By θ₁+θ₂ twice.
    pub turn: T,
}

impl<T: Real> StrainDisplacement<T> {
    /// Geometric stiffness of the resultants `s`; those that the element does not have are 0.
    ///
    /// ```text
    /// ∂² ln l = (I − 2 ttᵀ)/l²,  ∂²φ = −(ntᵀ + tnᵀ)/l²,  ∂² ln r = −(∂ ln r)²
    /// ```
    #[inline(always)]
    pub fn geometric_stiffness(&self, s: &Generalised<T>) -> GeometricStiffness<T> {
        let [x, y] = self.along;
        let (product, apart) = (x * y * 2.0, y * y - x * x);
        // A membrane has no shear: its row is zero, whatever the force.
        let (along, shear) = (s[EPS_S], s[GAMMA] * self.shear * -2.0);
        GeometricStiffness {
            difference: [
                along * apart + shear * product,
                shear * apart - along * product,
                -(along * apart + shear * product),
            ],
            hoop: -(s[EPS_T] * self.hoop * self.hoop),
            turn: s[KAPPA_T] * self.swing,
        }
    }
}

impl Current {
    /// B, without its zeros.
    #[inline]
    pub fn strain_displacement(&self) -> StrainDisplacement {
        let (c, s, reference) = (self.cos / self.length, self.sin / self.length, &self.reference);
        let bending = if reference.bending { 1.0 } else { 0.0 };
        let hoop = if reference.hoop { 1.0 } else { 0.0 };
        StrainDisplacement {
            along: [c, s],
            across: [-s * bending, c * bending],
            hoop: hoop * 0.5 / self.radius,
            bend: bending / reference.length,
            turn: bending * hoop * 0.5 * self.fibre.cos / reference.radius,
            shear: -0.5 * bending,
            swing: -0.25 * bending * hoop * self.fibre.sin / reference.radius,
        }
    }

    /// Whether the element bends, or is a membrane.
    pub fn bends(&self) -> bool {
        self.reference.bending
    }

    /// Change of the slope φ of the meridian in the step \[rad\].
    pub fn turn(&self) -> f64 {
        let Reference { dr, dz, .. } = self.reference;
        (dr * self.sin - dz * self.cos).atan2(dr * self.cos + dz * self.sin)
    }

    /// Rows of Δε_s and Δε_θ by r₁, z₁, r₂, z₂ \[1/mm\].
    pub fn membrane_rows(&self) -> [[f64; 4]; 2] {
        let StrainDisplacement { along: [c, s], hoop, .. } = self.strain_displacement();
        [[-c, -s, c, s], [hoop, 0.0, hoop, 0.0]]
    }
}

#[cfg(test)]
mod tests;
