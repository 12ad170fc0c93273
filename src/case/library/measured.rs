//! Measured points that a sheet's laws are fitted to, tests at other rates, and the misfit of the laws.

use crate::material::Material;
use crate::units::{Dimensioned, Number, StrainRate, Stress};
use serde::Deserialize;

/// Points that were measured.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Measured {
    /// Test, number of specimens and meaning of the scatter.
    pub of: String,
    rate: StrainRate,
    points: Vec<(Number, Stress, Stress)>,
    /// Tests at several rates, where there are some.
    pub rates: Option<Rates>,
}

/// Tests at several rates, of which ratios are used.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Rates {
    /// Test and its source.
    pub of: String,
    tests: Vec<RateTest>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct RateTest {
    rate: StrainRate,
    /// At strains that are the same in all tests, the smallest first; a test may end before the others.
    stress: Vec<Stress>,
}

/// A point of a tension test.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Equivalent plastic strain \[–\].
    pub strain: f64,
    /// True stress, mean of the specimens \[MPa\].
    pub stress: f64,
    /// Scatter of the specimens to either side \[MPa\].
    pub scatter: f64,
}

/// Misfit of a law to its points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// Points.
    pub points: usize,
    /// Root of the mean square of law less point, \[MPa\] of stresses.
    pub rms: f64,
    /// The largest in magnitude of law less point.
    pub largest: f64,
    /// Strain, or rate \[1/s\], where it is.
    pub at: f64,
    /// Smallest and largest strain, or rate \[1/s\], of the points.
    pub range: [f64; 2],
}

impl Fit {
    /// Misfit of places, each with law less point.
    fn of(misses: &[(f64, f64)]) -> Option<Self> {
        let &(at, largest) = misses.iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
        let square = misses.iter().map(|(_, miss)| miss * miss).sum::<f64>() / misses.len() as f64;
        let places = || misses.iter().map(|(place, _)| *place);
        let range = [places().fold(f64::INFINITY, f64::min), places().fold(f64::NEG_INFINITY, f64::max)];
        Some(Self { points: misses.len(), rms: square.sqrt(), largest, at, range })
    }
}

impl Measured {
    /// Strain rate of the points \[1/s\].
    pub fn rate(&self) -> f64 {
        self.rate.value()
    }

    /// The points, by rising strain.
    pub fn points(&self) -> impl Iterator<Item = Point> {
        self.points.iter().map(|(strain, stress, scatter)| Point {
            strain: strain.value(),
            stress: stress.value(),
            scatter: scatter.value(),
        })
    }

    /// Strain of every point, and the hardening law at the points' rate less the point \[MPa\].
    pub fn misses(&self, material: &Material) -> Vec<(f64, f64)> {
        let factor = rate_factor(material, self.rate());
        let miss = |point: Point| (point.strain, factor * material.hardening.at(point.strain).stress - point.stress);
        self.points().map(miss).collect()
    }

    /// Misfit of the hardening law.
    pub fn fit(&self, material: &Material) -> Option<Fit> {
        Fit::of(&self.misses(material))
    }

    /// Misfit of the rate law's ratios to those of the tests.
    pub fn rate_fit(&self, material: &Material) -> Option<Fit> {
        let rates = self.rates.as_ref()?;
        let miss = |(rate, ratio): (f64, f64)| (rate, rates.law(material, rate) - ratio);
        Fit::of(&rates.ratios().into_iter().map(miss).collect::<Vec<_>>())
    }
}

impl Rates {
    /// The rates of the tests \[1/s\], the one that all are held against first.
    pub fn rates(&self) -> impl Iterator<Item = f64> {
        self.tests.iter().map(|test| test.rate.value())
    }

    /// Rates \[1/s\] of all tests but the first, each with its stress over the first test's at the same strain \[–\].
    pub fn ratios(&self) -> Vec<(f64, f64)> {
        let Some((first, others)) = self.tests.split_first() else { return Vec::new() };
        let of = |test: &RateTest| {
            let pairs = test.stress.iter().zip(&first.stress);
            let rate = test.rate.value();
            pairs.map(|(stress, slow)| (rate, stress.value() / slow.value())).collect::<Vec<_>>()
        };
        others.iter().flat_map(of).collect()
    }

    /// Ratio by the sheet's rate law at any rate \[1/s\].
    pub fn law(&self, material: &Material, rate: f64) -> f64 {
        let first = self.rates().next().unwrap_or(rate);
        rate_factor(material, rate) / rate_factor(material, first)
    }
}

/// The factor of the rate on the yield stress \[–\].
fn rate_factor(material: &Material, rate: f64) -> f64 {
    material.rate.map_or(1.0, |law| law.at(rate).value)
}
