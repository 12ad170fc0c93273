//! Strokes joined end to end into one line.

use super::ImportError;
use super::dxf::Source;
use super::frame::Frame;
use super::layers::ToolId;
use super::stroke::Stroke;
use crate::geometry::{Arc, Bounds, Piece, Point, turn};
use crate::units::significant;
use std::f64::consts::{FRAC_PI_2, PI};

/// Largest angle between overlapping lines \[rad\].
const ALONG: f64 = 0.01;

#[derive(Clone, Debug)]
pub(super) struct Chain {
    /// Pieces in order, each with the index of its stroke.
    pub pieces: Vec<(Piece, usize)>,
    /// Source of each stroke.
    pub sources: Vec<Source>,
    pub is_closed: bool,
}

/// Index of a stroke, and whether its last point is meant.
type End = (usize, bool);

impl Chain {
    pub fn first(&self) -> Point {
        self.pieces[0].0.first()
    }

    pub fn last(&self) -> Point {
        self.pieces[self.pieces.len() - 1].0.last()
    }

    pub fn reversed(self) -> Self {
        Self { pieces: self.pieces.iter().rev().map(|(piece, stroke)| (piece.reversed(), *stroke)).collect(), ..self }
    }

    /// Source of a piece.
    pub fn source(&self, piece: usize) -> &Source {
        &self.sources[self.pieces[piece].1]
    }
}

/// Joins the strokes of a tool.
///
/// # Errors
/// When they overlap, branch, cross, or leave a gap.
pub(super) fn join(
    strokes: Vec<Stroke>,
    tool: ToolId,
    frame: &Frame,
    notes: &mut Vec<String>,
) -> Result<Chain, ImportError> {
    let strokes = without_repeats(strokes, frame, notes);
    let corners = corners(&strokes, frame.join);
    if let Some((at, ends)) = corners.iter().find(|(_, ends)| ends.len() > 2) {
        let names: Vec<String> = ends.iter().map(|(i, _)| strokes[*i].source.to_string()).collect();
        let what = format!("the {tool}'s line branches at {}: {} meet", frame.place(*at), names.join(", "));
        let help = "a section is one line without side branches: leave only what meets the sheet";
        return Err(strokes[ends[0].0].source.error(what, help));
    }
    touching(&strokes, tool, frame)?;
    let lines = walk(strokes.len(), &corners);
    if let Some((line, _)) = lines.iter().find(|(_, is_closed)| *is_closed).filter(|_| lines.len() > 1) {
        let Stroke { source, pieces } = &strokes[line[0].0];
        let (place, count) = (frame.place(pieces[0].first()), lines.len());
        let what = format!("the {tool}'s line is {count} lines, one of them closed: {source} at {place}");
        let help = "which one meets the sheet cannot be told: leave only that, an open line or one outline";
        return Err(source.error(what, help));
    }
    let [(line, is_closed)] = &lines[..] else { return Err(gap(&strokes, &lines, tool, frame)) };
    let pieces = line.iter().flat_map(|(i, last)| {
        let stroke = if *last { strokes[*i].reversed() } else { strokes[*i].clone() };
        stroke.pieces.into_iter().map(|piece| (piece, *i))
    });
    let mut pieces: Vec<(Piece, usize)> = pieces.collect();
    let widest = close_joints(&mut pieces, *is_closed);
    if widest > 1e-6 {
        notes.push(format!("ends of the {tool}'s line that were up to {widest:.2e} mm apart are joined"));
    }
    Ok(Chain { pieces, sources: strokes.into_iter().map(|stroke| stroke.source).collect(), is_closed: *is_closed })
}

fn without_repeats(strokes: Vec<Stroke>, frame: &Frame, notes: &mut Vec<String>) -> Vec<Stroke> {
    let points = |stroke: &Stroke| stroke.pieces.iter().flat_map(|piece| piece.sample(4)).collect::<Vec<_>>();
    let within = |a: &Stroke, b: &Stroke| points(a).iter().all(|p| distance(b, *p) <= frame.join);
    let mut distinct: Vec<(Bounds, Stroke)> = Vec::new();
    for stroke in strokes {
        let around = stroke.bounds();
        let mut close =
            distinct.iter().filter(|(other, _)| !around.is_apart(other, frame.join)).map(|(_, other)| other);
        match close.find(|other| within(&stroke, other) && within(other, &stroke)) {
            Some(Stroke { source: other, .. }) => {
                let (source, from, to) = (&stroke.source, frame.place(stroke.first()), frame.place(stroke.last()));
                notes.push(format!("{source} is left out: it repeats {other}, from {from} to {to}"));
            }
            None => distinct.push((around, stroke)),
        }
    }
    distinct.into_iter().map(|(_, stroke)| stroke).collect()
}

/// \[mm\]
fn distance(stroke: &Stroke, p: Point) -> f64 {
    stroke.pieces.iter().map(|piece| (piece.closest_point(p) - p).norm()).fold(f64::INFINITY, f64::min)
}

fn corners(strokes: &[Stroke], join: f64) -> Vec<(Point, Vec<End>)> {
    let mut corners: Vec<(Point, Vec<End>)> = Vec::new();
    for (i, stroke) in strokes.iter().enumerate() {
        for (point, last) in [(stroke.first(), false), (stroke.last(), true)] {
            match corners.iter_mut().find(|(at, _)| (point - *at).norm() <= join) {
                Some((_, ends)) => ends.push((i, last)),
                None => corners.push((point, vec![(i, last)])),
            }
        }
    }
    corners
}

