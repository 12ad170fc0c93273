//! Stress through the thickness of one frame: at every layer in numbers, at a few places as curves.

use super::chart::{Chart, Look, Panel, Scale, Series};
use super::{WriteError, csv, png, profile, write_into};
use crate::measure::{Place, places};
use crate::model::Model;
use crate::solution::{Frame, PointRecord};
use crate::table::{Column, Table, Unit};
use std::path::{Path, PathBuf};

/// The files that [`write`] makes.
pub(super) const FILES: [&str; 2] = ["residual_stress.csv", "residual_stress.png"];

/// Least height of a stress axis \[MPa\]: smaller stresses are noise or nothing to look at.
const LEAST: f64 = 1.0;

/// Writes `residual_stress.csv` and `residual_stress.png` of a frame into `dir`; nothing of a frame without layers.
///
/// # Errors
/// When a file cannot be written.
pub fn write(dir: &Path, frame: &Frame, model: &Model) -> Result<Vec<PathBuf>, WriteError> {
    let Some(chart) = plot(frame, model) else { return Ok(Vec::new()) };
    write_into(dir, FILES, [csv(&table(frame, model)), png(&chart)])
}

/// One row per element and layer, from the axis outward and from the die's face to the punch's.
pub fn table(frame: &Frame, model: &Model) -> Table {
    let layers = &frame.through.layers;
    let elements = &frame.elements[..frame.through.elements().len().min(frame.elements.len())];
    let points = &frame.through.points[..elements.len() * layers.len()];
    let profile = profile::table(model, std::slice::from_ref(frame));
    let of_elements = |key: &str| {
        let Column { key, label, unit, ref values } = *profile.column(key);
        let each = values[..elements.len()].iter().flat_map(|v| std::iter::repeat_n(*v, layers.len()));
        Column::new(key, label, unit, each.collect())
    };
    let of_points = |key: &str, value: fn(&PointRecord) -> f64| {
        let Column { key, label, unit, .. } = *profile.column(key);
        Column::new(key, label, unit, points.iter().map(value).collect())
    };
    let place = elements.iter().flat_map(|_| layers.iter().map(|layer| 0.5 * layer.xi));
    let zeta = elements.iter().flat_map(|e| layers.iter().map(|layer| 0.5 * layer.xi * e.thickness));
    Table::new(vec![
        of_elements("s0"),
        of_elements("r"),
        of_elements("z"),
        Column::new("place", "ζ/t, from the die's face (−0.5) to the punch's (0.5)", Unit::None, place.collect()),
        Column::new("zeta", "ζ, from the mid-surface towards the punch", Unit::Mm, zeta.collect()),
        of_points("stress_meridional", |p| p.stress_meridional),
        of_points("stress_hoop", |p| p.stress_hoop),
        of_points("strain_equivalent", |p| p.strain_equivalent),
    ])
}

/// Both stresses over the place through the thickness, at the places of [`places`]; `None` without layers.
pub fn plot(frame: &Frame, model: &Model) -> Option<Chart> {
    let table = table(frame, model);
    let n = frame.through.layers.len();
    let shown: Vec<_> =
        places(frame).into_iter().filter(|place| n > 0 && (place.element + 1) * n <= table.rows()).collect();
    shown.first()?;
    let panel = |key: &str, labelled: bool| {
        let pairs = table.pairs("place", key);
        let series = shown.iter().enumerate().map(|(i, place)| Series {
            label: labelled.then(|| format!("{}, s0 = {:.1} mm", place.name, frame.elements[place.element].s0)),
            points: pairs[place.element * n..(place.element + 1) * n].to_vec(),
            look: Look::curve(i),
        });
        Panel {
            x: table.column("place").axis(),
            y: table.column(key).axis(),
            series: series.collect(),
            scale: Scale::Fit { height: 300.0, least: LEAST },
        }
    };
    let is_held = shown.iter().any(|place| place.name == Place::FLANGE);
    let held = is_held.then(|| "In the flange the punch's face is the holder's.".to_owned());
    Some(Chart {
        title: format!("{}: stress through the thickness", model.title),
        legend: "",
        panels: vec![panel("stress_meridional", true), panel("stress_hoop", false)],
        notes: std::iter::once(format!("{n} layer points.")).chain(held).chain(model.notes.iter().cloned()).collect(),
    })
}
