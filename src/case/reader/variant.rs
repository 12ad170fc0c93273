//! A variant of an enum, as serde reads it.

use super::{Error, Span, Value};
use serde::de::value::StrDeserializer;
use serde::de::{DeserializeSeed, EnumAccess, Error as _, Unexpected, VariantAccess, Visitor};
use toml::de::DeValue;

/// A variant: its name alone, or the one entry of a table, its name and what it is made of.
pub(super) struct Variant<'t> {
    name: &'t str,
    span: Span,
    content: Content<'t>,
}

/// What a variant is made of, if it says so.
pub(super) struct Content<'t>(Option<Value<'t>>);

impl<'t> Value<'t> {
    pub(super) fn variant(&self) -> Result<Variant<'t>, Error> {
        match self.value {
            DeValue::String(name) => Ok(Variant { name, span: self.span.clone(), content: Content(None) }),
            DeValue::Table(table) => match (table.iter().next(), table.len()) {
                (Some((name, value)), 1) => {
                    Ok(Variant { name: name.get_ref(), span: name.span(), content: Content(Some(Self::of(value))) })
                }
                (None, _) => Err(Error::custom("wanted exactly 1 element, found 0 elements")),
                _ => Err(Error::custom("wanted exactly 1 element, more than 1 element")),
            },
            _ => Err(Error::custom("wanted string or table")),
        }
    }
}

impl<'t> EnumAccess<'t> for Variant<'t> {
    type Error = Error;
    type Variant = Content<'t>;

    fn variant_seed<S: DeserializeSeed<'t>>(self, seed: S) -> Result<(S::Value, Content<'t>), Error> {
        let name = StrDeserializer::<Error>::new(self.name);
        let read = seed.deserialize(name).map_err(|error| error.at(&self.span))?;
        Ok((read, self.content))
    }
}

impl<'t> Content<'t> {
    fn value(self, wanted: &'static str) -> Result<Value<'t>, Error> {
        self.0.ok_or_else(|| Error::invalid_type(Unexpected::UnitVariant, &wanted))
    }
}

impl<'t> VariantAccess<'t> for Content<'t> {
    type Error = Error;

    fn unit_variant(self) -> Result<(), Error> {
        let Some(Value { value, span }) = self.0 else { return Ok(()) };
        match value {
            DeValue::Table(table) if table.is_empty() => Ok(()),
            DeValue::Table(_) => Err(Error::new("expected empty table", &span)),
            other => Err(Error::new(format!("expected table, found {}", other.type_str()), &span)),
        }
    }

    fn newtype_variant_seed<S: DeserializeSeed<'t>>(self, seed: S) -> Result<S::Value, Error> {
        let value = self.value("newtype variant")?;
        let span = value.span.clone();
        seed.deserialize(value).map_err(|error| error.at(&span))
    }

    fn tuple_variant<V: Visitor<'t>>(self, _: usize, visitor: V) -> Result<V::Value, Error> {
        let value = self.value("tuple variant")?;
        let span = value.span.clone();
        value.array(visitor).map_err(|error| error.at(&span))
    }

    fn struct_variant<V: Visitor<'t>>(self, fields: &'static [&'static str], visitor: V) -> Result<V::Value, Error> {
        let value = self.value("struct variant")?;
        if let DeValue::Table(table) = value.value {
            let unknown = table.keys().find(|key| !fields.contains(&key.get_ref().as_ref()));
            if let Some(key) = unknown {
                return Err(Error::unknown_field(key.get_ref(), fields).at(&key.span()));
            }
        }
        let span = value.span.clone();
        value.table(visitor).map_err(|error| error.at(&span))
    }
}
