//! Edge of a hole or of a tube: its expansion against what the sheet's edge bears.

use super::*;
use crate::model::tool_sizes::full_mouth;

/// Time \[s\] and travel \[mm\] at which the hole of a stage comes to the limit of its edge, between two steps in proportion.
pub(super) fn reached(stage: &StageSolution) -> Option<[f64; 2]> {
    let limit = stage.model.blank.edge_limit?.expansion;
    let used = |step: &StepRecord| step.edge_expansion(&stage.model.blank) / limit;
    let pair = stage.steps.windows(2).find(|pair| used(&pair[1]) >= 1.0)?;
    let share = ((1.0 - used(&pair[0])) / (used(&pair[1]) - used(&pair[0]))).clamp(0.0, 1.0);
    let between = |value: fn(&StepRecord) -> f64| value(&pair[0]) + share * (value(&pair[1]) - value(&pair[0]));
    Some([between(|step| step.time), between(|step| step.travel)])
}

/// Expansion that the punch asks of a hole's edge, if that is beyond what it bears.
pub(super) fn planned(model: &Model) -> Option<Finding> {
    let (blank, punch) = (&model.blank, model.tool(Role::Punch)?);
    let limit = blank.edge_limit.filter(|_| blank.has_hole() && blank.meridian.is_none() && !model.stop.edge_limit)?;
    let wide = full_mouth(model, punch);
    let [from, to] = [blank.hole, wide].map(|half| Amount::drawn(2.0 * half));
    let warning =
        Finding::warning("planned_edge", "Edge", format!("the punch widens the hole from Ø {from} to Ø {to}, by {{}}"));
    let warning = warning.number(Amount::share(wide / blank.hole - 1.0)).at_most(100.0 * limit.expansion, None);
    warning.source("the case's blank.edge_limit").advice("a larger hole for a lower collar, or two steps").if_beyond()
}

/// Expansion from which on the end of a tube is widened \[–\]: half a percent.
const WIDENED: f64 = 0.005;

pub(super) fn judge(run: &Run) -> Option<Finding> {
    let blank = &run.case.model().blank;
    let is_hole = blank.has_hole() && blank.meridian.is_none();
    if !is_hole && (!blank.is_open() || blank.edge != Edge::Free) {
        return None;
    }
    let (edge, wall) = if is_hole { ("hole goes", "") } else { ("end widens", " at most, at mid-wall") };
    let (_, ratio, widest) = run.peak(|_, stage| {
        let expansions = stage.steps.iter().map(|step| (step.edge_expansion(blank), step.edge_diameter(blank)));
        expansions.max_by(|a, b| a.0.total_cmp(&b.0)).filter(|(ratio, _)| is_hole || *ratio > WIDENED)
    })?;
    let [from, to] = [2.0 * blank.widened_radius(), widest].map(Amount::place);
    let instant = formed(run.stages).find_map(|(i, stage)| Some((i, reached(stage)?[1])));
    let instant = instant.map_or_else(String::new, |(i, travel)| {
        run.of_stage(format!("it cracks at {} of travel", Amount::place(travel)), i)
    });
    let text = joined([format!("the {edge} from Ø {from} to Ø {to}{wall}, expansion ratio {{}}"), instant], "; ");
    let finding = Finding::judged("edge", "Edge", text).number(Amount::share(ratio));
    let Some(limit) = blank.edge_limit else {
        let advice = "write `blank.edge_limit` = { expansion = \"60 %\", scatter = \"10 %\" } with the hole expansion ratio of \
                      this sheet and edge, measured by ISO 16630";
        return Some(finding.light(Light::Grey).limit("that of the edge, not in the case").advice(advice));
    };
    let finding = finding.at_most(100.0 * (limit.expansion - limit.scatter), 100.0 * limit.expansion);
    let advice = "ream the hole, or turn its burr to the punch, and give the ratio of such an edge; two steps, the edge \
                  annealed between; a larger hole for a lower collar";
    Some(finding.source("the case's blank.edge_limit, less its scatter").advice(advice))
}
