//! A solved stage as the page draws it.

use crate::film::Strip;
use crate::json::{Numbers, Value, table};
use stampflow::forming_limit::Curve;
use stampflow::measure::events;
use stampflow::message::{Form, Message};
use stampflow::solver::solution::ElementRecord;
use stampflow::{StageSolution, StepRecord};

/// How finely arcs of tools are drawn \[rad\].
const ARC: f64 = 0.03;

/// A column: its name, and its number of a row.
type Column<T> = (&'static str, fn(&T) -> f64);

/// What is written of a step, forces in N or N/mm, lengths in mm.
const STEP: [Column<StepRecord>; 11] = [
    ("travel", |s| s.travel),
    ("punch_force", |s| s.punch_force),
    ("holder_force", |s| s.holder_force),
    ("edge_force", |s| s.edge_force),
    ("draw_in", |s| s.draw_in),
    ("thinnest", |s| s.thinnest),
    ("pole_height", |s| s.pole_height),
    ("pressure", |s| s.pressure),
    ("penetration", |s| s.penetration),
    ("time", |s| s.time),
    ("iterations", |s| s.iterations as f64),
];

/// What is written of an element at the end, stresses in MPa.
const ELEMENT: [Column<ElementRecord>; 9] = [
    ("s0", |e| e.s0),
    ("r", |e| e.r),
    ("z", |e| e.z),
    ("thickness", |e| e.thickness),
    ("strain_meridional", |e| e.strain_meridional),
    ("strain_hoop", |e| e.strain_hoop),
    ("strain_equivalent", |e| e.strain_equivalent),
    ("stress_meridional", |e| e.stress_meridional),
    ("stress_hoop", |e| e.stress_hoop),
];

/// Its curves, its section as it moves, what happens on the way, and why it ended.
pub fn json(name: &str, stage: &StageSolution, strip: Strip, form: Form, numbers: &mut Numbers) -> Value {
    let model = &stage.model;
    let elements = stage.frames.last().map_or(&[][..], |frame| &frame.elements);
    let tools = model.tools.iter().map(|tool| {
        let outline = tool.profile.polyline(ARC).into_iter().flat_map(|point| [point.x, point.y]);
        table! { "role": tool.role.name(), "outline": numbers.put(outline) }
    });
    let tools: Vec<Value> = tools.collect();
    let events = events(stage).into_iter().map(|event| {
        let label = form.tell(event.kind.label());
        table! { "label": label, "travel": event.travel, "force": event.force }
    });
    let events: Vec<Value> = events.collect();
    table! {
        "name": name,
        "forceUnit": model.extent().force_unit().symbol(),
        "travel": model.travel,
        "thickness": model.blank.thickness,
        "length": model.blank.length,
        "isRelease": model.release.is_some(),
        "steps": columns(&STEP, &stage.steps, numbers),
        "end": columns(&ELEMENT, elements, numbers),
        "film": strip.json(&stage.end, numbers),
        "tools": tools,
        "events": events,
        "limit": model.forming_limit.as_ref().map(|curve| limit(curve, form, numbers)),
        "isComplete": stage.stop.is_complete(),
        "why": form.tell(stage.stop.message()),
    }
}

fn columns<T>(fields: &[Column<T>], of: &[T], numbers: &mut Numbers) -> Value {
    Value::Table(fields.iter().map(|(key, value)| (*key, numbers.put(of.iter().map(value)))).collect())
}

/// Minor and major strain of the curve's points.
fn limit(curve: &Curve, form: Form, numbers: &mut Numbers) -> Value {
    let name = Message::from(curve.name);
    table! {
        "name": form.tell(name),
        "points": numbers.put(curve.points().iter().flatten().copied()),
        "endsAt": curve.ends_at(),
    }
}
