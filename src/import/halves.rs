//! The right half of what is drawn: cut at the axis, and compared with the left half where that is drawn too.

use super::{ImportError, Result, chain::Chain, chain::join, ensure, frame::Frame, layers::ToolId};
use crate::geometry::{Bounds, Piece, Point};

pub(super) fn right(strokes: Vec<Chain>, tool: ToolId, frame: &Frame) -> Result<Chain> {
    let parts = strokes.iter().flat_map(|stroke| cut(stroke, frame));
    let (right, left): (Vec<Chain>, Vec<Chain>) = parts.partition(|part| is_right(&part.pieces[0].0));
    let mirrored = |part: &Chain| Chain::stroke(part.pieces().map(Piece::across_axis), part.source(0));
    let left: Vec<Chain> = left.iter().map(mirrored).collect();
    let help = "draw the side of the tool that meets the sheet; --axis says where the axis is";
    let empty = || ImportError::new(format!("all of the {tool}'s line lies on the axis"), help);
    ensure(!(right.is_empty() && left.is_empty()), empty)?;
    if right.is_empty() {
        frame.note(format!("the {tool} is drawn on the left of the axis only: its mirror image is used"));
        return join(left, tool, frame);
    }
    let chain = join(right, tool, frame)?;
    if !left.is_empty() {
        // The notes of the right half are true of the left one too.
        compare(&chain, &join(left, tool, &frame.clone())?, tool, frame)?;
        frame.note(format!("both halves of the {tool} are drawn and are alike: the right one is used"));
    }
    Ok(chain)
}

fn cut(stroke: &Chain, frame: &Frame) -> Vec<Chain> {
    let on_axis = |p: Point| if p.x.abs() <= frame.join { Point::new(0.0, p.y) } else { p };
    let (source, mut parts) = (stroke.source(0), Vec::<Vec<Piece>>::new());
    // The side of the part that the next piece goes on with.
    let mut open = None;
    let mut along = false;
    for piece in stroke.pieces() {
        let (from, to) = (on_axis(piece.first()), on_axis(piece.last()));
        if from.x == 0.0 && to.x == 0.0 && matches!(piece, Piece::Segment(_)) {
            (open, along) = (None, true);
            continue;
        }
        for piece in piece.with_ends(from, to).cut_at_axis(frame.join) {
            let piece = piece.with_ends(on_axis(piece.first()), on_axis(piece.last()));
            let side = Some(is_right(&piece));
            match parts.last_mut().filter(|_| open == side) {
                Some(part) => part.push(piece),
                None => parts.push(vec![piece]),
            }
            open = side;
        }
    }
    if along {
        frame.note(format!("{source} runs along the axis, and that part of it is left out"));
    }
    parts.into_iter().map(|pieces| Chain::stroke(pieces, source)).collect()
}

fn is_right(piece: &Piece) -> bool {
    piece.sample(2)[1].x > 0.0
}

fn compare(right: &Chain, image: &Chain, tool: ToolId, frame: &Frame) -> Result {
    let worst = [(right, image, 1.0), (image, right, -1.0)].into_iter().flat_map(|(these, others, side)| {
        let points = these.pieces.iter().flat_map(|(one, source)| one.sample(8).into_iter().map(move |p| (p, source)));
        let others: Vec<(Bounds, &Piece)> = others.pieces().map(|piece| (piece.bounds(), piece)).collect();
        points.map(move |(p, source)| {
            let distance = others.iter().fold(f64::INFINITY, |least, (around, other)| {
                if around.is_beyond(p, least) { least } else { least.min((other.closest_point(p) - p).norm()) }
            });
            (distance, Point::new(side * p.x, p.y), source)
        })
    });
    let Some((distance, at, source)) = worst.max_by(|a, b| a.0.total_cmp(&b.0)) else { return Ok(()) };
    if distance <= frame.join + 2.0 * frame.tolerance {
        return Ok(());
    }
    let (place, distance) = (frame.place(at), (distance * 1e4).round() / 1e4);
    let what = format!(
        "the two halves of the {tool} differ, most by {distance} mm: {source} at {place} is so far from the other's image"
    );
    Err(source.error(what, "draw one half only, or both alike; --axis says where the axis is if it is not x = 0"))
}
