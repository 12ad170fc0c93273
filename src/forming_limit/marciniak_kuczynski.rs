//! A groove that thins before the sheet around it does.
//!
//! The sheet carries a groove of f₀ times its thickness, which thins faster. The limit is the strain of the sheet around it
//! when the groove strains [`MarciniakKuczynski::CRITICAL`] times as fast.
//!
//! On the left the groove lies as it hurts most; it turns with the sheet. f₀ stands for all that is uneven in a sheet and has
//! to be fitted to a measured point. With β > 0 the limit of a rate-free sheet is sensitive to f₀ and to the yield condition:
//! it is too high by Hill's with r̄ < 1 (for AA6016-T4 1.2 in equi-biaxial stretching). Hosford's corner brings it down.
//!
//! # References
//! Z. Marciniak, K. Kuczyński, Int. J. Mech. Sci. 9 (1967) 609–620; Z. Marciniak, K. Kuczyński, T. Pokora, Int. J. Mech. Sci.
//! 15 (1973) 789–805; J. W. Hutchinson, K. W. Neale, Sheet necking (1978) 127–153 (not read; derived beside this).

use super::{instability::Proportional, instability::ratios, instability::uniform_strain, *};
use crate::material::law::prelude::*;
use groove::Groove;
use std::ops::RangeInclusive;

mod groove;

/// Grooves that make sense \[–\]: nearer to 1 a step cannot tell them from none.
const GROOVES: RangeInclusive<f64> = 0.9..=0.9999;

parameters! {
    /// A groove of `imperfection` times the sheet's thickness takes over.
    ///
    /// Valid for straight strain paths; by Hill's condition with r̄ below 1 it ends in plane strain: beyond it is too high.
    /// Source: Z. Marciniak, K. Kuczyński, Int. J. Mech. Sci. 9 (1967) 609–620 (not read; derived in the program).
    pub struct MarciniakKuczynski {
        /// f₀, 0.9 to 0.9999: thickness of the groove over that around it; 0.995 when not given, an assumption.
        #[serde(default = "imperfection")]
        pub imperfection: "As::<Fraction>" = 0.995,
        /// Strain rate of the sheet \[1/s\]; 1 /s when not given, an assumption. A power law of the rate does not feel it.
        #[serde(default = "one")]
        pub strain_rate: "As::<Positive<StrainRate>>" = "1 /s",
    }
}

/// An assumption, of the size that fits cold-rolled sheet.
fn imperfection() -> f64 {
    0.995
}

/// A point of the curve, and the groove that made it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// Minor strain \[–\].
    pub minor: f64,
    /// Major strain \[–\].
    pub major: f64,
    /// Between the groove's normal and the major strain, at the start \[rad\].
    pub angle: f64,
}

impl MarciniakKuczynski {
    /// Strain rate of the groove over that of the sheet at which the sheet counts as necked \[–\], a usual convention.
    pub const CRITICAL: f64 = 10.0;
    /// Largest equivalent strain that is searched \[–\].
    pub const LARGEST: f64 = 4.0;
    /// First step over the uniform strain \[–\], at most [`Self::STEP`], halved until two answers agree.
    const SHARE: f64 = 0.02;
    const STEP: f64 = 4e-3;
    const HALVINGS: i32 = 7;
    const AGREEMENT: f64 = 2e-3;
    /// Steepest groove that is tried \[rad\], and how many.
    const STEEPEST: f64 = 1.05;
    const ANGLES: usize = 12;

    /// Checks what was read. Fails when the groove is none that makes sense.
    pub fn check(&self) -> Result<(), LawError> {
        let help = "it is the groove's thickness over the sheet's: 0.98 to 0.999 is usual";
        require_or("imperfection", GROOVES.contains(&self.imperfection), help, || {
            let (least, most) = (GROOVES.start(), GROOVES.end());
            format!("`imperfection` must lie between {least} and {most}, found {}", self.imperfection)
        })
    }

    pub(super) fn curve(&self, sheet: &Sheet) -> Result<Curve, LawError> {
        let limits = ratios(sheet.material.yield_criterion, 8, 10).map(|beta| self.limit(sheet, beta));
        let points = limits.collect::<Result<Vec<_>, _>>()?.iter().map(|limit| [limit.minor, limit.major]).collect();
        let rate = sheet.material.rate.map(|_| format!(" at a strain rate of {} 1/s", Amount::norm(self.strain_rate)));
        let note = format!(
            "Forming limit: Marciniak and Kuczyński with f₀ = {groove} (an assumption unless it was fitted), by the hardening \
             law of the sheet{}; necked where the groove strains {times} times as fast.",
            rate.unwrap_or_default(),
            groove = Amount::number(self.imperfection).to(Digits::Given(6)),
            times = Amount::number(Self::CRITICAL)
        );
        Ok(Curve::new("Marciniak-Kuczyński", points, vec![note])?.computed(sheet))
    }

    /// Limit of a strain ratio β. Fails when no groove necks below [`Self::LARGEST`], or the integration does not settle.
    pub fn limit(&self, sheet: &Sheet, beta: f64) -> Result<Limit, LawError> {
        let angle = if beta < 0.0 { self.worst_angle(sheet, beta)? } else { 0.0 };
        let path = Proportional::new(sheet.material.yield_criterion, beta);
        let mut before = f64::NAN;
        for step in (0..=Self::HALVINGS).map(|i| Self::first_step(sheet) * 0.5_f64.powi(i)) {
            let Some(strain) = Groove::new(*self, sheet, beta, angle).neck(step)? else {
                let most = Self::LARGEST;
                let what = format!("no groove necks below an equivalent strain of {most}, at strain ratio {beta:.3}");
                let help = "use points, or an imperfection further from 1: a sheet like this hardly necks";
                return Err(LawError::new(what, help));
            };
            if (strain - before).abs() < Self::AGREEMENT * strain {
                return Ok(Limit { minor: path.strain[1] * strain, major: path.strain[0] * strain, angle });
            }
            before = strain;
        }
        let what = format!("the groove's limit does not settle as its step is halved, at strain ratio {beta:.3}");
        Err(LawError::new(what, "use hill, or an imperfection further from 1"))
    }

    /// A sheet that hardly hardens necks at small strains: its steps go by its uniform strain.
    fn first_step(sheet: &Sheet) -> f64 {
        uniform_strain(sheet).map_or(Self::STEP, |strain| Self::STEP.min(Self::SHARE * strain))
    }

    fn worst_angle(&self, sheet: &Sheet, beta: f64) -> Result<f64, LawError> {
        let step = Self::first_step(sheet);
        let at = |angle: f64| {
            Ok::<f64, LawError>(Groove::new(*self, sheet, beta, angle).neck(step)?.unwrap_or(f64::INFINITY))
        };
        let apart = Self::STEEPEST / Self::ANGLES as f64;
        let mut best = (f64::INFINITY, 0.0);
        for angle in (0..=Self::ANGLES).map(|i| apart * i as f64) {
            let strain = at(angle)?;
            best = if strain < best.0 { (strain, angle) } else { best };
        }
        let (mut low, mut high) = ((best.1 - apart).max(0.0), best.1 + apart);
        // Thirds of the bracket: the limit is flat about its least, a degree of the angle is less than 0.1 % of it.
        while high - low > 0.02 {
            let third = (high - low) / 3.0;
            if at(low + third)? < at(high - third)? { high -= third } else { low += third }
        }
        Ok(0.5 * (low + high))
    }
}
