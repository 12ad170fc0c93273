//! What a sample says: how each number scatters and what it hangs on, how likely each light is, and bands of the curves.

use super::base::{Base, Known};
use super::estimate::{Estimate, Tries, probability};
use super::indices::{Index, indices, rank_correlation};
use super::plan::Scatter;
use super::sample::Sample;
use super::sampling::{Part, REPLICATES};
use crate::assess::Light;
use std::collections::BTreeMap;

/// Shares of parts below the quantiles that are told.
pub const QUANTILES: [f64; 3] = [0.05, 0.5, 0.95];

/// Rows of the verdict by any of which the sheet tears.
const TEARING: [&str; 4] = ["localisation", "thinning", "forming_limit", "bottom_tearing"];

/// What a sample says.
#[derive(Clone, Debug)]
pub struct Found {
    /// Names of what scatters, by columns.
    pub factors: Vec<String>,
    /// Names of its groups.
    pub groups: Vec<String>,
    /// Runs that statistics are of: points, and their partners where there are any.
    pub runs: usize,
    /// Of these, runs that say nothing of the part.
    pub failed: usize,
    /// Of all runs, why some say nothing, and how many.
    pub failures: BTreeMap<String, usize>,
    /// Every number of the case.
    pub numbers: Vec<Spread>,
    /// The lights: of all together, of tearing, of each row that is red or amber in some run.
    pub events: Vec<Event>,
    /// Punch force over the travel.
    pub load: Option<Band>,
    /// Thickness over the initial distance from the axis.
    pub thickness: Option<Band>,
}

/// How a number scatters.
#[derive(Clone, Debug)]
pub struct Spread {
    /// Its column.
    pub header: String,
    /// What it is.
    pub number: Known,
    /// Its values, of the runs that statistics are of; rising.
    pub values: Vec<f64>,
    /// What it hangs on.
    pub influence: Influence,
}

/// What something hangs on.
#[derive(Clone, Debug, Default)]
pub struct Influence {
    /// Spearman's rank correlation with each factor; `None` where there is none.
    pub ranks: Vec<Option<f64>>,
    /// Sobol indices of each group, where they were asked for.
    pub indices: Option<Vec<Index>>,
}

/// What is an event.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum What {
    /// The verdict.
    Verdict,
    /// Any row by which the sheet tears.
    Tear,
    /// A row of the verdict, by its place in [`Sample::keys`].
    Row(usize),
}

/// A light, and how likely it is.
#[derive(Clone, Debug)]
pub struct Event {
    /// What has it.
    pub what: What,
    /// Name in files.
    pub key: String,
    /// Name in tables.
    pub label: &'static str,
    /// Red or amber.
    pub light: Light,
    /// Runs that have it.
    pub hits: u64,
    /// How likely it is \[–\].
    pub chance: Estimate,
    /// What it hangs on: where its number alone decides it, what that hangs on.
    pub influence: Influence,
}

/// Quantiles across the curves of a sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// Where \[mm\].
    pub x: Vec<f64>,
    /// By [`QUANTILES`], each as long.
    pub quantiles: [Vec<f64>; 3],
    /// Runs that come there.
    pub runs: Vec<usize>,
}

impl Spread {
    /// By [`QUANTILES`]; `None` where no run has it.
    pub fn quantiles(&self) -> Option<[f64; 3]> {
        (!self.values.is_empty()).then(|| QUANTILES.map(|share| quantile(&self.values, share)))
    }

    /// Mean and standard deviation.
    pub fn moments(&self) -> (f64, f64) {
        let count = self.values.len() as f64;
        let mean = self.values.iter().sum::<f64>() / count;
        (mean, (self.values.iter().map(|value| (value - mean).powi(2)).sum::<f64>() / (count - 1.0)).sqrt())
    }
}

/// The quantile of rising values, between the two that stand about it (Hazen's rule).
fn quantile(values: &[f64], share: f64) -> f64 {
    let place = (share * values.len() as f64 - 0.5).clamp(0.0, values.len() as f64 - 1.0);
    let (below, part) = (place.floor() as usize, place.fract());
    values[below] + part * (values[(below + 1).min(values.len() - 1)] - values[below])
}

