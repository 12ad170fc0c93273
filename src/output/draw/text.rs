//! Text: sizes, widths, line breaks, and the built-in font that plotters measures with.

use super::shape::rgb;
use super::{Canvas, FINE, NEVER, units};
use crate::output::chart::{BLACK, Color};
use crate::output::font::{DATA, FAMILY};
use plotters::prelude::*;
use plotters::style::register_font;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use std::sync::Once;

pub(super) const TITLE: f64 = 21.0;
/// Axes.
pub(super) const LABEL: f64 = 19.0;
/// Ticks and legend.
pub(super) const TICK: f64 = 17.0;
pub(super) const NOTE: f64 = 13.5;
/// Inside a panel.
pub(super) const MARK: f64 = 15.0;
/// Line spacing over font size.
pub(super) const SPACING: f64 = 1.3;

/// Makes the font known to plotters; once is enough, more does no harm.
pub(super) fn register() {
    static DONE: Once = Once::new();
    DONE.call_once(|| {
        if register_font(FAMILY, FontStyle::Normal, DATA).is_err() {
            unreachable!("the built-in font is a font");
        }
    });
}

/// Lines no wider than `width`, broken between words, and within a word that is wider than a line.
pub(super) fn wrapped(paragraph: &str, size: f64, width: f64) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in paragraph.split_whitespace().flat_map(|word| pieces(word, size, width)) {
        let line = lines.last_mut().expect("there is a line");
        let longer = if line.is_empty() { word.to_owned() } else { format!("{line} {word}") };
        if line.is_empty() || text_width(&longer, size) <= width {
            *line = longer;
        } else {
            lines.push(word.to_owned());
        }
    }
    lines
}

/// A word in pieces no wider than `width`.
fn pieces(word: &str, size: f64, width: f64) -> Vec<String> {
    let mut pieces = vec![String::new()];
    for letter in word.chars() {
        let piece = pieces.last_mut().expect("there is a piece");
        piece.push(letter);
        if piece.chars().count() > 1 && text_width(piece, size) > width {
            piece.pop();
            pieces.push(letter.to_string());
        }
    }
    pieces
}

pub(super) fn text_width(text: &str, size: f64) -> f64 {
    let (width, _) = style(size, BLACK).font.box_size(text).expect(NEVER);
    f64::from(width) / FINE
}

pub(super) fn text(canvas: &Canvas, text: &str, size: f64, color: Color, at: (f64, f64)) {
    // What XML cannot hold, escape sequences for example, is left out.
    let text = text.replace(|c: char| c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}'), "");
    let style = style(size, color).pos(Pos::new(HPos::Left, VPos::Top));
    canvas.draw(&Text::new(text, (units(at.0), units(at.1)), style)).expect(NEVER);
}

/// plotters sizes a font by its line, 1.24 times the em that is meant here.
pub(super) fn style(size: f64, color: Color) -> TextStyle<'static> {
    FontDesc::new(FontFamily::Name(FAMILY), 1.24 * size * FINE, FontStyle::Normal).color(&rgb(color))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_notes_are_wrapped_between_words() {
        register();
        let note = "word ".repeat(60);
        let lines = wrapped(&note, NOTE, 300.0);
        assert!(lines.len() > 3 && lines.iter().all(|line| text_width(line, NOTE) <= 300.0));
        assert_eq!(lines.join(" "), note.trim());
    }

    #[test]
    fn a_word_wider_than_a_line_is_broken() {
        register();
        let path = format!("see {}", "/a/long/path".repeat(20));
        let lines = wrapped(&path, NOTE, 300.0);
        assert!(lines.len() > 3 && lines.iter().all(|line| text_width(line, NOTE) <= 300.0), "{lines:?}");
        assert_eq!(lines.concat().replace(' ', ""), path.replace(' ', ""));
    }
}
