//! A solved stage as the page draws it.

use crate::film::Film;
use serde_json::{Map, Value, json};
use stampflow::forming_limit::Curve;
use stampflow::measure::events;
use stampflow::solver::solution::{ElementRecord, Frame};
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

/// Curves, the section as it moves, events, and why the stage ended.
pub fn json(name: &str, stage: &StageSolution, mut frames: Vec<Frame>) -> Value {
    let model = &stage.model;
    frames.push(stage.end.frame(model));
    let elements = stage.frames.last().map_or(&[][..], |frame| &frame.elements);
    let tools = model.tools.iter().map(|tool| {
        let outline: Vec<f64> = tool.profile.polyline(ARC).into_iter().flat_map(|point| [point.x, point.y]).collect();
        json!({ "role": tool.role.name(), "outline": outline })
    });
    let events = events(stage)
        .into_iter()
        .map(|event| json!({ "label": event.kind.label().to_string(), "travel": event.travel, "force": event.force }));
    json!({
        "name": name,
        "forceUnit": model.extent().force_unit().symbol(),
        "travel": model.travel,
        "thickness": model.blank.thickness,
        "length": model.blank.length,
        "isRelease": model.release.is_some(),
        "steps": columns(&STEP, &stage.steps),
        "end": columns(&ELEMENT, elements),
        "film": Film::new(model, &frames),
        "tools": tools.collect::<Vec<_>>(),
        "events": events.collect::<Vec<_>>(),
        "limit": model.forming_limit.as_ref().map(limit),
        "isComplete": stage.stop.is_complete(),
        "why": stage.stop.to_string(),
    })
}

fn columns<T>(fields: &[Column<T>], rows: &[T]) -> Value {
    let column =
        |(key, value): &Column<T>| ((*key).to_owned(), Value::from(rows.iter().map(value).collect::<Vec<f64>>()));
    Value::Object(fields.iter().map(column).collect::<Map<_, _>>())
}

/// Points of the forming limit for a chart \[–\].
fn limit(curve: &Curve) -> Value {
    let minor: Vec<f64> = (-80..=80).map(|i| 0.01 * f64::from(i)).filter(|minor| curve.knows(*minor)).collect();
    let major: Vec<f64> = minor.iter().map(|minor| curve.major_at(*minor)).collect();
    json!({ "name": curve.name, "minor": minor, "major": major, "planeStrain": curve.plane_strain() })
}
