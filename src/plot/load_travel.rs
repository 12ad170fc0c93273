//! Forces over the punch travel, or the gas pressure over the height of the dome.

use super::*;
use crate::measure;
use crate::model::Edge;
use crate::plot::{axis::capitalised, fields::step::*};

const NEAR: f64 = 2.0;
const FEED_FORCE: &str = "Feed force on the tube's wall";
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
        let peak = steps.iter().zip(view.stage.working_force()).max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((peak, largest)) = peak.filter(|(_, force)| *force > 0.0) {
            let text = format!("peak {} at {}", Amount::force(largest, unit), Amount::place(peak.travel));
            panel.annotations.push(Annotation::flag(text, (peak.travel, largest)));
            if let Some((press, rating)) = view.case.and_then(|case| Some((&case.press, case.press.force?))) {
                let of = if press.drive.is_some() { "Permitted by the drive, nominal force" } else { "Press rating," };
                let label = format!("{of} {}", Amount::given_force(rating, unit));
                let most = |step: &StepRecord| press.permitted(view.model().travel - step.travel).unwrap_or(rating);
                let line = steps.iter().map(|step| (step.travel, most(step)));
                let line: Vec<_> = line.filter(|(_, force)| *force <= NEAR * largest).collect();
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
    let is_fed = model.blank.edge == Edge::Fed && model.tool(Role::Punch).is_none();
    let (over, y, fields) = if view.is_by_gas() {
        (POLE_HEIGHT, PRESSURE.axis(extent), vec![PRESSURE])
    } else {
        let acts = |field: &Field<StepRecord>| steps.iter().any(|step| (field.value)(step) != 0.0);
        let punch = [PUNCH_FORCE].into_iter().filter(|force| model.worker().further().is_none() || acts(force));
        let fields: Vec<_> = punch.chain([HOLDER_FORCE, PAD_FORCE, EDGE_FORCE].into_iter().filter(acts)).collect();
        let several = fields.len() > 1 || !model.further.is_empty();
        let own = if is_fed { Axis::named(FEED_FORCE, extent.force_unit()) } else { PUNCH_FORCE.axis(extent) };
        let y = if several { Axis::named("Force", extent.force_unit()) } else { own };
        (if model.travel > 0.0 { TRAVEL } else { TIME }, y, fields)
    };
    let curve = |(i, field): (usize, &Field<StepRecord>)| {
        let label = if is_fed && field.key == PUNCH_FORCE.key { FEED_FORCE } else { field.label(extent) };
        Series::new(label, over.against(field, steps), Style::curve(i))
    };
    let further = view.stage.further_forces().enumerate().map(|(i, (name, forces))| {
        let points = steps.iter().map(over.value).zip(forces).collect();
        Series::new(format!("{} force", capitalised(name)), points, Style::curve(fields.len() + i))
    });
    let travel = if is_fed { "Feed".into() } else { format!("{} travel", capitalised(model.name_of(model.worker()))) };
    let x = if over.key == TRAVEL.key { Axis::named(travel, Unit::Mm) } else { over.axis(extent) };
    Some(Panel::fit(x, y, height, 0.0).with(further).with(fields.iter().enumerate().map(curve)))
}