/// Refuses ends inside another stroke: overlaps and side branches.
fn touching(strokes: &[Stroke], tool: ToolId, frame: &Frame) -> Result<(), ImportError> {
    let boxes: Vec<Bounds> = strokes.iter().map(Stroke::bounds).collect();
    for (i, stroke) in strokes.iter().enumerate() {
        let last = stroke.pieces[stroke.pieces.len() - 1];
        let ends = [(stroke.first(), stroke.pieces[0].tangent(false)), (stroke.last(), last.tangent(true))];
        for (at, along) in ends {
            let is_close = |j: &usize| *j != i && !boxes[*j].is_beyond(at, frame.join);
            for other in (0..strokes.len()).filter(is_close).map(|j| &strokes[j]) {
                let at_end = [other.first(), other.last()].iter().any(|end| (end - at).norm() <= frame.join);
                let on = other.pieces.iter().find(|piece| (piece.closest_point(at) - at).norm() <= frame.join);
                let Some(piece) = on.filter(|_| !at_end) else { continue };
                let tangent = match piece {
                    Piece::Segment(_) => piece.tangent(false),
                    Piece::Arc(arc) => nalgebra::Rotation2::new(FRAC_PI_2) * (at - arc.center),
                };
                let angle = turn(along, tangent).abs();
                let (place, source, other) = (frame.place(at), &stroke.source, &other.source);
                return Err(if angle.min(PI - angle) < ALONG {
                    let what = format!("two parts of the {tool}'s line overlap at {place}: {source} and {other}");
                    source.error(what, "draw each part of the line once")
                } else {
                    let what = format!("the {tool}'s line branches at {place}: {source} ends on the inside of {other}");
                    let help = "a section is one line without side branches: trim the lines there, or leave one out";
                    source.error(what, help)
                });
            }
        }
    }
    Ok(())
}

/// Lines of strokes, each stroke with the end that it is entered by, and whether the line is closed.
type Line = (Vec<End>, bool);

fn walk(count: usize, corners: &[(Point, Vec<End>)]) -> Vec<Line> {
    let mut done = vec![false; count];
    let mut lines = Vec::new();
    // The corner of either end of each stroke.
    let mut corner = vec![[0; 2]; count];
    for (k, (i, last)) in corners.iter().enumerate().flat_map(|(k, (_, ends))| ends.iter().map(move |end| (k, *end))) {
        corner[i][usize::from(last)] = k;
    }
    // A line without a free end is closed, wherever one begins.
    let free = corners.iter().filter(|(_, ends)| ends.len() == 1).map(|(_, ends)| (ends[0], false));
    for (start, is_closed) in free.chain((0..count).map(|i| ((i, false), true))) {
        let mut next = Some(start).filter(|(i, _)| !done[*i]);
        let mut line = Vec::new();
        while let Some((i, last)) = next {
            done[i] = true;
            line.push((i, last));
            let (_, there) = &corners[corner[i][usize::from(!last)]];
            next = there.iter().copied().find(|end| !done[end.0]);
        }
        if !line.is_empty() {
            lines.push((line, is_closed));
        }
    }
    lines
}

/// Error of the two ends of different lines that come closest.
fn gap(strokes: &[Stroke], lines: &[Line], tool: ToolId, frame: &Frame) -> ImportError {
    let point = |(i, last): End| (if last { strokes[i].last() } else { strokes[i].first() }, &strokes[i].source);
    let ends = |(line, _): &Line| {
        let (i, last) = line[line.len() - 1];
        [point(line[0]), point((i, !last))]
    };
    let ends: Vec<_> = lines.iter().map(ends).collect();
    let pairs = ends.iter().enumerate().flat_map(|(i, line)| ends[i + 1..].iter().map(move |other| (line, other)));
    let pairs = pairs.flat_map(|(line, other)| other.iter().flat_map(move |b| line.iter().map(move |a| (a, b))));
    let distances = pairs.map(|(a, b)| ((b.0 - a.0).norm(), a, b));
    let closest = distances.min_by(|a, b| a.0.total_cmp(&b.0)).expect("there is more than one line");
    let (distance, (a, from_a), (b, from_b)) = closest;
    let (a, b) = (frame.place(*a), frame.place(*b));
    let what = format!(
        "the {tool}'s line has a gap of {} mm: {from_a} ends at {a} and {from_b} at {b}",
        significant(distance, 4)
    );
    let more = (1.2 * distance * 1e4).ceil() / 1e4;
    from_a.error(what, format!("close it in the drawing, or let such ends meet with --join \"{more} mm\""))
}

/// Closes all joints and returns the widest \[mm\]; a line gives way to an arc, so that tangents stay.
fn close_joints(pieces: &mut [(Piece, usize)], is_closed: bool) -> f64 {
    let (mut widest, count): (f64, usize) = (0.0, pieces.len());
    for i in 0..count {
        let next = (i + 1) % count;
        if next == 0 && !is_closed || next > 0 && pieces[i].1 == pieces[next].1 {
            continue;
        }
        let (a, b) = (pieces[i].0, pieces[next].0);
        let (end, start) = (a.last(), b.first());
        widest = widest.max((start - end).norm());
        let at = if matches!(a, Piece::Segment(_)) { start } else { end };
        pieces[i].0 = with_ends(&a, a.first(), at);
        pieces[next].0 = with_ends(&b, at, b.last());
    }
    widest
}

pub(super) fn with_ends(piece: &Piece, from: Point, to: Point) -> Piece {
    match piece {
        _ if (from, to) == (piece.first(), piece.last()) => *piece,
        Piece::Segment(_) => Piece::line(from, to),
        Piece::Arc(arc) => Piece::Arc(Arc::between(from, to, arc.center, arc.sweep > 0.0).0),
    }
}
