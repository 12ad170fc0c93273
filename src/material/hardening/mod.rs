//! Hardening laws: the yield stress σ_y(ε̄) of uniaxial tension over the equivalent plastic strain ε̄ ≥ 0.
//!
//! One law, one file, as [`law`](crate::material::law) says: a new one is a file and two lines here, `mod` and its line in the family.

mod flow_stress;
mod hockett_sherby;
mod hollomon;
mod isotherms;
mod ludwik;
mod mixed;
mod piecewise_power;
mod scaled;
mod swift;
mod table;
mod voce;

pub use crate::material::law::LawError;
pub use flow_stress::FlowStress;
pub use piecewise_power::Branch;
pub use table::Extrapolation;

use crate::material::law::prelude::*;
use flow_stress::{check_saturating, offset_power, power, saturating};
use table::few;

family! {
    /// Yield stress σ over equivalent plastic strain ε of uniaxial tension: exactly one law.
    pub enum Hardening: HardeningLaw, named in HardeningTable as "Hardening";
    /// σ_y and dσ_y/dε̄ at the equivalent plastic strain `strain` ≥ 0 \[–\] and a temperature \[K\].
    fn at_temperature(strain: f64, temperature: f64) -> FlowStress;
    [scaled: Scaled]
    swift: Swift,
    hollomon: Hollomon,
    ludwik: Ludwik,
    voce: Voce,
    table: Table,
    piecewise_power: PiecewisePower,
    isotherms: Isotherms,
    hockett_sherby: HockettSherby,
    mixed: Mixed,
}

impl Hardening {
    /// σ_y and dσ_y/dε̄ at the equivalent plastic strain `strain` ≥ 0 \[–\]; of the coldest curve where there are several.
    pub fn at(&self, strain: f64) -> FlowStress {
        self.at_temperature(strain, 0.0)
    }

    /// Largest strain the law was given for, where it says so (tables) \[–\].
    pub fn valid_up_to(&self) -> Option<f64> {
        match self {
            Self::Table(law) => Some(law.curve.last_strain()),
            Self::Isotherms(law) => Some(law.valid_up_to()),
            Self::Scaled(scaled) => scaled.law.valid_up_to(),
            _ => None,
        }
    }

    /// The coldest and the hottest temperature the law was given for, where it depends on it \[K\].
    pub fn temperatures(&self) -> Option<[f64; 2]> {
        match self {
            Self::Isotherms(law) => Some(law.temperatures()),
            Self::Scaled(scaled) => scaled.law.temperatures(),
            _ => None,
        }
    }
}
