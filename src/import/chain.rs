//! Strokes joined end to end into one open line.

use super::error::ImportError;
use super::frame::Frame;
use super::listing::Listed;
use super::stroke::Stroke;
use crate::geometry::{Arc, Bounds, Piece, Point, Segment, turn};
use crate::model::Role;
use crate::units::significant;
use std::f64::consts::{FRAC_PI_2, PI};

/// Lines that lie on each other go the same way within this angle \[rad\].
const ALONG: f64 = 0.01;

/// An open line of strokes, each beginning where the one before ends.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub strokes: Vec<Stroke>,
}

/// One end of a stroke: its index, and whether it is the last point.
type End = (usize, bool);

impl Chain {
    /// The pieces in order, and the index of each one's stroke.
    pub fn pieces(&self) -> impl DoubleEndedIterator<Item = (&Piece, usize)> {
        self.strokes.iter().enumerate().flat_map(|(i, stroke)| stroke.pieces.iter().map(move |piece| (piece, i)))
    }

    pub fn first(&self) -> Point {
        self.strokes[0].first()
    }

    pub fn last(&self) -> Point {
        self.strokes[self.strokes.len() - 1].last()
    }

    /// The same line walked the other way.
    pub fn reversed(&self) -> Self {
        Self { strokes: self.strokes.iter().rev().map(Stroke::reversed).collect() }
    }
}

/// Joins the strokes of a tool.
///
/// # Errors
/// When they overlap, branch, close, cross, or leave a gap.
pub(super) fn join(
    strokes: Vec<Stroke>,
    role: Role,
    frame: &Frame,
    notes: &mut Vec<String>,
) -> Result<Chain, ImportError> {
    let strokes = without_repeats(strokes, frame, notes);
    let corners = corners(&strokes, frame.join);
    if let Some((at, ends)) = corners.iter().find(|(_, ends)| ends.len() > 2) {
        let named: Vec<String> = ends.iter().map(|(i, _)| strokes[*i].from.to_string()).collect();
        let what = format!("the {}'s line branches at {}: {} meet", role.name(), frame.place(*at), named.join(", "));
        return Err(ImportError::new(
            what,
            "a section is one line without side branches: leave only what meets the sheet",
        )
        .at(strokes[ends[0].0].from.line));
    }
    touching(&strokes, role, frame)?;
    let mut lines = walk(&strokes, &corners, role, frame)?;
    if lines.len() > 1 {
        return Err(gap(&lines, role, frame));
    }
    let mut strokes = lines.pop().expect("a tool has strokes");
    let widest = close_joints(&mut strokes);
    if widest > 1e-6 {
        notes.push(format!("ends of the {}'s line that were up to {widest:.2e} mm apart are joined", role.name()));
    }
    Ok(Chain { strokes })
}

/// The strokes without those that another one draws as well.
fn without_repeats(strokes: Vec<Stroke>, frame: &Frame, notes: &mut Vec<String>) -> Vec<Stroke> {
    let looks = |stroke: &Stroke| stroke.pieces.iter().flat_map(|piece| piece.sample(4)).collect::<Vec<_>>();
    let within = |a: &Stroke, b: &Stroke| looks(a).iter().all(|p| away(b, *p) <= frame.join);
    let mut kept: Vec<(Bounds, Stroke)> = Vec::new();
    for stroke in strokes {
        let around = stroke.bounds();
        let near = kept.iter().filter(|(other, _)| !around.is_apart(other, frame.join)).map(|(_, other)| other);
        match near.into_iter().find(|other| within(&stroke, other) && within(other, &stroke)) {
            Some(other) => notes.push(format!(
                "{} is left out: it repeats {}, from {} to {}",
                stroke.from,
                other.from,
                frame.place(stroke.first()),
                frame.place(stroke.last())
            )),
            None => kept.push((around, stroke)),
        }
    }
    kept.into_iter().map(|(_, stroke)| stroke).collect()
}

/// Distance of a point from a stroke \[mm\].
fn away(stroke: &Stroke, p: Point) -> f64 {
    stroke.pieces.iter().map(|piece| (piece.closest_point(p) - p).norm()).fold(f64::INFINITY, f64::min)
}

/// The places where strokes end, each with the ends that are there.
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

/// Ends that lie on the inside of another stroke: overlaps and side branches.
fn touching(strokes: &[Stroke], role: Role, frame: &Frame) -> Result<(), ImportError> {
    let boxes: Vec<Bounds> = strokes.iter().map(Stroke::bounds).collect();
    for (i, stroke) in strokes.iter().enumerate() {
        for (at, along) in [
            (stroke.first(), stroke.pieces[0].tangent(false)),
            (stroke.last(), stroke.pieces[stroke.pieces.len() - 1].tangent(true)),
        ] {
            let near = |j: &usize| *j != i && !boxes[*j].is_beyond(at, frame.join);
            for other in (0..strokes.len()).filter(near).map(|j| &strokes[j]) {
                let at_end = [other.first(), other.last()].iter().any(|end| (end - at).norm() <= frame.join);
                let on = other.pieces.iter().find(|piece| (piece.closest_point(at) - at).norm() <= frame.join);
                let Some(piece) = on.filter(|_| !at_end) else { continue };
                let angle = turn(along, tangent_near(piece, at)).abs();
                let (name, place) = (role.name(), frame.place(at));
                if angle < ALONG || PI - angle < ALONG {
                    let what = format!(
                        "two parts of the {name}'s line overlap at {place}: {} and {}",
                        stroke.from, other.from
                    );
                    return Err(ImportError::new(what, "draw each part of the line once").at(stroke.from.line));
                }
                let what = format!(
                    "the {name}'s line branches at {place}: {} ends on the inside of {}",
                    stroke.from, other.from
                );
                let help = "a section is one line without side branches: trim the lines there, or leave one out";
                return Err(ImportError::new(what, help).at(stroke.from.line));
            }
        }
    }
    Ok(())
}