impl Found {
    /// What the sample of a scatter says.
    pub fn of(scatter: &Scatter, base: &Base, sample: &Sample) -> Self {
        let reader = Reader { scatter, sample, is_drawn: drawn(scatter, sample.rows()) };
        let numbers: Vec<Spread> = base
            .numbers
            .iter()
            .zip(&base.columns.numbers)
            .zip(&sample.numbers)
            .map(|((number, header), values)| Spread {
                header: header.clone(),
                number: number.clone(),
                values: reader.rising(values),
                influence: reader.influence(values),
            })
            .collect();
        let [load, thickness] = &sample.curves;
        Self {
            factors: scatter.factors().iter().map(|factor| factor.key.clone()).collect(),
            groups: scatter.groups(),
            runs: reader.is_drawn.iter().filter(|is| **is).count(),
            failed: reader.drawn().filter(|&i| sample.verdict[i].is_none()).count(),
            failures: sample.failures.clone(),
            events: reader.events(base, &numbers),
            load: reader.band(&base.grids.load, load),
            thickness: reader.band(&base.grids.thickness, thickness),
            numbers,
        }
    }
}

/// Rows that are drawn by chance: points and partners, not what lies between them.
fn drawn(scatter: &Scatter, rows: usize) -> Vec<bool> {
    let is_drawn = |row: usize| !matches!(scatter.sampling().place(row as u64).part, Part::Mixed(_));
    (0..rows).map(is_drawn).collect()
}

struct Reader<'a> {
    scatter: &'a Scatter,
    sample: &'a Sample,
    is_drawn: Vec<bool>,
}

