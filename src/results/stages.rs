//! List of a case's stages, as a table and as printed lines.

use super::csv::csv_with_texts;
use super::{Files, Results};
use crate::case::Solution;
use crate::plot::stop_text as ended;
use crate::solver::solution::{StageSolution, StepRecord, Stop};
use crate::table::fields::step::{HOLDER_FORCE, POLE_HEIGHT, PUNCH_FORCE, THINNEST};
use crate::table::{Column, Field, Table, Unit};
use crate::units::{Amount, joined};

/// Name of the table.
pub(super) const FILE: &str = "stages.csv";

/// First columns, by which the table is recognised.
pub(super) const HEADERS: &str = "stage,name,stop,";

/// Folders of the stages in a table: `1-draw`.
pub(super) fn folders(list: &str) -> Vec<String> {
    let label = |line: &str| {
        line.split_once(',').map(|(i, rest)| format!("{i}-{}", rest.split(',').next().unwrap_or_default()))
    };
    list.lines().skip(1).filter_map(label).collect()
}

/// Names of all stages, and the solutions of those that were run.
fn lines(solution: &Solution) -> impl Iterator<Item = (&str, Option<&StageSolution>)> {
    solution.case.stage_names().enumerate().map(|(i, name)| (name, solution.stages.get(i)))
}

/// State at the end of every stage; NaN for those that were not run.
fn table(solution: &Solution) -> Table {
    let extent = solution.case.model().extent();
    let at_end = |value: &dyn Fn(&StageSolution, &StepRecord) -> f64| {
        let of = |stage: &StageSolution| Some(value(stage, stage.steps.last()?));
        lines(solution).map(|(_, stage)| stage.and_then(of).unwrap_or(f64::NAN)).collect::<Vec<f64>>()
    };
    let field = |field: Field<StepRecord>| field.filled(extent, at_end(&|_, step| (field.value)(step)));
    let edge = at_end(&|stage, step| stage.model.blank.length - step.draw_in);
    Table::new(vec![
        Column::new("stage", "Stage", Unit::None, (1..=lines(solution).count()).map(|i| i as f64).collect()),
        Column::new("end_time", "Time at the end", Unit::Second, at_end(&|_, step| step.time)),
        Column::new("travel", "Travel", Unit::Mm, at_end(&|_, step| step.travel)),
        field(PUNCH_FORCE),
        field(HOLDER_FORCE),
        field(THINNEST),
        Column::new("edge_r", "Distance of the edge from the axis", Unit::Mm, edge),
        field(POLE_HEIGHT),
    ])
}

fn stop(stage: Option<&StageSolution>) -> &'static str {
    stage.map_or("not run", ended)
}

/// Makes [`FILE`] of a case with several stages.
pub(super) fn files(results: &Results) -> Files {
    let solution = results.solution;
    if lines(solution).nth(1).is_none() {
        return Vec::new();
    }
    let names = lines(solution).map(|(name, _)| name.to_owned()).collect();
    let stops = lines(solution).map(|(_, stage)| stop(stage).to_owned()).collect();
    vec![(FILE.to_owned(), csv_with_texts(&table(solution), &[("name", names), ("stop", stops)]))]
}

/// One printed line per stage; empty if there is one only.
pub(super) fn printed(solution: &Solution) -> String {
    if lines(solution).nth(1).is_none() {
        return String::new();
    }
    let width = lines(solution).map(|(name, _)| name.len()).max().unwrap_or(0);
    let each = lines(solution).enumerate().map(|(i, (name, stage))| {
        let ended = match stage {
            Some(stage) if stage.stop == Stop::FullTravel => format!("{} reached", ended(stage)),
            stage => stop(stage).to_owned(),
        };
        let figures = stage.and_then(figures).unwrap_or_default();
        format!("{:>2} {name:<width$}  {}", i + 1, joined([ended, figures], ": "))
    });
    each.collect::<Vec<_>>().join("\n")
}

/// Main numbers at the end of a stage.
fn figures(stage: &StageSolution) -> Option<String> {
    let last = stage.steps.last()?;
    let unit = stage.model.extent().force_unit();
    let time = if stage.model.timed { format!("{}, ", Amount::time(last.time)) } else { String::new() };
    Some(format!(
        "{time}travel {}, punch {}, holder {}, thinnest {}, edge at {}, middle at {}",
        Amount::place(last.travel),
        Amount::force(last.punch_force, unit),
        Amount::force(last.holder_force, unit),
        Amount::thickness(last.thinnest),
        Amount::place(stage.model.blank.length - last.draw_in),
        Amount::place(last.pole_height)
    ))
}
