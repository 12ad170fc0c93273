//! Strokes of a tool joined end to end into one chain.

use super::{ImportError, Result, dxf::Source, ensure, frame::Frame, layers::ToolId};
use crate::geometry::{Bounds, Piece, Point, turn};
use crate::units::significant;
use std::{f64::consts::FRAC_PI_2, f64::consts::PI, rc::Rc};

/// Largest angle between overlapping lines \[rad\].
const ALONG: f64 = 0.01;

/// Pieces in order, each with the source of its stroke: of one entity, or of a tool.
#[derive(Clone, Debug)]
pub(super) struct Chain {
    pub pieces: Vec<(Piece, Rc<Source>)>,
    pub is_closed: bool,
}

type End = (usize, bool);

impl Chain {
    pub fn stroke(pieces: impl IntoIterator<Item = Piece>, source: &Source) -> Self {
        let source = Rc::new(source.clone());
        Self { pieces: pieces.into_iter().map(|piece| (piece, source.clone())).collect(), is_closed: false }
    }

    pub fn first(&self) -> Point {
        self.pieces[0].0.first()
    }

    pub fn last(&self) -> Point {
        self.pieces[self.pieces.len() - 1].0.last()
    }

    pub fn pieces(&self) -> impl DoubleEndedIterator<Item = &Piece> + Clone {
        self.pieces.iter().map(|(piece, _)| piece)
    }

    pub fn bounds(&self) -> Bounds {
        Bounds::around(self.pieces().copied()).expect("a chain has pieces")
    }

    pub fn reversed(self) -> Self {
        let pieces = self.pieces.iter().rev().map(|(piece, source)| (piece.reversed(), source.clone())).collect();
        Self { pieces, ..self }
    }

    pub fn source(&self, piece: usize) -> &Source {
        &self.pieces[piece].1
    }
}

pub(super) fn join(strokes: Vec<Chain>, tool: ToolId, frame: &Frame) -> Result<Chain> {
    let strokes = without_repeats(strokes, frame);
    let corners = corners(&strokes, frame.join);
    if let Some((at, ends)) = corners.iter().find(|(_, ends)| ends.len() > 2) {
        let names: Vec<String> = ends.iter().map(|(i, _)| strokes[*i].source(0).to_string()).collect();
        let what = format!("the {tool}'s line branches at {}: {} meet", frame.place(*at), names.join(", "));
        let help = "a section is one line without side branches: leave only what meets the sheet";
        return Err(strokes[ends[0].0].source(0).error(what, help));
    }
    touching(&strokes, tool, frame)?;
    let mut lines = lines(&strokes, &corners);
    if let Some(line) = lines.iter().find(|line| line.is_closed).filter(|_| lines.len() > 1) {
        let (source, place, count) = (line.source(0), frame.place(line.first()), lines.len());
        let what = format!("the {tool}'s line is {count} lines, one of them closed: {source} at {place}");
        let help = "which one meets the sheet cannot be told: leave only that, an open line or one outline";
        return Err(source.error(what, help));
    }
    ensure(lines.len() == 1, || gap(&lines, tool, frame))?;
    let mut chain = lines.remove(0);
    let widest = close_joints(&mut chain);
    if widest > 1e-6 {
        frame.note(format!("ends of the {tool}'s line that were up to {widest:.2e} mm apart are joined"));
    }
    Ok(chain)
}

fn without_repeats(strokes: Vec<Chain>, frame: &Frame) -> Vec<Chain> {
    // [mm]
    let distance = |stroke: &Chain, p: Point| {
        stroke.pieces().map(|piece| (piece.closest_point(p) - p).norm()).fold(f64::INFINITY, f64::min)
    };
    let within = |a: &Chain, b: &Chain| a.pieces().flat_map(|one| one.sample(4)).all(|p| distance(b, p) <= frame.join);
    let mut distinct: Vec<(Bounds, Chain)> = Vec::new();
    for stroke in strokes {
        let around = stroke.bounds();
        let mut close = distinct.iter().filter(|(other, _)| !around.is_apart(other, frame.join));
        match close.find(|(_, other)| within(&stroke, other) && within(other, &stroke)) {
            Some((_, other)) => {
                let (from, to) = (frame.place(stroke.first()), frame.place(stroke.last()));
                let (source, other) = (stroke.source(0), other.source(0));
                frame.note(format!("{source} is left out: it repeats {other}, from {from} to {to}"));
            }
            None => distinct.push((around, stroke)),
        }
    }
    distinct.into_iter().map(|(_, stroke)| stroke).collect()
}

