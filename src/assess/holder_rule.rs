//! Force of the holder as a blank grows, for searches.

use super::estimate::{flange_strength, held_from};
use super::*;
use crate::rules::holder_pressure;
use std::f64::consts::PI;

/// Holder force of a blank by the rules of [`holder_pressure`] without the usual one, which may be twice as much.
#[derive(Clone, Copy, Debug)]
pub struct HolderRule {
    /// Radius of the punch's mouth, and inner edge of the flat between holder and die \[mm\].
    punch: f64,
    end: f64,
    thickness: f64,
    /// \[MPa\]
    strength: f64,
    /// Whether the case gives the holder a pressure.
    by_pressure: bool,
}

impl HolderRule {
    /// `None` without a pressed holder, and where the command line gives its force.
    pub fn new(case: &Case, punch: f64) -> Option<Self> {
        let model = case.model();
        let is_given = case.overrides.iter().any(|key| key.starts_with("tools.holder.") && !key.contains("friction"));
        let holder = model.tool(Role::Holder).filter(|holder| matches!(holder.motion, Motion::Pressed(_)))?;
        let end = held_from(model)?.max(extent(holder).0);
        let (thickness, strength) = (model.blank.thickness, flange_strength(model));
        let by_pressure = !case.written("tools.holder.pressure").is_empty();
        (!is_given).then_some(Self { punch, end, thickness, strength, by_pressure })
    }

    fn pressure(&self, blank: f64) -> f64 {
        let flat = [self.end, blank];
        holder_pressure(0.0, blank / self.punch, 2.0 * self.punch, flat, self.thickness, self.strength).value
    }

    /// Force on a blank of this radius \[mm\] at its start \[N\].
    pub fn force(&self, blank: f64) -> f64 {
        PI * (blank * blank - self.end * self.end) * self.pressure(blank)
    }

    /// Override of the case for a blank of this radius \[mm\].
    pub fn setting(&self, blank: f64) -> String {
        match self.by_pressure {
            true => format!("tools.holder.pressure={:.5} MPa", self.pressure(blank)),
            false => format!("tools.holder.force={:.0} N", self.force(blank).ceil()),
        }
    }
}
