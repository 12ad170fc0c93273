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
use crate::numerics::number::{Instructions, Lanes, beside};
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

/// An element in its reference configuration, as a step begins; or several alike side by side.
#[derive(Clone, Copy, Debug)]
pub struct Reference<T = f64> {
    hoop: bool,
    bending: bool,
    dr: T,
    dz: T,
    fibre: Fibre<T>,
    /// Length of the meridian \[mm\].
    pub length: T,
    /// Radius of the middle \[mm\].
    pub radius: T,
}

/// Cosine and sine of the mean rotation θ_m.
#[derive(Clone, Copy, Debug)]
struct Fibre<T> {
    cos: T,
    sin: T,
}

impl<T: Real> Fibre<T> {
    #[inline(always)]
    fn new(angle: T) -> Self {
        let [sin, cos] = small::sin_cos(angle);
        Self { cos, sin }
    }

    /// Turned on.
    #[inline(always)]
    fn turned(&self, by: &Self) -> Self {
        Self { cos: self.cos * by.cos - self.sin * by.sin, sin: self.sin * by.cos + self.cos * by.sin }
    }
}

/// The element in its current configuration: as it is tried at the end of the step.
#[derive(Clone, Copy, Debug)]
pub struct Current<T = f64> {
    reference: Reference<T>,
    cos: T,
    sin: T,
    length: T,
    radius: T,
    fibre: Fibre<T>,
    /// Strain increments of the step.
    pub strain: Generalised<T>,
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
            length: (dr * dr + dz * dz).sqrt(),
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
}

impl<S: Instructions> Reference<Lanes<S>> {
    /// As many as there are lanes, of one geometry and theory.
    #[inline(always)]
    pub fn beside(simd: S, of: &[Reference]) -> Self {
        Self {
            hoop: of[0].hoop,
            bending: of[0].bending,
            dr: beside!(simd, of, dr),
            dz: beside!(simd, of, dz),
            fibre: Fibre { cos: beside!(simd, of, fibre.cos), sin: beside!(simd, of, fibre.sin) },
            length: beside!(simd, of, length),
            radius: beside!(simd, of, radius),
        }
    }
}

impl<T: Real> Reference<T> {
    /// The same element after its nodes have moved by `a` and `b` in the step; `None` when it has collapsed or crossed
    /// the axis.
    ///
    /// Strains are formed from the moves, not from positions: where the sheet hardly flows, stress is a strain of 1e-10
    /// times a viscosity of 1e8 MPa, and the difference of two positions would be round-off.
    #[inline(always)]
    pub fn moved(&self, a: [T; 3], b: [T; 3]) -> Option<Current<T>> {
        let (ur, uz, turn) = (b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        let (dr, dz) = (self.dr + ur, self.dz + uz);
        let length = (dr * dr + dz * dz).sqrt();
        let outward = (a[0] + b[0]) * 0.5;
        let radius = self.radius + outward;
        // The comparisons are also false for NaN.
        let sound = length.everywhere(length.exceeds(self.length * 1e-6))
            && (!self.hoop || radius.everywhere(radius.exceeds(self.radius * 1e-6)));
        if !sound {
            return None;
        }
        let rotation = (a[2] + b[2]) * 0.5;
        let mut fibre = self.fibre;
        let mut strain = [length.constant(0.0); 5];
        let stretch = ((self.dr * ur + self.dz * uz) * 2.0 + ur * ur + uz * uz) / (self.length * self.length);
        strain[EPS_S] = small::ln_1p(stretch) * 0.5;
        if self.hoop {
            strain[EPS_T] = small::ln_1p(outward / self.radius);
        }
        if self.bending {
            strain[KAPPA_S] = turn / self.length;
            if self.hoop {
                // sin(θ + δ) − sin θ = 2 cos(θ + δ/2) sin(δ/2)
                let half = Fibre::new(rotation * 0.5);
                let middle = fibre.turned(&half);
                strain[KAPPA_T] = middle.cos * 2.0 * half.sin / self.radius;
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

impl<T: Real> Current<T> {
    /// B, without its zeros.
    #[inline(always)]
    pub fn strain_displacement(&self) -> StrainDisplacement<T> {
        let (c, s, reference) = (self.cos / self.length, self.sin / self.length, &self.reference);
        let bending = if reference.bending { 1.0 } else { 0.0 };
        let hoop = if reference.hoop { 1.0 } else { 0.0 };
        StrainDisplacement {
            along: [c, s],
            across: [-s * bending, c * bending],
            hoop: c.constant(0.5 * hoop) / self.radius,
            bend: c.constant(bending) / reference.length,
            turn: self.fibre.cos * (0.5 * bending * hoop) / reference.radius,
            shear: c.constant(-0.5 * bending),
            swing: self.fibre.sin * (-0.25 * bending * hoop) / reference.radius,
        }
    }

    /// Rows of Δε_s and Δε_θ by r₁, z₁, r₂, z₂ \[1/mm\].
    #[inline(always)]
    pub fn membrane_rows(&self) -> [[T; 4]; 2] {
        let StrainDisplacement { along: [c, s], hoop, .. } = self.strain_displacement();
        let zero = hoop.constant(0.0);
        [[-c, -s, c, s], [hoop, zero, hoop, zero]]
    }
}

impl Current {
    /// Whether the element bends, or is a membrane.
    pub fn bends(&self) -> bool {
        self.reference.bending
    }

    /// Change of the slope φ of the meridian in the step \[rad\].
    pub fn turn(&self) -> f64 {
        let Reference { dr, dz, .. } = self.reference;
        (dr * self.sin - dz * self.cos).atan2(dr * self.cos + dz * self.sin)
    }
}

#[cfg(test)]
mod tests;
