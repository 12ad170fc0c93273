//! Built-in font: registration, text widths and line breaks.

use super::{Canvas, FINE, IN_MEMORY, rgb, units};
use crate::plot::chart::Color;
use ab_glyph::{Font, FontRef};
use plotters::style::{FontDesc, FontFamily, FontStyle, TextStyle, register_font};
use std::sync::LazyLock;

/// Family in SVG files: the built-in font, then what a browser without it has.
pub(super) const FONT: &str = "DejaVu Sans, Verdana, sans-serif";

/// DejaVu Sans, Latin, Greek and mathematical signs only.
pub(crate) static FONT_DATA: &[u8] = include_bytes!("../../../assets/DejaVuSans-subset.ttf");

static FACE: LazyLock<FontRef<'static>> =
    LazyLock::new(|| FontRef::try_from_slice(FONT_DATA).expect("the built-in font is a font"));

/// Font sizes \[px\].
pub(super) const TITLE: f64 = 21.0;
/// Axis labels.
pub(super) const LABEL: f64 = 19.0;
/// Ticks and legend.
pub(super) const TICK: f64 = 17.0;
pub(super) const NOTE: f64 = 13.5;
/// Texts inside a panel.
pub(super) const MARK: f64 = 15.0;
/// Callouts, legible at the width of a column.
pub(super) const CALLOUT: f64 = 20.0;
/// Line spacing over font size.
pub(super) const SPACING: f64 = 1.3;
/// plotters' SVG backend divides font sizes by this.
const POINTS: f64 = 1.24;
/// Room for a browser's substitute font, which may be wider.
const ROOM: f64 = 1.065;

/// Makes the built-in font known to plotters.
pub(super) fn register() {
    static ONCE: LazyLock<()> =
        LazyLock::new(|| assert!(register_font(FONT, FontStyle::Normal, FONT_DATA).is_ok(), "the font is built in"));
    *ONCE;
}

pub(super) fn style(size: f64, color: Color) -> TextStyle<'static> {
    FontDesc::new(FontFamily::Name(FONT), size * FINE * POINTS, FontStyle::Normal).color(&rgb(color))
}

/// Draws a line of text by its upper left corner.
pub(super) fn draw(canvas: &Canvas, text: &str, size: f64, color: Color, (x, top): (f64, f64)) {
    canvas.draw_text(&clean(text), &style(size, color), (units(x), units(top))).expect(IN_MEMORY);
}

/// Text without the characters that XML cannot hold.
pub(super) fn clean(text: &str) -> String {
    text.replace(|c: char| c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}'), "")
}

/// Characters of a text that the built-in font lacks, each once.
pub(crate) fn missing(text: &str) -> Vec<char> {
    let mut missing: Vec<char> = text.chars().filter(|c| !c.is_control() && FACE.glyph_id(*c).0 == 0).collect();
    missing.sort_unstable();
    missing.dedup();
    missing
}

/// Width of a line of text \[px\].
pub(super) fn width(text: &str, size: f64) -> f64 {
    let em = FACE.units_per_em().unwrap_or(1.0);
    let advance = |c: char| f64::from(FACE.h_advance_unscaled(FACE.glyph_id(c)) / em);
    ROOM * size * text.chars().map(advance).sum::<f64>()
}

/// Lines no wider than `widest`, broken between words, and within a word that is wider than a line.
pub(super) fn wrapped(paragraph: &str, size: f64, widest: f64) -> Vec<String> {
    let is_break = |c: char| c.is_whitespace() && !matches!(c, '\u{a0}' | '\u{2009}' | '\u{202f}');
    let mut lines = vec![String::new()];
    let words = paragraph.split(is_break).filter(|word| !word.is_empty());
    for word in words.flat_map(|word| pieces(word, size, widest)) {
        let line = lines.last_mut().expect("there is a line");
        let longer = format!("{line} {word}");
        if line.is_empty() {
            *line = word;
        } else if width(&longer, size) <= widest {
            *line = longer;
        } else {
            lines.push(word);
        }
    }
    lines
}

fn pieces(word: &str, size: f64, widest: f64) -> Vec<String> {
    let mut pieces = vec![String::new()];
    for letter in word.chars() {
        let piece = pieces.last_mut().expect("there is a piece");
        piece.push(letter);
        if piece.chars().count() > 1 && width(piece, size) > widest {
            piece.pop();
            pieces.push(letter.to_string());
        }
    }
    pieces
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_break_between_words_but_not_before_a_unit() {
        for text in ["force 26\u{a0}kN ".repeat(40), "/a/long/path".repeat(40)] {
            let lines = wrapped(&text, NOTE, 300.0);
            assert!(lines.len() > 3 && lines.iter().all(|line| width(line, NOTE) <= 300.0), "{lines:?}");
            assert!(lines.iter().all(|line| !line.starts_with("kN")), "{lines:?}");
            assert_eq!(lines.concat().replace(' ', ""), text.replace(' ', ""));
        }
    }
}
