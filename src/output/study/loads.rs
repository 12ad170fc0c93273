//! Load curves of a study of one axis, dark to light as its value rises.

use crate::plot::chart::{Chart, Look, Panel, Scale, Series};
use crate::plot::viridis::viridis;
use crate::study::Results;
use crate::table::{Axis, Unit};

/// Curves in the legend at most; others are drawn without a word.
const NAMED: usize = 8;
/// How far up the map colours go \[–\]: the lightest ones are lost on paper.
const LIGHTEST: f64 = 0.9;
const DASHES: [&[f64]; 2] = [&[], &[9.0, 4.0]];

/// The punch force \[N, or N/mm\] over the travel \[mm\] of each design, in the order of the designs; nothing where none has a
/// curve or the study is not of one axis.
pub fn loads(results: &Results, curves: &[Vec<(f64, f64)>]) -> Option<Chart> {
    let [axis] = results.axes.as_slice() else { return None };
    let unit = results.numbers().find(|(_, number)| number.key == "punch_force")?.1.amount.unit;
    let mut order: Vec<usize> = (0..axis.values.len().min(curves.len())).collect();
    order.sort_by(|&a, &b| axis.values[a].total_cmp(&axis.values[b]));
    order.retain(|&i| curves[i].len() > 1);
    let last = order.len().checked_sub(1)?;
    // Both ends, and those between at even steps.
    let named = |n: usize| last < NAMED || (0..NAMED).any(|k| (k * last + (NAMED - 1) / 2) / (NAMED - 1) == n);
    let series = order.iter().enumerate().map(|(n, &i)| {
        let share = LIGHTEST * n as f64 / last.max(1) as f64;
        let look = Look::Line { color: viridis(share), width: 2.0, dash: DASHES[n % DASHES.len()] };
        let label = named(n).then(|| axis.told(axis.values[i]).to_string());
        Series { label, points: curves[i].clone(), look }
    });
    Some(
        Chart {
            title: format!("{}: {}", String::from(axis.message()), String::from("load curves")),
            legend: String::from(axis.message()),
            panels: vec![Panel {
                x: Axis::named("Punch travel", Unit::Mm),
                y: Axis::named("Punch force", unit),
                series: series.collect(),
                scale: Scale::Fit { height: 400.0, least: 0.0 },
            }],
            notes: Vec::new(),
        }
        .displayed(),
    )
}
