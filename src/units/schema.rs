//! Quantities in the JSON schema of a case file.

use super::quantity::Quantity;

/// The schema of a quantity: a number with its bounds, or text with examples.
pub(super) fn of<Q: Quantity>() -> schemars::Schema {
    let kind = Q::KIND;
    let mut schema = if kind.unit.is_empty() {
        schemars::json_schema!({ "type": "number" })
    } else {
        let note = format!("{} with its unit; solved in {}", kind.name, kind.unit);
        schemars::json_schema!({ "type": "string", "description": note, "examples": kind.examples })
    };
    if kind.unit.is_empty() {
        for (keyword, bound) in Q::BOUND {
            schema.insert((*keyword).into(), (*bound).into());
        }
    }
    schema
}
