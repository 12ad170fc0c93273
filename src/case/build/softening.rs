//! `[material.softening]`: exactly one law of the temperature.

use crate::case::file;
use crate::case::{CaseError, source::Source};
use crate::material::ThermalLaw;
use crate::material::thermal::{Arrhenius, Exponential, Melting};
use crate::units::Quantity;

/// R \[N mm/(mol K)\].
const GAS_CONSTANT: f64 = 8_314.462_618;

pub(super) fn convert(file: file::Softening, source: &Source) -> Result<ThermalLaw, CaseError> {
    let johnson_cook = file.johnson_cook.map(|l| {
        let (reference, melting) = (l.reference.value(), l.melting.value());
        ThermalLaw::JohnsonCook(Melting { reference, melting, exponent: l.exponent.value() })
    });
    if let Some(ThermalLaw::JohnsonCook(law)) = johnson_cook
        && law.melting <= law.reference
    {
        let what =
            format!("johnson_cook: melting at {} K is not above the reference of {} K", law.melting, law.reference);
        return Err(source.error("material.softening.johnson_cook.melting", what, "600 °C or so for aluminium"));
    }
    let exponential = file.exponential.map(|l| {
        ThermalLaw::Exponential(Exponential { coefficient: l.coefficient.value(), reference: l.reference.value() })
    });
    let arrhenius = file.arrhenius.map(|l| {
        let over_gas_constant = l.activation.value() / GAS_CONSTANT;
        ThermalLaw::Arrhenius(Arrhenius {
            over_gas_constant,
            exponent: l.exponent.value(),
            reference: l.reference.value(),
        })
    });
    let names = "johnson_cook, exponential, arrhenius";
    super::only_one([johnson_cook, exponential, arrhenius], "material.softening", names, source)
}
