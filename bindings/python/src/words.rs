//! Sentences as the command line prints them: with plain spaces, so that a text can be looked for in them.

use stampflow::message::NO_BREAK;
use std::fmt::Display;

/// A text with plain spaces between numbers and their units.
pub fn plain(text: impl Display) -> String {
    text.to_string().replace(NO_BREAK, " ")
}
