//! A later stage in a line.

use crate::model::stage::Stage;
use crate::model::{Mode, Motion};
use crate::units::rounded;

/// What happens in a stage.
pub(super) fn describe(stage: &Stage) -> String {
    let Stage { model, begin, .. } = stage;
    let mut does = Vec::new();
    does.extend(begin.trim.map(|half| format!("cut at {} mm", super::size(model.geometry, half))));
    does.extend(begin.anneal.then(|| "annealed".to_owned()));
    for tool in &model.tools {
        let (name, new) = (tool.role.name(), if begin.meets.contains(&tool.role) { "new " } else { "" });
        does.push(match &tool.motion {
            Motion::Path(way) if way.x == 0.0 => format!("{new}{name} goes {} mm", rounded(way.y)),
            Motion::Path(way) => {
                format!("{new}{name} goes {} mm and {} mm aside", rounded(way.y), rounded(way.x))
            }
            Motion::Pressed(press) => {
                let unit = model.extent().force_unit().symbol();
                format!("{new}{name} presses with {:.0} {unit} at the end", press.force.at(model.travel))
            }
            Motion::Fixed | Motion::Gap(_) | Motion::Travel => format!("{new}{name} stands"),
        });
    }
    does.extend(model.release.map(|_| "tools taken away".to_owned()));
    let mode = match model.mode {
        Mode::Flow => None,
        Mode::ElastoViscoplastic => Some("elasto-viscoplastic".to_owned()),
        Mode::Elastic => Some("elastic".to_owned()),
    };
    let time = model.timed.then(|| format!("{} s", rounded(model.duration)));
    let how: Vec<String> = mode.into_iter().chain(time).collect();
    does.extend((!how.is_empty()).then(|| how.join(", ")));
    does.join("; ")
}
