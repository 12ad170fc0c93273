//! What a user is told: sentences with their numbers, put into a language and a system of units only where they are shown.
//!
//! The English sentence stands where it is made, its numbers by name; [`Form`] tells it in German from a table
//! (`de.toml`), or with inches and tons. A third language is one more table.
//!
//! ```
//! use stampflow::message::{Amount, Form, message};
//! let found = message!("{thinning} thinner at {place}", thinning = Amount::share(0.387), place = Amount::place(23.52));
//! assert_eq!(found.told(Form::default()), "39\u{a0}% thinner at 23.5\u{a0}mm");
//! ```

mod form;
mod glossary;
mod language;

pub use crate::told as message;
pub use crate::units::{Amount, Digits};
pub use form::{Form, NO_BREAK, System, Told};
pub use glossary::{Term, terms};
pub use language::{LANGUAGES, Language};

use std::borrow::Cow;
use std::fmt;

/// A sentence, or a part of one, that can be told in any [`Form`]. Displays in English and SI.
#[derive(Clone, Debug, PartialEq)]
pub enum Message {
    /// As it is: names, files and texts of the user.
    Plain(String),
    /// A law written out, in its own units: as it is but for the decimal sign.
    Formula(String),
    /// An English sentence with `{names}` where its values stand; tables of languages go by this text.
    Sentence {
        /// The English text.
        text: &'static str,
        /// A value for every name in it.
        values: Vec<(&'static str, Value)>,
    },
    /// One after the other.
    Joined {
        /// In order; empty ones are left out.
        parts: Vec<Message>,
        /// What stands between them.
        separator: &'static str,
    },
}

/// What stands in a sentence for one of its names.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number with its unit.
    Amount(Amount),
    /// Part of a sentence.
    Message(Message),
}

/// A [`Message`](crate::message::Message) from an English sentence, and a value for every name in braces:
/// `message!("{n} of {all} elements", n = 3, all = 50)`.
#[macro_export]
#[doc(hidden)]
macro_rules! told {
    ($text:literal $(, $name:ident = $value:expr)* $(,)?) => {
        $crate::message::Message::sentence($text, vec![$((stringify!($name), $crate::message::Value::from($value))),*])
    };
}

impl Message {
    /// A sentence whose names have these values.
    pub fn sentence(text: &'static str, values: Vec<(&'static str, Value)>) -> Self {
        debug_assert!(
            names(text).all(|name| values.iter().any(|(known, _)| *known == name)),
            "a name without a value: {text}"
        );
        debug_assert!(values.iter().all(|(name, _)| names(text).any(|n| n == *name)), "a value without a name: {text}");
        Self::Sentence { text, values }
    }

    /// Parts one after the other, with a separator between those that are not empty.
    pub fn joined(parts: impl IntoIterator<Item = Self>, separator: &'static str) -> Self {
        Self::Joined { parts: parts.into_iter().filter(|part| !part.is_empty()).collect(), separator }
    }

    /// Whether nothing is said.
    pub fn is_empty(&self) -> bool {
        match self {
            Self::Plain(text) | Self::Formula(text) => text.is_empty(),
            Self::Sentence { text, .. } => text.is_empty(),
            Self::Joined { parts, .. } => parts.iter().all(Self::is_empty),
        }
    }

    /// The number, of a message that is nothing else.
    pub fn amount(&self) -> Option<Amount> {
        match self {
            Self::Sentence { text: "{amount}", values } => values.iter().find_map(|(_, value)| match value {
                Value::Amount(amount) => Some(*amount),
                Value::Message(_) => None,
            }),
            _ => None,
        }
    }

    /// The same with every number in it changed.
    #[must_use]
    pub fn with_amounts(&self, change: &dyn Fn(Amount) -> Amount) -> Self {
        match self {
            Self::Plain(_) | Self::Formula(_) => self.clone(),
            Self::Sentence { text, values } => {
                let of = |value: &Value| match value {
                    Value::Amount(amount) => Value::Amount(change(*amount)),
                    Value::Message(message) => Value::Message(message.with_amounts(change)),
                };
                Self::Sentence { text, values: values.iter().map(|(name, value)| (*name, of(value))).collect() }
            }
            Self::Joined { parts, separator } => {
                Self::Joined { parts: parts.iter().map(|part| part.with_amounts(change)).collect(), separator }
            }
        }
    }

    /// In words, numbers and units of a form; a number and its unit are kept on one line by a no-break space.
    pub fn told(&self, form: Form) -> String {
        match self {
            Self::Plain(text) => text.clone(),
            Self::Formula(text) => form.language.number(text),
            Self::Sentence { text, values } => filled(form.language.of_text(text), |name| {
                let value = values.iter().find(|(known, _)| *known == name);
                value.map_or_else(String::new, |(_, value)| value.told(form))
            }),
            Self::Joined { parts, separator } => {
                parts.iter().map(|part| part.told(form)).collect::<Vec<_>>().join(separator)
            }
        }
    }

    /// The English texts in it that a language has no words for.
    pub fn untranslated(&self, language: Language) -> Vec<&'static str> {
        match self {
            Self::Plain(_) | Self::Formula(_) => Vec::new(),
            Self::Sentence { text, values } => {
                let inner = values.iter().flat_map(|(_, value)| match value {
                    Value::Message(message) => message.untranslated(language),
                    Value::Amount(_) => Vec::new(),
                });
                let own = (!text.is_empty() && !language.knows(text)).then_some(*text);
                own.into_iter().chain(inner).collect()
            }
            Self::Joined { parts, .. } => parts.iter().flat_map(|part| part.untranslated(language)).collect(),
        }
    }
}

