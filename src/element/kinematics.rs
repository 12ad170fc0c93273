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
//! Source: Oñate, Agelet de Saracibar, Int. J. Num. Meth. Engng. 30 (1990) 1577; Zienkiewicz, Taylor, FEM (1989).

use super::{Geometry, Node, Theory, Vector6, surface::STATIONS, surface::stations};
use nalgebra::{SMatrix, SVector, UnitComplex};

/// Generalised strains or stress resultants: meridional and hoop membrane, meridional and hoop bending, shear.
pub type Generalised = SVector<f64, 5>;

/// Index of the meridional membrane strain in [`Generalised`].
pub const EPS_S: usize = 0;
/// Hoop membrane strain.
pub const EPS_T: usize = 1;
/// Meridional bending.
pub const KAPPA_S: usize = 2;
/// Hoop bending.
pub const KAPPA_T: usize = 3;
/// Transverse shear.
pub const GAMMA: usize = 4;

/// Least area of a face over that of the mid-surface \[–\]; at a radius of half the thickness there is no inner face.
const SMALLEST_FACE: f64 = 0.25;

/// Element in its reference configuration, that of the start of the step.
#[derive(Clone, Copy, Debug)]
pub struct Reference {
    hoop: bool,
    pub(super) bending: bool,
    dr: f64,
    dz: f64,
    /// Mean rotation θ_m.
    fibre: UnitComplex<f64>,
    /// Length of the meridian \[mm\].
    pub length: f64,
    /// Radius of the middle \[mm\].
    pub radius: f64,
}

/// The element in its current configuration, at the end of the step.
#[derive(Clone, Copy, Debug)]
pub struct Current {
    pub(super) reference: Reference,
    /// ∂ε_s/∂(r₂−r₁, z₂−z₁) = t/l \[1/mm\].
    along: [f64; 2],
    /// ∂ε_θ/∂(r₁+r₂) \[1/mm\].
    hoop: f64,
    /// ∂κ_s/∂(θ₂−θ₁) and ∂κ_θ/∂(θ₁+θ₂) \[1/mm\].
    bend: [f64; 2],
    fibre: UnitComplex<f64>,
    /// Strain increments of the step; 0 where the element has no such strain.
    pub strain: Generalised,
}

impl Reference {
    /// The element between `a` (nearer the axis) and `b`, of its own theory: bending or membrane.
    pub fn new(geometry: Geometry, theory: Theory, a: Node, b: Node) -> Self {
        let (dr, dz) = (b[0] - a[0], b[1] - a[1]);
        let (hoop, bending) = (geometry == Geometry::Axisymmetric, theory == Theory::Bending);
        let (length, radius) = ((dr * dr + dz * dz).sqrt(), 0.5 * (a[0] + b[0]));
        Self { hoop, bending, dr, dz, fibre: UnitComplex::new(0.5 * (a[2] + b[2])), length, radius }
    }

    /// Mid-surface area \[mm², or mm per mm of depth\].
    pub fn area(&self) -> f64 {
        if self.hoop { std::f64::consts::TAU * self.radius * self.length } else { self.length }
    }

    /// The parts of the area that belong to the [contact points](stations); they sum to the area.
    pub fn contact_areas(&self) -> [f64; STATIONS] {
        stations(self.bending)
            .map(|station| self.area() * (0.5 + if self.hoop { station.skew * self.dr / self.radius } else { 0.0 }))
    }

    /// Areas of the lower and the upper face of a sheet of this `thickness` \[mm\] over that of its mid-surface \[–\].
    ///
    /// ```text
    /// (1 ± ½ t dθ/ds)(1 ± ½ t sin θ/r), − for the upper face, which lies along n; 1 for a membrane
    /// ```
    pub fn faces(&self, turn: f64, thickness: f64) -> [f64; 2] {
        if !self.bending {
            return [1.0; 2];
        }
        let around = if self.hoop { self.fibre.im / self.radius } else { 0.0 };
        [1.0, -1.0].map(|side| {
            let h = 0.5 * side * thickness;
            ((1.0 + h * turn / self.length) * (1.0 + h * around)).max(SMALLEST_FACE)
        })
    }

