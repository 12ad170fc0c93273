//! Pictures: as SVG, and as what they show, to be drawn by others.

use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use stampflow::output::chart::{Chart, Color, Look, Panel, Scale};
use stampflow::output::svg;
use stampflow::table::Axis;

/// How a series is drawn: what as, its colour and that of its edge or hatching, the width of a line and the lengths drawn and
/// left out in turn \[px of a picture 800 wide\], and how hatching rises \[°\].
type LookParts = (&'static str, Option<String>, Option<String>, f64, Vec<f64>, f64);

/// A series: label, x, y, how it is drawn.
pub type SeriesParts<'py> = (Option<String>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, LookParts);

/// Label with unit, whether equal ratios are equally far apart, names where there are no numbers.
type AxisParts = (String, bool, Vec<String>);

/// Ends of x and y.
type Window = ((f64, f64), (f64, f64));

/// Both axes, series from the back to the front, the window, how the axes are scaled, and the height \[px of a picture 800
/// wide\] where that is given.
pub type PanelParts<'py> = ((AxisParts, AxisParts), Vec<SeriesParts<'py>>, Window, (&'static str, Option<f64>));

/// The SVG, the title, what the legend's entries have in common, the panels from the top down, and the small print.
pub type Picture<'py> = (String, String, String, Vec<PanelParts<'py>>, Vec<String>);

/// A chart, part by part.
pub fn picture<'py>(py: Python<'py>, chart: &Chart) -> Picture<'py> {
    let svg = py.detach(|| svg(chart));
    let panels = chart.panels.iter().map(|panel| parts(py, panel)).collect();
    (svg, chart.title.clone(), chart.legend.clone(), panels, chart.notes.clone())
}

fn parts<'py>(py: Python<'py>, panel: &Panel) -> PanelParts<'py> {
    // Of a logarithmic axis the values.
    let [along, up] = [panel.x.spacing(), panel.y.spacing()];
    let series = panel.series.iter().map(|series| {
        let (x, y): (Vec<f64>, Vec<f64>) = series.points.iter().map(|&(x, y)| (along.value(x), up.value(y))).unzip();
        (series.label.clone(), x.into_pyarray(py), y.into_pyarray(py), look(series.look))
    });
    let [x, y] = panel.ranges();
    let window = ((along.value(x.0), along.value(x.1)), (up.value(y.0), up.value(y.1)));
    let scale = match panel.scale {
        Scale::Fit { height, .. } => ("fit", Some(height)),
        Scale::Window { height, .. } => ("window", Some(height)),
        Scale::Multiple { height, .. } => ("multiple", Some(height)),
        Scale::Section { .. } => ("section", None),
        Scale::Small { .. } => ("small", None),
        Scale::Bar => ("bar", None),
    };
    ((axis(&panel.x), axis(&panel.y)), series.collect(), window, scale)
}

fn axis(axis: &Axis) -> AxisParts {
    (axis.text(), axis.spacing().is_logarithmic(), axis.names().to_vec())
}

fn look(look: Look) -> LookParts {
    let plain = |name, color: Option<Color>| (name, color.map(hex), None, 0.0, Vec::new(), 0.0);
    match look {
        Look::Line { color, width, dash } => ("line", Some(hex(color)), None, width, dash.to_vec(), 0.0),
        Look::Circles { color } => plain("circles", Some(color)),
        Look::Dots { color } => plain("dots", Some(color)),
        Look::Triangles { color } => plain("triangles", Some(color)),
        Look::Area { fill, edge } => ("area", Some(hex(fill)), edge.map(hex), 0.0, Vec::new(), 0.0),
        Look::Hatched { fill, line, rise } => ("hatched", fill.map(hex), Some(hex(line)), 0.0, Vec::new(), rise),
        Look::Text => plain("text", None),
        Look::Before => plain("before", None),
        Look::Name => plain("name", None),
        Look::Callout => plain("callout", None),
        Look::Flag => plain("flag", None),
    }
}

fn hex((red, green, blue): Color) -> String {
    format!("#{red:02X}{green:02X}{blue:02X}")
}
