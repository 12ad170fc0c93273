//! What decides: a bar for each thing that scatters, the longest on top; Sobol indices with their intervals, or rank
//! correlations.

use crate::plot::chart::{BLACK, Chart, Look, Panel, Scale, Series, color, pale};
use crate::study::scatter::{Found, Index, Spread, called, deciding};
use crate::table::{Axis, Column, Unit};

/// Bars of a panel at most.
const MOST: usize = 10;

/// Height of a bar with its room \[px of a picture 800 wide\].
const ROW: f64 = 34.0;

/// Half of a bar, of 1 from bar to bar.
const HALF: f64 = 0.34;

const TOTAL: fn() -> Look = || Look::Area { fill: pale(color(0)), edge: None };
const FIRST: fn() -> Look = || Look::Area { fill: color(0), edge: None };
const INTERVAL: Look = Look::Line { color: BLACK, width: 1.6, dash: &[] };

pub(super) fn chart(found: &Found, name: &str) -> Option<Chart> {
    let mut panels: Vec<Panel> = deciding(found).into_iter().filter_map(|spread| panel(found, spread)).collect();
    let has_indices = found.numbers.iter().any(|spread| spread.influence.indices.is_some());
    let entries: &[(&str, Look)] = match has_indices {
        true => &[("Alone", FIRST()), ("With others", TOTAL()), ("Interval of 95 %", INTERVAL)],
        false => &[],
    };
    let first = panels.first_mut()?;
    first.series.extend(entries.iter().map(|(label, look)| Series::new(String::from(*label), Vec::new(), *look)));
    let name = name.to_owned();
    let title = match has_indices {
        true => format!("{name}: what decides (Sobol indices)"),
        false => format!("{name}: what goes with what (rank correlations)"),
    };
    Some(Chart { title: title.to_string(), legend: String::new(), panels, notes: Vec::new() })
}

/// A bar with its intervals.
struct Bar<'a> {
    key: &'a str,
    lengths: Vec<(f64, Look)>,
    intervals: Vec<(f64, f64)>,
}

impl Bar<'_> {
    fn series(&self, row: usize) -> Vec<Series> {
        let y = row as f64;
        let bars = self.lengths.iter().map(|(end, look)| {
            Series::silent(vec![(0.0, y - HALF), (*end, y - HALF), (*end, y + HALF), (0.0, y + HALF)], *look)
        });
        // Beside each other, the one of the first bar below.
        let intervals = self.intervals.iter().enumerate().map(|(i, (low, high))| {
            let y = y + HALF * (i as f64 - 0.5);
            Series::silent(vec![(*low, y), (*high, y)], INTERVAL)
        });
        bars.chain(intervals).collect()
    }
}

/// The bars of a number, the longest on top.
fn panel(found: &Found, spread: &Spread) -> Option<Panel> {
    let (mut bars, what, least) = match &spread.influence.indices {
        Some(indices) => (of_indices(found, indices), "share of its variance", 0.0),
        None => (of_ranks(found, &spread.influence.ranks), "rank correlation", -1.0),
    };
    bars.truncate(MOST);
    bars.reverse();
    let names = bars.iter().map(|bar| called(bar.key).to_string()).collect();
    let x = Axis::shared(&[
        &Column::new("number", spread.number.label, Unit::None, Vec::new()),
        &Column::new("what", what, Unit::None, Vec::new()),
    ]);
    let rows = bars.len() as f64;
    let scale = Scale::Window { height: ROW * rows + 12.0, x: (least, 1.02), y: (-0.6, rows - 0.4) };
    let series = bars.iter().enumerate().flat_map(|(row, bar)| bar.series(row)).collect();
    (!bars.is_empty()).then(|| Panel { x, y: Axis::of_names("", names), series, scale })
}

fn of_indices<'a>(found: &'a Found, indices: &[Index]) -> Vec<Bar<'a>> {
    let mut order: Vec<(&String, &Index)> = found.groups.iter().zip(indices).collect();
    order.sort_by(|a, b| b.1.total.value.total_cmp(&a.1.total.value));
    let within = |share: f64| share.clamp(0.0, 1.0);
    let bar = |(key, Index { first, total }): (&'a String, &Index)| Bar {
        key,
        lengths: vec![(within(total.value), TOTAL()), (within(first.value), FIRST())],
        intervals: [first, total].map(|index| (within(index.low), within(index.high))).to_vec(),
    };
    order.into_iter().map(bar).collect()
}

fn of_ranks<'a>(found: &'a Found, ranks: &[Option<f64>]) -> Vec<Bar<'a>> {
    let known = found.factors.iter().zip(ranks).filter_map(|(key, rank)| Some((key, (*rank)?)));
    let mut order: Vec<(&String, f64)> = known.collect();
    order.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    let bar = |(key, rank): (&'a String, f64)| Bar { key, lengths: vec![(rank, FIRST())], intervals: Vec::new() };
    order.into_iter().map(bar).collect()
}
