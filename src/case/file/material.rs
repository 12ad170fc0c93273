//! `[material]` and one table per hardening law.

use super::{Rate, Softening, Voids};
use crate::model::Mode;
use crate::units::{Fraction, NonNegative, Number, Positive, Stress, Temperature};
use schemars::JsonSchema;
use serde::Deserialize;

/// The sheet's material, isotropic in its plane.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Material {
    /// A sheet of the built-in library (`stampflow materials` lists them); what else is written here replaces what the
    /// library says.
    #[schemars(example = &"aa6016-t4")]
    pub name: Option<String>,
    /// Where the numbers come from: author and year, or how they were measured; left out where they are assumed.
    #[schemars(example = &"tension tests of this coil")]
    pub source: Option<String>,
    /// Young's modulus; given together with `poisson`.
    #[schemars(example = "210 GPa")]
    pub young: Option<Positive<Stress>>,
    /// Poisson's ratio, below 0.5.
    #[schemars(example = 0.3)]
    pub poisson: Option<Fraction>,
    /// Normal anisotropy r̄, 0.1 to 10: width strain over thickness strain in tension, mean over the directions in the
    /// sheet; 1 when not given. σ_y² = σ_s² − 2 r̄/(1 + r̄) σ_s σ_θ + σ_θ².
    ///
    /// Valid for sheet that is alike in all its directions; it cannot show ears, and aluminium with r̄ below 1 is stronger in
    /// equi-biaxial tension than it says. Source: R. Hill, Proc. R. Soc. London A 193 (1948) 281–297.
    #[schemars(example = 1.6)]
    pub anisotropy: Option<Positive<Number>>,
    /// How the metal answers to strain; "flow" when not given. The others need `young` and `poisson`.
    #[schemars(example = &"elasto_viscoplastic")]
    pub mode: Option<Mode>,
    /// Strain-rate dependence; none when not given. The punch's `speed` then matters.
    pub rate: Option<Rate>,
    /// Dependence on the temperature; none when not given. `[heat]` says what the temperature is.
    pub softening: Option<Softening>,
    /// Back-stresses of an elasto-viscoplastic sheet, at most two; none when not given. The hardening law is then what is
    /// left of the yield stress without them.
    ///
    /// dα = C ξ/σ_R dε − γ α dε: valid for metal that is bent and bent back; it needs tests with reversed strain. Source:
    /// J. L. Chaboche, Int. J. Plasticity 2 (1986) 149–188 (not read; the form is in common use).
    #[serde(default)]
    #[schemars(length(max = 2))]
    pub kinematic: Vec<BackStress>,
    /// Microscopic voids; none when not given.
    pub voids: Option<Voids>,
    /// Exactly one law, such as `[material.hardening.swift]`.
    #[serde(default)]
    pub hardening: Hardening,
}

/// A back-stress.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BackStress {
    /// C: its first slope over the plastic strain.
    #[schemars(example = "2500 MPa")]
    pub modulus: Positive<Stress>,
    /// γ: it comes to C/γ; 0 when not given, which is linear.
    #[schemars(example = 30)]
    pub recall: Option<NonNegative<Number>>,
}

/// Yield stress σ over equivalent plastic strain ε of uniaxial tension: exactly one law.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Hardening {
    pub swift: Option<Swift>,
    pub hollomon: Option<Hollomon>,
    pub ludwik: Option<Ludwik>,
    pub voce: Option<Voce>,
    pub table: Option<Table>,
    pub piecewise_power: Option<PiecewisePower>,
    pub isotherms: Option<Isotherms>,
}

/// σ = k (offset + ε)^n.
///
/// Valid up to large strains for most steels; it hardens without end.
/// Source: H. W. Swift, J. Mech. Phys. Solids 1 (1952) 1–18.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Swift {
    #[schemars(example = "520 MPa")]
    pub k: Positive<Stress>,
    #[schemars(example = 0.22)]
    pub n: Fraction,
    /// Offset strain, 1e-6 to 1.
    #[schemars(example = 0.005)]
    pub offset: Positive<Number>,
}

