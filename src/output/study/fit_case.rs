//! Measured curves beside the run that a fit begins with and the one that it ends with.

use crate::plot::chart::{BLACK, Chart, GREY, Look, Panel, Scale, Series, color};
use crate::study::fit::{CaseFit, Matched};
use crate::table::{Column, Unit};
use crate::units::joined;

/// A picture for each curve: points and both runs above, what the fitted run misses the points by below.
pub fn fit_case(fit: &CaseFit) -> Vec<Chart> {
    fit.matched.iter().map(|matched| chart(fit, matched)).collect()
}

fn chart(fit: &CaseFit, matched: &Matched) -> Chart {
    let [x, y] = matched.axes.clone();
    let points = |used: bool| {
        let of = matched.points.iter().filter(|p| p.computed.is_some() == used);
        of.map(|p| (p.x, p.reference)).collect::<Vec<_>>()
    };
    // As far as the runs go, so that both panels have one axis.
    let runs = matched.before.iter().chain(&matched.after).map(|p| p.0);
    let end = matched.points.iter().map(|p| p.x).chain(runs).fold(0.0, f64::max);
    let mut above = vec![
        Series::new(String::from("Run at the start"), matched.before.clone(), Look::curve(1)),
        Series::new(String::from("Fitted run"), matched.after.clone(), Look::curve(0)),
        Series::new(matched.name.clone(), points(true), Look::Circles { color: BLACK }),
    ];
    if matched.left_out > 0 {
        above.push(Series::new(String::from("Points that are left out"), points(false), Look::Circles { color: GREY }));
    }
    let size = matched.points.iter().map(|p| p.reference.abs()).sum::<f64>() / matched.points.len() as f64;
    let misses: Vec<(f64, f64)> =
        matched.points.iter().filter_map(|p| Some((p.x, 100.0 * (p.computed? - p.reference) / size))).collect();
    let below = vec![
        Series::silent(vec![(0.0, 0.0), (end, 0.0)], Look::Line { color: GREY, width: 1.2, dash: &[] }),
        Series::silent(misses.clone(), Look::Line { color: color(0), width: 1.2, dash: &[] }),
        Series::silent(misses, Look::Circles { color: BLACK }),
    ];
    let miss = Column::new("miss", "Run less point", Unit::Percent, Vec::new());
    let keys = fit.estimates.all.iter().map(|estimate| {
        let estimate = estimate.clone().displayed();
        let error = estimate.told_error().map_or_else(String::new, |error| format!(" ± {error}"));
        String::from(format!("{} = {}{error} {}", estimate.key, estimate.told(), estimate.unit).trim_end().to_owned())
    });
    let chart = Chart {
        title: format!("Fitted to {file}", file = matched.name),
        legend: String::new(),
        panels: vec![
            Panel { x: x.clone(), y, series: above, scale: Scale::Fit { height: 300.0, least: 0.0 } },
            Panel { x, y: miss.axis(), series: below, scale: Scale::Fit { height: 200.0, least: 0.5 } },
        ],
        notes: vec![
            joined(keys, "; ").to_string(),
            String::from("What the run misses is told over the mean height of the curve."),
        ],
    };
    chart.displayed()
}
