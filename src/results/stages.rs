//! One line for every stage of a sequence: [`FILE`] and what is printed.

use super::csv::with_texts;
use super::{Files, Results};
use crate::case::Solution;
use crate::plot::stage_view::ended;
use crate::solver::solution::{StageSolution, StepRecord, Stop};
use crate::table::fields::step::{HOLDER_FORCE, POLE_HEIGHT, PUNCH_FORCE, THINNEST};
use crate::table::{Column, Field, Table, Unit};
use crate::units::{Amount, joined};

/// The list of a case's stages.
pub(super) const FILE: &str = "stages.csv";

/// What its first line begins with.
pub(super) const HEADERS: &str = "stage,name,stop,";

/// The folders of the stages that a list names: `1-draw`.
pub(super) fn folders(list: &str) -> Vec<String> {
    let label = |line: &str| {
        line.split_once(',').map(|(i, rest)| format!("{i}-{}", rest.split(',').next().unwrap_or_default()))
    };
    list.lines().skip(1).filter_map(label).collect()
}

/// Names of all stages, with those that were run.
fn lines(solution: &Solution) -> impl Iterator<Item = (&str, Option<&StageSolution>)> {
    solution.case.stage_names().enumerate().map(|(i, name)| (name, solution.stages.get(i)))
}

/// Where every stage ended; NaN for those that were not run.
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

/// How a stage ended, in a few words.
fn stop(stage: Option<&StageSolution>) -> &'static str {
    stage.map_or("not run", ended)
}

/// [`FILE`], of a case with several stages.
pub(super) fn files<'a>(results: &'a Results<'a>) -> Files<'a> {
    let solution = results.solution;
    let several = lines(solution).nth(1).is_some();
    Box::new(several.then_some(()).into_iter().map(|()| {
        let names = lines(solution).map(|line| line.0.to_owned()).collect();
        let stops = lines(solution).map(|line| stop(line.1).to_owned()).collect();
        (FILE.to_owned(), with_texts(&[("name", names), ("stop", stops)], &table(solution)))
    }))
}

/// One printed line for every stage; nothing where there is one only.
pub(super) fn printed(solution: &Solution) -> String {
    if lines(solution).nth(1).is_none() {
        return String::new();
    }
    let width = lines(solution).map(|line| line.0.len()).max().unwrap_or(0);
    let each = lines(solution).enumerate().map(|(i, (name, stage))| {
        let name = String::from(format!("{:>2} {name:<width$}  ", i + 1));
        let ended = match stage {
            Some(stage) if stage.stop == Stop::FullTravel => format!("{end} reached", end = ended(stage)),
            stage => stop(stage).into(),
        };
        let figures = stage.and_then(figures).unwrap_or_default();
        joined([name, joined([ended, figures], ": ")], "")
    });
    joined(each, "\n")
}

/// Where a stage ended, in its main numbers.
fn figures(stage: &StageSolution) -> Option<String> {
    let last = stage.steps.last()?;
    let unit = stage.model.extent().force_unit();
    let time = if stage.model.timed { Amount::time(last.time).into() } else { String::new() };
    let figures = format!(
        "travel {travel}, punch {punch}, holder {holder}, thinnest {thinnest}, edge at {edge}, middle at {middle}",
        travel = Amount::place(last.travel),
        punch = Amount::force(last.punch_force, unit),
        holder = Amount::force(last.holder_force, unit),
        thinnest = Amount::thickness(last.thinnest),
        edge = Amount::place(stage.model.blank.length - last.draw_in),
        middle = Amount::place(last.pole_height)
    );
    Some(joined([time, figures], ", "))
}
