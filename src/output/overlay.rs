//! A computed curve over a reference, and their difference below it.

use super::chart::{BLACK, Chart, GREY, Look, Panel, Scale, Series, color};
use super::{Subject, WriteError, csv, png, svg, write};
use crate::compare::{Comparison, Point, Quantity, Verdict};
use crate::quantity::rounded;
use std::path::{Path, PathBuf};

/// Writes `compare_<n>_<quantity>.png` and `.csv` into `dir`; nothing when there are no data.
///
/// # Errors
/// When a file cannot be written.
pub fn write_comparison(
    subject: &Subject,
    n: usize,
    comparison: &Comparison,
    dir: &Path,
) -> Result<Vec<PathBuf>, WriteError> {
    if comparison.verdict == Verdict::NoData {
        return Ok(Vec::new());
    }
    let stem = format!("compare_{n}_{}", comparison.spec.quantity.name());
    let files = [
        (dir.join(format!("{stem}.csv")), csv(&comparison.table())),
        (dir.join(format!("{stem}.png")), png(&svg(&plot(subject, comparison)))),
    ];
    for (path, bytes) in &files {
        write(path, bytes)?;
    }
    Ok(files.map(|(path, _)| path).to_vec())
}

/// Whether a file's name is one that [`write_comparison`] gives.
pub(super) fn is_comparison(name: &str) -> bool {
    let stem = name.strip_suffix(".csv").or(name.strip_suffix(".png"));
    let parts = stem.and_then(|stem| stem.strip_prefix("compare_")).and_then(|rest| rest.split_once('_'));
    parts.is_some_and(|(n, quantity)| n.parse::<usize>().is_ok() && Quantity::ALL.iter().any(|q| q.name() == quantity))
}

/// The difference is drawn up to this many tolerances; what lies beyond is counted in the caption.
const SCALE: f64 = 6.0;

/// Reference as circles, computed as a line; the relative difference within its tolerance below.
pub fn plot(subject: &Subject, comparison: &Comparison) -> Chart {
    let Comparison { spec, points, curve, .. } = comparison;
    let table = comparison.table();
    let (x, y) = comparison.axes();
    let tolerance = rounded(100.0 * spec.tolerance);
    let xs = || points.iter().map(|p| p.x).chain(curve.iter().map(|p| p.0));
    let ends = (xs().fold(f64::INFINITY, f64::min), xs().fold(f64::NEG_INFINITY, f64::max));
    let level = |label: Option<String>, value: f64| Series {
        label,
        points: vec![(ends.0, value), (ends.1, value)],
        look: Look::Line { color: GREY, width: 1.6, dash: &[6.0, 4.0] },
    };
    let references = points.iter().map(|p| (p.x, p.reference)).collect();
    let differences: Vec<_> = points
        .iter()
        .filter_map(|p| Some((p.x, 100.0 * p.difference()?)))
        .filter(|d| d.1.abs() <= SCALE * tolerance)
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
    Chart {
        title: format!("{}: computed and reference", subject.model.title),
        legend: "",
        panels: vec![
            Panel { x: x.clone(), y, series: above, scale: Scale::Fit { height: 270.0, least: 0.0 } },
            Panel {
                x,
                y: table.column("difference").axis(),
                series: below,
                scale: Scale::Fit { height: 150.0, least: 0.0 },
            },
        ],
        notes: notes(comparison).into_iter().chain(subject.notes()).collect(),
    }
}

fn notes(comparison: &Comparison) -> Vec<String> {
    let Comparison { spec, source, .. } = comparison;
    let file = spec.reference.file_name().unwrap_or_default().to_string_lossy();
    let from = source.as_ref().map_or_else(|| "source not stated".to_owned(), ToString::to_string);
    let mut notes = vec![
        format!("Reference: {file}, column {}: {from}.", spec.y),
        format!("Tolerance {} %: {}.", rounded(100.0 * spec.tolerance), spec.reason.trim_end_matches('.')),
    ];
    if let Some((point, difference)) = comparison.worst().and_then(|p| Some((p, p.difference()?))) {
        notes.push(format!("Largest difference {:+.1} % at {}.", 100.0 * difference, comparison.place(point)));
    }
    let judged = comparison.judged().count();
    let missed = comparison.judged().filter(|p| p.computed.is_none()).count();
    if missed > 0 {
        notes.push(format!("{missed} of {judged} reference points were not reached."));
    }
    if let Some((low, high)) = spec.range {
        notes.push(format!("Judged from {low} to {high} in {}; the other points are shown only.", spec.x));
    }
    let off = |p: &&Point| p.difference().is_some_and(|d| d.abs() > SCALE * spec.tolerance);
    let beyond: Vec<_> = comparison.points.iter().filter(off).collect();
    if let Some(difference) = beyond.iter().filter_map(|p| p.difference()).max_by(|a, b| a.abs().total_cmp(&b.abs())) {
        let (count, most) = (beyond.len(), 100.0 * difference);
        notes.push(format!("{count} points lie beyond the scale of the difference, up to {most:+.0} %."));
    }
    if spec.quantity == Quantity::Travel {
        notes.push("The travel is the first at which the force is reached, before its peak.".to_owned());
    }
    notes
}
