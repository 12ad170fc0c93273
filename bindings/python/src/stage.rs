//! A stage and its frames, part by part.

use super::column::{Column, columns};
use super::words::plain;
use pyo3::prelude::*;
use stampflow::output::profile;
use stampflow::table::{Column as Named, Unit};
use stampflow::{StageSolution, Table};

/// Name, why it ended in a few words and as a sentence, whether that is as wished, iterations, and how many frames it kept.
pub type StageParts = (String, &'static str, String, bool, usize, usize);

/// Time [s], travel [mm], elements and nodes.
pub type FrameParts<'py> = (f64, f64, Vec<Column<'py>>, Vec<Column<'py>>);

/// A stage that was run.
pub fn parts(name: &str, stage: &StageSolution) -> StageParts {
    let iterations = stage.steps.iter().map(|step| step.iterations).sum();
    let stop = &stage.stop;
    (name.to_owned(), stop.kind(), plain(stop), stop.is_complete(), iterations, stage.frames.len())
}

/// What was kept of an instant.
pub fn frame<'py>(py: Python<'py>, stage: &StageSolution, i: usize) -> Option<FrameParts<'py>> {
    let kept = stage.frames.get(i..=i)?;
    let mut elements = profile::table(&stage.model, kept);
    elements.columns.remove(0); // the travel, of all alike
    let node = |key, label, unit, value: fn(&stampflow::solver::solution::NodeRecord) -> f64| {
        Named::new(key, label, unit, kept[0].nodes.iter().map(value).collect())
    };
    let nodes = Table::new(vec![
        node("r", "Distance from the axis", Unit::Mm, |node| node.r),
        node("z", "z, along punch travel", Unit::Mm, |node| node.z),
        node("theta", "Rotation of the fibre", Unit::None, |node| node.theta),
        node("thickness", "Thickness", Unit::Mm, |node| node.thickness),
    ]);
    Some((kept[0].time, kept[0].travel, columns(py, elements), columns(py, nodes)))
}
