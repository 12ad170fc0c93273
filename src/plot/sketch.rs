//! Sketch of imported tools: their sections as drawn, and the ends of the drawn lines.

use super::{sections::SAGITTA, sections::body, sections::panel, *};

const AROUND: f64 = 0.1;

/// Imported tool.
#[derive(Clone, Debug)]
pub struct SketchedTool {
    /// Legend entry.
    pub label: String,
    /// Side of the sheet that it stands on.
    pub role: Role,
    /// Outline that faces the sheet.
    pub profile: Profile,
    /// Ends of drawn lines, arcs and splines.
    pub ends: Vec<Point>,
}

/// One panel for each operation, one colour for each tool; long walls are cut off.
pub fn sketch(title: String, geometry: Geometry, operations: &[Vec<SketchedTool>], notes: Vec<String>) -> Chart {
    let mut colors = 0..;
    let operation = |tools: &Vec<SketchedTool>| {
        let width = bounds(tools.iter().flat_map(|tool| tool.profile.polyline(0.05)).map(|p| p.x)).1;
        let (low, high) = bounds(tools.iter().flat_map(|tool| vertices(&tool.profile)).map(|p| p.y));
        let around = AROUND * width.max(high - low);
        let (x, y) = ((0.0, width + 0.5 * around), (low - around, high + around));
        let (mut bodies, mut ends) = (Vec::new(), Vec::new());
        for (tool, i) in tools.iter().zip(&mut colors) {
            let outline = body(tool.role, &tool.profile, Point::zeros(), SAGITTA * width);
            let style = Style::Area { fill: pale(color(i)), edge: Some(color(i)) };
            bodies.push(Series::new(tool.label.clone(), outline, style));
            let inside = tool.ends.iter().filter(|p| (y.0..=y.1).contains(&p.y));
            ends.push(Series::silent(inside.map(|p| (p.x, p.y)).collect(), Style::Circles { color: color(i) }));
        }
        panel(geometry, [x, y]).with(bodies).with(ends)
    };
    Chart::new(title, operations.iter().map(operation).collect(), notes)
}

fn vertices(profile: &Profile) -> impl Iterator<Item = Point> {
    let pieces = profile.pieces();
    let is_wall = |piece: &&Piece| matches!(piece, Piece::Segment(_)) && piece.tangent(false).x.abs() < 1e-3;
    let first = pieces.iter().take_while(is_wall).count();
    let last = pieces.len() - pieces.iter().rev().take_while(is_wall).count();
    pieces[if first < last { first..last } else { 0..pieces.len() }].iter().flat_map(|piece| piece.sample(8))
}