fn corners(strokes: &[Chain], join: f64) -> Vec<(Point, Vec<End>)> {
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

fn touching(strokes: &[Chain], tool: ToolId, frame: &Frame) -> Result {
    let boxes: Vec<Bounds> = strokes.iter().map(Chain::bounds).collect();
    for (i, stroke) in strokes.iter().enumerate() {
        let [first, last] = [&stroke.pieces[0].0, &stroke.pieces[stroke.pieces.len() - 1].0];
        for (at, along) in [(first.first(), first.tangent(false)), (last.last(), last.tangent(true))] {
            let is_close = |j: &usize| *j != i && !boxes[*j].is_beyond(at, frame.join);
            for other in (0..strokes.len()).filter(is_close).map(|j| &strokes[j]) {
                let at_end = [other.first(), other.last()].iter().any(|end| (end - at).norm() <= frame.join);
                let on = other.pieces().find(|piece| (piece.closest_point(at) - at).norm() <= frame.join);
                let Some(piece) = on.filter(|_| !at_end) else { continue };
                let tangent = match piece {
                    Piece::Segment(_) => piece.tangent(false),
                    Piece::Arc(arc) => nalgebra::Rotation2::new(FRAC_PI_2) * (at - arc.center),
                };
                let angle = turn(along, tangent).abs();
                let (place, source, other) = (frame.place(at), stroke.source(0), other.source(0));
                let (what, help) = if angle.min(PI - angle) < ALONG {
                    let what = format!("two parts of the {tool}'s line overlap at {place}: {source} and {other}");
                    (what, "draw each part of the line once")
                } else {
                    let what = format!("the {tool}'s line branches at {place}: {source} ends on the inside of {other}");
                    (what, "a section is one line without side branches: trim the lines there, or leave one out")
                };
                return Err(source.error(what, help));
            }
        }
    }
    Ok(())
}

fn lines(strokes: &[Chain], corners: &[(Point, Vec<End>)]) -> Vec<Chain> {
    let (mut done, mut lines) = (vec![false; strokes.len()], Vec::new());
    let free = corners.iter().filter(|(_, ends)| ends.len() == 1).map(|(_, ends)| (ends[0], false));
    for (start, is_closed) in free.chain((0..strokes.len()).map(|i| ((i, false), true))) {
        let mut line = Chain { pieces: Vec::new(), is_closed };
        let mut next = Some(start).filter(|(i, _)| !done[*i]);
        while let Some((i, last)) = next {
            done[i] = true;
            let stroke = strokes[i].clone();
            line.pieces.extend(if last { stroke.reversed() } else { stroke }.pieces);
            let corner = corners.iter().find(|(_, ends)| ends.contains(&(i, !last)));
            next = corner.and_then(|(_, ends)| ends.iter().copied().find(|end| !done[end.0]));
        }
        lines.push(line);
    }
    lines.retain(|line| !line.pieces.is_empty());
    lines
}

fn gap(lines: &[Chain], tool: ToolId, frame: &Frame) -> ImportError {
    let ends = |line: usize| {
        let chain = &lines[line];
        [(line, chain.first(), chain.source(0)), (line, chain.last(), chain.source(chain.pieces.len() - 1))]
    };
    let ends: Vec<_> = (0..lines.len()).flat_map(ends).collect();
    let all = ends.iter().flat_map(|b| ends.iter().filter(move |a| a.0 < b.0).map(move |a| ((b.1 - a.1).norm(), a, b)));
    let closest = all.min_by(|a, b| a.0.total_cmp(&b.0)).expect("there is more than one line");
    let (distance, (_, a, from_a), (_, b, from_b)) = closest;
    let (a, b, size) = (frame.place(*a), frame.place(*b), significant(distance, 4));
    let what = format!("the {tool}'s line has a gap of {size} mm: {from_a} ends at {a} and {from_b} at {b}");
    let more = (1.2 * distance * 1e4).ceil() / 1e4;
    from_a.error(what, format!("close it in the drawing, or let such ends meet with --join \"{more} mm\""))
}

/// Closes all joints and returns the widest \[mm\]; a line gives way to an arc, so that tangents stay.
fn close_joints(chain: &mut Chain) -> f64 {
    let (mut widest, pieces): (f64, _) = (0.0, &mut chain.pieces);
    for i in 0..pieces.len() {
        let next = (i + 1) % pieces.len();
        if next == 0 && !chain.is_closed || next > 0 && Rc::ptr_eq(&pieces[i].1, &pieces[next].1) {
            continue;
        }
        let (a, b) = (pieces[i].0, pieces[next].0);
        let (end, start) = (a.last(), b.first());
        widest = widest.max((start - end).norm());
        let at = if matches!(a, Piece::Segment(_)) { start } else { end };
        pieces[i].0 = a.with_ends(a.first(), at);
        pieces[next].0 = b.with_ends(at, b.last());
    }
    widest
}
