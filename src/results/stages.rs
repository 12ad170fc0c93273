//! List of a case's stages, as a table and as printed lines.

use super::{Files, Results, csv::csv_with_texts};
use crate::assess::largest;
use crate::case::Solution;
use crate::measure::part_height;
use crate::model::{Role, stage::Beginning, tool_sizes};
use crate::plot::fields::step::{HOLDER_FORCE, POLE_HEIGHT, PUNCH_FORCE, THINNEST};
use crate::plot::stop_text;
use crate::solver::solution::{Frame, StageSolution, StepRecord, StopKind};
use crate::table::{Column, Field, Table, Unit, keyed};
use crate::units::Amount;

pub(super) const FILE: &str = "stages.csv";

/// First columns, by which the table is recognised.
pub(super) const HEADERS: &str = "stage,name,stop,";

pub(super) fn folders(list: &str) -> Vec<String> {
    list.lines().skip(1).map(|line| line.split(',').take(2).collect::<Vec<_>>().join("-")).collect()
}

fn lines(solution: &Solution) -> Vec<(&str, &str, Option<&StageSolution>)> {
    let stages = solution.stages.iter().map(Some).chain(std::iter::repeat(None));
    let names = solution.case.stages.iter().map(|stage| stage.name.as_str());
    let lines: Vec<_> = names.zip(stages).map(|(name, s)| (name, s.map_or("not run", stop_text), s)).collect();
    if lines.len() > 1 { lines } else { Vec::new() }
}

fn edge(stage: &StageSolution, last: &StepRecord) -> f64 {
    stage.model.blank.edge_radius() - last.draw_in
}

pub(super) fn files(results: &Results) -> Files {
    let lines = lines(results.solution);
    if lines.is_empty() {
        return Vec::new();
    }
    let extent = results.solution.case.model().extent();
    let of_stage = |value: &dyn Fn(&StageSolution) -> Option<f64>| {
        lines.iter().map(|(.., stage)| stage.and_then(value).unwrap_or(f64::NAN)).collect::<Vec<f64>>()
    };
    let at_end = |value: &dyn Fn(&StepRecord) -> f64| of_stage(&|stage| Some(value(stage.steps.last()?)));
    let edges = of_stage(&|stage| Some(edge(stage, stage.steps.last()?)));
    let field = |field: Field<StepRecord>| field.filled(extent, at_end(&field.value));
    let peaks = |force: fn(&StepRecord) -> f64| of_stage(&|stage| Some(largest(stage, force)));
    let sizes = of_stage(&|stage| Some(2.0 * tool_sizes::extent(stage.model.tool(Role::Punch)?).1));
    let before = std::iter::once(2.0 * results.solution.case.model().blank.length).chain(sizes.iter().copied());
    let ratios = sizes.iter().zip(before).map(|(now, before)| before / now).collect();
    let radius = |role: Role| {
        of_stage(&|stage| stage.model.tool(role)?.profile.corners().map(|arc| arc.radius).reduce(f64::min))
    };
    let formed = |value: fn(&Frame) -> Option<f64>| of_stage(&|stage| value(stage.frames.last()?));
    let rims = formed(|frame| Some(frame.nodes.last()?.thickness));
    let begins = |is: fn(&Beginning) -> bool| {
        results.solution.case.stages.iter().map(|stage| f64::from(u8::from(is(&stage.begin)))).collect()
    };
    let further = results.solution.case.stages.last().map_or(&[][..], |stage| &stage.model.further);
    let further = further.iter().map(|name| {
        let peak = |stage: &StageSolution| Some(stage.further_peaks().find(|(_, other, _)| other == name)?.2);
        let (key, label) = (format!("{}_force_peak", keyed(name)), format!("Largest {name} force"));
        Column::new(key, label, extent.force_unit(), of_stage(&peak))
    });
    let mut columns = vec![
        Column::new("stage", "Stage", Unit::None, (1..=lines.len()).map(|i| i as f64).collect()),
        Column::new("end_time", "Time at the end", Unit::Second, at_end(&|step| step.time)),
        Column::new("travel", "Travel", Unit::Mm, at_end(&|step| step.travel)),
        field(PUNCH_FORCE),
        field(HOLDER_FORCE),
        field(THINNEST),
        Column::new("edge_r", "Distance of the edge from the axis", Unit::Mm, edges),
        field(POLE_HEIGHT),
        Column::new("punch_force_peak", "Largest punch force", extent.force_unit(), peaks(|step| step.punch_force)),
        Column::new("holder_force_peak", "Largest holder force", extent.force_unit(), peaks(|step| step.holder_force)),
        Column::new("punch_width", "Width of the punch", Unit::Mm, sizes),
        Column::new("draw_ratio", "Width before over that of the punch", Unit::None, ratios),
        Column::new("punch_radius", "Smallest radius of the punch", Unit::Mm, radius(Role::Punch)),
        Column::new("die_radius", "Smallest radius of the die", Unit::Mm, radius(Role::Die)),
        Column::new("height", "Height over all", Unit::Mm, formed(part_height)),
        Column::new("rim_thickness", "Thickness of the rim", Unit::Mm, rims),
        Column::new("annealed", "Annealed before", Unit::None, begins(|begin| begin.anneal)),
        Column::new("turned_over", "Turned over before", Unit::None, begins(|begin| begin.turn_over)),
    ];
    columns.extend(further);
    let (names, stops) = lines.iter().map(|(name, stop, _)| (name.to_string(), stop.to_string())).unzip();
    vec![(FILE.to_owned(), csv_with_texts(&Table::new(columns), &[("name", names), ("stop", stops)]))]
}

pub(super) fn printed(solution: &Solution) -> String {
    let lines = lines(solution);
    let width = lines.iter().map(|(name, ..)| name.len()).max().unwrap_or(0);
    let figures = |stage: &StageSolution| {
        let (last, unit) = (stage.steps.last()?, stage.model.extent().force_unit());
        let time = if stage.model.timed { format!("{}, ", Amount::time(last.time)) } else { String::new() };
        let [travel, edge, middle] = [last.travel, edge(stage, last), last.pole_height].map(Amount::place);
        let thin = Amount::thickness(last.thinnest);
        let forces = stage.peaks().map(|(_, name, peak)| format!("{name} at most {}, ", Amount::force(peak, unit)));
        let forces: String = forces.collect();
        Some(format!(": {time}travel {travel}, {forces}thinnest {thin}, edge at {edge}, middle at {middle}"))
    };
    let each = lines.into_iter().enumerate().map(|(i, (name, stop, stage))| {
        let reached = if stage.is_some_and(|stage| stage.stop.kind == StopKind::FullTravel) { " reached" } else { "" };
        format!("{:>2} {name:<width$}  {stop}{reached}{}", i + 1, stage.and_then(figures).unwrap_or_default())
    });
    each.collect::<Vec<_>>().join("\n")
}
