//! Language and units of text.

use super::Message;
use super::language::Language;
use crate::units::Amount;
pub use crate::units::{DisplaySettings as System, DisplayUnit as Told};

/// Between a number and its unit: a line does not end there.
pub const NO_BREAK: char = '\u{a0}';

/// Language and system of units of what is told.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Form {
    /// Of words and of the decimal sign.
    pub language: Language,
    /// Of numbers.
    pub system: System,
}

impl Form {
    /// The words for it.
    pub fn tell(self, what: impl Into<Message>) -> String {
        what.into().told(self)
    }
}

impl Amount {
    /// The number and its unit in a form.
    pub fn told(self, form: Form) -> String {
        let _scope = form.system.scope();
        self.to_string().replace(' ', &NO_BREAK.to_string())
    }
}
