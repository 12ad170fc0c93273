//! Check that the axis is at x = 0: tools that are drawn elsewhere would be read as rings.

use super::ImportError;
use super::blocks::Placed;
use super::chain::Chain;
use super::dxf::Source;
use super::frame::Frame;
use super::layers::ToolId;
use crate::geometry::{Bounds, Piece, Point};
use crate::model::Role;

/// Largest distance of a punch from x = 0 over the farthest x of all tools \[–\], at which it still reaches the axis.
const REACHES: f64 = 0.02;

/// Names of centre lines' layers and line types; the last two are those of ISO 128, as CAD programs name them.
const CENTRE: [&str; 11] =
    ["center", "centre", "mitte", "achse", "axis", "axe", "symm", "dashdot", "strichpunkt", "iso04w", "iso10w"];

/// Refuses tools that would be rings or lie symmetric about a line other than x = 0; a centre line at x = 0 accepts them.
pub(super) fn check(strokes: &[(ToolId, Vec<Chain>)], entities: &[Placed], frame: &Frame) -> Result<(), ImportError> {
    let pieces = |roles: &[Role]| {
        let strokes = strokes.iter().filter(|(tool, _)| roles.contains(&tool.role)).flat_map(|(_, strokes)| strokes);
        strokes.flat_map(|stroke| stroke.pieces().copied()).collect::<Vec<Piece>>()
    };
    let bounds = |role| Bounds::around(&pieces(&[role]));
    let all = pieces(&Role::ALL);
    let (Some(around), Some(punch)) = (Bounds::around(&all), bounds(Role::Punch)) else { return Ok(()) };
    let is_on_both_sides = around.low.x < -frame.join && around.high.x > frame.join;
    let lines = centre_lines(entities, frame);
    if is_on_both_sides || lines.iter().any(|(x, _)| x.abs() <= frame.join) {
        return Ok(());
    }
    let distance = punch.low.x.abs().min(punch.high.x.abs());
    let reach = around.low.x.abs().max(around.high.x.abs());
    let is_ring = distance > REACHES * reach && punch.high.x - punch.low.x > frame.join;
    let middle = 0.5 * (around.low.x + around.high.x);
    let [width, height] = (around.high - around.low).into();
    let alike = width.min(height) > frame.join && are_alike(&all, middle, frame.join);
    if !is_ring && !alike {
        return Ok(());
    }
    let (x, why) = match &lines[..] {
        [(x, source)] => (*x, format!("where {source} is a centre line")),
        _ if alike => (middle, "on both sides of which the tools are alike".to_owned()),
        _ => {
            // The end away from the die, or nearer to x = 0 without a die.
            let inward = match bounds(Role::Die) {
                Some(die) => die.low.x + die.high.x > punch.low.x + punch.high.x,
                None => punch.low.x.abs() < punch.high.x.abs(),
            };
            (if inward { punch.low.x } else { punch.high.x }, "where the punch ends".to_owned())
        }
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

/// Vertical centre lines: x from the assumed axis \[mm\] and source.
fn centre_lines<'a>(entities: &'a [Placed], frame: &Frame) -> Vec<(f64, &'a Source)> {
    let is_centre = |name: &str| CENTRE.iter().any(|word| name.to_lowercase().contains(word));
    let mut lines: Vec<(f64, &Source)> = Vec::new();
    for Placed { source, entity, placement } in entities {
        if source.on_paper || source.kind != "LINE" || !is_centre(&source.line_type) && !is_centre(&source.layer) {
            continue;
        }
        let [a, b] = [10, 11].map(|code| {
            let [x, y, _] = entity.point(code);
            frame.point(placement.at(Point::new(x, y)))
        });
        let is_new = lines.iter().all(|(x, _)| (x - a.x).abs() > frame.join);
        if (a.x - b.x).abs() <= frame.join && (a.y - b.y).abs() > frame.join && is_new {
            lines.push((a.x, source));
        }
    }
    lines
}
