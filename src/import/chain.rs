//! Strokes joined end to end into one line.

use super::error::ImportError;
use super::frame::Frame;
use super::listing::Listed;
use super::parts::Part;
use super::stroke::Stroke;
use crate::geometry::{Arc, Bounds, Piece, Point, Segment, turn};
use crate::units::significant;
use std::f64::consts::{FRAC_PI_2, PI};

/// Largest angle between overlapping lines \[rad\].
const ALONG: f64 = 0.01;

#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub strokes: Vec<Stroke>,
    pub is_closed: bool,
}

/// Index of a stroke, and whether its last point is meant.
type End = (usize, bool);

impl Chain {
    /// Pieces in order with the index of their stroke.
    pub fn pieces(&self) -> impl DoubleEndedIterator<Item = (&Piece, usize)> {
        self.strokes.iter().enumerate().flat_map(|(i, stroke)| stroke.pieces.iter().map(move |piece| (piece, i)))
    }

    pub fn first(&self) -> Point {
        self.strokes[0].first()
    }

    pub fn last(&self) -> Point {
        self.strokes[self.strokes.len() - 1].last()
    }

    pub fn reversed(&self) -> Self {
        Self { strokes: self.strokes.iter().rev().map(Stroke::reversed).collect(), ..*self }
    }
}

/// Joins the strokes of a tool.
///
/// # Errors
/// When they overlap, branch, cross, or leave a gap.
pub(super) fn join(
    strokes: Vec<Stroke>,
    part: Part,
    frame: &Frame,
    notes: &mut Vec<String>,
) -> Result<Chain, ImportError> {
    let strokes = without_repeats(strokes, frame, notes);
    let corners = corners(&strokes, frame.join);
    if let Some((at, ends)) = corners.iter().find(|(_, ends)| ends.len() > 2) {
        let named: Vec<String> = ends.iter().map(|(i, _)| strokes[*i].from.to_string()).collect();
        let what = format!("the {}'s line branches at {}: {} meet", part.name(), frame.place(*at), named.join(", "));
        return Err(ImportError::new(
            what,
            "a section is one line without side branches: leave only what meets the sheet",
        )
        .at(strokes[ends[0].0].from.line));
    }
    touching(&strokes, part, frame)?;
    let mut lines = walk(&strokes, &corners);
    if let Some((line, _)) = lines.iter().find(|(_, is_closed)| *is_closed).filter(|_| lines.len() > 1) {
        let (from, place, count) = (&line[0].from, frame.place(line[0].first()), lines.len());
        let what = format!("the {}'s line is {count} lines, one of them closed: {from} at {place}", part.name());
        let help = "which one meets the sheet cannot be told: leave only that, an open line or one outline";
        return Err(ImportError::new(what, help).at(from.line));
    }
    if lines.len() > 1 {
        let open: Vec<_> = lines.into_iter().map(|(line, _)| line).collect();
        return Err(gap(&open, part, frame));
    }
    let (mut strokes, is_closed) = lines.pop().expect("a tool has strokes");
    let widest = close_joints(&mut strokes, is_closed);
    if widest > 1e-6 {
        notes.push(format!("ends of the {}'s line that were up to {widest:.2e} mm apart are joined", part.name()));
    }
    Ok(Chain { strokes, is_closed })
}

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

/// \[mm\]
fn away(stroke: &Stroke, p: Point) -> f64 {
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
fn touching(strokes: &[Stroke], part: Part, frame: &Frame) -> Result<(), ImportError> {
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
                let (name, place) = (part.name(), frame.place(at));
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

fn tangent_near(piece: &Piece, at: Point) -> Point {
    match piece {
        Piece::Segment(_) => piece.tangent(false),
        Piece::Arc(arc) => nalgebra::Rotation2::new(FRAC_PI_2) * (at - arc.center),
    }
}

/// Lines made of strokes, each with whether it is closed.
fn walk(strokes: &[Stroke], corners: &[(Point, Vec<End>)]) -> Vec<(Vec<Stroke>, bool)> {
    let mut done = vec![false; strokes.len()];
    let mut lines = Vec::new();
    // The corner of either end of each stroke.
    let mut corner = vec![[0; 2]; strokes.len()];
    for (k, (i, last)) in corners.iter().enumerate().flat_map(|(k, (_, ends))| ends.iter().map(move |end| (k, *end))) {
        corner[i][usize::from(last)] = k;
    }
    // What has no free end is closed, wherever one begins.
    let free = corners.iter().filter(|(_, ends)| ends.len() == 1).map(|(_, ends)| (ends[0], false));
    let anywhere = (0..strokes.len()).map(|i| ((i, false), true));
    for (start, is_closed) in free.chain(anywhere) {
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
            lines.push((line, is_closed));
        }
    }
    lines
}

/// Error of the two ends of different lines that come closest.
fn gap(lines: &[Vec<Stroke>], part: Part, frame: &Frame) -> ImportError {
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
    let what = format!("the {}'s line has a gap of {} mm: {words}", part.name(), significant(distance, 4));
    let more = (1.2 * distance * 1e4).ceil() / 1e4;
    ImportError::new(what, format!("close it in the drawing, or let such ends meet with --join \"{more} mm\""))
        .at(from_a.line)
}

/// Closes all joints and returns the widest \[mm\]; a line gives way to an arc, so that tangents stay.
fn close_joints(strokes: &mut [Stroke], is_closed: bool) -> f64 {
    let mut widest: f64 = 0.0;
    let mut close = |a: &mut Piece, b: &mut Piece| {
        let (end, start) = (a.last(), b.first());
        widest = widest.max((start - end).norm());
        let at = if matches!(a, Piece::Segment(_)) { start } else { end };
        *a = with_ends(a, a.first(), at);
        *b = with_ends(b, at, b.last());
    };
    for i in 1..strokes.len() {
        let (before, after) = strokes.split_at_mut(i);
        close(before[i - 1].pieces.last_mut().expect("a stroke"), &mut after[0].pieces[0]);
    }
    if is_closed {
        // The joint of a line that is one stroke is between two pieces of it.
        let last = strokes.len() - 1;
        let (mut end, mut start) = (strokes[last].pieces[strokes[last].pieces.len() - 1], strokes[0].pieces[0]);
        close(&mut end, &mut start);
        *strokes[last].pieces.last_mut().expect("a stroke") = end;
        strokes[0].pieces[0] = start;
    }
    widest
}

pub(super) fn with_ends(piece: &Piece, from: Point, to: Point) -> Piece {
    match piece {
        _ if (from, to) == (piece.first(), piece.last()) => *piece,
        Piece::Segment(_) => Piece::Segment(Segment::new(from, to)),
        Piece::Arc(arc) => Piece::Arc(Arc::between(from, to, arc.center, arc.sweep > 0.0).0),
    }
}
