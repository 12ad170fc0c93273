//! The section at the start with its dimensions, drawn and in a table, of every stage that brings tools of its own.

use super::document::{Block, Picture, Row, Section};
use super::sizes::dimensions;
use super::solved::Report;
use crate::model::{Model, Tool};
use crate::results::{Dimension, dimensioned};
use crate::solver::solution::{Frame, StageSolution};

/// A section for each stage with tools that no stage before it had.
pub(super) fn sections(report: &Report) -> Vec<Section> {
    let (case, stages) = (&report.solution.case, &report.solution.stages);
    let first = section("section", String::from("Section"), case.model(), None, &report.dimensions);
    let later = stages.iter().enumerate().skip(1).filter(|(i, stage)| brings_tools(&stages[..*i], stage));
    let later = later.map(|(i, stage)| {
        let dimensions = dimensions(&stage.model, stage.start.as_ref());
        let heading = report.stage(i) + &String::from("section");
        section(&format!("section-{}", i + 1), heading, &stage.model, stage.start.as_ref(), &dimensions)
    });
    std::iter::once(first).chain(later).collect()
}

/// Whether a stage has a tool that none before it had.
fn brings_tools(before: &[StageSolution], stage: &StageSolution) -> bool {
    let known = |tool: &Tool| before.iter().flat_map(|stage| &stage.model.tools).any(|t| t.profile == tool.profile);
    stage.model.release.is_none() && stage.model.tools.iter().any(|tool| !known(tool))
}

fn section(name: &str, heading: String, model: &Model, start: Option<&Frame>, dimensions: &[Dimension]) -> Section {
    let rows = dimensions.iter().map(|d| {
        let (value, unit) = d.amount.parts();
        Row::plain([String::from(d.name()), value, unit.to_owned()])
    });
    let title = format!("{heading} at the start");
    let chart = dimensioned(String::from(title), model, start, dimensions);
    let caption = String::from("the section at the start with its dimensions");
    let table = Block::table(["Dimension", "Value", "Unit"], rows.collect());
    Section { blocks: vec![Block::Picture(Picture { name: name.to_owned(), caption, chart }), table], heading }
}
