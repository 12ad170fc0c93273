//! What was understood of a drawing: the tools' sections as drawn, and where their lines end.

use super::chart::{Chart, Look, Panel, Series, color, pale};
use super::sections::{body, panel};
use crate::geometry::{Piece, Point};
use crate::import::{Section, Sections};
use crate::model::Geometry;
use crate::table::capitalised;
use std::ops::RangeFrom;

/// What is shown around the tools, over their width.
const AROUND: f64 = 0.1;
/// How far a chord may leave its arc, over the picture's width.
const SAGITTA: f64 = 1e-4;

/// The sections in one picture, a panel for each operation and a colour for each tool. Long walls are cut off at its border.
pub fn sketch(name: &str, geometry: Geometry, sections: &Sections) -> Chart {
    let operations = std::iter::once(&sections.tools).chain(sections.later.iter().map(|later| &later.tools));
    let mut colors = 0..;
    let panels = operations.map(|tools| of_operation(tools, geometry, &mut colors)).collect();
    let caption = "Circles: where drawn lines, arcs and splines begin and end. The tools are where they are drawn; the case moves \
                   each along z to where it touches the sheet.";
    Chart {
        title: format!("{name}: the tools that were read"),
        legend: String::new(),
        panels,
        notes: std::iter::once(caption.to_owned())
            .chain(sections.notes.iter().map(|note| format!("{}.", capitalised(note))))
            .collect(),
    }
}

fn of_operation(tools: &[Section], geometry: Geometry, colors: &mut RangeFrom<usize>) -> Panel {
    let width = tools.iter().flat_map(|tool| tool.profile.polyline(0.05)).map(|p| p.x).fold(0.0, f64::max);
    let heights = tools.iter().flat_map(shown).map(|p| p.y);
    let (low, high) = heights.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), z| (z.min(low), z.max(high)));
    let around = AROUND * width.max(high - low);
    let (x, y) = ((0.0, width + 0.5 * around), (low - around, high + around));
    let (mut bodies, mut ends) = (Vec::new(), Vec::new());
    for (tool, i) in tools.iter().zip(colors) {
        let outline = body(tool.role, &tool.profile, Point::zeros(), SAGITTA * width);
        let label = format!("{}: {}", capitalised(tool.role.name()), tool.made_of);
        bodies.push(Series::new(label, outline, Look::Area { fill: pale(color(i)), edge: Some(color(i)) }));
        let inside = tool.ends.iter().filter(|p| (y.0..=y.1).contains(&p.y));
        ends.push(Series::silent(inside.map(|p| (p.x, p.y)).collect(), Look::Circles { color: color(i) }));
    }
    panel(geometry, bodies.into_iter().chain(ends), [x, y])
}

/// The vertices of a section but the far ends of its walls.
fn shown(tool: &Section) -> impl Iterator<Item = Point> {
    let pieces = tool.profile.pieces();
    let is_wall = |piece: &Piece| matches!(piece, Piece::Segment(_)) && piece.tangent(false).x.abs() < 1e-3;
    let first = pieces.iter().take_while(|piece| is_wall(piece)).count();
    let last = pieces.len() - pieces.iter().rev().take_while(|piece| is_wall(piece)).count();
    let kept = if first < last { first..last } else { 0..pieces.len() };
    pieces[kept].iter().flat_map(|piece| piece.sample(8))
}
