//! Lines of words.

use crate::plot::chart::{BLACK, Color};
use crate::plot::pdf::{Letters, text_width};

/// From one baseline to the next, over the font's size.
const SPACING: f64 = 1.32;
/// The first baseline below the top of a line, over the font's size.
const ASCENT: f64 = 0.95;

/// How words look.
#[derive(Clone, Copy, Debug)]
pub(super) struct Style {
    /// Of the font \[pt\].
    pub size: f64,
    pub color: Color,
    pub bold: bool,
}

impl Style {
    /// Black, so large \[pt\].
    pub const fn new(size: f64) -> Self {
        Self { size, color: BLACK, bold: false }
    }

    pub const fn bold(self) -> Self {
        Self { bold: true, ..self }
    }

    pub const fn in_color(self, color: Color) -> Self {
        Self { color, ..self }
    }

    /// From one line to the next \[pt\].
    pub fn leading(self) -> f64 {
        SPACING * self.size
    }

    /// The baseline below the top of a line \[pt\].
    pub fn ascent(self) -> f64 {
        ASCENT * self.size
    }

    pub fn letters(self) -> Letters {
        Letters { size: self.size, color: self.color, bold: self.bold, turned: false }
    }

    /// How wide a line of words is \[pt\].
    pub fn width(self, words: &str) -> f64 {
        text_width(words, self.size)
    }
}

/// Lines no wider than `width` \[pt\], broken at spaces, and within a word only where it is wider than a line. A no-break space
/// is part of a word.
pub(super) fn lines(text: &str, style: Style, width: f64) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in
        text.split([' ', '\n', '\t']).filter(|word| !word.is_empty()).flat_map(|word| pieces(word, style, width))
    {
        let line = lines.last_mut().expect("there is a line");
        if line.is_empty() {
            *line = word;
        } else if style.width(line) + style.width(" ") + style.width(&word) <= width {
            line.push(' ');
            line.push_str(&word);
        } else {
            lines.push(word);
        }
    }
    lines
}

/// The widest word \[pt\].
pub(super) fn widest_word(text: &str, style: Style) -> f64 {
    text.split(' ').map(|word| style.width(word)).fold(0.0, f64::max)
}

/// A word in pieces no wider than `width` \[pt\].
fn pieces(word: &str, style: Style, width: f64) -> Vec<String> {
    if style.width(word) <= width {
        return vec![word.to_owned()];
    }
    let mut pieces = vec![String::new()];
    for letter in word.chars() {
        let piece = pieces.last_mut().expect("there is a piece");
        piece.push(letter);
        if piece.chars().count() > 1 && style.width(piece) > width {
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
    fn lines_break_between_words_but_not_between_a_number_and_its_unit() {
        let style = Style::new(10.0);
        let text = "thinnest at 23.5\u{a0}mm of the flat blank ".repeat(6);
        let broken = lines(&text, style, 90.0);
        assert!(broken.len() > 6 && broken.iter().all(|line| style.width(line) <= 90.0), "{broken:?}");
        assert_eq!(broken.join(" "), text.trim());
        assert_eq!(broken.iter().filter(|line| line.contains("23.5\u{a0}mm")).count(), 6);
        let path = lines(&"/a/long/path".repeat(9), style, 90.0);
        assert!(path.len() > 3 && path.concat() == "/a/long/path".repeat(9));
    }
}
