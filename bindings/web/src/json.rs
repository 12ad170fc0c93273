//! JSON as it is written: a few kinds of values, and arrays of numbers that stand beside it.

use std::fmt::{self, Display, Formatter, Write};

/// A value of the answer.
pub enum Value {
    Null,
    Bool(bool),
    Number(f64),
    Text(String),
    List(Vec<Value>),
    Table(Vec<(&'static str, Value)>),
}

/// A table of keys and what can become a value.
macro_rules! table {
    ($($key:literal: $value:expr),* $(,)?) => {
        $crate::json::Value::Table(vec![$(($key, $crate::json::Value::from($value))),*])
    };
}
pub(crate) use table;

impl Value {
    /// A list of what can become values.
    pub fn list<T: Into<Value>>(of: impl IntoIterator<Item = T>) -> Self {
        Self::List(of.into_iter().map(Into::into).collect())
    }
}

impl From<bool> for Value {
    fn from(is: bool) -> Self {
        Self::Bool(is)
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<usize> for Value {
    fn from(count: usize) -> Self {
        Self::Number(count as f64)
    }
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

impl From<String> for Value {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}

impl From<Vec<Value>> for Value {
    fn from(values: Vec<Value>) -> Self {
        Self::List(values)
    }
}

impl<T: Into<Value>> From<Option<T>> for Value {
    fn from(value: Option<T>) -> Self {
        value.map_or(Self::Null, Into::into)
    }
}

impl Display for Value {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Bool(is) => write!(f, "{is}"),
            Self::Number(number) if number.is_finite() => write!(f, "{number}"),
            Self::Null | Self::Number(_) => f.write_str("null"),
            Self::Text(text) => quoted(text, f),
            Self::List(values) => {
                f.write_char('[')?;
                for (i, value) in values.iter().enumerate() {
                    write!(f, "{}{value}", if i > 0 { "," } else { "" })?;
                }
                f.write_char(']')
            }
            Self::Table(entries) => {
                f.write_char('{')?;
                for (i, (key, value)) in entries.iter().enumerate() {
                    write!(f, "{}\"{key}\":{value}", if i > 0 { "," } else { "" })?;
                }
                f.write_char('}')
            }
        }
    }
}

fn quoted(text: &str, f: &mut Formatter<'_>) -> fmt::Result {
    f.write_char('"')?;
    for letter in text.chars() {
        match letter {
            '"' | '\\' => write!(f, "\\{letter}")?,
            '\0'..=' ' if letter != ' ' => write!(f, "\\u{:04x}", u32::from(letter))?,
            _ => f.write_char(letter)?,
        }
    }
    f.write_char('"')
}

/// Arrays of numbers, one after the other.
#[derive(Default)]
pub struct Numbers(pub Vec<f64>);

impl Numbers {
    /// Adds an array; what stands for it in the JSON.
    pub fn put(&mut self, values: impl IntoIterator<Item = f64>) -> Value {
        let at = self.0.len();
        self.0.extend(values);
        table! { "at": at, "of": self.0.len() - at }
    }
}