/// σ = k ε^n, started at the elastic line or at a declared offset strain.
///
/// Valid beyond a strain of some per cent; at yield it says little.
/// Source: J. H. Hollomon, Trans. AIME 162 (1945) 268–290.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Hollomon {
    #[schemars(example = "547 MPa")]
    pub k: Positive<Stress>,
    #[schemars(example = 0.18)]
    pub n: Fraction,
    /// Offset strain; without it `young` must be given, and the law starts where it meets the elastic line.
    #[schemars(example = 0.001)]
    pub offset: Option<Positive<Number>>,
}

/// σ = initial + k ε^n.
///
/// Valid for metals with a marked yield stress; just beyond yield its slope is infinite, a chord over 1e-6 takes its place.
/// Source: P. Ludwik, Elemente der technologischen Mechanik, Springer, Berlin (1909).
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ludwik {
    #[schemars(example = "150 MPa")]
    pub initial: Positive<Stress>,
    #[schemars(example = "400 MPa")]
    pub k: NonNegative<Stress>,
    #[schemars(example = 0.5)]
    pub n: Fraction,
}

/// σ = saturation − (saturation − initial) exp(−rate ε^exponent).
///
/// Valid for metals whose hardening comes to an end, such as aluminium.
/// Source: E. Voce, J. Inst. Metals 74 (1948) 537–562; the exponent: J. E. Hockett, O. D. Sherby (1975).
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Voce {
    #[schemars(example = "125 MPa")]
    pub initial: Positive<Stress>,
    #[schemars(example = "320 MPa")]
    pub saturation: Positive<Stress>,
    #[schemars(example = 7.5)]
    pub rate: NonNegative<Number>,
    /// Power of the strain; 1 when not given.
    #[schemars(example = 1.0)]
    pub exponent: Option<Fraction>,
}

/// Measured points, interpolated smoothly: `points`, or `strain` and `stress`.
///
/// Valid up to the last point; beyond it the case says what is assumed, and the run warns.
/// Source: monotone cubics of F. N. Fritsch, R. E. Carlson, SIAM J. Numer. Anal. 17 (1980) 238–246.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Table {
    /// Pairs of strain and stress, the first at strain 0: `[[0, "150 MPa"], [0.1, "290 MPa"]]`.
    pub points: Option<Vec<(NonNegative<Number>, Positive<Stress>)>>,
    /// Strains, when not given as `points`.
    pub strain: Option<Vec<NonNegative<Number>>>,
    /// Stresses, when not given as `points`.
    pub stress: Option<Vec<Positive<Stress>>>,
    /// What the law does beyond the last point: a choice that has to be made.
    #[schemars(example = &"slope")]
    pub extrapolation: Beyond,
}

/// Beyond the last point of a table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Beyond {
    /// Keeps the last stress.
    Hold,
    /// Goes on along the last two points.
    Slope,
}

/// Measured points at several temperatures, interpolated straight over the temperature.
///
/// Valid between the coldest and the hottest curve; beyond them these are held.
/// Source: each curve as `table`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Isotherms {
    /// At rising temperatures.
    pub curves: Vec<Isotherm>,
    /// What the curves do beyond their last point: a choice that has to be made.
    #[schemars(example = &"slope")]
    pub extrapolation: Beyond,
}

/// One curve.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Isotherm {
    #[schemars(example = "150 °C")]
    pub temperature: Positive<Temperature>,
    /// Pairs of strain and stress, the first at strain 0: `[[0, "90 MPa"], [0.1, "170 MPa"]]`.
    pub points: Vec<(NonNegative<Number>, Positive<Stress>)>,
}

/// σ = initial + k ε^n with other constants on each range of strain.
///
/// Valid where the branches were fitted; they must meet within 0.5 %.
/// Source: D. M. Woo, Int. J. Mech. Sci. 10 (1968) 83–94.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PiecewisePower {
    pub branches: Vec<Branch>,
}

/// One branch; it must meet the next one.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Branch {
    /// Strain where the branch ends; left out in the last one.
    #[schemars(example = 0.36)]
    pub up_to: Option<Positive<Number>>,
    #[schemars(example = "5.4 tonf_uk/in^2")]
    pub initial: Positive<Stress>,
    #[schemars(example = "27.8 tonf_uk/in^2")]
    pub k: NonNegative<Stress>,
    #[schemars(example = 0.504)]
    pub n: Fraction,
}