    /// The element after its nodes have moved by `a` and `b`; `None` when it has collapsed or crossed the axis.
    /// Strains are formed from the moves: where the sheet hardly flows, differences of positions would be round-off.
    pub fn moved(&self, a: [f64; 3], b: [f64; 3]) -> Option<Current> {
        let (ur, uz, turn) = (b[0] - a[0], b[1] - a[1], b[2] - a[2]);
        let (dr, dz) = (self.dr + ur, self.dz + uz);
        let length = (dr * dr + dz * dz).sqrt();
        let outward = (a[0] + b[0]) * 0.5;
        let radius = self.radius + outward;
        // The comparisons are also false for NaN.
        let sound = length > 1e-6 * self.length && (!self.hoop || radius > 1e-6 * self.radius);
        if !sound {
            return None;
        }
        let rotation = (a[2] + b[2]) * 0.5;
        let mut fibre = self.fibre;
        let mut strain = Generalised::zeros();
        let stretch = ((self.dr * ur + self.dz * uz) * 2.0 + ur * ur + uz * uz) / (self.length * self.length);
        strain[EPS_S] = 0.5 * stretch.ln_1p();
        if self.hoop {
            strain[EPS_T] = (outward / self.radius).ln_1p();
        }
        if self.bending {
            strain[KAPPA_S] = turn / self.length;
            if self.hoop {
                // sin(θ + δ) − sin θ = 2 cos(θ + δ/2) sin(δ/2)
                let half = UnitComplex::new(rotation * 0.5);
                let middle = fibre * half;
                strain[KAPPA_T] = middle.re * 2.0 * half.im / self.radius;
                fibre = middle * half;
            }
            strain[GAMMA] = (self.dr * uz - self.dz * ur).atan2(self.dr * dr + self.dz * dz) - rotation;
        }
        let along = [dr, dz].map(|d| d / (length * length));
        let hoop = if self.hoop { 0.5 / radius } else { 0.0 };
        let bend_along = if self.bending { 1.0 / self.length } else { 0.0 };
        let bend_across = if self.bending && self.hoop { 0.5 * fibre.re / self.radius } else { 0.0 };
        Some(Current { reference: *self, along, hoop, bend: [bend_along, bend_across], fibre, strain })
    }
}

/// B, the derivatives of the strains (rows) by r₁, z₁, θ₁, r₂, z₂, θ₂ (columns).
pub type StrainDisplacement = SMatrix<f64, 5, 6>;

/// Matrix of an element by its freedoms.
pub type Matrix6 = SMatrix<f64, 6, 6>;

impl Current {
    /// Bᵀ S: forces of the nodes that balance the resultants `s`.
    #[inline(always)]
    pub fn nodal_forces(&self, s: &Generalised) -> Vector6 {
        let (shear, half) = if self.reference.bending { (s[GAMMA], 0.5 * s[GAMMA]) } else { (0.0, 0.0) };
        let ([x, y], hoop) = (self.along, self.hoop * s[EPS_T]);
        let (r, z) = (x * s[EPS_S] - y * shear, y * s[EPS_S] + x * shear);
        let (apart, mean) = (self.bend[0] * s[KAPPA_S], self.bend[1] * s[KAPPA_T] - half);
        [hoop - r, -z, mean - apart, hoop + r, z, mean + apart].into()
    }

    /// B; rows of strains that the element does not have are zero.
    pub fn strain_displacement(&self) -> StrainDisplacement {
        let row = |i: usize| self.nodal_forces(&Generalised::ith(i, 1.0)).transpose();
        StrainDisplacement::from_rows(&[EPS_S, EPS_T, KAPPA_S, KAPPA_T, GAMMA].map(row))
    }

    /// Bᵀ C B of a symmetric C.
    pub fn stiffness(&self, c: &SMatrix<f64, 5, 5>) -> Matrix6 {
        let half: [Vector6; 5] = std::array::from_fn(|j| self.nodal_forces(&c.column(j).into_owned()));
        let row = |i: usize| self.nodal_forces(&half.map(|column| column[i]).into());
        Matrix6::from_columns(&[0, 1, 2, 3, 4, 5].map(row))
    }

    /// Geometric stiffness Σ S ∂²strain of the resultants `s`.
    ///
    /// ```text
    /// ∂² ln l = (I − 2 ttᵀ)/l²,  ∂²φ = −(ntᵀ + tnᵀ)/l²,  ∂² ln r = −(∂ ln r)²,  ∂² sin θ = −sin θ
    /// ```
    pub fn geometric_stiffness(&self, s: &Generalised) -> Matrix6 {
        let (reference, [x, y], hoop) = (&self.reference, self.along, self.hoop);
        let shear = if reference.bending { s[GAMMA] } else { 0.0 };
        let rr = s[EPS_S] * (y * y - x * x) + 2.0 * shear * x * y;
        let rz = shear * (y * y - x * x) - 2.0 * s[EPS_S] * x * y;
        let sum = -s[EPS_T] * hoop * hoop;
        let turns = reference.bending && reference.hoop;
        let turn = if turns { -0.25 * s[KAPPA_T] * self.fibre.im / reference.radius } else { 0.0 };
        let mut k = Matrix6::zeros();
        for (i, j, sign) in [(0, 0, 1.0), (0, 3, -1.0), (3, 0, -1.0), (3, 3, 1.0)] {
            (k[(i, j)], k[(i, j + 1)]) = (sign * rr + sum, sign * rz);
            (k[(i + 1, j)], k[(i + 1, j + 1)]) = (sign * rz, -sign * rr);
            k[(i + 2, j + 2)] = turn;
        }
        k
    }

    /// Stiffness of a membrane force against moves across the element.
    pub fn transverse_stiffness(&self, force: f64) -> Matrix6 {
        let [c, s] = self.along;
        let across = Vector6::from([s, -c, 0.0, -s, c, 0.0]);
        force * across * across.transpose()
    }

    /// ∂(Δε_s + Δε_θ) by the element's freedoms \[1/mm\].
    pub fn stretch_rows(&self) -> Vector6 {
        let ([c, s], hoop) = (self.along, self.hoop);
        [hoop - c, -s, 0.0, hoop + c, s, 0.0].into()
    }
}
