//! Letters as pixels, each made once.

use super::cover::{Cover, FAR, Span};
use super::mark::Point;
use crate::plot::font;
use std::cell::RefCell;
use std::collections::HashMap;
use ttf_parser::GlyphId;

/// Chords of letters leave their curves by about so much \[pixels\].
const SAGITTA: f64 = 0.15;

/// Places within a pixel that letters are drawn at, along each direction: none is off by as much as is seen.
const PLACES: f64 = 4.0;

thread_local! {
    /// What the pictures of a run have in common, titles and notes, is made for the first of them.
    static GLYPHS: RefCell<Glyphs> = RefCell::default();
}

/// A letter, how large it is \[pixels\], as bits, whether it goes up the page, and its place within a pixel.
type Key = (GlyphId, u64, bool, [u8; 2]);

#[derive(Default)]
struct Glyphs {
    known: HashMap<Key, Vec<Span>>,
    /// What a letter is made with.
    cover: Cover,
}

/// Says the pixels of a letter whose font is `em` large, with its origin at a point, and which goes up the page where it
/// is turned \[pixels\].
pub(super) fn spans(glyph: GlyphId, em: f64, turned: bool, at: Point, mut each: impl FnMut(Span)) {
    // The pixel, and the place in it.
    let [(column, right), (row, down)] = [at.0, at.1].map(|v| {
        let place = (v.clamp(-FAR, FAR) * PLACES).round();
        let pixel = (place / PLACES).floor();
        (pixel as i32, (place - PLACES * pixel) as u8)
    });
    GLYPHS.with_borrow_mut(|Glyphs { known, cover }| {
        let made = known.entry((glyph, em.to_bits(), turned, [right, down])).or_insert_with(|| {
            let within = (f64::from(right) / PLACES, f64::from(down) / PLACES);
            made(cover, glyph, em, turned, within)
        });
        for span in made.iter() {
            each(Span { row: row + span.row, from: column + span.from, to: column + span.to, ..*span });
        }
    });
}

/// The pixels of a letter about its origin.
fn made(cover: &mut Cover, glyph: GlyphId, em: f64, turned: bool, at: Point) -> Vec<Span> {
    let mut edges = Vec::new();
    let place = |(x, y): Point| {
        let (x, y) = if turned { (y, -x) } else { (x, y) };
        (at.0 + em * x, at.1 + em * y)
    };
    font::outline(glyph, SAGITTA / em, &mut |from, to| edges.push((place(from), place(to))));
    // Into a window of the letter's size and back.
    let points = || edges.iter().flat_map(|edge| [edge.0, edge.1]);
    let (left, top) = points().fold((0.0_f64, 0.0_f64), |(x, y), p| (x.min(p.0), y.min(p.1)));
    let (right, bottom) = points().fold((0.0_f64, 0.0_f64), |(x, y), p| (x.max(p.0), y.max(p.1)));
    let (left, top) = (left.floor(), top.floor());
    cover.widen((right - left).ceil() as usize, (bottom - top).ceil() as usize);
    let moved = |p: Point| (p.0 - left, p.1 - top);
    edges.iter().for_each(|(from, to)| cover.edge(moved(*from), moved(*to)));
    let (row, column) = (top as i32, left as i32);
    let mut spans = Vec::new();
    cover.spans(|span| {
        spans.push(Span { row: span.row + row, from: span.from + column, to: span.to + column, ..span });
    });
    spans
}
