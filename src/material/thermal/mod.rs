//! Softening by heat: a factor h(T) with σ_y = σ_s(ε̄) g(ε̄̇) h(T). One law, one file: [`law`](crate::material::law).

mod arrhenius;
mod exponential;
mod johnson_cook;

use crate::material::law::prelude::*;

family! {
    /// A factor on the hardening law: exactly one. A table of curves by temperature is `[material.hardening.isotherms]`.
    #[derive(Copy)]
    pub enum ThermalLaw: TemperatureLaw, named in ThermalTable as "ThermalLaw";
    /// h at a temperature \[K\].
    fn at(temperature: f64) -> f64;
    johnson_cook: Melting,
    exponential: Exponential,
    arrhenius: Arrhenius,
}

/// A temperature \[K\] in °C, for captions.
fn celsius(kelvin: f64) -> f64 {
    rounded(kelvin - ZERO_CELSIUS)
}
