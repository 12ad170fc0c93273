//! Forces over the punch travel, or the gas pressure over the height of the dome.

use super::*;
use crate::assess::on_ram;
use crate::measure;
use crate::model::Edge;
use crate::plot::{axis::capitalised, fields::step::*};

const NEAR: f64 = 2.0;
const ON_WALL: &str = "of it on the tube's wall";
const ON_RAM: &str = "Force of all tools on the ram";
const RATING: Style = Style::Line { color: BLACK, width: 1.4, dash: &[7.0, 3.0, 1.5, 3.0] };

pub(crate) fn plot(view: &StageView) -> Option<Chart> {
    let mut panel = panel(view, 350.0)?;
    let mut notes = Vec::new();
    if view.model().travel > 0.0 {
        let unit = view.extent().force_unit();
        let events = measure::events(view.stage).into_iter().map(|event| {
            let text = format!("{}, {}", event.kind.label(view.model()), Amount::place(event.travel));
            Annotation::flag(text, (event.travel, event.force))
        });
        panel = panel.annotated(events);
        let steps = &view.stage.steps;
        let forces = view.stage.working_force();
        let peak = steps.iter().zip(&forces).max_by(|a, b| a.1.total_cmp(b.1));
        if let Some((peak, &largest)) = peak.filter(|(_, force)| **force > 0.0) {
            let text = format!("peak {} at {}", Amount::force(largest, unit), Amount::place(peak.travel));
            panel.annotations.push(Annotation::flag(text, (peak.travel, largest)));
            let on_ram = on_ram(view.stage);
            let largest = on_ram.iter().copied().fold(largest, f64::max);
            if let Some((press, rating)) = view.case.and_then(|case| Some((&case.press, case.press.force?))) {
                let of = if press.drive.is_some() { "Permitted by the drive, nominal force" } else { "Press rating," };
                let label = format!("{of} {}", Amount::given_force(rating, unit));
                let most = |step: &StepRecord| press.permitted(view.model().travel - step.travel).unwrap_or(rating);
                let line = steps.iter().map(|step| (step.travel, most(step)));
                let line: Vec<_> = line.filter(|(_, force)| *force <= NEAR * largest).collect();
                if on_ram != forces {
                    let points = steps.iter().map(|step| step.travel).zip(on_ram).collect();
                    panel = panel.with([Series::new(ON_RAM, points, Style::solid(BLACK, 1.8))]);
                }
                if !line.is_empty() {
                    panel = panel.with([Series::new(label, line, RATING)]);
                } else {
                    notes.push(format!("{label}: above the picture."));
                }
            }
        }
    }
    Some(view.chart(if view.is_by_gas() { "pressure" } else { "forces" }, vec![panel], notes))
}

pub(super) fn panel(view: &StageView, height: f64) -> Option<Panel> {
    let (extent, steps) = (view.extent(), &view.stage.steps);
    steps.first().filter(|_| view.model().release.is_none())?;
    let model = view.model();
    let is_fed = model.blank.edge == Edge::Fed;
    let (over, y, fields) = if view.is_by_gas() {
        (POLE_HEIGHT, PRESSURE.axis(extent), vec![PRESSURE])
    } else {
        let acts = |field: &Field<StepRecord>| steps.iter().any(|step| (field.value)(step) != 0.0);
        let punch = [PUNCH_FORCE].into_iter().filter(|force| model.worker().further().is_none() || acts(force));
        let fields: Vec<_> = punch.chain([HOLDER_FORCE, PAD_FORCE, EDGE_FORCE].into_iter().filter(acts)).collect();
        let several = fields.len() > 1 || !model.further.is_empty();
        let y = Axis::named(if several { "Force" } else { model.force_label() }, extent.force_unit());
        (if model.travel > 0.0 { TRAVEL } else { TIME }, y, fields)
    };
    let curve = |(i, field): (usize, &Field<StepRecord>)| {
        let label = match field.key == PUNCH_FORCE.key {
            true if is_fed => ON_WALL.into(),
            true => format!("{} force", capitalised(model.name_of(Role::Punch))),
            false => field.label(extent).into(),
        };
        Series::new(label, over.against(field, steps), Style::curve(i))
    };
    let further = view.stage.further_forces().enumerate().map(|(i, (name, forces))| {
        let points = steps.iter().map(over.value).zip(forces).collect();
        Series::new(format!("{} force", capitalised(name)), points, Style::curve(fields.len() + i))
    });
    let travel = || Axis::named(capitalised(&view.progress()), Unit::Mm);
    let x = if over.key == TRAVEL.key { travel() } else { over.axis(extent) };
    let fed = steps.iter().map(over.value).zip(view.stage.working_force()).collect();
    let fed = is_fed.then(|| Series::new(model.force_label(), fed, Style::curve(fields.len())));
    Some(Panel::fit(x, y, height, 0.0).with(further).with(fed).with(fields.iter().enumerate().map(curve)))
}
