//! A computed curve over a reference: points with their difference below, or a band.

use super::chart::{BLACK, Chart, Color, GREY, Look, Panel, Scale, Series, color};
use super::{Format, StageView};
use crate::case::{Case, Solution};
use crate::compare::{
    Against, Band, BandQuantity, BandSpec, CompareError, Comparison, Computed, CurveSpec, Found, Interval, Point,
    Points, Quantity, compare,
};
use crate::results::{Files, Results, csv};
use crate::units::rounded;

impl Solution {
    /// What the case is compared with beside what its first stage computed, and with the ring of the last.
    ///
    /// # Errors
    /// When a reference cannot be read or does not fit.
    pub fn comparisons(&self) -> Result<Vec<Comparison>, CompareError> {
        let Some(first) = self.stages.first() else { return Ok(Vec::new()) };
        let ring = self.case.springback.ring.and_then(|ring| ring.test(&self.stages));
        comparisons(&self.case, &Computed { ring: ring.as_ref(), ..Computed::of(first) })
    }
}

/// What a case is compared with beside what was computed.
///
/// # Errors
/// When a reference cannot be read or does not fit.
pub fn comparisons(case: &Case, computed: &Computed) -> Result<Vec<Comparison>, CompareError> {
    case.compare.iter().map(|spec| compare(spec, computed)).collect()
}

/// `compare_<n>_<quantity>.csv` and the picture of every comparison with data, counted from 1.
pub(crate) fn files(results: &Results) -> Files {
    let Some(view) = results.views.first() else { return Vec::new() };
    let drawn = results.comparisons.iter().enumerate().filter_map(|(i, comparison)| {
        let stem = format!("compare_{}_{}", i + 1, comparison.spec.against.name());
        let pictures = view.pictures.files(&stem, &plot(view, comparison)?);
        Some(std::iter::once((format!("{stem}.csv"), csv(&comparison.table()))).chain(pictures))
    });
    drawn.flatten().collect()
}

/// Whether a file's name is one that [`files`] gives.
pub(crate) fn is_comparison(_: &str, name: &str) -> bool {
    let stem = name.strip_suffix(".csv").or(Format::stem(name));
    let parts = stem.and_then(|stem| stem.strip_prefix("compare_")).and_then(|rest| rest.split_once('_'));
    parts.is_some_and(|(n, quantity)| n.parse::<usize>().is_ok() && is_quantity(quantity))
}

fn is_quantity(name: &str) -> bool {
    Quantity::ALL.iter().any(|q| q.name() == name) || BandQuantity::ALL.iter().any(|q| q.name() == name)
}

/// The picture of a comparison; `None` without data.
pub fn plot(view: &StageView, comparison: &Comparison) -> Option<Chart> {
    let (panels, notes) = match (&comparison.spec.against, &comparison.found) {
        (Against::Curve(spec), Found::Points(points)) => {
            (over_points(comparison, spec, points), notes_on_points(comparison, spec, points))
        }
        (Against::Band(spec), Found::Band(band)) => {
            (vec![over_band(comparison, spec, band)], notes_on_band(comparison, spec, band))
        }
        _ => return None,
    };
    Some(Chart {
        title: view.titled("computed and reference"),
        legend: String::new(),
        panels,
        notes: notes.into_iter().chain(view.notes()).collect(),
    })
}

/// The difference is drawn up to this many tolerances, where half of the points lie there; what lies beyond is counted in the
/// caption.
const SCALE: f64 = 6.0;

/// Up to where the difference is drawn \[–\].
fn scale(points: &[Point], spec: &CurveSpec) -> f64 {
    let end = SCALE * spec.tolerance;
    let beyond = points.iter().filter_map(Point::difference).filter(|d| d.abs() > end).count();
    if 2 * beyond > points.len() { f64::INFINITY } else { end }
}

/// Reference as circles, computed as a line; the relative difference within its tolerance below.
fn over_points(comparison: &Comparison, spec: &CurveSpec, Points(points): &Points) -> Vec<Panel> {
    let curve = &comparison.curve;
    let (x, y) = comparison.axes();
    let tolerance = rounded(100.0 * spec.tolerance);
    let ends = ends(points.iter().map(|p| p.x).chain(curve.iter().map(|p| p.0)));
    let level = |label: Option<String>, value: f64| Series {
        label,
        points: vec![(ends.low, value), (ends.high, value)],
        look: Look::Line { color: GREY, width: 1.6, dash: &[6.0, 4.0] },
    };
    let references = points.iter().map(|p| (p.x, p.reference)).collect();
    let differences: Vec<_> = points
        .iter()
        .filter_map(|p| Some((p.x, 100.0 * p.difference()?)))
        .filter(|d| d.1.abs() <= scale(points, spec) * 100.0)
        .collect();
    let above = vec![
        Series::new("Computed", curve.clone(), Look::curve(0)),
        Series::new("Reference", references, Look::Circles { color: color(1) }),
    ];
    let below = vec![
        level(Some(format!("Tolerance ±{tolerance} %")), tolerance),
        level(None, -tolerance),
        Series::silent(differences.clone(), Look::Line { color: BLACK, width: 1.6, dash: &[] }),
        Series::silent(differences, Look::Circles { color: BLACK }),
    ];
    vec![
        Panel { x: x.clone(), y, series: above, scale: Scale::Fit { height: 270.0, least: 0.0 } },
        Panel { x, y: Comparison::difference_axis(), series: below, scale: Scale::Fit { height: 150.0, least: 0.0 } },
    ]
}

