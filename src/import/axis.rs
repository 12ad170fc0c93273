//! Whether the axis is where it is taken to be, at x = 0: tools that are drawn elsewhere would be read as rings.

use super::blocks::Placed;
use super::curve::Curve;
use super::error::ImportError;
use super::frame::Frame;
use super::listing::Listed;
use super::parts::Part;
use super::stroke::Stroke;
use crate::geometry::{Bounds, Piece, Point};
use crate::model::Role;

/// Largest distance of a punch from x = 0 over the farthest x of all tools \[–\], at which it still reaches the axis.
const NEAR: f64 = 0.02;

const CENTRE: [&str; 9] = ["center", "centre", "mitte", "achse", "axis", "axe", "symm", "dashdot", "strichpunkt"];
/// Line types of ISO 128 for centre lines, as CAD programs name them.
const ISO: [&str; 2] = ["iso04w", "iso10w"];

/// Vertical centre line, x from the assumed axis \[mm\].
struct CentreLine<'a> {
    x: f64,
    from: &'a Listed,
}

/// Refuses tools that would be rings or lie symmetric about a line other than x = 0; a centre line at x = 0 accepts them.
pub(super) fn ask(strokes: &[(Part, Vec<Stroke>)], entities: &[Placed], frame: &Frame) -> Result<(), ImportError> {
    let of = |is: &dyn Fn(Role) -> bool| {
        let pieces = strokes.iter().filter(|(part, _)| is(part.role)).flat_map(|(_, strokes)| strokes);
        pieces.flat_map(|stroke| stroke.pieces.iter().copied()).collect::<Vec<Piece>>()
    };
    let all = of(&|_| true);
    let (Some(around), Some(punch)) = (Bounds::around(&all), Bounds::around(&of(&|role| role == Role::Punch))) else {
        return Ok(());
    };
    let is_on_both_sides = around.low.x < -frame.join && around.high.x > frame.join;
    let lines = centre_lines(entities, frame);
    if is_on_both_sides || lines.iter().any(|line| line.x.abs() <= frame.join) {
        return Ok(());
    }
    let away = |bounds: &Bounds| bounds.low.x.abs().min(bounds.high.x.abs());
    let reach = around.low.x.abs().max(around.high.x.abs());
    let is_ring = away(&punch) > NEAR * reach && punch.high.x - punch.low.x > frame.join;
    let middle = 0.5 * (around.low.x + around.high.x);
    let [width, height] = (around.high - around.low).into();
    let alike = width.min(height) > frame.join && are_alike(&all, middle, frame.join);
    if !is_ring && !alike {
        return Ok(());
    }
    let (x, why) = match &lines[..] {
        [line] => (line.x, format!("where {} is a centre line", line.from)),
        _ if alike => (middle, "on both sides of which the tools are alike".to_owned()),
        _ => (inner_end(&punch, Bounds::around(&of(&|role| role == Role::Die))), "where the punch ends".to_owned()),
    };
    let found = if is_ring {
        format!("no tool comes to x = 0, the axis: the punch is {} away and would be a ring", frame.along(away(&punch)))
    } else {
        "the tools are alike on both sides of a line that is not x = 0, the axis".to_owned()
    };
    let x = frame.along(x);
    let help = format!("if so, write --axis \"{x}\"; --axis \"0 mm\" if x = 0 is right");
    Err(ImportError::new(format!("{found}: is the axis at x = {x}, {why}?"), help))
}

/// End of a punch away from the die, or nearer to x = 0 without a die \[mm\].
fn inner_end(punch: &Bounds, die: Option<Bounds>) -> f64 {
    let inward = match die {
        Some(die) => die.low.x + die.high.x > punch.low.x + punch.high.x,
        None => punch.low.x.abs() < punch.high.x.abs(),
    };
    if inward { punch.low.x } else { punch.high.x }
}

fn are_alike(pieces: &[Piece], middle: f64, join: f64) -> bool {
    let ends: Vec<Point> = pieces.iter().flat_map(|piece| [piece.first(), piece.last()]).collect();
    let has_image = |p: &Point| {
        let image = Point::new(2.0 * middle - p.x, p.y);
        ends.iter().any(|end| (end - image).norm() <= join)
    };
    ends.iter().all(has_image)
}

fn centre_lines<'a>(entities: &'a [Placed], frame: &Frame) -> Vec<CentreLine<'a>> {
    let says = |name: &str| {
        let name = name.to_lowercase();
        CENTRE.iter().chain(&ISO).any(|word| name.contains(word))
    };
    let mut lines: Vec<CentreLine> = Vec::new();
    for Placed { listed, curve, placement } in entities.iter().filter(|placed| !placed.listed.on_paper) {
        let Some(Curve::Line(ends)) = curve else { continue };
        if !says(&listed.line_type) && !says(&listed.layer) {
            continue;
        }
        let [a, b] = ends.map(|[x, y, _]| {
            let p = placement.at(Point::new(x, y));
            frame.point(p.x, p.y)
        });
        let is_new = lines.iter().all(|line| (line.x - a.x).abs() > frame.join);
        if (a.x - b.x).abs() <= frame.join && (a.y - b.y).abs() > frame.join && is_new {
            lines.push(CentreLine { x: a.x, from: listed });
        }
    }
    lines
}
