//! A material by itself: its flow curve beside what it is fitted to, and the forming limits that follow from it.

use super::chart::{BLACK, Chart, GREY, Look, Panel, Scale, Series, color, pale};
use super::forming_limit::axes;
use crate::case::library::{Measured, Rates};
use crate::forming_limit::Curve;
use crate::material::Material;
use crate::table::{Column, Unit};

/// Equivalent strain that the flow curve is drawn to where its law says nothing \[–\].
const LARGEST: f64 = 0.8;
const POINTS: usize = 200;

/// The yield stress over the equivalent plastic strain, its factor over the rate where tests at several rates are known, and
/// limit curves below.
pub fn chart(
    title: &str,
    material: &Material,
    measured: Option<&Measured>,
    limits: &[Curve],
    notes: Vec<String>,
) -> Chart {
    let mut panels = vec![over_strain(material, measured)];
    panels.extend(measured.and_then(|m| m.rates.as_ref()).map(|rates| over_rate(material, rates)));
    if !limits.is_empty() {
        let [x, y] = axes();
        let series = limits.iter().enumerate().map(|(i, limit)| {
            let points = limit.points().iter().map(|p| (p[0], p[1])).collect();
            Series::new(format!("{}, computed", limit.name), points, Look::curve(i + 1))
        });
        panels.push(Panel { x, y, series: series.collect(), scale: Scale::Fit { height: 260.0, least: 0.1 } });
    }
    Chart { title: title.to_owned(), legend: String::new(), panels, notes }
}

/// `count` values and one more, from `low` to `high`.
fn evenly(low: f64, high: f64) -> impl Iterator<Item = f64> {
    (0..=POINTS).map(move |i| low + (high - low) * i as f64 / POINTS as f64)
}

/// The flow curve of every rate that was tested, beyond the range of the fit thin, and the measured points with their
/// scatter.
fn over_strain(material: &Material, measured: Option<&Measured>) -> Panel {
    let known = material.measured_up_to();
    let drawn = material.hardening.valid_up_to().unwrap_or(LARGEST);
    let curve = |factor: f64, from: f64, to: f64| -> Vec<(f64, f64)> {
        evenly(from, to).map(|strain| (strain, factor * material.hardening.at(strain).stress)).collect()
    };
    let factor = |rate: f64| material.rate.map_or(1.0, |law| law.at(rate).value);
    let own = measured.map(Measured::rate);
    let mut series = Vec::new();
    if let Some(measured) = measured {
        let [above, below] = [1.0, -1.0].map(|side| {
            measured.points().map(|p| (p.strain, p.stress + side * p.scatter)).collect::<Vec<_>>()
        });
        let outline = above.into_iter().chain(below.into_iter().rev()).collect();
        series.push(Series::new("Scatter", outline, Look::Area { fill: pale(GREY), edge: None }));
    }
    let end = known.unwrap_or(drawn).min(drawn);
    let rate = own.map_or(String::new(), |rate| format!(", {rate} /s"));
    let law = format!("{}{rate}", material.hardening.describe());
    series.push(Series::new(law, curve(own.map_or(1.0, factor), 0.0, end), Look::curve(0)));
    if end < drawn {
        let beyond = curve(own.map_or(1.0, factor), end, drawn);
        series.push(Series::new("Beyond the measured range", beyond, Look::curve(0).faint()));
    }
    let tested = measured.and_then(|m| m.rates.as_ref()).into_iter().flat_map(Rates::rates);
    let others: Vec<f64> = tested.filter(|rate| own.is_none_or(|own| *rate > own)).collect();
    for (i, rate) in others.iter().enumerate() {
        series.push(Series::new(format!("{rate} /s"), curve(factor(*rate), 0.0, end), Look::curve(i + 1)));
    }
    if let Some(measured) = measured {
        let points = measured.points().map(|p| (p.strain, p.stress)).collect();
        series.push(Series::new("Measured", points, Look::Circles { color: BLACK }));
    }
    let strain = Column::new("strain_equivalent", "Equivalent plastic strain", Unit::None, Vec::new());
    let stress = Column::new("yield_stress", "Yield stress", Unit::MPa, Vec::new());
    Panel { x: strain.axis(), y: stress.axis(), series, scale: Scale::Fit { height: 260.0, least: 10.0 } }
}

/// The rate law's factor and the tests' ratios over the logarithm of the rate.
fn over_rate(material: &Material, rates: &Rates) -> Panel {
    let ratios = rates.ratios().into_iter().map(|(rate, ratio)| (rate.log10(), ratio)).collect();
    let [slow, fast] = rates.rates().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], rate| {
        [low.min(rate.log10()), high.max(rate.log10())]
    });
    let law = evenly(slow, fast).map(|decade| (decade, rates.law(material, 10_f64.powf(decade)))).collect();
    let label = material.rate.map_or_else(|| "No rate law".to_owned(), |law| law.to_string());
    let decades = Column::new("rate_decades", "Decades of the strain rate, log₁₀ of 1/s", Unit::None, Vec::new());
    let factor = Column::new("rate_factor", "Yield stress over that of the slowest test", Unit::None, Vec::new());
    let series = vec![
        Series::new(label, law, Look::curve(0)),
        Series::new("Measured ratios", ratios, Look::Triangles { color: color(1) }),
    ];
    Panel { x: decades.axis(), y: factor.axis(), series, scale: Scale::Fit { height: 200.0, least: 0.1 } }
}
