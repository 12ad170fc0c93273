//! List of a case's stages, as a table and as printed lines.

use super::csv::csv_with_texts;
use super::{Files, Results};
use crate::case::Solution;
use crate::plot::fields::step::{HOLDER_FORCE, POLE_HEIGHT, PUNCH_FORCE, THINNEST};
use crate::plot::stop_text;
use crate::solver::solution::{StageSolution, StepRecord, StopKind};
use crate::table::{Column, Field, Table, Unit};
use crate::units::Amount;

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

/// Names of all stages, and the solutions of those that were run; none of a case with one stage.
fn lines(solution: &Solution) -> Vec<(&str, Option<&StageSolution>)> {
    let names = solution.case.stage_names().enumerate();
    let lines: Vec<_> = names.map(|(i, name)| (name, solution.stages.get(i))).collect();
    if lines.len() > 1 { lines } else { Vec::new() }
}

fn edge(stage: &StageSolution, last: &StepRecord) -> f64 {
    stage.model.blank.length - last.draw_in
}

fn stop(stage: Option<&StageSolution>) -> &'static str {
    stage.map_or("not run", stop_text)
}

/// Makes [`FILE`] of a case with several stages: the state at the end of each, empty for those that were not run.
pub(super) fn files(results: &Results) -> Files {
    let lines = lines(results.solution);
    if lines.is_empty() {
        return Vec::new();
    }
    let extent = results.solution.case.model().extent();
    let at_end = |value: &dyn Fn(&StageSolution, &StepRecord) -> f64| {
        let of = |stage: &StageSolution| Some(value(stage, stage.steps.last()?));
        lines.iter().map(|(_, stage)| stage.and_then(of).unwrap_or(f64::NAN)).collect::<Vec<f64>>()
    };
    let field = |field: Field<StepRecord>| field.filled(extent, at_end(&|_, step| (field.value)(step)));
    let table = Table::new(vec![
        Column::new("stage", "Stage", Unit::None, (1..=lines.len()).map(|i| i as f64).collect()),
        Column::new("end_time", "Time at the end", Unit::Second, at_end(&|_, step| step.time)),
        Column::new("travel", "Travel", Unit::Mm, at_end(&|_, step| step.travel)),
        field(PUNCH_FORCE),
        field(HOLDER_FORCE),
        field(THINNEST),
        Column::new("edge_r", "Distance of the edge from the axis", Unit::Mm, at_end(&edge)),
        field(POLE_HEIGHT),
    ]);
    let (names, stops) = lines.iter().map(|(name, stage)| ((*name).to_owned(), stop(*stage).to_owned())).unzip();
    vec![(FILE.to_owned(), csv_with_texts(&table, &[("name", names), ("stop", stops)]))]
}

/// One printed line per stage with the main numbers at its end; empty if there is one only.
pub(super) fn printed(solution: &Solution) -> String {
    let lines = lines(solution);
    let width = lines.iter().map(|(name, _)| name.len()).max().unwrap_or(0);
    let figures = |stage: &StageSolution| {
        let (last, unit) = (stage.steps.last()?, stage.model.extent().force_unit());
        let time = if stage.model.timed { format!("{}, ", Amount::time(last.time)) } else { String::new() };
        let forces = [last.punch_force, last.holder_force].map(|force| Amount::force(force, unit));
        let places = [last.travel, edge(stage, last), last.pole_height].map(Amount::place);
        let ([travel, edge, middle], [punch, holder], thin) = (places, forces, Amount::thickness(last.thinnest));
        Some(format!(
            ": {time}travel {travel}, punch {punch}, holder {holder}, thinnest {thin}, edge at {edge}, middle at {middle}"
        ))
    };
    let each = lines.into_iter().enumerate().map(|(i, (name, stage))| {
        let reached = if stage.is_some_and(|stage| stage.stop.kind == StopKind::FullTravel) { " reached" } else { "" };
        format!("{:>2} {name:<width$}  {}{reached}{}", i + 1, stop(stage), stage.and_then(figures).unwrap_or_default())
    });
    each.collect::<Vec<_>>().join("\n")
}
