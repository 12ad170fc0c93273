//! Pictures and tables of comparisons.

use super::band::{interval_text, which};
use super::{Band, Compared, Comparison, Point, Points};
use crate::case::comparison::{Against, BandSpec, ComparedQuantity, CurveSpec};
use crate::plot::StageView;
use crate::plot::chart::{Chart, Panel};
use crate::plot::comparison::{band_panel, curve_panels};
use crate::results::{Files, Format, Results, csv};
use crate::units::{joined, rounded};

/// Beginning of the names of files.
pub(in crate::results) const PREFIX: &str = "compare_";

/// Largest drawn difference in tolerances, if half of the points lie within.
const DRAWN: f64 = 6.0;

/// Table and picture `compare_<n>_<quantity>` of every comparison with data, counted from 1.
pub(in crate::results) fn files(results: &Results) -> Files {
    let mut files = Vec::new();
    let Some(view) = results.views.first() else { return files };
    for (i, comparison) in results.comparisons.iter().enumerate() {
        let stem = format!("{PREFIX}{}_{}", i + 1, comparison.spec.against.quantity().name());
        if let Some(chart) = plot(view, comparison) {
            files.push((format!("{stem}.csv"), csv(&comparison.table())));
            files.extend(view.pictures.files(&stem, &chart));
        }
    }
    files
}

/// True if a file's name is one that [`files`] gives.
pub(in crate::results) fn is_comparison(name: &str) -> bool {
    let stem = name.strip_suffix(".csv").or(Format::stem(name));
    let parts = stem.and_then(|stem| stem.strip_prefix(PREFIX)).and_then(|rest| rest.split_once('_'));
    let is_quantity = |name: &str| ComparedQuantity::names().any(|known| known == name);
    parts.is_some_and(|(n, quantity)| n.parse::<usize>().is_ok() && is_quantity(quantity))
}

fn plot(view: &StageView, comparison: &Comparison) -> Option<Chart> {
    let (panels, columns, text) = match (&comparison.spec.against, &comparison.compared) {
        (Against::Curve(spec), Compared::Points(points)) => {
            (curve(comparison, spec, points), spec.y.clone(), curve_text(comparison, points))
        }
        (Against::Band(spec), Compared::Band(found)) => {
            (vec![band(comparison, spec, found)], spec.columns.join(", "), band_text(comparison, found))
        }
        _ => return None,
    };
    let spec = &comparison.spec;
    let file = spec.reference.file_name().unwrap_or_default().to_string_lossy();
    let from = comparison.source().map_or_else(|| "source not stated".to_owned(), ToString::to_string);
    let notes = [
        format!("Reference: {file}, {columns}: {from}."),
        format!("Accepted: {}; {text}.", comparison.accepted()),
        format!("Reason: {}.", spec.reason.trim_end_matches('.')),
    ];
    let demonstration = spec.demonstration.then(|| "A demonstration, not a validation.".to_owned());
    let notes = demonstration.into_iter().chain(notes);
    Some(view.chart("computed and reference", panels, notes))
}

fn curve(comparison: &Comparison, spec: &CurveSpec, Points(points): &Points) -> Vec<Panel> {
    let end = DRAWN * spec.tolerance;
    let beyond = points.iter().filter_map(Point::difference).filter(|d| d.abs() > end).count();
    let largest = if 2 * beyond > points.len() { f64::INFINITY } else { end };
    let differences = points.iter().filter_map(|p| Some((p.x, p.difference()?)));
    let differences = differences.filter(|d| d.1.abs() <= largest).map(|(x, d)| (x, 100.0 * d)).collect();
    let reference = points.iter().map(|p| (p.x, p.reference)).collect();
    let axes = [comparison.x.axis(), comparison.y.axis()];
    curve_panels(axes, comparison.curve.clone(), reference, differences, rounded(100.0 * spec.tolerance))
}

fn curve_text(comparison: &Comparison, points: &Points) -> String {
    let judged = points.judged().count();
    let missed = points.judged().filter(|point| point.computed.is_none()).count();
    let missed = format!("{missed} of {judged} reference points were not reached");
    let worst = points.worst().zip(comparison.worst());
    let worst = worst.map(|(point, worst)| format!("largest difference {worst} at {}", comparison.place(point)));
    joined([worst.unwrap_or_default(), missed], "; ")
}

fn band(comparison: &Comparison, spec: &BandSpec, band: &Band) -> Panel {
    let (curve, unit, which) = (&comparison.curve, comparison.y.unit, which(spec.quantity));
    let compared = band.computed.map_or_else(Default::default, |computed| {
        let is_compared = |p: &(f64, f64)| computed.contains(&p.1);
        let points = match computed[0] == computed[1] {
            true => curve.iter().copied().rfind(is_compared).into_iter().collect(),
            false => curve.iter().copied().filter(is_compared).collect(),
        };
        (format!("Computed {which}, {}", interval_text(computed, unit)), points)
    });
    let measured = (format!("Reference {which}, {}", interval_text(band.measured, unit)), band.measured);
    let widened = (band.accepted != band.measured)
        .then(|| (format!("Reference with its error, {}", interval_text(band.accepted, unit)), band.accepted));
    let axes = [comparison.x.axis(), comparison.y.axis()];
    band_panel(axes, curve.clone(), compared, measured, widened)
}

fn band_text(comparison: &Comparison, band: &Band) -> String {
    let computed = band.computed.zip(comparison.worst());
    let text =
        computed.map(|(computed, worst)| format!("computed {}: {worst}", interval_text(computed, comparison.y.unit)));
    text.unwrap_or_else(|| "the run ended before the compared value".to_owned())
}
