//! How the numbers were found: mesh, steps, norms; and what the solver and the check warn of.

use super::Report;
use super::document::{Block, Row, Section};
use crate::output::Figure;

/// Lines of the summary that are about the solution; the others are about the part.
const KEYS: [&str; 17] = [
    "imbalance",
    "cutoff_share",
    "penetration",
    "flips",
    "strain_increment",
    "mesh",
    "bending_share",
    "point_share",
    "corrector",
    "steps",
    "iterations",
    "velocity_norm",
    "residual_norm",
    "rejected",
    "wall_time",
    "moment_error",
    "sticking",
];

/// Whether a line of the summary is about the solution.
pub(super) fn is_ours(figure: &Figure) -> bool {
    KEYS.contains(&figure.key) || figure.key.starts_with("steps_")
}

pub(super) fn section(report: &Report) -> Section {
    let mut blocks = Vec::new();
    for (i, (_, summary)) in report.stages.iter().enumerate() {
        let stage = report.stage(i);
        if !stage.is_empty() {
            blocks.push(Block::Paragraph(format!("Stage {}", stage.trim_end_matches(": "))));
        }
        blocks.push(figures(summary.figures().filter(is_ours)));
    }
    Section { heading: "Solver".into(), blocks }
}

/// A table of the summary's lines; what belongs to the line above is indented.
pub(super) fn figures(figures: impl Iterator<Item = Figure>) -> Block {
    let row = |f: Figure| {
        let label = f.label.trim_start();
        let indent = "\u{2003}".repeat((f.label.len() - label.len()) / 2);
        Row::plain([format!("{indent}{label}"), f.value, f.unit.to_owned()])
    };
    Block::Table { head: vec!["Quantity", "Value", "Unit"], rows: figures.map(row).collect() }
}

/// What the check says before and the solver after the run.
pub(super) fn warnings(report: &Report) -> Section {
    let runs = report.stages.iter().enumerate();
    let of_runs = runs.flat_map(|(i, (view, _))| view.warnings.iter().map(move |w| format!("{}{w}", report.stage(i))));
    let all: Vec<String> = report.check.warnings.iter().cloned().chain(of_runs).collect();
    let none = || Block::Paragraph("None.".into());
    let block = if all.is_empty() { none() } else { Block::List(all) };
    Section { heading: "Warnings".into(), blocks: vec![block] }
}
