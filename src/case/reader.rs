//! A parsed case as serde reads it.
//!
//! What serde makes of a type is copied for every kind of table, array and text that a deserializer knows; this one knows one
//! of each, borrows what was parsed, hands to a visitor only what it asks for, and so is a fraction of what that of the TOML
//! crate would add to the program.

mod variant;

use serde::de::value::StrDeserializer;
use serde::de::{self, DeserializeSeed, Deserializer, Error as _, Expected, MapAccess, SeqAccess, Unexpected, Visitor};
use std::fmt::{self, Display};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

type Span = Range<usize>;

/// What serde complains of, and the place in the text that it is about; small, for every field hands it on.
#[derive(Debug)]
pub(super) struct Error(Box<Complaint>);

#[derive(Debug)]
struct Complaint {
    message: String,
    span: Option<Span>,
}

impl Error {
    /// In serde's words.
    pub fn message(&self) -> &str {
        &self.0.message
    }

    /// Of the key or value.
    pub fn span(&self) -> Option<Span> {
        self.0.span.clone()
    }

    fn new(message: impl Into<String>, span: &Span) -> Self {
        Self(Box::new(Complaint { message: message.into(), span: Some(span.clone()) }))
    }

    /// At a place, unless a deeper one is known.
    #[cold]
    fn at(mut self, span: &Span) -> Self {
        self.0.span.get_or_insert_with(|| span.clone());
        self
    }
}

impl Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.message())
    }
}

impl std::error::Error for Error {}

impl de::Error for Error {
    fn custom<T: Display>(message: T) -> Self {
        Self(Box::new(Complaint { message: message.to_string(), span: None }))
    }
}

/// Reads the table that a text is; what is about the whole of it stands at its beginning.
pub(super) fn read<'t, T: de::Deserialize<'t>>(table: &'t DeTable<'t>) -> Result<T, Error> {
    T::deserialize(Table(table)).map_err(|error| error.at(&(0..0)))
}

/// The table that a text is.
struct Table<'t>(&'t DeTable<'t>);

impl<'t> Deserializer<'t> for Table<'t> {
    type Error = Error;

    fn deserialize_any<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_map(Entries::of(self.0))
    }

    serde::forward_to_deserialize_any! {
        <V: Visitor<'t>>
        bool u8 u16 u32 u64 u128 i8 i16 i32 i64 i128 f32 f64 char str string seq bytes byte_buf map unit
        ignored_any unit_struct tuple_struct tuple identifier option newtype_struct struct enum
    }
}

/// A value, and where it stands.
struct Value<'t> {
    value: &'t DeValue<'t>,
    span: Span,
}

/// A value as a visitor takes it.
enum Plain<'t> {
    Text(&'t str),
    Integer(i64),
    Float(f64),
    Boolean(bool),
    Array(&'t [Spanned<DeValue<'t>>]),
    Table(&'t DeTable<'t>),
}

impl<'t> Value<'t> {
    fn of(value: &'t Spanned<DeValue<'t>>) -> Self {
        Self { value: value.get_ref(), span: value.span() }
    }

    /// What it is; a date is nothing that is wanted.
    #[inline(never)]
    fn plain(&self, wanted: &dyn Expected) -> Result<Plain<'t>, Error> {
        Ok(match self.value {
            DeValue::String(text) => Plain::Text(text),
            DeValue::Integer(number) => match i64::from_str_radix(number.as_str(), number.radix()) {
                Ok(number) => Plain::Integer(number),
                Err(_) => return Err(Error::custom("integer number overflowed")),
            },
            DeValue::Float(number) => match float(number.as_str()) {
                Some(number) => Plain::Float(number),
                None => return Err(Error::custom("floating-point number overflowed")),
            },
            DeValue::Boolean(is) => Plain::Boolean(*is),
            DeValue::Datetime(_) => return Err(Error::invalid_type(Unexpected::Other("date"), wanted)),
            DeValue::Array(values) => Plain::Array(values),
            DeValue::Table(table) => Plain::Table(table),
        })
    }

    /// That it is not what is wanted.
    #[cold]
    #[inline(never)]
    fn refused(&self, wanted: &dyn Expected) -> Error {
        let found = match self.plain(wanted) {
            Ok(Plain::Text(text)) => Unexpected::Str(text),
            Ok(Plain::Integer(number)) => Unexpected::Signed(number),
            Ok(Plain::Float(number)) => Unexpected::Float(number),
            Ok(Plain::Boolean(is)) => Unexpected::Bool(is),
            Ok(Plain::Array(_)) => Unexpected::Seq,
            Ok(Plain::Table(_)) => Unexpected::Map,
            Err(error) => return error,
        };
        Error::invalid_type(found, wanted)
    }

    fn number<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.plain(&visitor)? {
            Plain::Integer(number) => visitor.visit_i64(number),
            Plain::Float(number) => visitor.visit_f64(number),
            _ => Err(self.refused(&visitor)),
        }
    }

    fn text<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.value {
            DeValue::String(text) => visitor.visit_str(text),
            _ => Err(self.refused(&visitor)),
        }
    }

    fn array<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.value {
            DeValue::Array(values) => visitor.visit_seq(Items(values.iter())),
            _ => Err(self.refused(&visitor)),
        }
    }

    fn table<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.value {
            DeValue::Table(table) => visitor.visit_map(Entries::of(table)),
            _ => Err(self.refused(&visitor)),
        }
    }
}

