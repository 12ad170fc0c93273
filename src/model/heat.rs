//! The sheet's temperature and what changes it.

use super::Role;
use crate::numerics::PiecewiseLinear;

/// The sheet's temperature and what changes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Heat {
    /// Initial temperature over the distance from the axis or symmetry plane \[K over mm\].
    pub initial: PiecewiseLinear,
    /// `None` where the temperature stays what it is.
    pub flow: Option<HeatFlow>,
}

/// What changes the temperature, which is the same through the thickness.
#[derive(Clone, Debug, PartialEq)]
pub struct HeatFlow {
    /// ρ c: density times specific heat \[MPa/K\].
    pub capacity: f64,
    /// β: share of the plastic work that becomes heat \[–\].
    pub plastic_share: f64,
    /// Conductivity along the sheet \[N/(s K), which is W/(m K)\]; 0 without.
    pub conductivity: f64,
    /// Tools that heat or cool what they touch.
    pub tools: Vec<ToolHeat>,
}

/// Heat transfer between a tool and the sheet where they touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolHeat {
    /// Which tool.
    pub role: Role,
    /// The tool's temperature, which stays \[K\].
    pub temperature: f64,
    /// Heat-transfer coefficient h \[N/(mm s K)\].
    pub transfer: f64,
}
