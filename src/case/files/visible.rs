//! Text from outside, for a screen.

use std::borrow::Cow;

/// The text with what a terminal would obey written as its code: a title that holds an escape shows `\u001b`.
///
/// Codes are those of JSON and TOML, so that a JSON text stays one. Ends of lines and tabs are left alone.
pub fn visible(text: &str) -> Cow<'_, str> {
    if !text.contains(is_obeyed) {
        return Cow::Borrowed(text);
    }
    let shown = |(at, c): (usize, char)| match c {
        '\r' if text[at..].starts_with("\r\n") => "\r".to_owned(),
        c if is_obeyed(c) => format!("\\u{:04x}", u32::from(c)),
        c => c.to_string(),
    };
    Cow::Owned(text.char_indices().map(shown).collect())
}

/// Control characters, and those that turn the direction of writing or end a line where none is seen to end.
fn is_obeyed(c: char) -> bool {
    let turns = matches!(c, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    turns || c.is_control() && c != '\n' && c != '\t'
}
