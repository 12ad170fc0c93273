//! Letters: sizes, widths and line breaks.

use crate::plot::font;
use plotters::style::text_anchor::HPos;

pub(super) const TITLE: f64 = 21.0;
/// Axes.
pub(super) const LABEL: f64 = 19.0;
/// Ticks and legend.
pub(super) const TICK: f64 = 17.0;
pub(super) const NOTE: f64 = 13.5;
/// Inside a panel.
pub(super) const MARK: f64 = 15.0;
/// What a picture is looked at for, read at the width of a column too.
pub(super) const CALLOUT: f64 = 20.0;
/// Line spacing over font size.
pub(super) const SPACING: f64 = 1.3;
/// Top of a line above its baseline, over the font size.
pub(super) const CAP: f64 = 0.76;
/// The middle of a line of text above its baseline, over the font size.
pub(super) const MIDDLE: f64 = 0.25;
/// How much wider text may come out than in the built-in font: a browser that has not got it takes another.
const ROOM: f64 = 1.065;

/// Lines no wider than `width`, broken between words, and within a word that is wider than a line.
pub(super) fn wrapped(paragraph: &str, size: f64, width: f64) -> Vec<String> {
    let mut lines = vec![String::new()];
    let (mut end, space) = (0.0, text_width(" ", size));
    let words = paragraph.split(is_break).filter(|word| !word.is_empty());
    for word in words.flat_map(|word| pieces(word, size, width)) {
        let line = lines.last_mut().expect("there is a line");
        let wide = text_width(&word, size);
        if line.is_empty() {
            (*line, end) = (word, wide);
        } else if end + space + wide <= width {
            line.push(' ');
            line.push_str(&word);
            end += space + wide;
        } else {
            lines.push(word);
            end = wide;
        }
    }
    lines
}

/// Whether a line may end here: not between a number and its unit.
fn is_break(letter: char) -> bool {
    letter.is_whitespace() && !matches!(letter, '\u{a0}' | '\u{2009}' | '\u{202f}')
}

/// A word in pieces no wider than `width`.
fn pieces(word: &str, size: f64, width: f64) -> Vec<String> {
    if text_width(word, size) <= width {
        return vec![word.to_owned()];
    }
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

/// Where a line of text begins from the place that it is anchored at \[em\].
pub(super) fn start(text: &str, anchor: HPos) -> f64 {
    match anchor {
        HPos::Left => 0.0,
        HPos::Center => -0.5 * font::width(text),
        HPos::Right => -font::width(text),
    }
}

pub(super) fn text_width(text: &str, size: f64) -> f64 {
    ROOM * size * font::width(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_notes_are_wrapped_between_words() {
        let note = "word ".repeat(60);
        let lines = wrapped(&note, NOTE, 300.0);
        assert!(lines.len() > 3 && lines.iter().all(|line| text_width(line, NOTE) <= 300.0));
        assert_eq!(lines.join(" "), note.trim());
    }

    #[test]
    fn a_number_stays_with_its_unit() {
        let lines = wrapped(&"force 26\u{a0}kN ".repeat(40), NOTE, 300.0);
        assert!(lines.len() > 3 && lines.iter().all(|line| !line.starts_with("kN")), "{lines:?}");
    }

    #[test]
    fn a_word_wider_than_a_line_is_broken() {
        let path = format!("see {}", "/a/long/path".repeat(20));
        let lines = wrapped(&path, NOTE, 300.0);
        assert!(lines.len() > 3 && lines.iter().all(|line| text_width(line, NOTE) <= 300.0), "{lines:?}");
        assert_eq!(lines.concat().replace(' ', ""), path.replace(' ', ""));
    }
}
