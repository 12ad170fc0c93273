//! What a study found, in sentences.

use super::plan::How;
use super::results::{Found, Results};
use super::swing::swings;
use super::varied::Varied;
use super::window::{Distance, Meets, Window, windows};
use super::zone::Zone;
use crate::assess::Light;
use crate::units::{Amount, joined};

/// What a study found.
#[derive(Clone, Debug, PartialEq)]
pub struct Said {
    /// How many designs there are.
    pub designs: usize,
    /// How many of them are sound, and how many of these are amber.
    pub sound: usize,
    /// See `sound`.
    pub amber: usize,
    /// How many fail, each by the way that is asked for first.
    pub fails: Vec<(Zone, usize)>,
    /// Of the first number that decides the place, and the rows where it is least and largest among sound designs.
    pub extremes: Option<[usize; 3]>,
    /// How far it is from where the case stands to the borders; empty where it stands outside or is of one key at a time.
    pub distances: Vec<Distance>,
}

/// Keys that are named when each is changed by itself.
const NAMED: usize = 3;

impl Said {
    /// Of a study that is complete.
    pub fn of(results: &Results) -> Self {
        let designs = results.designs();
        let sound = designs.iter().filter(|found| found.is_sound());
        let count = |zone: &Zone| designs.iter().filter(|found| found.worst() == Some(*zone)).count();
        let fails = Zone::ALL.into_iter().map(|zone| (zone, count(&zone))).filter(|(_, count)| *count > 0);
        let distances = match results.plan.how() {
            How::Combined => windows(results).iter().flat_map(|window| window.distances()).collect(),
            How::OneAtATime => Vec::new(),
        };
        Self {
            designs: designs.len(),
            sound: sound.clone().count(),
            amber: sound.filter(|found| found.light == Some(Light::Amber)).count(),
            fails: fails.collect(),
            extremes: results.deciding(1).first().and_then(|place| extremes(results, *place)),
            distances,
        }
    }

    /// In a few sentences, the first of them a count.
    pub fn sentences(&self, results: &Results) -> Vec<String> {
        let mut said = vec![self.counted()];
        if let Some([place, least, most]) = self.extremes {
            said.push(format!("{number} of sound designs: {least} at {where}, {most} at {there}", number = results.number(place).label, least = told(results, place, results.rows[least].numbers[place]), where = at(results, least), most = told(results, place, results.rows[most].numbers[place]), there = at(results, most)));
        }
        match results.plan.how() {
            How::Combined => said.extend(self.fails.iter().map(|(zone, _)| span(results, *zone))),
            How::OneAtATime => said.extend(results.deciding(4).into_iter().map(|place| ranked(results, place))),
        }
        said.extend(self.stands(results));
        said
    }

    /// `400 designs: 212 sound (32 amber), 150 wrinkle`
    fn counted(&self) -> String {
        let sound = match self.amber {
            0 => format!("{n} sound", n = self.sound),
            amber => format!("{n} sound ({amber} of them amber)", n = self.sound),
        };
        let failed = self.fails.iter().map(|(zone, n)| {
            let n = *n;
            match zone {
                Zone::Tears => format!("{n} tear"),
                Zone::Wrinkles => format!("{n} wrinkle"),
                Zone::Press => format!("{n} need a larger press"),
                Zone::Other => format!("{n} are refused otherwise"),
                Zone::NoResult => format!("{n} have no answer"),
            }
        });
        let parts = joined(std::iter::once(sound).chain(failed), ", ");
        format!("{n}: {parts}", n = designs(self.designs))
    }

    /// Where the case stands: how far from each border, or that it is outside.
    fn stands(&self, results: &Results) -> Vec<String> {
        if results.plan.how() == How::OneAtATime {
            return Vec::new();
        }
        let wide = results.wide();
        if wide.is_empty() {
            return vec!["one value has no borders: give several to see how far the case may go".into()];
        }
        if wide.len() > 3 {
            return vec!["no picture of more than three keys: --one-at-a-time draws one of any number".into()];
        }
        if windows(results).iter().any(Window::is_coarse) {
            return vec!["the designs stand too far apart about the case as it stands to tell its distances from the borders: give values nearer to it".into()];
        }
        if self.distances.is_empty() {
            let is_of_names = results.axes.iter().all(Varied::has_names);
            return if is_of_names {
                Vec::new()
            } else {
                vec!["the case as it stands is none of these designs".into()]
            };
        }
        let state = results.base.fails.first().map_or_else(|| "sound".into(), |zone| zone.label());
        let own = results.axes.iter().filter_map(|axis| Some(value(axis, axis.own?)));
        let stands = format!("the case as it stands ({where}): {state}", where = joined(own, ", "));
        std::iter::once(stands).chain(self.distances.iter().map(|distance| distance.told(results))).collect()
    }
}

