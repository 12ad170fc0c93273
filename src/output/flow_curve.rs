//! A material by itself: its flow curve, and the forming limits that follow from it.

use super::chart::{Chart, Look, Panel, Scale, Series};
use super::forming_limit::axes;
use crate::forming_limit::Curve;
use crate::material::Material;
use crate::table::{Column, Unit};

/// Equivalent strain that the flow curve is drawn to where its law says nothing \[–\].
const LARGEST: f64 = 0.8;
const POINTS: usize = 200;

/// The yield stress over the equivalent plastic strain, and limit curves below it.
pub fn chart(title: &str, material: &Material, limits: &[Curve], notes: Vec<String>) -> Chart {
    let largest = material.hardening.valid_up_to().unwrap_or(LARGEST);
    let strains: Vec<f64> = (0..=POINTS).map(|i| largest * i as f64 / POINTS as f64).collect();
    let stresses: Vec<f64> = strains.iter().map(|&strain| material.hardening.at(strain).stress).collect();
    let points = strains.iter().copied().zip(stresses.iter().copied()).collect();
    let strain = Column::new("strain_equivalent", "Equivalent plastic strain", Unit::None, strains);
    let stress = Column::new("yield_stress", "Yield stress", Unit::MPa, stresses);
    let mut panels = vec![Panel {
        x: strain.axis(),
        y: stress.axis(),
        series: vec![Series::new(material.hardening.describe(), points, Look::curve(0))],
        scale: Scale::Fit { height: 260.0, least: 10.0 },
    }];
    if !limits.is_empty() {
        let [x, y] = axes();
        let series = limits.iter().enumerate().map(|(i, limit)| {
            let points = limit.points().iter().map(|p| (p[0], p[1])).collect();
            let label = if limit.is_measured() { "Measured".into() } else { format!("{}, computed", limit.name) };
            Series::new(label, points, Look::curve(i + 1))
        });
        panels.push(Panel { x, y, series: series.collect(), scale: Scale::Fit { height: 260.0, least: 0.1 } });
    }
    Chart { title: title.to_owned(), legend: String::new(), panels, notes }
}
