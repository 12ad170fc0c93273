//! A solved stage as the page draws it.

use crate::film::{Picture, film, picture};
use serde_json::{Value, json};
use stampflow::StageSolution;
use stampflow::forming_limit::Curve;
use stampflow::measure::events;

/// How finely arcs of tools are drawn \[rad\].
const ARC: f64 = 0.03;

/// Columns of records by the names of their fields.
macro_rules! columns {
    ($records:expr; $($field:ident)*) => {
        json!({ $(stringify!($field): $records.iter().map(|record| record.$field as f64).collect::<Vec<_>>()),* })
    };
}

/// Curves, the section as it moves, events, and why the stage ended.
pub fn json(name: &str, stage: &StageSolution, mut frames: Vec<Picture>) -> Value {
    let model = &stage.model;
    frames.push(picture(model, &stage.end));
    let elements = stage.frames.last().map_or(&[][..], |frame| &frame.elements);
    let tools = model.tools.iter().map(|tool| {
        let outline: Vec<f64> = tool.profile.polyline(ARC).into_iter().flat_map(|point| [point.x, point.y]).collect();
        json!({ "role": tool.role.name(), "outline": outline })
    });
    let events = events(stage)
        .into_iter()
        .map(|event| json!({ "label": event.kind.label(model), "travel": event.travel, "force": event.force }));
    json!({
        "name": name,
        "forceUnit": model.extent().force_unit().symbol(),
        "travel": model.travel,
        "thickness": model.blank.thickness,
        "length": model.blank.length,
        "isRelease": model.release.is_some(),
        "steps": columns!(stage.steps; travel punch_force holder_force edge_force draw_in thinnest pole_height pressure penetration time iterations),
        "end": columns!(elements; s0 r z thickness strain_meridional strain_hoop strain_equivalent stress_meridional stress_hoop),
        "film": film(model, &frames),
        "tools": tools.collect::<Vec<_>>(),
        "events": events.collect::<Vec<_>>(),
        "limit": model.forming_limit.as_ref().map(limit),
    })
}

/// Points of the forming limit for a chart \[–\].
fn limit(curve: &Curve) -> Value {
    let minor: Vec<f64> = (-80..=80).map(|i| 0.01 * f64::from(i)).filter(|minor| curve.knows(*minor)).collect();
    let major: Vec<f64> = minor.iter().map(|minor| curve.major_at(*minor)).collect();
    json!({ "name": curve.name, "minor": minor, "major": major, "planeStrain": curve.plane_strain() })
}