/// What a type is told of.
macro_rules! told {
    ($($function:ident $kind:ident),*) => {$(
        fn $function<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Error> {
            self.$kind(visitor)
        }
    )*};
}

impl<'t> Deserializer<'t> for Value<'t> {
    type Error = Error;

    fn deserialize_any<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.plain(&visitor)? {
            Plain::Text(text) => visitor.visit_str(text),
            Plain::Integer(number) => visitor.visit_i64(number),
            Plain::Float(number) => visitor.visit_f64(number),
            Plain::Boolean(is) => visitor.visit_bool(is),
            Plain::Array(values) => visitor.visit_seq(Items(values.iter())),
            Plain::Table(table) => visitor.visit_map(Entries::of(table)),
        }
    }

    told!(
        deserialize_u8 number, deserialize_u16 number, deserialize_u32 number, deserialize_u64 number,
        deserialize_i8 number, deserialize_i16 number, deserialize_i32 number, deserialize_i64 number,
        deserialize_f32 number, deserialize_f64 number,
        deserialize_str text, deserialize_string text, deserialize_identifier text,
        deserialize_seq array, deserialize_map table
    );

    fn deserialize_bool<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.value {
            DeValue::Boolean(is) => visitor.visit_bool(*is),
            _ => Err(self.refused(&visitor)),
        }
    }

    /// Its fields have names: an array in their order is refused.
    fn deserialize_struct<V: Visitor<'t>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        self.table(visitor)
    }

    fn deserialize_tuple<V: Visitor<'t>>(self, _: usize, visitor: V) -> Result<V::Value, Error> {
        self.array(visitor)
    }

    fn deserialize_option<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_some(self)
    }

    fn deserialize_newtype_struct<V: Visitor<'t>>(self, _: &'static str, visitor: V) -> Result<V::Value, Error> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_enum<V: Visitor<'t>>(
        self,
        _: &'static str,
        _: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_enum(self.variant()?)
    }

    serde::forward_to_deserialize_any! {
        <V: Visitor<'t>> u128 i128 char bytes byte_buf unit ignored_any unit_struct tuple_struct
    }
}

/// A number as it is written; `None` of one that is too large, which the language would make infinite.
fn float(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.is_finite() || text.contains("inf") || text.contains("nan"))
}

/// The values of an array.
struct Items<'t>(std::slice::Iter<'t, Spanned<DeValue<'t>>>);

impl<'t> SeqAccess<'t> for Items<'t> {
    type Error = Error;

    fn next_element_seed<S: DeserializeSeed<'t>>(&mut self, seed: S) -> Result<Option<S::Value>, Error> {
        let Some(value) = self.0.next() else { return Ok(None) };
        seed.deserialize(Value::of(value)).map(Some).map_err(|error| error.at(&value.span()))
    }

    fn size_hint(&self) -> Option<usize> {
        Some(self.0.len())
    }
}

type Key<'t> = Spanned<toml::de::DeString<'t>>;

/// The keys of a table with their values.
struct Entries<'t> {
    rest: Box<dyn Iterator<Item = (&'t Key<'t>, &'t Spanned<DeValue<'t>>)> + 't>,
    value: Option<&'t Spanned<DeValue<'t>>>,
}

impl<'t> Entries<'t> {
    fn of(table: &'t DeTable<'t>) -> Self {
        Self { rest: Box::new(table.iter()), value: None }
    }
}

impl<'t> MapAccess<'t> for Entries<'t> {
    type Error = Error;

    fn next_key_seed<S: DeserializeSeed<'t>>(&mut self, seed: S) -> Result<Option<S::Value>, Error> {
        let Some((key, value)) = self.rest.next() else { return Ok(None) };
        self.value = Some(value);
        let name = StrDeserializer::<Error>::new(key.get_ref());
        seed.deserialize(name).map(Some).map_err(|error| error.at(&key.span()))
    }

    fn next_value_seed<S: DeserializeSeed<'t>>(&mut self, seed: S) -> Result<S::Value, Error> {
        let value = self.value.take().ok_or_else(|| Error::custom("a value without its key"))?;
        // What is made of the value, not only the value itself, may be wrong.
        seed.deserialize(Value::of(value)).map_err(|error| error.at(&value.span()))
    }
}

#[cfg(test)]
mod tests;
