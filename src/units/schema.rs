//! Quantities in the JSON schema of a case file.

use super::dimensioned::Dimensioned;
use super::serde::As;
use schemars::JsonSchema;

/// Schema of a quantity: a number, or text with examples, kind and unit.
pub(super) fn of<Q: Dimensioned>() -> schemars::Schema {
    let kind = Q::KIND;
    let mut schema = if kind.unit.is_empty() {
        schemars::json_schema!({ "type": "number" })
    } else {
        let note = format!("{} with its unit; solved in {}", kind.name, kind.unit);
        schemars::json_schema!({ "type": "string", "description": note, "examples": kind.examples, "x-quantity": kind.measured() })
    };
    for (keyword, bound) in Q::BOUND {
        schema.insert((*keyword).into(), (*bound).into());
    }
    schema
}

impl<Q: JsonSchema> JsonSchema for As<Q> {
    fn inline_schema() -> bool {
        Q::inline_schema()
    }

    fn schema_name() -> std::borrow::Cow<'static, str> {
        Q::schema_name()
    }

    fn json_schema(generator: &mut schemars::SchemaGenerator) -> schemars::Schema {
        Q::json_schema(generator)
    }
}
