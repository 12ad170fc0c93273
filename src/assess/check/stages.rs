//! A later stage in a line.

use super::line::size_of;
use crate::model::stage::Stage;
use crate::model::{Mode, Motion};
use crate::units::{Amount, joined};

/// What happens in a stage.
pub(super) fn describe(stage: &Stage) -> String {
    let Stage { model, begin, .. } = stage;
    let mut does = Vec::new();
    does.extend(begin.trim.map(|half| format!("cut at {size}", size = size_of(model, half, Amount::set))));
    does.extend(begin.anneal.then(|| "annealed".into()));
    for tool in &model.tools {
        let name = tool.role.name();
        let tool_name = match begin.meets.contains(&tool.role) {
            true => format!("new {name}"),
            false => name.into(),
        };
        does.push(match &tool.motion {
            Motion::Path(way) if way.x == 0.0 => {
                format!("{tool_name} goes {way}", way = Amount::size(way.y))
            }
            Motion::Path(way) => format!(
                "{tool_name} goes {way} and {aside} aside",
                way = Amount::size(way.y),
                aside = Amount::size(way.x)
            ),
            Motion::Pressed(press) => format!(
                "{tool_name} presses with {force} at the end",
                force = Amount::force(press.force.at(model.travel), model.extent().force_unit())
            ),
            Motion::Fixed | Motion::Gap(_) | Motion::Travel => format!("{tool_name} stands"),
        });
    }
    does.extend(model.release.map(|_| "tools taken away".into()));
    let mode = match model.mode {
        Mode::Flow => String::new(),
        Mode::ElastoViscoplastic => "elasto-viscoplastic".into(),
        Mode::Elastic => "elastic".into(),
    };
    let time = if model.timed { Amount::time(model.duration).into() } else { String::new() };
    does.push(joined([mode, time], ", "));
    joined(does, "; ")
}
