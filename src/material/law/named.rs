//! The text form of a family: a table that names one of its laws.

use super::Family;
use crate::units::{Dimensioned, Fraction};
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::de::{self, Deserialize, Deserializer, MapAccess, Visitor, value};
use std::fmt;
use std::marker::PhantomData;

/// A law of a plain number, and what can be written instead of a table, in words.
pub type OfNumber<F> = (fn(f64) -> F, &'static str);

/// A family that a case can name a law of.
pub trait Readable: Family {
    /// Description of the family.
    const ABOUT: &'static str;
    /// Law of a plain number, if the family has one.
    const NUMBER: Option<OfNumber<Self>>;

    /// Reads the parameters of the law with this index.
    ///
    /// # Errors
    /// When they are not those of the law.
    fn read<'de, A: MapAccess<'de>>(index: usize, map: &mut A) -> Result<Self, A::Error>;

    /// The schema of every law.
    fn schemas(generator: &mut SchemaGenerator) -> Vec<Schema>;
}

/// A family as a case writes it: `{ swift = { k = "520 MPa", … } }`, and whether that is one law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Named<F> {
    law: Option<F>,
    /// Bit i: the law i of the family is named.
    named: u64,
}

impl<F: Family> Named<F> {
    /// The law, where it is the only one.
    ///
    /// # Errors
    /// With the names of all laws that were given: none, or more than one.
    pub fn only(self) -> Result<F, Vec<&'static str>> {
        match self.law {
            Some(law) if self.named.count_ones() <= 1 => Ok(law),
            _ => Err((0..F::NAMES.len()).filter(|i| self.named >> i & 1 == 1).map(|i| F::NAMES[i]).collect()),
        }
    }
}

struct Reader<F>(PhantomData<F>);

impl<'de, F: Readable> Visitor<'de> for Reader<F> {
    type Value = Named<F>;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(F::NUMBER.map_or("a map", |(_, wanted)| wanted))
    }

    fn visit_i64<E: de::Error>(self, number: i64) -> Result<Named<F>, E> {
        match F::NUMBER {
            Some(_) => self.visit_f64(number as f64),
            None => Err(E::invalid_type(de::Unexpected::Signed(number), &self)),
        }
    }

    fn visit_f64<E: de::Error>(self, number: f64) -> Result<Named<F>, E> {
        let (law, _) = F::NUMBER.ok_or_else(|| E::invalid_type(de::Unexpected::Float(number), &self))?;
        let number = Fraction::deserialize(value::F64Deserializer::new(number))?;
        Ok(Named { law: Some(law(number.value())), named: 0 })
    }

    fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Named<F>, A::Error> {
        let mut found = Named { law: None, named: 0 };
        while let Some(index) = map.next_key_seed(Name(F::NAMES))? {
            found = Named { law: Some(F::read(index, &mut map)?), named: found.named | 1 << index };
        }
        Ok(found)
    }
}

/// The index of a name.
struct Name(&'static [&'static str]);

impl<'de> de::DeserializeSeed<'de> for Name {
    type Value = usize;

    fn deserialize<D: Deserializer<'de>>(self, from: D) -> Result<usize, D::Error> {
        from.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Name {
    type Value = usize;

    fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str("the name of a law")
    }

    fn visit_str<E: de::Error>(self, name: &str) -> Result<usize, E> {
        self.0.iter().position(|known| *known == name).ok_or_else(|| E::unknown_field(name, self.0))
    }
}

impl<'de, F: Readable> Deserialize<'de> for Named<F> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_any(Reader(PhantomData))
    }
}

impl<F: Readable> JsonSchema for Named<F> {
    fn schema_name() -> std::borrow::Cow<'static, str> {
        F::TITLE.into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let laws = F::NAMES.iter().zip(F::schemas(generator));
        let properties: serde_json::Map<_, _> =
            laws.map(|(name, schema)| ((*name).to_owned(), schema.to_value())).collect();
        let mut schema = schemars::json_schema!({
            "type": "object", "description": F::ABOUT.trim(), "properties": properties,
            "additionalProperties": false, "minProperties": 1, "maxProperties": 1,
        });
        if F::NUMBER.is_some() {
            schema.insert("type".into(), ["number", "object"].as_slice().into());
            schema.insert("minimum".into(), 0.into());
            schema.insert("maximum".into(), 1.into());
        }
        schema
    }
}
