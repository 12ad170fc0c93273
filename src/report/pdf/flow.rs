//! Pages that are filled from the top down.

use super::words::{Style, lines};
use crate::output::Drawing;
use crate::plot::chart::Color;
use crate::plot::pdf::{MM, Page};

/// A4 \[pt\].
const SIZE: (f64, f64) = (210.0 * MM, 297.0 * MM);
/// Left and right, above and below what is written \[pt\].
const SIDE: f64 = 14.0 * MM;
const TOP: f64 = 14.0 * MM;
const BOTTOM: f64 = 18.0 * MM;
/// Between margins \[pt\].
pub(super) const WIDTH: f64 = SIZE.0 - 2.0 * SIDE;

/// Where the foot of a page stands \[pt\].
const FOOT: f64 = SIZE.1 - 10.0 * MM;

/// Pages in the making. Places are from the left margin and from the top of the page \[pt\].
pub(super) struct Flow {
    pub pages: Vec<Page>,
    /// How far the last page is filled.
    pub y: f64,
}

impl Flow {
    pub fn new() -> Self {
        Self { pages: vec![Page::new(SIZE.0, SIZE.1)], y: TOP }
    }

    /// Height that is left on the page.
    pub fn left(&self) -> f64 {
        SIZE.1 - BOTTOM - self.y
    }

    /// Goes on to the next page unless there is so much room; what is higher than a page begins on one.
    pub fn reserve(&mut self, height: f64) {
        if height > self.left() {
            self.turn();
        }
    }

    /// Goes on to the next page, unless this one is empty.
    pub fn turn(&mut self) {
        if self.y > TOP {
            self.pages.push(Page::new(SIZE.0, SIZE.1));
            self.y = TOP;
        }
    }

    pub fn skip(&mut self, height: f64) {
        self.y += height;
    }

    /// The page that is filled, counted from 0.
    pub fn number(&self) -> usize {
        self.pages.len() - 1
    }

    pub fn page(&mut self) -> &mut Page {
        self.pages.last_mut().expect("there is a page")
    }

    /// A line of words by its upper left corner, on the page that is filled.
    pub fn write(&mut self, words: &str, style: Style, x: f64, top: f64) {
        self.page().text(words, (SIDE + x, top + style.ascent()), style.letters());
    }

    /// A line of words on any page, with its right end at the right margin.
    pub fn write_right(&mut self, page: usize, words: &str, style: Style, top: f64) {
        let at = (SIDE + WIDTH - style.width(words), top + style.ascent());
        self.pages[page].text(words, at, style.letters());
    }

    /// Words in lines between `x` and the right margin, from where the page is filled to.
    pub fn words(&mut self, words: &str, style: Style, x: f64) {
        for line in lines(words, style, WIDTH - x) {
            self.reserve(style.leading());
            self.write(&line, style, x, self.y);
            self.skip(style.leading());
        }
    }

    /// A rectangle by its upper left corner, width and height.
    pub fn bar(&mut self, (x, top): (f64, f64), (width, height): (f64, f64), fill: Color) {
        let (left, right, bottom) = (SIDE + x, SIDE + x + width, top + height);
        self.page().area(&[(left, top), (right, top), (right, bottom), (left, bottom)], fill);
    }

    /// The outline of a rectangle.
    pub fn frame(&mut self, (x, top): (f64, f64), (width, height): (f64, f64), color: Color) {
        let (left, right, bottom) = (SIDE + x, SIDE + x + width, top + height);
        let around = [(left, top), (right, top), (right, bottom), (left, bottom), (left, top)];
        self.page().lines([&around[..]], color, 0.5);
    }

    /// A thin line over the whole width.
    pub fn rule(&mut self, top: f64, color: Color, width: f64) {
        self.page().lines([&[(SIDE, top), (SIDE + WIDTH, top)][..]], color, width);
    }

    /// A drawing by its upper left corner, so many times as large.
    pub fn drawing(&mut self, drawing: &Drawing, (x, top): (f64, f64), scale: f64) {
        drawing.onto(self.page(), (SIDE + x, top), scale * drawing.width);
    }

    /// The foot of every page: `left`, and which of how many it is.
    pub fn number_pages(&mut self, left: &str, number: impl Fn(usize, usize) -> String, style: Style) {
        let all = self.pages.len();
        let left = lines(left, style, 0.8 * WIDTH).swap_remove(0);
        for i in 0..all {
            self.pages[i].text(&left, (SIDE, FOOT + style.ascent()), style.letters());
            self.write_right(i, &number(i + 1, all), style, FOOT);
        }
    }
}
