//! A parsed case as serde reads it.
//!
//! What serde makes of a type is copied for every kind of table, array and text that a deserializer knows; this one knows one
//! of each, borrows what was parsed, and so is a third of what that of the TOML crate would add to the program.

use serde::de::value::StrDeserializer;
use serde::de::{
    self, DeserializeSeed, Deserializer, EnumAccess, Error as _, MapAccess, SeqAccess, Unexpected, VariantAccess,
    Visitor,
};
use std::fmt::{self, Display};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

type Span = Range<usize>;

/// What serde complains of, and the place in the text that it is about.
#[derive(Debug)]
pub(super) struct Error {
    message: String,
    span: Option<Span>,
}

impl Error {
    /// In serde's words.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// Of the key or value.
    pub fn span(&self) -> Option<Span> {
        self.span.clone()
    }

    fn new(message: impl Into<String>, span: &Span) -> Self {
        Self { message: message.into(), span: Some(span.clone()) }
    }

    /// At a place, unless a deeper one is known.
    #[cold]
    fn at(mut self, span: &Span) -> Self {
        self.span.get_or_insert_with(|| span.clone());
        self
    }
}

impl Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl std::error::Error for Error {}

impl de::Error for Error {
    fn custom<T: Display>(message: T) -> Self {
        Self { message: message.to_string(), span: None }
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

impl<'t> Value<'t> {
    fn of(value: &'t Spanned<DeValue<'t>>) -> Self {
        Self { value: value.get_ref(), span: value.span() }
    }
}

impl<'t> Deserializer<'t> for Value<'t> {
    type Error = Error;

    fn deserialize_any<V: Visitor<'t>>(self, visitor: V) -> Result<V::Value, Error> {
        let read = match self.value {
            DeValue::String(text) => visitor.visit_str(text),
            DeValue::Integer(number) => match i64::from_str_radix(number.as_str(), number.radix()) {
                Ok(number) => visitor.visit_i64(number),
                Err(_) => Err(Error::custom("integer number overflowed")),
            },
            DeValue::Float(number) => match float(number.as_str()) {
                Some(number) => visitor.visit_f64(number),
                None => Err(Error::custom("floating-point number overflowed")),
            },
            DeValue::Boolean(is) => visitor.visit_bool(*is),
            DeValue::Datetime(_) => Err(Error::invalid_type(Unexpected::Other("date"), &visitor)),
            DeValue::Array(values) => visitor.visit_seq(Items(values.iter())),
            DeValue::Table(table) => visitor.visit_map(Entries::of(table)),
        };
        read.map_err(|error| error.at(&self.span))
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
        let read = match self.value {
            DeValue::String(text) => visitor.visit_enum(StrDeserializer::new(text)),
            DeValue::Table(table) => match (table.iter().next(), table.len()) {
                (Some((name, value)), 1) => visitor.visit_enum(Variant { name, value: Self::of(value) }),
                (None, _) => Err(Error::custom("wanted exactly 1 element, found 0 elements")),
                _ => Err(Error::custom("wanted exactly 1 element, more than 1 element")),
            },
            _ => Err(Error::custom("wanted string or table")),
        };
        read.map_err(|error| error.at(&self.span))
    }

    serde::forward_to_deserialize_any! {
        <V: Visitor<'t>>
        bool u8 u16 u32 u64 u128 i8 i16 i32 i64 i128 f32 f64 char str string seq bytes byte_buf map unit
        ignored_any unit_struct tuple_struct tuple identifier struct
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
        self.0.next().map(|value| seed.deserialize(Value::of(value))).transpose()
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

/// The one entry of a table that stands for a variant with its parameters.
struct Variant<'t> {
    name: &'t Key<'t>,
    value: Value<'t>,
}

impl<'t> EnumAccess<'t> for Variant<'t> {
    type Error = Error;
    type Variant = Value<'t>;

