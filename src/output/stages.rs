//! One line for every stage of a sequence: `stages.csv` and what is printed.

use super::csv::with_texts;
use super::file::{WriteError, write};
use super::{ended, force_unit};
use crate::model::{Geometry, Model};
use crate::solution::{StageSolution, Stop};
use crate::table::{Column, Table, Unit};
use std::path::{Path, PathBuf};

/// The file of a sequence.
pub const STAGES: &str = "stages.csv";

/// A stage of a sequence: its name, and its model and run where it was run.
pub type Line<'a> = (&'a str, Option<(&'a Model, &'a StageSolution)>);

/// The folder of a stage, counted from 0, inside that of its case.
pub fn stage_folder(number: usize, name: &str) -> String {
    format!("{}-{name}", number + 1)
}

/// Where every stage ended; NaN for those that were not run.
pub fn stages_table(geometry: Geometry, lines: &[Line]) -> Table {
    let force = force_unit(geometry);
    let column = |key, label, unit, value: fn(&Model, &StageSolution) -> Option<f64>| {
        let of = |line: &Line| line.1.and_then(|(model, run)| value(model, run)).unwrap_or(f64::NAN);
        Column::new(key, label, unit, lines.iter().map(of).collect())
    };
    Table::new(vec![
        Column::new("stage", "Stage", Unit::None, (1..=lines.len()).map(|i| i as f64).collect()),
        column("end_time", "Time at the end", Unit::Second, |_, run| Some(run.steps.last()?.time)),
        column("travel", "Travel", Unit::Mm, |_, run| Some(run.steps.last()?.travel)),
        column("punch_force", "Punch force", force, |_, run| Some(run.steps.last()?.punch_force)),
        column("holder_force", "Holder force", force, |_, run| Some(run.steps.last()?.holder_force)),
        column("thinnest", "Least thickness", Unit::Mm, |_, run| Some(run.steps.last()?.thinnest)),
        column("edge_r", "Distance of the edge from the axis", Unit::Mm, |model, run| {
            Some(model.blank.length - run.steps.last()?.draw_in)
        }),
        column("pole_height", "Height of the middle", Unit::Mm, |_, run| Some(run.steps.last()?.pole_height)),
    ])
}

/// How a stage ended, in a few words.
fn stop(line: &Line) -> &'static str {
    line.1.map_or("not run", |(model, run)| ended(model, &run.stop))
}

/// Writes [`STAGES`] into a folder.
///
/// # Errors
/// As [`write()`].
pub fn write_stages(geometry: Geometry, lines: &[Line], dir: &Path) -> Result<PathBuf, WriteError> {
    let names = lines.iter().map(|line| line.0.to_owned()).collect();
    let stops = lines.iter().map(|line| stop(line).to_owned()).collect();
    let path = dir.join(STAGES);
    write(&path, &with_texts(&[("name", names), ("stop", stops)], &stages_table(geometry, lines)))?;
    Ok(path)
}

/// One printed line for every stage.
pub fn stages_report(geometry: Geometry, lines: &[Line]) -> String {
    let unit = force_unit(geometry).symbol();
    let width = lines.iter().map(|line| line.0.len()).max().unwrap_or(0);
    let text = lines.iter().enumerate().map(|(i, line)| {
        let last = line.1.and_then(|(model, run)| Some((model, run.steps.last()?)));
        let figures = last.map_or(String::new(), |(model, last)| {
            format!(
                ": {:.3} s, travel {:.2} mm, punch {:.0} {unit}, holder {:.0} {unit}, thinnest {:.4} mm, edge at {:.2} \
                 mm, middle at {:.2} mm",
                last.time,
                last.travel,
                last.punch_force,
                last.holder_force,
                last.thinnest,
                model.blank.length - last.draw_in,
                last.pole_height
            )
        });
        let reached = line.1.is_some_and(|(_, run)| run.stop == Stop::FullTravel);
        let reached = if reached { " reached" } else { "" };
        format!("{:>2} {:<width$}  {}{reached}{figures}\n", i + 1, line.0, stop(line))
    });
    text.collect()
}
