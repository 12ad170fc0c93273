//! A later stage in a line.

use super::line::size_of;
use crate::message::{Amount, Message, message};
use crate::model::stage::Stage;
use crate::model::{Mode, Motion};

/// What happens in a stage.
pub(super) fn describe(stage: &Stage) -> Message {
    let Stage { model, begin, .. } = stage;
    let mut does = Vec::new();
    does.extend(begin.trim.map(|half| message!("cut at {size}", size = size_of(model, half, Amount::set))));
    does.extend(begin.anneal.then(|| "annealed".into()));
    for tool in &model.tools {
        let name = tool.role.name();
        let tool_name = match begin.meets.contains(&tool.role) {
            true => message!("new {tool}", tool = name),
            false => name.into(),
        };
        does.push(match &tool.motion {
            Motion::Path(way) if way.x == 0.0 => {
                message!("{tool} goes {way}", tool = tool_name, way = Amount::size(way.y))
            }
            Motion::Path(way) => message!(
                "{tool} goes {way} and {aside} aside",
                tool = tool_name,
                way = Amount::size(way.y),
                aside = Amount::size(way.x)
            ),
            Motion::Pressed(press) => message!(
                "{tool} presses with {force} at the end",
                tool = tool_name,
                force = Amount::force(press.force.at(model.travel), model.extent().force_unit())
            ),
            Motion::Fixed | Motion::Gap(_) | Motion::Travel => message!("{tool} stands", tool = tool_name),
        });
    }
    does.extend(model.release.map(|_| "tools taken away".into()));
    let mode = match model.mode {
        Mode::Flow => Message::default(),
        Mode::ElastoViscoplastic => "elasto-viscoplastic".into(),
        Mode::Elastic => "elastic".into(),
    };
    let time = if model.timed { Amount::time(model.duration).into() } else { Message::default() };
    does.push(Message::joined([mode, time], ", "));
    Message::joined(does, "; ")
}