/// What was measured, and paler its error: tints of the reference's colour.
const MEASURED: Color = (238, 174, 132);
const ERROR: Color = (249, 224, 206);

/// The band over the whole width, the computed curve on it, and circles where computed values are compared.
fn over_band(comparison: &Comparison, spec: &BandSpec, band: &Band) -> Panel {
    let curve = &comparison.curve;
    let (x, y) = comparison.axes();
    let ends = ends(curve.iter().map(|p| p.0));
    let area = |label: String, Interval { low, high }: Interval, fill| {
        let corners = vec![(ends.low, low), (ends.high, low), (ends.high, high), (ends.low, high)];
        Series::new(label, corners, Look::Area { fill, edge: Some(color(1)) })
    };
    let which = spec.quantity.which();
    let mut series = Vec::new();
    if band.accepted != band.measured {
        let label = format!("Reference with its error, {}", comparison.text(band.accepted));
        series.push(area(label, band.accepted, ERROR));
    }
    series.push(area(format!("Reference {which}, {}", comparison.text(band.measured)), band.measured, MEASURED));
    series.push(Series::new("Computed", curve.clone(), Look::curve(0)));
    if let Some(computed) = band.computed {
        let is_compared = |p: &(f64, f64)| p.1 == computed.low || p.1 == computed.high;
        let compared = match computed.low == computed.high {
            true => curve.iter().copied().rfind(is_compared).into_iter().collect(),
            false => curve.iter().copied().filter(is_compared).collect(),
        };
        let label = format!("Computed {which}, {}", comparison.text(computed));
        series.push(Series::new(label, compared, Look::Circles { color: BLACK }));
    }
    Panel { x, y, series, scale: Scale::Fit { height: 350.0, least: 0.0 } }
}

fn ends(values: impl Iterator<Item = f64>) -> Interval {
    Interval::of(values).unwrap_or(Interval { low: 0.0, high: 1.0 })
}

/// Where the reference comes from, and that a demonstration is one.
fn origin(comparison: &Comparison, columns: &str) -> Vec<String> {
    let Comparison { spec, source, .. } = comparison;
    let file = spec.reference.file_name().unwrap_or_default().to_string_lossy();
    let from = source.as_ref().map_or_else(|| "source not stated".to_owned(), ToString::to_string);
    let demonstration = spec.demonstration.then(|| "A demonstration, not a validation.".to_owned());
    demonstration.into_iter().chain([format!("Reference: {file}, {columns}: {from}.")]).collect()
}

fn notes_on_points(comparison: &Comparison, spec: &CurveSpec, points: &Points) -> Vec<String> {
    let reason = comparison.spec.reason.trim_end_matches('.');
    let mut notes = origin(comparison, &format!("column {}", spec.y));
    notes.push(format!("Tolerance {}: {reason}.", comparison.accepted()));
    if let (Some(point), Some(worst)) = (points.worst(), comparison.worst()) {
        notes.push(format!("Largest difference {worst} at {}.", comparison.place(point)));
    }
    let judged = points.judged().count();
    let missed = points.judged().filter(|p| p.computed.is_none()).count();
    if missed > 0 {
        notes.push(format!("{missed} of {judged} reference points were not reached."));
    }
    if let Some((low, high)) = spec.range {
        notes.push(format!("Judged from {low} to {high} in {}; the other points are shown only.", spec.x));
    }
    let differences = points.0.iter().filter_map(|p| p.difference());
    let beyond: Vec<f64> = differences.filter(|d| d.abs() > scale(&points.0, spec)).collect();
    if let Some(most) = beyond.iter().max_by(|a, b| a.abs().total_cmp(&b.abs())) {
        let (count, most) = (beyond.len(), 100.0 * most);
        notes.push(format!("{count} points lie beyond the scale of the difference, up to {most:+.0} %."));
    }
    if spec.quantity == Quantity::Travel {
        notes.push("The travel is the first at which the force is reached, before its peak.".to_owned());
    }
    notes
}

fn notes_on_band(comparison: &Comparison, spec: &BandSpec, band: &Band) -> Vec<String> {
    let columns = if spec.columns.len() == 1 { "column" } else { "columns" };
    let mut notes = origin(comparison, &format!("{columns} {}", spec.columns.join(", ")));
    notes.push(match (band.computed, comparison.worst()) {
        (Some(computed), Some(worst)) => {
            let widened = if band.accepted == band.measured { "" } else { ", errors of measurement included" };
            let (computed, accepted) = (comparison.text(computed), comparison.accepted());
            format!("Computed {computed}: {worst}; the reference is {accepted}{widened}.")
        }
        _ => "The run ended before the value that is compared.".to_owned(),
    });
    notes.push(format!("Remark: {}.", comparison.spec.reason.trim_end_matches('.')));
    notes
}
