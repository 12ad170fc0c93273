//! End of the run.

use super::*;
use crate::model::tool_sizes::name_on_tube;

pub(super) fn judge(run: &Run) -> Option<Finding> {
    let last = run.stages.last()?;
    let (model, stop) = (&last.model, &last.stop);
    let missed = missed(run, last).filter(|_| stop.kind == StopKind::FullTravel && model.release.is_none());
    let text = match &missed {
        Some(missed) => format!("{stop}, and {missed}"),
        None if stop.kind == StopKind::FullTravel && model.release.is_some() => "tools taken away".into(),
        None => stop.to_string(),
    };
    let light = match stop.kind {
        _ if missed.is_some() => Light::Amber,
        _ if stop.is_complete() => Light::Green,
        // Many a cup leaves its die at the other end.
        StopKind::DrawnThrough | StopKind::Interrupted => Light::Amber,
        _ => Light::Red,
    };
    let stages = 1 + run.case.later().len();
    let at = if stages > 1 { format!("stage {} of {stages}", run.stages.len()) } else { String::new() };
    let closes = last.closing.is_some() && model.tool(Role::Punch).is_none();
    let closing = if closes { "while the holder closes".into() } else { String::new() };
    let judged = Finding::judged("stop", "Run", joined([at, closing, text], ": ")).light(light);
    Some(judged.limit("reaches its end").source("the solver").advice(advice(last)))
}

/// Purpose that a full travel has missed.
fn missed(run: &Run, last: &StageSolution) -> Option<String> {
    let model = &last.model;
    // A redraw that ends before its rim comes leaves a step.
    let went_through = run.stages.iter().any(|stage| stage.stop.kind == StopKind::LeftDie);
    let groove = model.tool(Role::Punch).filter(|punch| model.blank.is_open() && name_on_tube(punch) == "groove");
    if let (Some(_), [.., before, end]) = (groove, &last.frames.last()?.nodes[..]) {
        // Outward from straight down; beyond half a turn it has curled in.
        let turned = (end.r - before.r).atan2(before.z - end.z).to_degrees().rem_euclid(360.0);
        let text = || format!("the end has turned by {}, not by 180°: it is not inside out", Amount::angle(turned));
        return (turned < 180.0).then(text);
    }
    let missed = model.stop.drawn_through && !went_through;
    let text = if model.stop.edge_limit { "the edge limit is not reached" } else { "the cup is not through the die" };
    (missed || model.stop.edge_limit).then(|| text.into())
}

fn advice(last: &StageSolution) -> &'static str {
    match last.stop.kind {
        StopKind::FullTravel if last.model.blank.is_open() => "more travel, or a smaller groove",
        StopKind::FullTravel => "more travel",
        StopKind::Interrupted => "let it run to its end",
        StopKind::Refused => "a value that the solver can take",
        StopKind::Mechanism => {
            "blank.theory = \"bending\"; or a holder with friction, a bead or a clamped edge that pulls the strip tight"
        }
        StopKind::Arched => "a holder that keeps the legs from swinging, a larger gap of punch and die, or less travel",
        StopKind::DrawnThrough => {
            "[stop] drawn_through = true if you want that; else a shorter travel, a larger blank, or a holder with more force"
        }
        StopKind::ToolsClosed if !last.model.further.is_empty() => {
            "another drive or `gap` of the further tool, if the stop names it; else a shorter travel"
        }
        StopKind::ToolsClosed => "a shorter travel, or a larger gap between punch and die",
        StopKind::Creeping => "coarser elements there, a larger solver.min_step; or the shape: the sheet may snap",
        StopKind::NoEquilibrium => "what the stop names; else a finer mesh at the radii (blank.elements)",
        // As wished, or a tear, whose own row advises.
        _ => "",
    }
}

pub(super) fn earlier(model: &Model) -> Option<Finding> {
    let sheet = model.blank.preform.as_ref().filter(|sheet| !sheet.doubt.is_empty())?;
    let text = format!("{}: {}; what comes after it is doubtful", sheet.folder, sheet.doubt);
    let warning = Finding::warning("earlier_run", "Earlier run", text).limit("complete, no red line");
    Some(warning.source("its summary.json").advice("mend that run first"))
}

pub(super) fn remedied(stage: &StageSolution) -> Option<Finding> {
    let [first, last] = [stage.remedied.first()?, stage.remedied.last()?];
    let settings = stage.remedied.iter().filter_map(|(by, _)| by.setting(&stage.model.settings));
    let mut settings: Vec<String> = settings.collect();
    settings.sort_unstable();
    settings.dedup();
    let [from, to] = [first.1[0], last.1[1]].map(Amount::place);
    let text = format!(
        "the case's own settings found no equilibrium everywhere between {from} and {to} of travel; {} took the run past that",
        joined(settings, ", ")
    );
    let advice = "check the numbers there against a run with these settings throughout";
    Some(Finding::warning("remedied", "Other settings", text).source("the solver").advice(advice))
}

pub(super) fn contact_share(stage: &StageSolution) -> Option<Finding> {
    let share = stage.steps.last()?.contact_share;
    let wanted = stage.model.stop.contact_share.filter(|_| stage.stop.kind != StopKind::ContactShare)?;
    let limit = Amount::given_share(wanted);
    let text = format!("{{}} of the sheet lies on its tools at the end, not the {limit} that were to end the run");
    let warning = Finding::warning("contact_share", "Contact", text).number(Amount::share(share));
    let warning = warning.at_least(100.0 * wanted, None).source("the case's stop.contact_share");
    Some(warning.advice("give more time, travel or pressure"))
}
