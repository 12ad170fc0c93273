//! Pictures: as SVG, and as the series that they show.

use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use stampflow::output::chart::{Chart, Color, Look, Panel, Scale};
use stampflow::output::svg;

/// A series: label, x, y, how it is drawn and in which colour.
pub type SeriesParts<'py> =
    (Option<String>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, &'static str, Option<String>);

/// Ends of x and y of a window.
type Window = ((f64, f64), (f64, f64));

/// A pair of axes: their labels with units, series from the back to the front, the window where it is one, and whether it is a
/// section: both axes alike, and y down the page.
pub type PanelParts<'py> = (String, String, Vec<SeriesParts<'py>>, Option<Window>, bool);

/// The SVG, the title and the panels from the top down.
pub type Picture<'py> = (String, String, Vec<PanelParts<'py>>);

/// A chart, part by part.
pub fn picture<'py>(py: Python<'py>, chart: &Chart) -> Picture<'py> {
    let svg = py.detach(|| svg(chart));
    (svg, chart.title.clone(), chart.panels.iter().map(|panel| parts(py, panel)).collect())
}

fn parts<'py>(py: Python<'py>, panel: &Panel) -> PanelParts<'py> {
    let series = panel.series.iter().map(|series| {
        let (x, y): (Vec<f64>, Vec<f64>) =
            series.points.iter().map(|&(x, y)| (panel.x.value(x), panel.y.value(y))).unzip();
        let (look, color) = named(series.look);
        (series.label.clone(), x.into_pyarray(py), y.into_pyarray(py), look, color.map(hex))
    });
    // Of a logarithmic axis the values.
    let ends = |x: (f64, f64), y: (f64, f64)| {
        ((panel.x.value(x.0), panel.x.value(x.1)), (panel.y.value(y.0), panel.y.value(y.1)))
    };
    let (window, is_section) = match panel.scale {
        Scale::Section { x, y } | Scale::Small { x, y } => (Some((x, y)), true),
        Scale::Window { x, y, .. } | Scale::Multiple { x, y, .. } => (Some(ends(x, y)), false),
        Scale::Fit { .. } | Scale::Bar => (None, false),
    };
    (panel.x.text(), panel.y.text(), series.collect(), window, is_section)
}

fn named(look: Look) -> (&'static str, Option<Color>) {
    match look {
        Look::Line { color, .. } => ("line", Some(color)),
        Look::Circles { color } => ("circles", Some(color)),
        Look::Dots { color } => ("dots", Some(color)),
        Look::Triangles { color } => ("triangles", Some(color)),
        Look::Area { fill, .. } => ("area", Some(fill)),
        Look::Hatched { fill, line, .. } => ("area", Some(fill.unwrap_or(line))),
        Look::Text | Look::Before | Look::Name => ("text", None),
        Look::Callout => ("callout", None),
        Look::Flag => ("flag", None),
    }
}

fn hex((red, green, blue): Color) -> String {
    format!("#{red:02X}{green:02X}{blue:02X}")
}