/// Direction of a piece at a point on it.
fn tangent_near(piece: &Piece, at: Point) -> Point {
    match piece {
        Piece::Segment(_) => piece.tangent(false),
        Piece::Arc(arc) => nalgebra::Rotation2::new(FRAC_PI_2) * (at - arc.center),
    }
}

/// The open lines that the strokes make, each in order and one way.
fn walk(
    strokes: &[Stroke],
    corners: &[(Point, Vec<End>)],
    role: Role,
    frame: &Frame,
) -> Result<Vec<Vec<Stroke>>, ImportError> {
    let mut done = vec![false; strokes.len()];
    let mut lines = Vec::new();
    // The corner of either end of each stroke.
    let mut corner = vec![[0; 2]; strokes.len()];
    for (k, (i, last)) in corners.iter().enumerate().flat_map(|(k, (_, ends))| ends.iter().map(move |end| (k, *end))) {
        corner[i][usize::from(last)] = k;
    }
    let starts = corners.iter().filter(|(_, ends)| ends.len() == 1).map(|(_, ends)| ends[0]);
    for start in starts {
        let mut next = Some(start).filter(|(i, _)| !done[*i]);
        let mut line = Vec::new();
        while let Some((i, from_last)) = next {
            done[i] = true;
            line.push(if from_last { strokes[i].reversed() } else { strokes[i].clone() });
            let far = (i, !from_last);
            let (_, there) = &corners[corner[i][usize::from(!from_last)]];
            next = there.iter().copied().find(|end| *end != far && !done[end.0]);
        }
        if !line.is_empty() {
            lines.push(line);
        }
    }
    if let Some(i) = done.iter().position(|done| !done) {
        let (from, place) = (&strokes[i].from, frame.place(strokes[i].first()));
        let what = format!("the {}'s line is closed: it comes back to {place}, where {from} begins", role.name());
        let help = "draw only the side of the tool that meets the sheet, as an open line";
        return Err(ImportError::new(what, help).at(from.line));
    }
    Ok(lines)
}

/// The two ends of different lines that come closest.
fn gap(lines: &[Vec<Stroke>], role: Role, frame: &Frame) -> ImportError {
    let ends = |line: &'_ [Stroke]| {
        let (first, last) = (&line[0], &line[line.len() - 1]);
        [(first.first(), first.from.clone()), (last.last(), last.from.clone())]
    };
    let ends: Vec<_> = lines.iter().map(|line| ends(line)).collect();
    let pairs = ends.iter().enumerate().flat_map(|(i, line)| ends[i + 1..].iter().map(move |other| (line, other)));
    let pairs = pairs.flat_map(|(line, other)| other.iter().flat_map(move |b| line.iter().map(move |a| (a, b))));
    let distance = |((a, _), (b, _)): &(&(Point, Listed), &(Point, Listed))| (b - a).norm();
    let closest = pairs.min_by(|a, b| distance(a).total_cmp(&distance(b)));
    let closest = closest.expect("there is more than one line");
    let (distance, ((a, from_a), (b, from_b))) = (distance(&closest), closest);
    let (a, b) = (frame.place(*a), frame.place(*b));
    let words = format!("{from_a} ends at {a} and {from_b} at {b}");
    let what = format!("the {}'s line has a gap of {} mm: {words}", role.name(), significant(distance, 4));
    let more = (1.2 * distance * 1e4).ceil() / 1e4;
    ImportError::new(what, format!("close it in the drawing, or let such ends meet with --join \"{more} mm\""))
        .at(from_a.line)
}

/// Makes every stroke begin exactly where the one before ends, and returns the widest joint \[mm\]. A line gives way to an
/// arc, so that tangents stay.
fn close_joints(strokes: &mut [Stroke]) -> f64 {
    let mut widest: f64 = 0.0;
    for i in 1..strokes.len() {
        let (before, after) = strokes.split_at_mut(i);
        let (a, b) = (before[i - 1].pieces.last_mut().expect("a stroke"), &mut after[0].pieces[0]);
        let (end, start) = (a.last(), b.first());
        widest = widest.max((start - end).norm());
        let at = if matches!(a, Piece::Segment(_)) { start } else { end };
        *a = with_ends(a, a.first(), at);
        *b = with_ends(b, at, b.last());
    }
    widest
}

/// The piece between other ends, close to its own.
pub(super) fn with_ends(piece: &Piece, from: Point, to: Point) -> Piece {
    match piece {
        _ if (from, to) == (piece.first(), piece.last()) => *piece,
        Piece::Segment(_) => Piece::Segment(Segment::new(from, to)),
        Piece::Arc(arc) => Piece::Arc(Arc::between(from, to, arc.center, arc.sweep > 0.0).0),
    }
}
