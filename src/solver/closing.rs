//! Distance between holder and die: the blocks that keep it, and the closing of a holder that cannot lie on the flat sheet.
//!
//! The holder closes before the punch moves, up to the force of the start of the draw or to the fixed gap.

use super::*;
use crate::model::StopRules;
use crate::solver::solution::Closing;

/// Closing travel over the thickness up to which holder and die lie on the flat sheet \[–\].
const LIES: f64 = 0.1;
/// Overtravel into the closed sheet over the thickness \[–\]: any force is reached there.
const SQUEEZE: f64 = 0.05;
/// Least distance of holder and die over the sheet thickness \[–\].
const APART: f64 = 0.5;

/// Travel of a model's holder from the flat sheet until it is one thickness, or the held gap, from the die \[mm\]; `None` where
/// both lie on the flat sheet, where the holder has no force, and where they do not meet over the blank.
pub fn closing_way(model: &Model) -> Option<f64> {
    let (holder, die) = (model.tool(Role::Holder)?, model.tool(Role::Die)?);
    let apart = match &holder.motion {
        Motion::Gap(gap) => *gap,
        Motion::Pressed(press) if !press.is_idle() => model.blank.thickness,
        _ => return None,
    };
    let way = holder.profile.rise_until(&die.profile, apart);
    let (distance, at) = holder.profile.distance_to(&die.profile, Point::new(0.0, way));
    let meets = distance < (1.0 + LIES) * apart && at.x < model.blank.length;
    let held = !matches!(model.blank.edge, Edge::Pulled { .. });
    (meets && held && model.release.is_none() && way > LIES * model.blank.thickness).then_some(way)
}

/// Move of the holder from the flat sheet to its blocks, relative to the die \[mm\]; `None` without a holder.
pub(super) fn block_height(model: &Model) -> Option<f64> {
    let (holder, apart) = (model.tool(Role::Holder)?, APART * model.blank.thickness);
    let on_die = model.tool(Role::Die).map(|die| holder.profile.rise_until(&die.profile, apart));
    Some(on_die.unwrap_or(model.blank.thickness - apart))
}

pub(super) fn close(model: &Model, way: f64, observer: &mut dyn Observer) -> StageSolution {
    let apart = closing_model(model, way);
    let solution = run_from(&apart, State::initial(&apart, mesh::nodes(&apart)), &mut Unseen(observer));
    let last = solution.steps.last().copied().unwrap_or_default();
    let closing = Closing { way, gap: (way - last.travel).max(0.0), force: last.holder_force };
    StageSolution { closing: Some(closing), ..solution }
}

/// The model with the preload of its springs at the closed holder.
pub(super) fn closed(model: &Model, way: f64) -> Model {
    let mut model = model.clone();
    for tool in model.tools.iter_mut().filter(|tool| tool.role == Role::Holder) {
        if let Motion::Pressed(press) = &mut tool.motion {
            press.force = press.force.raised(press.stiffness * way);
        }
    }
    model
}

fn closing_model(model: &Model, way: f64) -> Model {
    let mut model = model.clone();
    model.tools.retain(|tool| !matches!(tool.role, Role::Punch | Role::Pad));
    let (mut force, mut travel) = (None, way);
    for tool in model.tools.iter_mut().filter(|tool| tool.role == Role::Holder) {
        if let Motion::Pressed(press) = &tool.motion {
            force = Some(press.force.at(0.0)).filter(|force| *force > 0.0);
            travel = way + SQUEEZE * model.blank.thickness;
        }
        tool.motion = Motion::Path(Point::new(0.0, travel));
    }
    model.stop = StopRules { localised: model.stop.localised, holder_force: force, ..StopRules::default() };
    (model.travel, model.duration, model.schedule) = (travel, travel / model.speed, None);
    model.frames = vec![model.duration];
    (model.beads, model.gas, model.forming_limit) = (Vec::new(), Vec::new(), None);
    model.heat.iter_mut().for_each(|heat| heat.flow = None);
    model
}

pub(super) struct Unseen<'a>(pub &'a mut dyn Observer);

impl Observer for Unseen<'_> {
    fn wants_to_stop(&mut self) -> bool {
        self.0.wants_to_stop()
    }
}
