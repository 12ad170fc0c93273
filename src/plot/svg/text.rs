//! Built-in font: registration, text widths and line breaks.

use super::*;
use ab_glyph::{Font, FontRef};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontDesc, FontFamily, FontStyle, TextStyle, register_font};
use std::sync::LazyLock;
use textwrap::{Options, WordSeparator, WordSplitter};

/// Family in SVG files: the built-in font, then what a browser without it has.
pub(super) const FONT: &str = "DejaVu Sans, Verdana, sans-serif";

/// DejaVu Sans, Latin, Greek and mathematical signs only.
pub(crate) static FONT_DATA: &[u8] = include_bytes!("../../../assets/DejaVuSans-subset.ttf");

static FACE: LazyLock<FontRef<'static>> =
    LazyLock::new(|| FontRef::try_from_slice(FONT_DATA).expect("the built-in font is a font"));

/// Font sizes \[px\].
pub(super) const TITLE: f64 = 21.0;
pub(super) const LABEL: f64 = 19.0;
pub(super) const TICK: f64 = 17.0;
pub(super) const NOTE: f64 = 13.5;
pub(super) const MARK: f64 = 15.0;
pub(super) const FLAG: f64 = 20.0;
pub(super) const SPACING: f64 = 1.3;
/// plotters' SVG backend divides font sizes by this.
const POINTS: f64 = 1.24;
/// Letters in a line over the mean of its paragraph, so that lines of wide letters fit.
const DENSER: f64 = 0.92;
/// Room for a browser's substitute font, which may be wider.
const ROOM: f64 = 1.065;

pub(super) fn register() {
    static ONCE: LazyLock<()> =
        LazyLock::new(|| assert!(register_font(FONT, FontStyle::Normal, FONT_DATA).is_ok(), "the font is built in"));
    *ONCE;
}

pub(super) fn style(size: f64, color: Color) -> TextStyle<'static> {
    FontDesc::new(FontFamily::Name(FONT), size * FINE * POINTS, FontStyle::Normal).color(&rgb(color))
}

pub(super) fn draw(canvas: &Canvas, text: &str, size: f64, color: Color, (x, top): (f64, f64)) {
    canvas.draw_text(&clean(text), &style(size, color), (units(x), units(top))).expect(IN_MEMORY);
}

pub(super) fn draw_line(canvas: &Canvas, line: &str, size: f64, (x, y): (f64, f64), side: HPos) {
    let style = style(size, BLACK).pos(Pos::new(side, VPos::Top));
    canvas.draw_text(&clean(line), &style, (units(x), units(y - 0.4 * size))).expect(IN_MEMORY);
}

pub(super) fn clean(text: &str) -> String {
    text.replace(|c: char| c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}'), "")
}

pub(crate) fn missing(text: &str) -> Vec<char> {
    let mut missing: Vec<char> = text.chars().filter(|c| !c.is_control() && FACE.glyph_id(*c).0 == 0).collect();
    missing.sort_unstable();
    missing.dedup();
    missing
}

/// Width of a line of text \[px\].
pub(super) fn width(text: &str, size: f64) -> f64 {
    let advance = |c: char| f64::from(FACE.h_advance_unscaled(FACE.glyph_id(c)) / FACE.units_per_em().unwrap_or(1.0));
    ROOM * size * text.chars().map(advance).sum::<f64>()
}

pub(super) fn wrapped(paragraph: &str, size: f64, widest: f64) -> Vec<String> {
    let share = width(paragraph, size) / widest;
    let columns = if share > 1.0 { (DENSER * paragraph.chars().count() as f64 / share) as usize } else { usize::MAX };
    let options = Options::new(columns).word_separator(WordSeparator::AsciiSpace);
    textwrap::wrap(paragraph, options.word_splitter(WordSplitter::NoHyphenation)).into_iter().map(Into::into).collect()
}
