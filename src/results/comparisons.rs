//! Comparisons with references as pictures and tables.

use super::{Chart, Files, Format, Results, StageView, csv};
use crate::case::{Case, Solution};
use crate::compare::{
    Against, Band, BandQuantity, BandSpec, CompareError, Comparison, Computed, CurveSpec, Found, Interval, Point,
    Points, Quantity, compare,
};
use crate::plot::chart::Panel;
use crate::plot::comparison::{band_panel, curve_panels};
use crate::units::{joined, rounded};

impl Solution {
    /// Comparisons with the results of the first stage and with the ring of the last.
    ///
    /// # Errors
    /// If a reference cannot be read or does not fit.
    pub fn comparisons(&self) -> Result<Vec<Comparison>, CompareError> {
        let Some(first) = self.stages.first() else { return Ok(Vec::new()) };
        let ring = self.case.springback.ring.and_then(|ring| ring.test(&self.stages));
        comparisons(&self.case, &Computed { ring: ring.as_ref(), ..Computed::of(first) })
    }
}

/// Comparisons of a case with computed results.
///
/// # Errors
/// If a reference cannot be read or does not fit.
pub fn comparisons(case: &Case, computed: &Computed) -> Result<Vec<Comparison>, CompareError> {
    case.compare.iter().map(|spec| compare(spec, computed)).collect()
}

/// `compare_<n>_<quantity>.csv` and the picture of every comparison with data, counted from 1.
pub(super) fn files(results: &Results) -> Files {
    let mut files = Vec::new();
    let Some(view) = results.views.first() else { return files };
    for (i, comparison) in results.comparisons.iter().enumerate() {
        let stem = format!("compare_{}_{}", i + 1, comparison.spec.against.name());
        if let Some(chart) = plot(view, comparison) {
            files.push((format!("{stem}.csv"), csv(&comparison.table())));
            files.extend(view.pictures.files(&stem, &chart));
        }
    }
    files
}

/// True if a file's name is one that [`files`] gives.
pub(super) fn is_comparison(_: &str, name: &str) -> bool {
    let stem = name.strip_suffix(".csv").or(Format::stem(name));
    let parts = stem.and_then(|stem| stem.strip_prefix("compare_")).and_then(|rest| rest.split_once('_'));
    parts.is_some_and(|(n, quantity)| n.parse::<usize>().is_ok() && is_quantity(quantity))
}

fn is_quantity(name: &str) -> bool {
    Quantity::ALL.iter().any(|q| q.name() == name) || BandQuantity::ALL.iter().any(|q| q.name() == name)
}

/// Picture of a comparison; `None` without data.
pub(crate) fn plot(view: &StageView, comparison: &Comparison) -> Option<Chart> {
    let panels = match (&comparison.spec.against, &comparison.found) {
        (Against::Curve(spec), Found::Points(points)) => curve(comparison, spec, points),
        (Against::Band(spec), Found::Band(found)) => vec![band(comparison, spec, found)],
        _ => return None,
    };
    let notes = notes(comparison).into_iter().chain(view.notes()).collect();
    Some(Chart::new(view.titled("computed and reference"), panels, notes))
}

/// Largest drawn difference in tolerances, if half of the points lie within.
const DRAWN: f64 = 6.0;

fn largest_drawn(points: &[Point], spec: &CurveSpec) -> f64 {
    let end = DRAWN * spec.tolerance;
    let beyond = points.iter().filter_map(Point::difference).filter(|d| d.abs() > end).count();
    if 2 * beyond > points.len() { f64::INFINITY } else { end }
}

fn curve(comparison: &Comparison, spec: &CurveSpec, Points(points): &Points) -> Vec<Panel> {
    let largest = largest_drawn(points, spec);
    let differences = points.iter().filter_map(|p| Some((p.x, p.difference()?)));
    let differences = differences.filter(|d| d.1.abs() <= largest).map(|(x, d)| (x, 100.0 * d)).collect();
    let reference = points.iter().map(|p| (p.x, p.reference)).collect();
    let tolerance = rounded(100.0 * spec.tolerance);
    curve_panels(comparison.axes().into(), comparison.curve.clone(), reference, differences, tolerance)
}

fn band(comparison: &Comparison, spec: &BandSpec, band: &Band) -> Panel {
    let curve = &comparison.curve;
    let which = spec.quantity.which();
    let compared = band.computed.map_or_else(Default::default, |computed| {
        let is_compared = |p: &(f64, f64)| p.1 == computed.low || p.1 == computed.high;
        let points = match computed.low == computed.high {
            true => curve.iter().copied().rfind(is_compared).into_iter().collect(),
            false => curve.iter().copied().filter(is_compared).collect(),
        };
        (format!("Computed {which}, {}", comparison.text(computed)), points)
    });
    let ends = |interval: Interval| [interval.low, interval.high];
    let measured = (format!("Reference {which}, {}", comparison.text(band.measured)), ends(band.measured));
    let widened = (band.accepted != band.measured)
        .then(|| (format!("Reference with its error, {}", comparison.text(band.accepted)), ends(band.accepted)));
    band_panel(comparison.axes().into(), curve.clone(), compared, measured, widened)
}

/// Source, tolerance and largest difference of a comparison.
fn notes(comparison: &Comparison) -> Vec<String> {
    let Comparison { spec, source, .. } = comparison;
    let file = spec.reference.file_name().unwrap_or_default().to_string_lossy();
    let from = source.as_ref().map_or_else(|| "source not stated".to_owned(), ToString::to_string);
    let demonstration = spec.demonstration.then(|| "A demonstration, not a validation.".to_owned());
    let (columns, text) = match (&spec.against, &comparison.found) {
        (Against::Curve(curve), Found::Points(points)) => {
            let judged = points.judged().count();
            let missed = points.judged().filter(|point| point.computed.is_none()).count();
            let missed = format!("{missed} of {judged} reference points were not reached");
            let worst = points.worst().zip(comparison.worst());
            let worst =
                worst.map(|(point, worst)| format!("largest difference {worst} at {}", comparison.place(point)));
            (curve.y.clone(), joined([worst.unwrap_or_default(), missed], "; "))
        }
        (Against::Band(band), Found::Band(found)) => {
            let computed = found.computed.zip(comparison.worst());
            let text = computed.map(|(computed, worst)| format!("computed {}: {worst}", comparison.text(computed)));
            (band.columns.join(", "), text.unwrap_or_else(|| "the run ended before the compared value".to_owned()))
        }
        (against, _) => (against.name().to_owned(), String::new()),
    };
    let reference = format!("Reference: {file}, {columns}: {from}.");
    let judgement = format!("Accepted: {}; {text}.", comparison.accepted());
    let reason = format!("Reason: {}.", spec.reason.trim_end_matches('.'));
    demonstration.into_iter().chain([reference, judgement, reason]).collect()
}