impl Value {
    fn told(&self, form: Form) -> String {
        match self {
            Self::Amount(amount) => amount.told(form),
            Self::Message(message) => message.told(form),
        }
    }
}

/// The text with its names replaced.
fn filled(text: &str, value: impl Fn(&str) -> String) -> String {
    let mut filled = String::with_capacity(text.len() + 16);
    let mut rest = text;
    while let Some((before, (name, after))) = rest.split_once('{').and_then(|(b, r)| Some((b, r.split_once('}')?))) {
        filled += before;
        filled += &value(name);
        rest = after;
    }
    filled + rest
}

/// The names in braces of a text.
pub fn names(text: &str) -> impl Iterator<Item = &str> {
    text.split('{').skip(1).filter_map(|rest| rest.split_once('}')).map(|(name, _)| name)
}

impl Default for Message {
    fn default() -> Self {
        Self::from("")
    }
}

/// A sentence without numbers.
impl From<&'static str> for Message {
    fn from(text: &'static str) -> Self {
        Self::Sentence { text, values: Vec::new() }
    }
}

/// What is not translated: names and texts of the user.
impl From<String> for Message {
    fn from(text: String) -> Self {
        Self::Plain(text)
    }
}

impl From<Cow<'static, str>> for Message {
    fn from(text: Cow<'static, str>) -> Self {
        match text {
            Cow::Borrowed(text) => text.into(),
            Cow::Owned(text) => text.into(),
        }
    }
}

impl From<Amount> for Message {
    fn from(amount: Amount) -> Self {
        message!("{amount}", amount = amount)
    }
}

impl From<Amount> for Value {
    fn from(amount: Amount) -> Self {
        Self::Amount(amount)
    }
}

impl From<usize> for Value {
    fn from(count: usize) -> Self {
        Self::Amount(Amount::count(count))
    }
}

impl From<Message> for Value {
    fn from(message: Message) -> Self {
        Self::Message(message)
    }
}

impl From<&'static str> for Value {
    fn from(text: &'static str) -> Self {
        Self::Message(text.into())
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        Self::Message(text.into())
    }
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.told(Form::default()).replace(NO_BREAK, " "))
    }
}

impl serde::Serialize for Message {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sentence_has_its_values_where_their_names_stand() {
        let inner = message!("{share} of it", share = Amount::share(0.25));
        let told = message!("{n} elements, {inner}, {file}", n = 3, inner = inner, file = "a.csv".to_owned());
        assert_eq!(told.to_string(), "3 elements, 25 % of it, a.csv");
        let joined = Message::joined([told, Message::default(), "end".into()], "; ");
        assert_eq!(joined.to_string(), "3 elements, 25 % of it, a.csv; end");
        assert!(Message::joined([Message::default()], "; ").is_empty());
    }
}
