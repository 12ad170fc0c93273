//! Temperature and heat transfer of the sheet.

use super::Role;
use crate::numerics::PiecewiseLinear;

/// Initial temperature and heat transfer.
#[derive(Clone, Debug, PartialEq)]
pub struct Heat {
    /// Initial temperature over the distance from the axis or symmetry plane \[K over mm\].
    pub initial: PiecewiseLinear,
    /// Heat transfer; `None` at constant temperature.
    pub flow: Option<HeatFlow>,
}

/// Heat transfer of the sheet, at uniform temperature through the thickness.
#[derive(Clone, Debug, PartialEq)]
pub struct HeatFlow {
    /// Density times specific heat, ρ c \[MPa/K\].
    pub capacity: f64,
    /// Share β of the plastic work that becomes heat \[–\].
    pub plastic_share: f64,
    /// Conductivity along the sheet \[N/(s K), which is W/(m K)\]; 0 without.
    pub conductivity: f64,
    /// Tools that heat or cool what they touch.
    pub tools: Vec<ToolHeat>,
}

/// Heat transfer between a tool and the sheet where they touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ToolHeat {
    /// Role of the tool.
    pub role: Role,
    /// Constant temperature of the tool \[K\].
    pub temperature: f64,
    /// Heat-transfer coefficient h \[N/(mm s K)\].
    pub transfer: f64,
}