    fn variant_seed<S: DeserializeSeed<'t>>(self, seed: S) -> Result<(S::Value, Value<'t>), Error> {
        let name = StrDeserializer::<Error>::new(self.name.get_ref());
        let read = seed.deserialize(name).map_err(|error| error.at(&self.name.span()))?;
        Ok((read, self.value))
    }
}

impl<'t> VariantAccess<'t> for Value<'t> {
    type Error = Error;

    fn unit_variant(self) -> Result<(), Error> {
        match self.value {
            DeValue::Table(table) if table.is_empty() => Ok(()),
            DeValue::Table(_) => Err(Error::new("expected empty table", &self.span)),
            other => Err(Error::new(format!("expected table, found {}", other.type_str()), &self.span)),
        }
    }

    fn newtype_variant_seed<S: DeserializeSeed<'t>>(self, seed: S) -> Result<S::Value, Error> {
        seed.deserialize(self)
    }

    fn tuple_variant<V: Visitor<'t>>(self, _: usize, visitor: V) -> Result<V::Value, Error> {
        self.deserialize_any(visitor)
    }

    fn struct_variant<V: Visitor<'t>>(self, fields: &'static [&'static str], visitor: V) -> Result<V::Value, Error> {
        if let DeValue::Table(table) = self.value {
            let unknown = table.keys().find(|key| !fields.contains(&key.get_ref().as_ref()));
            if let Some(key) = unknown {
                return Err(Error::unknown_field(key.get_ref(), fields).at(&key.span()));
            }
        }
        self.deserialize_any(visitor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::CaseFile;
    use serde::Deserialize;

    type Read = Result<String, (String, Option<Span>)>;

    /// What a text says by this reader, and by that of the TOML crate.
    fn by_both(text: &str) -> [Read; 2] {
        let table = DeTable::parse(text).expect("TOML");
        let own = read::<CaseFile>(table.get_ref());
        let theirs = CaseFile::deserialize(toml::de::Deserializer::from(table.clone()));
        [
            own.map(|file| format!("{file:?}")).map_err(|error| (error.message().to_owned(), error.span())),
            theirs.map(|file| format!("{file:?}")).map_err(|error| (error.message().to_owned(), error.span())),
        ]
    }

    /// Trust: the deserializer of the TOML crate.
    #[test]
    fn every_shipped_case_is_read_as_by_the_toml_crate() {
        let mut count = 0;
        for entry in std::fs::read_dir("cases").expect("the cases") {
            let path = entry.expect("an entry").path();
            if path.extension().is_some_and(|extension| extension == "toml") {
                let [own, theirs] = by_both(&std::fs::read_to_string(&path).expect("text"));
                assert_eq!(own, theirs, "{}", path.display());
                count += 1;
            }
        }
        assert!(count > 15, "only {count} cases");
    }

    /// Trust: the same; message and place.
    #[test]
    fn what_is_wrong_is_said_as_by_the_toml_crate() {
        let base = "title = \"A\"\ngeometry = \"axisymmetric\"\n";
        for wrong in [
            "",
            "[blank]\nradius = [1]\nthickness = \"1 mm\"\n",
            "[blank]\nradius = \"1 mm\"\nthickness = \"1 mm\"\nelements = 1.5\n",
            "[blank]\nradius = \"1 mm\"\nthickness = \"1 mm\"\nelements = -1\n",
            "[blank]\nradius = \"1 mm\"\nthickness = \"1 furlong\"\n",
            "[blank]\nradius = \"1 mm\"\nthickness = \"1 mm\"\nwidht = 1\n",
            "[solver]\niteration = \"newtn\"\n",
            "[solver]\nmax_step = true\n",
            "blank = 3\n",
            "notes = [\"a\", 2]\n",
        ] {
            let [own, theirs] = by_both(&format!("{base}{wrong}"));
            assert!(own.is_err(), "{wrong:?} is accepted");
            assert_eq!(own, theirs, "{wrong:?}");
        }
    }
}
