//! Forming limits: the major strain at which a sheet necks, over the minor strain, and what a run makes of it.
//!
//! Strains are logarithmic, of the mid-surface: over a sharp radius the outer face is strained more.
//!
//! ```text
//! ε₁ ≥ ε₂   principal strains in the plane of the sheet: meridional and hoop, whichever is larger first
//! β = ε₂/ε₁   −r̄/(1 + r̄) in tension, 0 in plane strain, 1 in equi-biaxial stretching
//! ```
//!
//! One curve, one file; a new one is a file here and a line in [`Kind`].

mod assess;
mod instability;
mod keeler_brazier;
mod marciniak_kuczynski;
mod paths;
mod points;
mod usual;

pub use assess::{Assessment, CROOKED, Judged, Onset, SHORTEST, assess};
pub use instability::{Hill, Swift, uniform_strain};
pub use keeler_brazier::KeelerBrazier;
pub use marciniak_kuczynski::{Limit, MarciniakKuczynski};
pub use paths::{Instant, Paths};
pub use points::{Points, Strain};

use crate::material::{Material, YieldCriterion, law::LawError};
use crate::units::{Amount, Digits};

/// The sheet that a curve is for.
#[derive(Clone, Copy, Debug)]
pub struct Sheet<'a> {
    /// Its material.
    pub material: &'a Material,
    /// Initial thickness \[mm\].
    pub thickness: f64,
    /// Temperature that curves are computed at \[K\].
    pub temperature: f64,
}

impl Sheet<'_> {
    /// Yield stress \[MPa\] and its slope \[MPa\] at an equivalent strain on a straight path, without the rate.
    fn hardening(&self, strain: f64) -> crate::material::FlowStress {
        self.material.monotonic(strain, self.temperature)
    }
}

/// Whether limits of biaxial stretching come out too high: Hill 1948 with r̄ below 1 yields in equi-biaxial tension at
/// √((1 + r̄)/2) of the yield stress, where aluminium is as strong or stronger, on a curve that is far too blunt.
///
/// # References
/// That aluminium is stronger: J. Woodthorpe, R. Pearce, Int. J. Mech. Sci. 12 (1970) 341–347. That the limit follows the
/// bluntness of the curve: Graf, Hosford, Metall. Trans. A 21 (1990) 87; Lian, Barlat, Baudelet (1989) (all not read).
fn overrates_biaxial(criterion: YieldCriterion) -> bool {
    matches!(criterion, YieldCriterion::Hill48(hill) if hill.ratio < 1.0)
}

/// Origin of a curve.
#[derive(Clone, Debug, PartialEq)]
pub enum Kind {
    /// Measured.
    Points(Points),
    /// Empirical, of steels.
    KeelerBrazier(KeelerBrazier),
    /// Localised necking.
    Hill(Hill),
    /// Diffuse necking.
    Swift(Swift),
    /// A groove that takes over.
    MarciniakKuczynski(MarciniakKuczynski),
}

impl Kind {
    /// The curve of a sheet. Fails when the kind does not hold for the sheet, or its equations have no solution.
    pub fn curve(&self, sheet: &Sheet) -> Result<Curve, LawError> {
        match self {
            Self::Points(kind) => kind.curve(),
            Self::KeelerBrazier(kind) => kind.curve(sheet),
            Self::Hill(kind) => kind.curve(sheet),
            Self::Swift(kind) => kind.curve(sheet),
            Self::MarciniakKuczynski(kind) => kind.curve(sheet),
        }
    }
}

/// A forming limit curve, straight between its points, left of them at constant thickness strain and right of them level.
///
/// One that [ends](Curve::ends_at) is not known to the right: there a sheet surely bears the level of its last point.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// Whether nothing is known to the right of its last point.
    ends: bool,
    /// Minor and major logarithmic strain \[–\], the minor rising.
    pub points: Vec<[f64; 2]>,
    /// True if the program chose it, because the case gives none.
    pub is_usual: bool,
    /// Name.
    pub name: &'static str,
    /// Origin of its numbers and assumptions, in sentences.
    pub notes: Vec<String>,
}

impl Curve {
    fn new(name: &'static str, points: Vec<[f64; 2]>, notes: Vec<String>) -> Result<Self, LawError> {
        if points.len() < 2 {
            let what = format!("a curve has two points at least, found {}", points.len());
            return Err(LawError::new(what, "give more points"));
        }
        if let Some(i) = points.windows(2).position(|w| w[1][0] <= w[0][0]) {
            let (before, after) = (points[i][0], points[i + 1][0]);
            let what = format!("the minor strain must rise from point to point, but {after:.4} follows {before:.4}");
            return Err(LawError::new(what, "write the points from left to right"));
        }
        Ok(Self { ends: false, points, is_usual: false, name, notes })
    }

    fn computed(mut self, sheet: &Sheet) -> Self {
        let criterion = sheet.material.yield_criterion;
        self.ends = overrates_biaxial(criterion);
        if self.ends {
            let r = Amount::number(criterion.ratio());
            self.notes.push(format!(
                "The limit ends in plane strain: by Hill 1948 with r̄ = {r}, below 1, limits of biaxial stretching come out too high."
            ));
        }
        self
    }

    /// Minor strain beyond which its computation is known to be wrong, if there is one \[–\].
    pub fn ends_at(&self) -> Option<f64> {
        self.ends.then(|| self.points[self.points.len() - 1][0])
    }

    /// Whether the limit is known at a minor strain \[–\].
    pub fn knows(&self, minor: f64) -> bool {
        self.ends_at().is_none_or(|end| minor <= end)
    }

    /// The major strain at which the sheet necks, at a minor strain; beyond the curve's end what it surely bears \[–\].
    pub fn major_at(&self, minor: f64) -> f64 {
        let [first, last] = [self.points[0], self.points[self.points.len() - 1]];
        if minor <= first[0] {
            return first[1] + (first[0] - minor);
        }
        let Some(i) = self.points.iter().position(|p| p[0] >= minor) else { return last[1] };
        let [a, b] = [self.points[i - 1], self.points[i]];
        a[1] + (b[1] - a[1]) * (minor - a[0]) / (b[0] - a[0])
    }

    /// The major strain at plane strain, FLC₀ \[–\].
    pub fn plane_strain(&self) -> f64 {
        self.major_at(0.0)
    }
}
