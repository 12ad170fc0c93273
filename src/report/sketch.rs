//! Section at the start with its dimensions, of every stage that brings tools of its own.

use super::Report;
use super::page::{Section, figure, table};
use super::sizes::dimensions;
use crate::model::{Model, Tool};
use crate::plot::{Dimension, dimensioned};
use crate::solver::solution::{Frame, StageSolution};
use maud::html;

/// One section per stage with tools that no stage before it had.
pub(super) fn sections(report: &Report) -> Vec<Section> {
    let (case, stages) = (&report.solution.case, &report.solution.stages);
    let mut sections = vec![section("Section".to_owned(), case.model(), None, &report.dimensions)];
    for (i, stage) in stages.iter().enumerate().skip(1).filter(|(i, stage)| brings_tools(&stages[..*i], stage)) {
        let start = stage.start.as_ref();
        let heading = report.stage(i) + "section";
        sections.push(section(heading, &stage.model, start, &dimensions(&stage.model, start)));
    }
    sections
}

fn brings_tools(before: &[StageSolution], stage: &StageSolution) -> bool {
    let known = |tool: &Tool| before.iter().flat_map(|stage| &stage.model.tools).any(|t| t.profile == tool.profile);
    stage.model.release.is_none() && stage.model.tools.iter().any(|tool| !known(tool))
}

fn section(heading: String, model: &Model, start: Option<&Frame>, dimensions: &[Dimension]) -> Section {
    let rows = dimensions.iter().map(|dimension| {
        let (value, unit) = dimension.amount.parts();
        [dimension.name.clone(), value, unit.to_owned()]
    });
    let chart = dimensioned(format!("{heading} at the start"), model, start, dimensions);
    let content = html! {
        (figure(&chart, "the section at the start with its dimensions"))
        (table(&["Dimension", "Value", "Unit"], rows))
    };
    Section::new(heading, content)
}
