//! Check that the axis is at x = 0: tools that are drawn elsewhere would be read as rings.

use super::{ImportError, Result, chain::Chain, frame::Frame, layers::ToolId};
use crate::geometry::{Bounds, Piece, Point};
use crate::model::Role;

/// Largest distance of a punch from x = 0 over the farthest x of all tools \[–\], at which it still reaches the axis.
const REACHES: f64 = 0.02;

pub(super) fn check(strokes: &[(ToolId, Vec<Chain>)], frame: &Frame) -> Result {
    let pieces = |roles: &[Role]| {
        let strokes = strokes.iter().filter(|(tool, _)| roles.contains(&tool.role)).flat_map(|(_, strokes)| strokes);
        strokes.flat_map(|stroke| stroke.pieces().copied()).collect::<Vec<Piece>>()
    };
    let bounds = |roles: &[Role]| Bounds::around(pieces(roles).into_iter());
    let (Some(around), Some(punch)) = (bounds(&Role::ALL), bounds(&[Role::Punch])) else { return Ok(()) };
    if around.low.x < -frame.join && around.high.x > frame.join {
        return Ok(());
    }
    let distance = punch.low.x.abs().min(punch.high.x.abs());
    let reach = around.low.x.abs().max(around.high.x.abs());
    let is_ring = distance > REACHES * reach && punch.high.x - punch.low.x > frame.join;
    let middle = 0.5 * (around.low.x + around.high.x);
    let size = around.high - around.low;
    let (x, why) = if size.min() > frame.join && are_alike(&pieces(&Role::ALL), middle, frame.join) {
        (middle, "on both sides of which the tools are alike")
    } else if is_ring {
        // The end away from the die, or nearer to x = 0 without a die.
        let inward = match bounds(&[Role::Die]) {
            Some(die) => die.low.x + die.high.x > punch.low.x + punch.high.x,
            None => punch.low.x.abs() < punch.high.x.abs(),
        };
        (if inward { punch.low.x } else { punch.high.x }, "where the punch ends")
    } else {
        return Ok(());
    };
    let what = if is_ring {
        format!("no tool comes to x = 0, the axis: the punch is {} away and would be a ring", frame.along(distance))
    } else {
        "the tools are alike on both sides of a line that is not x = 0, the axis".to_owned()
    };
    let x = frame.along(x);
    let help = format!("if so, write --axis \"{x}\"; --axis \"0 mm\" if x = 0 is right");
    Err(ImportError::new(format!("{what}: is the axis at x = {x}, {why}?"), help))
}

fn are_alike(pieces: &[Piece], middle: f64, join: f64) -> bool {
    let ends: Vec<Point> = pieces.iter().flat_map(|piece| [piece.first(), piece.last()]).collect();
    let mut images = ends.iter().map(|p| Point::new(2.0 * middle - p.x, p.y));
    images.all(|image| ends.iter().any(|end| (end - image).norm() <= join))
}
