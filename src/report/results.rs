//! What came out, stage by stage: the summary's lines, of a release its spring-back, and every plot of a stage.

use super::document::{Block, Picture, Row, Section};
use super::solved::Report;
use super::solver::figures;
use crate::output::summary::Group;
use crate::output::{Make, OUTPUTS, StageView, springback, svg};
use crate::units::four_digits;

pub(super) fn sections(report: &Report) -> Vec<Section> {
    let stages = report.stages.iter().enumerate();
    stages
        .map(|(i, (view, summary))| {
            let part = figures(summary, |group| matches!(group, Group::End | Group::Part));
            let blocks = std::iter::once(part).chain(released(view)).chain(plots(view));
            Section { heading: format!("{}Results", report.stage(i)), blocks: blocks.collect() }
        })
        .collect()
}

/// Every plot of a stage.
fn plots(view: &StageView) -> Vec<Block> {
    let plots = OUTPUTS.iter().filter_map(|output| {
        let Make::Plot(make) = output.make else { return None };
        let name = output.stem().to_owned();
        Some(Block::Picture(Picture { name, caption: output.about.to_owned(), svg: svg(&make(view)?) }))
    });
    plots.collect()
}

/// What was measured before and after, of a stage that takes its tools away.
fn released(view: &StageView) -> Option<Block> {
    let number = |value: Option<f64>| value.map_or_else(|| "none".to_owned(), four_digits);
    let rows = springback::changes(view.stage)?.into_iter().map(|c| {
        let [a, b, d] = [c.before, c.after, c.change()].map(number);
        Row::plain([c.quantity.label.to_owned(), a, b, d, c.quantity.unit.symbol().to_owned()])
    });
    Some(Block::Table { head: vec!["Spring-back", "Before", "After", "Change", "Unit"], rows: rows.collect() })
}