/// The rows where a number is least and largest among sound designs.
fn extremes(results: &Results, place: usize) -> Option<[usize; 3]> {
    let number = |row: &usize| results.rows[*row].numbers[place];
    let sound = (0..results.rows.len()).filter(|row| results.rows[*row].is_sound() && number(row).is_finite());
    let by = |a: &usize, b: &usize| number(a).total_cmp(&number(b));
    let (least, most) = (sound.clone().min_by(by)?, sound.max_by(by)?);
    (least != most).then_some([place, least, most])
}

/// A number as it is told.
fn told(results: &Results, place: usize, value: f64) -> Amount {
    results.number(place).amount.of(value)
}

/// `Holder force 10 kN, Friction 0.08`
fn at(results: &Results, row: usize) -> String {
    let places = results.plan.place(row as u64);
    let parts = results.axes.iter().zip(places).filter_map(|(axis, place)| Some(value(axis, axis.values[place?])));
    let parts: Vec<String> = parts.collect();
    if parts.is_empty() { "the case as it stands".into() } else { joined(parts, ", ") }
}

/// `Friction 0.08`
fn value(axis: &Varied, value: f64) -> String {
    format!("{axis} {value}", axis = axis.message(), value = axis.told(value))
}

/// Where designs fail in a way: `wrinkles: Holder force 0.5 to 1.8 kN`
fn span(results: &Results, zone: Zone) -> String {
    let failed: Vec<usize> = (0..results.rows.len()).filter(|row| is_in(&results.rows[*row], zone)).collect();
    let places: Vec<Vec<Option<usize>>> = failed.iter().map(|row| results.plan.place(*row as u64)).collect();
    let spans = results.axes.iter().enumerate().filter_map(|(i, axis)| {
        let met: Vec<f64> = places.iter().filter_map(|place| Some(axis.values[place[i]?])).collect();
        let ends =
            |values: &[f64]| values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)));
        let (low, high) = ends(&met);
        if axis.has_names() {
            let mut names: Vec<&str> = met.iter().map(|place| axis.names[*place as usize].as_str()).collect();
            names.sort_unstable();
            names.dedup();
            let is_all = names.len() == axis.names.len();
            return (!is_all).then(|| format!("{axis} {value}", axis = axis.message(), value = names.join(", ")));
        }
        ((low, high) != ends(&axis.values)).then(|| match low == high {
            true => value(axis, low),
            false => {
                format!("{axis} {low} to {high}", axis = axis.message(), low = axis.told(low), high = axis.told(high))
            }
        })
    });
    let spans: Vec<String> = spans.collect();
    let spans = if spans.is_empty() { "all over".into() } else { joined(spans, ", ") };
    format!("{zone}: {spans}", zone = zone.label())
}

fn is_in(found: &Found, zone: Zone) -> bool {
    found.fails.contains(&zone)
}

/// Which keys move a number most: `Thinning: Friction 2.1 %, Holder force 1.3 %`
fn ranked(results: &Results, place: usize) -> String {
    let swings = swings(results, place).into_iter().take(NAMED).filter(|swing| swing.width() > 0.0);
    let keys = swings.map(|swing| {
        format!(
            "{axis} ({amount})",
            axis = results.axes[swing.axis].message(),
            amount = told(results, place, swing.width())
        )
    });
    format!("{number} is moved most by: {keys}", number = results.number(place).label, keys = joined(keys, ", "))
}

impl Zone {
    /// What a part does there: `it …`.
    fn verb(self) -> String {
        match self {
            Self::Tears => "tears",
            Self::Wrinkles => "would wrinkle",
            Self::Press => "needs a larger press",
            Self::Other => "is refused otherwise",
            Self::NoResult => "has no answer",
        }
        .into()
    }
}

impl Distance {
    /// `Holder force may fall by 3.1 kN before it would wrinkle: red`
    pub fn told(&self, results: &Results) -> String {
        let axis = &results.axes[self.axis];
        let (key, by, to) = (axis.message(), axis.difference(self.to - self.from), axis.told(self.to));
        match (self.meets, self.to > self.from) {
            (Meets::Failure(zone), true) => {
                format!("{key} may rise by {by} before it {fails}: red", fails = zone.verb())
            }
            (Meets::Failure(zone), false) => {
                format!("{key} may fall by {by} before it {fails}: red", fails = zone.verb())
            }
            (Meets::Sound, true) => format!("{key} must rise by {by} for it to be sound"),
            (Meets::Sound, false) => format!("{key} must fall by {by} for it to be sound"),
            (Meets::End, _) if results.base.fails.is_empty() => {
                format!("{key} may go to {to}, the end of what was run")
            }
            (Meets::End, _) => format!("{key} alone does not help as far as {to}"),
        }
    }
}

/// So many designs.
pub fn designs(n: usize) -> String {
    if n == 1 { "1 design".into() } else { format!("{n} designs") }
}
