//! Hardening laws beside the tension tests that they are fitted to, and how sure the chosen one is beyond their end.

use crate::plot::chart::{BLACK, Chart, GREY, Look, Panel, Scale, Series, color};
use crate::study::fit::{FlowCurve, LawFit, LawFits};
use crate::table::{Column, Unit};
use crate::units::joined;

const POINTS: usize = 160;
/// How far the picture goes, over the end of the points \[–\].
const BEYOND: f64 = 2.0;
/// No more points of a test are drawn: they would cover each other.
const DRAWN: usize = 120;

/// Points, laws and the interval of the one to use above, what it misses the points by below.
pub fn fit_law(fits: &LawFits) -> Chart {
    let strain = Column::new("strain_plastic", "True plastic strain", Unit::None, Vec::new());
    let stress = Column::new("true_stress", "True stress", Unit::MPa, Vec::new());
    let miss = Column::new("miss", "Law less point", Unit::MPa, Vec::new());
    let notes = fits.tests.iter().map(FlowCurve::sentence).map(|sentence| sentence.to_string()).collect();
    let chart = Chart {
        title: format!("{law} fitted to {files}", law = fits.best().kind.label(), files = files(fits)),
        legend: String::new(),
        panels: vec![
            Panel {
                x: strain.axis(),
                y: stress.axis(),
                series: above(fits),
                scale: Scale::Fit { height: 330.0, least: 10.0 },
            },
            Panel {
                x: strain.axis(),
                y: miss.axis(),
                series: misses(fits),
                scale: Scale::Fit { height: 210.0, least: 1.0 },
            },
        ],
        notes,
    };
    chart.displayed()
}

fn files(fits: &LawFits) -> String {
    let name = |test: &FlowCurve| String::from(test.short_name().to_owned());
    joined(fits.tests.iter().map(name), ", ")
}

fn above(fits: &LawFits) -> Vec<Series> {
    let (best, end) = (fits.best(), fits.end());
    let rates = rates(fits);
    let strains: Vec<f64> = (0..=POINTS).map(|i| BEYOND * end * i as f64 / POINTS as f64).collect();
    let curve = |fit: &LawFit, rate| strains.iter().map(|&e| (e, fit.band(e, rate).0)).collect::<Vec<_>>();
    let first = rates.first().copied().flatten();
    let band: Vec<(f64, f64, f64)> =
        strains.iter().filter_map(|&e| best.band(e, first).1.map(|half| (e, best.band(e, first).0, half))).collect();
    let mut series = Vec::new();
    if !band.is_empty() {
        let side = |sign: f64| band.iter().map(move |(e, s, half)| (*e, s + sign * half));
        let outline = side(-1.0).chain(side(1.0).rev()).collect();
        let look = Look::Area { fill: crate::plot::chart::pale(color(0)), edge: None };
        series.push(Series::new(String::from("Its interval of 95 %, from scatter alone"), outline, look));
    }
    for (i, fit) in fits.fits.iter().filter(|fit| fit.kind != best.kind).enumerate() {
        series.push(Series::new(String::from(fit.kind.label()), curve(fit, first), thin(Look::curve(i + 1))));
    }
    for (i, rate) in rates.iter().enumerate() {
        let label = match rate {
            Some(rate) => format!("{law} at {rate} /s", law = best.kind.label(), rate = crate::units::rounded(*rate)),
            None => String::from(best.kind.label()),
        };
        let look = if i == 0 { Look::curve(0) } else { Look::curve(fits.fits.len() + i) };
        series.push(Series::new(label, curve(best, *rate), look));
    }
    let others: Vec<(f64, f64)> = fits.tests.iter().flat_map(left_out).collect();
    if !others.is_empty() {
        series.push(Series::new(String::from("Points that are left out"), others, Look::Dots { color: GREY }));
    }
    let several = fits.tests.len() > 1;
    for (i, test) in fits.tests.iter().enumerate() {
        let points = thinned(test.points.iter().map(|p| (p.strain, p.stress)));
        let label = if several { test.short_name().to_owned() } else { String::from("Points") };
        series.push(Series::new(
            label,
            points,
            if i == 0 { Look::Dots { color: BLACK } } else { Look::Triangles { color: color(i) } },
        ));
    }
    series.push(Series::new(String::from("end of the points"), vec![(end, best.band(end, first).0)], Look::Flag));
    series
}

/// The rates of the tests that were fitted to, each once.
fn rates(fits: &LawFits) -> Vec<Option<f64>> {
    let mut rates: Vec<f64> = fits.fitted().filter_map(|test| test.rate).collect();
    rates.sort_by(f64::total_cmp);
    rates.dedup();
    match fits.best().rate {
        Some(_) => rates.into_iter().map(Some).collect(),
        None => vec![None],
    }
}

fn misses(fits: &LawFits) -> Vec<Series> {
    let best = fits.best();
    let points: Vec<_> = fits.fitted().flat_map(|test| &test.points).collect();
    let found = thinned(points.iter().zip(&best.misses).map(|(point, miss)| (point.strain, *miss)));
    let mut series =
        vec![Series::silent(vec![(0.0, 0.0), (fits.end(), 0.0)], Look::Line { color: GREY, width: 1.2, dash: &[] })];
    let scatter: Option<Vec<(f64, f64)>> = points.iter().map(|p| p.scatter.map(|s| (p.strain, s))).collect();
    if let Some(scatter) = scatter.filter(|_| fits.fitted().count() == 1) {
        let low = scatter.iter().rev().map(|(e, s)| (*e, -s));
        let outline = scatter.iter().copied().chain(low).collect();
        let look = Look::Area { fill: crate::plot::chart::PALE, edge: None };
        series.insert(0, Series::new(String::from("Standard deviation of the points"), outline, look));
    }
    series.push(Series::silent(found, Look::Dots { color: BLACK }));
    series
}

/// The points of a test that are left out, but for its elastic line, which is no line here.
fn left_out(test: &FlowCurve) -> Vec<(f64, f64)> {
    let first = test.points.first().map_or(0.0, |point| point.strain);
    thinned(test.others.iter().filter(|p| p.strain > 0.5 * first).map(|p| (p.strain, p.stress)))
}

/// The same line, for what stands beside.
fn thin(look: Look) -> Look {
    match look {
        Look::Line { color, dash, .. } => Look::Line { color, dash, width: 1.3 },
        other => other,
    }
}

/// So many of the points, evenly.
fn thinned(points: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let all: Vec<(f64, f64)> = points.collect();
    let every = all.len().div_ceil(DRAWN).max(1);
    all.into_iter().step_by(every).collect()
}