impl Reader<'_> {
    fn drawn(&self) -> impl Iterator<Item = usize> {
        (0..self.is_drawn.len()).filter(|&i| self.is_drawn[i])
    }

    fn rising(&self, values: &[f64]) -> Vec<f64> {
        let mut own: Vec<f64> = self.drawn().map(|i| values[i]).filter(|value| value.is_finite()).collect();
        own.sort_by(f64::total_cmp);
        own
    }

    fn influence(&self, values: &[f64]) -> Influence {
        let of_drawn = |all: &[f64]| self.drawn().map(|i| all[i]).collect::<Vec<f64>>();
        let own = of_drawn(values);
        let ranks = self.sample.factors.iter().map(|factor| rank_correlation(&of_drawn(factor), &own)).collect();
        Influence { ranks, indices: indices(self.scatter.sampling(), values) }
    }

    fn events(&self, base: &Base, numbers: &[Spread]) -> Vec<Event> {
        let verdict = |light: Light| self.sample.verdict.iter().map(|own| own.map(|own| own == light)).collect();
        let tears = self.sample.has(Light::Red, &TEARING);
        let mut all = vec![
            self.event(What::Tear, "tear", "Tears", Light::Red, tears),
            self.event(What::Verdict, "verdict", "All together", Light::Red, verdict(Light::Red)),
            self.event(What::Verdict, "verdict", "All together", Light::Amber, verdict(Light::Amber)),
        ];
        for (key, label) in &base.rows {
            let Some(place) = self.sample.keys.iter().position(|known| known == key) else { continue };
            let number = numbers.iter().position(|spread| spread.number.row == Some(key));
            for light in [Light::Red, Light::Amber] {
                let has = self.sample.has(light, &[key]);
                let number = number.filter(|number| self.is_by(*number, light, key, &has));
                let mut event = self.event(What::Row(place), key, label, light, has);
                if let (Some(event), Some(number)) = (&mut event, number) {
                    event.influence = numbers[number].influence.clone();
                }
                all.push(event.filter(|event| event.hits > 0));
            }
        }
        let mut all: Vec<Event> = all.into_iter().flatten().collect();
        self.by_rows(&mut all);
        all
    }

    /// Whether a row has a light by its number: there is a value that parts the runs that have it from those that have not. A
    /// row that is amber for another reason as well, a sharp bend beside a forming limit, hangs on other things than its
    /// number does. Red is beyond amber, and counts for neither.
    fn is_by(&self, number: usize, light: Light, key: &str, has: &[Option<bool>]) -> bool {
        let red = self.sample.has(Light::Red, &[key]);
        let values = &self.sample.numbers[number];
        let counts = |i: &usize| values[*i].is_finite() && (light == Light::Red || red[*i] != Some(true));
        are_parted(self.drawn().filter(counts).filter_map(|i| Some((values[i], has[i]?))))
    }

    /// A light of several rows hangs on what its most frequent row hangs on, where only ranks are known: those of yes and no
    /// say little.
    fn by_rows(&self, all: &mut [Event]) {
        if self.scatter.sampling().has_partners() {
            return;
        }
        for i in 0..all.len() {
            let is_own = |row: &&Event| {
                matches!(row.what, What::Row(_))
                    && row.light == all[i].light
                    && (all[i].what != What::Tear || TEARING.contains(&row.key.as_str()))
            };
            let own = all.iter().filter(is_own).max_by_key(|row| row.hits).map(|row| row.influence.clone());
            if let (Some(own), What::Tear | What::Verdict) = (own, all[i].what) {
                all[i].influence = own;
            }
        }
    }

    fn event(&self, what: What, key: &str, label: &'static str, light: Light, has: Vec<Option<bool>>) -> Option<Event> {
        let mut tries: [Tries; REPLICATES] = Default::default();
        for i in self.drawn() {
            let Some(has) = has[i] else { continue };
            let own = &mut tries[self.scatter.sampling().place(i as u64).replicate];
            *own = (own.0 + u64::from(has), own.1 + 1);
        }
        let values: Vec<f64> = has.iter().map(|has| has.map_or(f64::NAN, |has| f64::from(u8::from(has)))).collect();
        Some(Event {
            what,
            key: key.to_owned(),
            label,
            light,
            hits: tries.iter().map(|own| own.0).sum(),
            chance: probability(&tries)?,
            influence: self.influence(&values),
        })
    }

    /// As far as half of the runs come.
    fn band(&self, x: &[f64], curves: &[Box<[f32]>]) -> Option<Band> {
        let mut band = Band { x: Vec::new(), quantiles: Default::default(), runs: Vec::new() };
        let whole = self.drawn().filter(|&i| !curves[i].is_empty()).count();
        for (k, x) in x.iter().enumerate() {
            let mut own: Vec<f64> =
                self.drawn().filter_map(|i| curves[i].get(k)).map(|value| f64::from(*value)).collect();
            if own.is_empty() || 2 * own.len() < whole {
                break;
            }
            own.sort_by(f64::total_cmp);
            band.x.push(*x);
            band.runs.push(own.len());
            band.quantiles.iter_mut().zip(QUANTILES).for_each(|(side, share)| side.push(quantile(&own, share)));
        }
        (band.x.len() > 1).then_some(band)
    }
}

/// Whether a value parts those that have something from those that have not.
fn are_parted(all: impl Iterator<Item = (f64, bool)>) -> bool {
    let mut ends = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
    for (value, has) in all {
        let [low, high] = &mut ends[usize::from(has)];
        (*low, *high) = (low.min(value), high.max(value));
    }
    ends[0][1] <= ends[1][0] || ends[1][1] <= ends[0][0]
}

#[cfg(test)]
mod tests {
    use super::are_parted;

    /// Trust: by hand.
    #[test]
    fn a_light_is_by_its_number_where_a_value_parts_those_that_have_it() {
        let parted = |has: [bool; 4]| are_parted([0.7, 0.9, 0.6, 0.8].into_iter().zip(has));
        assert!(parted([false, true, false, true]) && parted([true, false, true, false]));
        assert!(!parted([true, true, false, false]), "0.8 has it not, between 0.7 and 0.9 which have");
    }
}
