//! A material by itself: its flow curve beside what it is fitted to, and the forming limits that follow from it.

use super::chart::{BLACK, Chart, Look, PALE, Panel, Scale, Series, color};
use crate::case::library::{Measured, Rates};
use crate::forming_limit::Curve;
use crate::material::Material;
use crate::results::forming_limit::axes;
use crate::table::{Column, Unit};

/// Equivalent strain that the flow curve is drawn to where its law says nothing \[–\].
const LARGEST: f64 = 0.8;
const POINTS: usize = 200;
/// Looks that are left to the curves of several rates.
const RATES: usize = 3;

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
    panels.extend(measured.map(|measured| misses(material, measured)));
    panels.extend(measured.and_then(|m| m.rates.as_ref()).map(|rates| over_rate(material, rates)));
    if !limits.is_empty() {
        let [x, y] = axes();
        let series = limits.iter().enumerate().map(|(i, limit)| {
            let points = limit.points().iter().map(|p| (p[0], p[1])).collect();
            let label = if limit.is_measured() { "Measured".into() } else { format!("{}, computed", limit.name) };
            Series::new(label, points, Look::curve(i + RATES))
        });
        panels.push(Panel { x, y, series: series.collect(), scale: Scale::Fit { height: 260.0, least: 0.1 } });
    }
    Chart { title: title.to_owned(), legend: String::new(), panels, notes }
}

/// `count` values and one more, from `low` to `high`.
fn evenly(low: f64, high: f64) -> impl Iterator<Item = f64> {
    (0..=POINTS).map(move |i| low + (high - low) * i as f64 / POINTS as f64)
}

/// The flow curve, thin beyond the range of the fit, at rates that were tested and are a decade apart or more, and the measured
/// points.
fn over_strain(material: &Material, measured: Option<&Measured>) -> Panel {
    let drawn = material.hardening.valid_up_to().unwrap_or(LARGEST);
    let end = material.measured_up_to().unwrap_or(drawn).min(drawn);
    let factor = |rate: f64| material.rate.map_or(1.0, |law| law.at(rate).value);
    let curve = |factor: f64, from: f64, to: f64| -> Vec<(f64, f64)> {
        evenly(from, to).map(|strain| (strain, factor * material.hardening.at(strain).stress)).collect()
    };
    let own = measured.map(Measured::rate);
    let own_factor = own.map_or(1.0, factor);
    let at = own.map_or(String::new(), |rate| format!(", {rate} /s"));
    let law = format!("{}{at}", material.hardening.describe());
    let mut series = vec![Series::new(law, curve(own_factor, 0.0, end), Look::curve(0))];
    if end < drawn {
        let beyond = curve(own_factor, end, drawn);
        series.push(Series::new("Beyond the measured range", beyond, Look::curve(0).faint()));
    }
    let mut faster: Vec<f64> = own.into_iter().collect();
    for rate in measured.and_then(|m| m.rates.as_ref()).into_iter().flat_map(Rates::rates) {
        if faster.last().is_some_and(|last| rate >= 10.0 * last) {
            let points = curve(factor(rate), 0.0, end);
            series.push(Series::new(format!("The same, {rate} /s"), points, Look::curve(faster.len())));
            faster.push(rate);
        }
    }
    if let Some(measured) = measured {
        let points = measured.points().map(|p| (p.strain, p.stress)).collect();
        series.push(Series::new("Measured", points, Look::Dots { color: BLACK }));
    }
    let strain = Column::new("strain_equivalent", "Equivalent plastic strain", Unit::None, Vec::new());
    let stress = Column::new("yield_stress", "Yield stress", Unit::MPa, Vec::new());
    Panel { x: strain.axis(), y: stress.axis(), series, scale: Scale::Fit { height: 260.0, least: 10.0 } }
}

/// By how much the law lies above the measured points, and their scatter.
fn misses(material: &Material, measured: &Measured) -> Panel {
    let side = |sign: f64| measured.points().map(move |p| (p.strain, sign * p.scatter)).collect::<Vec<_>>();
    let outline = side(1.0).into_iter().chain(side(-1.0).into_iter().rev()).collect();
    let misses = measured.misses(material);
    let strain = Column::new("strain_equivalent", "Equivalent plastic strain", Unit::None, Vec::new());
    let miss = Column::new("miss", "Law less point", Unit::MPa, Vec::new());
    let series = vec![
        Series::new("Scatter of the points", outline, Look::Area { fill: PALE, edge: None }),
        Series::silent(misses.clone(), Look::curve(0)),
        Series::silent(misses, Look::Dots { color: BLACK }),
    ];
    Panel { x: strain.axis(), y: miss.axis(), series, scale: Scale::Fit { height: 150.0, least: 10.0 } }
}

/// The yield stress over that of the slowest test, by the rate law and as measured, over the logarithm of the rate.
fn over_rate(material: &Material, rates: &Rates) -> Panel {
    let ratios = rates.ratios().into_iter().map(|(rate, ratio)| (rate.log10(), ratio)).collect();
    let [slow, fast] = rates
        .rates()
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], rate| [low.min(rate.log10()), high.max(rate.log10())]);
    let law = evenly(slow, fast).map(|decade| (decade, rates.law(material, 10_f64.powf(decade)))).collect();
    let label = material.rate.map_or_else(|| "No rate law".to_owned(), |law| law.to_string());
    let decades = Column::new("rate_decades", "Decades of the strain rate, log₁₀ of 1/s", Unit::None, Vec::new());
    let factor = Column::new("rate_factor", "Rate factor", Unit::None, Vec::new());
    let series = vec![
        Series::new(label, law, Look::curve(0)),
        Series::new("Measured ratios", ratios, Look::Triangles { color: color(1) }),
    ];
    Panel { x: decades.axis(), y: factor.axis(), series, scale: Scale::Fit { height: 200.0, least: 0.1 } }
}
