//! The pictures of a scatter: how the numbers that decide lie to their limits, bands of the curves, and what decides.

use super::{scatter_bands, scatter_indices};
use crate::plot::chart::{BLACK, Chart, GREY, Look, Panel, Scale, Series, color, pale};
use crate::study::scatter::{Found, Grids, Spread, deciding};
use crate::table::{Column, Unit};

/// Bars of a histogram: few enough for a hundred runs.
const BARS: usize = 24;

/// A limit is drawn where it is no further from the values than so many times their width.
const NEAR: f64 = 1.5;

/// Each picture by the stem of its file.
pub fn pictures(found: &Found, grids: &Grids, name: &str) -> Vec<(&'static str, Chart)> {
    let histograms = histograms(found, name);
    let load = found.load.as_ref().map(|band| scatter_bands::load(band, grids.force, name));
    let thickness = found.thickness.as_ref().map(|band| scatter_bands::thickness(band, name));
    let all = [
        histograms.map(|chart| ("scatter", chart)),
        load.map(|chart| ("load_band", chart)),
        thickness.map(|chart| ("thickness_band", chart)),
        scatter_indices::chart(found, name).map(|chart| ("influence", chart)),
    ];
    all.into_iter().flatten().map(|(stem, chart)| (stem, chart.displayed())).collect()
}

fn histograms(found: &Found, name: &str) -> Option<Chart> {
    let mut panels: Vec<Panel> = deciding(found).into_iter().map(panel).collect();
    let first = panels.first_mut()?;
    let entries = [("Amber from here on", AMBER), ("Red from here on", RED), ("The case as it stands", OWN)];
    first.series.extend(entries.map(|(label, look)| Series::new(String::from(label), Vec::new(), look)));
    let title = format!("{name}: {what}", what = found.sentence());
    Some(Chart { title: title.to_string(), legend: String::new(), panels, notes: notes(found) })
}

/// What stands below the pictures.
fn notes(found: &Found) -> Vec<String> {
    vec![found.sentences().into_iter().map(|sentence| sentence.to_string() + ".").collect::<Vec<_>>().join(" ")]
}

/// The limits, and the case as it stands.
const AMBER: Look = Look::Line { color: (230, 159, 0), width: 2.4, dash: &[9.0, 4.0] };
const RED: Look = Look::Line { color: (213, 94, 0), width: 2.4, dash: &[] };
const OWN: Look = Look::Line { color: BLACK, width: 1.6, dash: &[2.5, 3.0] };

fn panel(spread: &Spread) -> Panel {
    let number = &spread.number;
    let (low, high) = (spread.values[0], spread.values[spread.values.len() - 1]);
    let width = (high - low) / BARS as f64;
    let mut shares = [0.0; BARS];
    for value in &spread.values {
        shares[(((value - low) / width) as usize).min(BARS - 1)] += 100.0 / spread.values.len() as f64;
    }
    let bars = shares.iter().enumerate().filter(|(_, share)| **share > 0.0).map(|(i, share)| {
        let (from, to) = (low + i as f64 * width, low + (i + 1) as f64 * width);
        let outline = vec![(from, 0.0), (to, 0.0), (to, *share), (from, *share)];
        Series::silent(outline, Look::Area { fill: pale(color(0)), edge: Some(GREY) })
    });
    let mut series: Vec<Series> = bars.collect();
    let top = 1.08 * shares.iter().copied().fold(0.0, f64::max);
    let mut upright = |at: Option<f64>, look: Look| {
        let at = at.filter(|at| *at > low - NEAR * (high - low) && *at < high + NEAR * (high - low));
        series.extend(at.map(|at| Series::silent(vec![(at, 0.0), (at, top)], look)));
    };
    upright(number.limits.and_then(|limits| limits.amber), AMBER);
    upright(number.limits.and_then(|limits| limits.red), RED);
    upright(Some(number.value), OWN);
    let ends = series.iter().flat_map(|series| &series.points).map(|point| point.0);
    let (from, to) = ends.fold((low, high), |(from, to), x| (from.min(x), to.max(x)));
    let margin = 0.03 * (to - from);
    let x = Column::new("number", number.label, number.unit, Vec::new()).axis();
    let y = Column::new("share", "Share of parts", Unit::Percent, Vec::new()).axis();
    Panel { x, y, series, scale: Scale::Window { height: 170.0, x: (from - margin, to + margin), y: (0.0, top) } }
}
