//! Material chart: flow curve with measured points, and forming limits.

use super::chart::{Chart, Panel, Series, Style};
use super::forming_diagram::strain_axes;
use crate::forming_limit::Curve;
use crate::material::Material;
use crate::plot::Axis;
use crate::table::Unit;

/// Largest strain of a law without a range of validity \[–\].
const LARGEST: f64 = 0.8;
const POINTS: usize = 200;
/// Styles that are left to the curves of several rates.
const RATES: usize = 3;

/// Yield stress over the equivalent plastic strain, limit curves below.
pub fn chart(title: &str, material: &Material, limits: &[Curve], notes: Vec<String>) -> Chart {
    let mut panels = vec![over_strain(material)];
    if !limits.is_empty() {
        let [x, y] = strain_axes(false);
        let series = limits.iter().enumerate().map(|(i, limit)| {
            let points = limit.points().iter().map(|p| (p[0], p[1])).collect();
            let label = if limit.is_measured() { "Measured".into() } else { format!("{}, computed", limit.name) };
            Series::new(label, points, Style::curve(i + RATES))
        });
        panels.push(Panel::fit(x, y, 260.0, 0.1).with(series));
    }
    Chart::new(title, panels, notes)
}

/// Flow curve at rates that were tested and are a decade apart or more, thin beyond the range of the fit.
fn over_strain(material: &Material) -> Panel {
    let drawn = material.hardening.valid_up_to().unwrap_or(LARGEST);
    let end = material.measured_up_to().unwrap_or(drawn).min(drawn);
    let curve = |from: f64, to: f64| -> Vec<(f64, f64)> {
        (0..=POINTS)
            .map(|i| from + (to - from) * i as f64 / POINTS as f64)
            .map(|strain| (strain, material.hardening.at(strain).stress))
            .collect()
    };
    let law = material.hardening.to_string();
    let mut series = vec![Series::new(law, curve(0.0, end), Style::curve(0))];
    if end < drawn {
        let beyond = curve(end, drawn);
        series.push(Series::new("Beyond the measured range", beyond, Style::curve(0).faint()));
    }
    let strain = Axis::named("Equivalent plastic strain", Unit::None);
    Panel::fit(strain, Axis::named("Yield stress", Unit::MPa), 260.0, 10.0).with(series)
}
