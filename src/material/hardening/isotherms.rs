//! Hardening curves measured at several temperatures.

use super::{FlowStress, LawError, Table, require};
use crate::units::{ZERO_CELSIUS, rounded};

/// σ_y(ε̄, T): one [`Table`] per temperature, in between interpolated straight over the temperature, held beyond the
/// coldest and the hottest.
#[derive(Clone, Debug, PartialEq)]
pub struct Isotherms {
    /// T \[K\], rising.
    temperature: Vec<f64>,
    curves: Vec<Table>,
}

impl Isotherms {
    /// Curves at rising temperatures \[K\].
    ///
    /// # Errors
    /// When there are fewer than two, or the temperatures do not rise.
    pub fn new(temperature: Vec<f64>, curves: Vec<Table>) -> Result<Self, LawError> {
        require("", curves.len() == temperature.len() && curves.len() >= 2, || {
            format!("needs curves at two temperatures or more, found {}", curves.len())
        })?;
        for i in 1..temperature.len() {
            require(&format!("curves.{i}.temperature"), temperature[i] > temperature[i - 1], || {
                format!("curve {}: its temperature does not rise above that of the one before", i + 1)
            })?;
        }
        Ok(Self { temperature, curves })
    }

    /// The coldest and the hottest temperature \[K\].
    pub fn range(&self) -> [f64; 2] {
        [self.temperature[0], self.temperature[self.temperature.len() - 1]]
    }

    pub(super) fn last_strain(&self) -> f64 {
        self.curves.iter().map(Table::last_strain).fold(f64::INFINITY, f64::min)
    }

    /// The coldest curve.
    #[inline(never)]
    pub(super) fn at(&self, strain: f64) -> FlowStress {
        self.curves[0].at(strain)
    }

    #[inline(never)] // the other laws stay small where they are called
    pub(super) fn at_temperature(&self, strain: f64, temperature: f64) -> FlowStress {
        let after = self.temperature.partition_point(|&t| t < temperature);
        if after == 0 || after == self.temperature.len() {
            return self.curves[after.min(self.curves.len() - 1)].at(strain);
        }
        let (cold, hot) = (self.curves[after - 1].at(strain), self.curves[after].at(strain));
        let [t0, t1] = [self.temperature[after - 1], self.temperature[after]];
        let x = (temperature - t0) / (t1 - t0);
        FlowStress {
            stress: cold.stress + x * (hot.stress - cold.stress),
            slope: cold.slope + x * (hot.slope - cold.slope),
        }
    }

    pub(super) fn describe(&self) -> String {
        let [cold, hot] = self.range().map(|t| rounded(t - ZERO_CELSIUS));
        format!(
            "{} hardening curves from {cold} to {hot} °C, the coldest a {}",
            self.curves.len(),
            self.curves[0].describe()
        )
    }
}
