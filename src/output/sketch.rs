//! What was understood of a drawing: the tools' sections as drawn, and where their pieces end.

use super::chart::{Chart, Look, Panel, Scale, Series, color};
use super::shapes::chords;
use super::worded;
use crate::import::Sections;
use crate::model::Geometry;
use crate::table::{Column, Unit};

/// What is shown around the tools, over their size.
const AROUND: f64 = 0.06;
/// How far a chord may leave its arc, over the picture's width.
const SAGITTA: f64 = 1e-4;

/// The sections in one picture, a colour for each tool.
pub fn sketch(name: &str, geometry: Geometry, sections: &Sections) -> Chart {
    let points = || sections.tools.iter().flat_map(|tool| tool.profile.polyline(0.05));
    let width = points().map(|p| p.x).fold(0.0, f64::max);
    let (low, high) = points().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (p.y.min(low), p.y.max(high)));
    let around = AROUND * width.max(high - low);
    let lines = sections.tools.iter().enumerate().map(|(i, tool)| {
        let pieces = tool.profile.pieces();
        let points = pieces.iter().flat_map(|piece| piece.sample(chords(piece, SAGITTA * width))).map(|p| (p.x, p.y));
        Series::new(format!("{}: {}", tool.role.name(), tool.made_of), points.collect(), Look::curve(i))
    });
    let ends = sections.tools.iter().enumerate().map(|(i, tool)| {
        Series::silent(tool.ends.iter().map(|p| (p.x, p.y)).collect(), Look::Circles { color: color(i) })
    });
    let axis = |key, label| Column::new(key, label, Unit::Mm, Vec::new()).axis();
    let r = worded(geometry, "Distance from the axis", "Distance from the symmetry plane");
    let notes = sections.notes.iter().map(|note| format!("{note}."));
    Chart {
        title: format!("{name}: the tools that were read"),
        legend: "",
        panels: vec![Panel {
            x: axis("r", r),
            y: axis("z", "z, along punch travel"),
            series: lines.chain(ends).collect(),
            scale: Scale::Section { x: (0.0, width + around), y: (low - around, high + around) },
        }],
        notes: std::iter::once(
            "Circles: where the drawing's entities begin and end. The tools are where they are drawn; \
                                the case moves each along z to where it touches the flat sheet."
                .to_owned(),
        )
        .chain(notes)
        .collect(),
    }
}
