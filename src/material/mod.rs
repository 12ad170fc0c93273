//! The sheet's material: hardening, rate, temperature, yield, back-stresses, voids, fracture, and the stress at a point.

pub mod chaboche;
mod elastic;
pub mod elastoplastic;
pub mod flow;
pub mod fracture;
pub mod gtn;
pub mod hardening;
mod hill48;
mod hosford;
pub mod law;
mod point_law;
mod r_values;
pub mod rate;
pub mod surroundings;
pub mod thermal;
mod yield_condition;
mod yield_criterion;

pub use chaboche::{BackStress, BackStresses};
pub use elastic::Elastic;
pub use fracture::Fracture;
pub use gtn::Gtn;
pub use hardening::{FlowStress, Hardening};
pub use hill48::Hill48;
pub use hosford::Hosford;
pub use point_law::PointLaw;
pub use r_values::RValues;
pub use rate::Rate;
pub use surroundings::Surroundings;
pub use thermal::ThermalLaw;
pub use yield_criterion::YieldCriterion;

use crate::numerics::bisect;
use flow::{FlowLaw, Iteration};

/// Strains among which the load maximum is searched \[–\], and halvings of the step there.
const STRAINS: (usize, f64) = (400, 0.01);
const HALVINGS: usize = 20;

/// The sheet's material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// σ_y(ε̄) of tension, slow and cold.
    pub hardening: Hardening,
    /// Largest strain of the measurements that a formula of hardening is fitted to, where it is known \[–\].
    pub fitted_up_to: Option<f64>,
    /// Elastic constants; `None` where the case gives none.
    pub elastic: Option<Elastic>,
    /// `None` for a rate-free metal.
    pub rate: Option<Rate>,
    /// `None` for a metal whose strength does not feel its temperature, or says so in its hardening law.
    pub thermal: Option<ThermalLaw>,
    /// The yield condition, with the normal anisotropy.
    pub yield_criterion: YieldCriterion,
    /// Back-stresses; the flow law has none.
    pub chaboche: BackStresses,
    /// `None` for a metal without voids.
    pub gtn: Option<Gtn>,
    /// `None` for a metal whose fracture is not judged.
    pub fracture: Option<Fracture>,
}

impl Material {
    /// The flow stress as a formula, the yield condition where it is not Huber-Mises', voids and fracture where there are any.
    pub fn describe(&self) -> String {
        let rate = self.rate.map(|rate| format!(" times {rate}"));
        let thermal = self.thermal.map(|thermal| format!(" times {thermal}"));
        let criterion = self.yield_criterion;
        let criterion = (criterion != YieldCriterion::default()).then(|| format!("; {criterion}"));
        let fracture = self.fracture.map(|fracture| format!("; fracture at {fracture}"));
        let others = [rate, thermal, criterion, self.gtn.map(|gtn| format!("; {gtn}")), fracture].into_iter().flatten();
        others.fold(self.hardening.to_string(), |text, more| text + &more)
    }

    /// An isotropic, rate-free sheet that does not feel its temperature.
    pub fn plain(hardening: Hardening) -> Self {
        let (fitted_up_to, elastic, rate, thermal, yield_criterion, chaboche, gtn, fracture) = Default::default();
        Self { hardening, fitted_up_to, elastic, rate, thermal, yield_criterion, chaboche, gtn, fracture }
    }

    /// Flow law of an iteration with `matrix`, in a step of `duration` \[s\] with the cut-off Δε₀ \[–\].
    pub fn flow_law(&self, matrix: Iteration, cutoff: f64, duration: f64) -> FlowLaw<'_> {
        let Self { hardening, rate, thermal, yield_criterion: criterion, gtn, .. } = self;
        let (rate, softening, voids) = (rate.as_ref(), thermal.as_ref(), gtn.as_ref());
        FlowLaw { hardening, rate, softening, criterion: *criterion, voids, matrix, cutoff, duration }
    }

    /// Largest strain that the hardening was measured to: of the fit, else of a table's last point \[–\].
    pub fn measured_up_to(&self) -> Option<f64> {
        self.fitted_up_to.or_else(|| self.hardening.valid_up_to())
    }

    /// Stress and slope of tension at a strain and a temperature \[K\], with back-stresses, without rate \[MPa\].
    pub fn monotonic(&self, strain: f64, temperature: f64) -> FlowStress {
        let left = self.hardening.at_temperature(strain, temperature);
        let shifts = self.chaboche.iter().map(|law| law.in_tension(strain));
        shifts.fold(left, |sum, shift| FlowStress { stress: sum.stress + shift.stress, slope: sum.slope + shift.slope })
    }

    /// Load maximum of a stretch whose equivalent strain is `ratio` times as large (A. Considère, 1885), at a temperature \[K\]: the
    /// equivalent strain ε̄ of the largest σ exp(−ε̄/ratio) \[–\], and that nominal stress, over `ratio` \[MPa\].
    pub fn load_maximum(&self, ratio: f64, temperature: f64) -> [f64; 2] {
        let at = |strain: f64| self.monotonic(strain, temperature);
        let nominal = |strain: f64| at(strain).stress * (-strain / ratio).exp();
        let (count, step) = STRAINS;
        let largest = (0..=count).map(|i| step * i as f64).max_by(|a, b| nominal(*a).total_cmp(&nominal(*b)));
        let coarse = largest.unwrap_or(0.0);
        let rises = |strain: f64| ratio * at(strain).slope > at(strain).stress;
        let [low, high] = bisect((coarse - step).max(0.0), coarse + step, HALVINGS, rises);
        let strain = 0.5 * (low + high);
        [strain, nominal(strain)]
    }

    /// Yield stress at a strain that came without reversal and a temperature \[K\], without the rate \[MPa\].
    pub fn yield_stress(&self, strain: f64, temperature: f64) -> f64 {
        let cold = self.monotonic(strain, temperature).stress;
        self.thermal.map_or(cold, |thermal| cold * thermal.at(temperature))
    }
}
