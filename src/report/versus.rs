//! The case beside others: pictures of all runs, and the table of their differences.

use super::document::{Block, Picture, Row, Section, word};
use crate::output::study::versus::pictures;
use crate::results::Chart;
use crate::study::versus::{COLUMNS, Versus};

/// Of a case that others stand against.
pub(super) fn section(versus: &Versus) -> Section {
    let legend = versus.legend().into_iter().map(|entry| String::from(entry));
    let mut blocks = vec![Block::List(legend.collect()), table(versus)];
    blocks.extend(pictures(versus, false).into_iter().map(|drawn| {
        let chart = Chart { title: String::new(), ..drawn.chart };
        Block::Picture(Picture { name: drawn.stem.replace('_', "-"), caption: String::from(drawn.about), chart })
    }));
    Section { heading: String::from("Compared"), blocks }
}

fn table(versus: &Versus) -> Block {
    let mut rows = Vec::new();
    for line in versus.lines() {
        let label = String::from(line.label);
        for (i, (said, member)) in line.of_runs.into_iter().zip(&versus.members).enumerate() {
            let value = said.light.map_or_else(|| String::from(said.value), |light| word(light));
            let first = if i == 0 { label.clone() } else { String::new() };
            rows.push(Row::plain([first, member.mark.clone(), value, String::from(said.change)]));
        }
    }
    Block::table(COLUMNS, rows)
}
