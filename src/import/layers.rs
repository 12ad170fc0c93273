//! Tool and operation of each layer.

use super::{ImportError, Result, blocks::Placed, dxf::cut, ensure, frame::Frame, options::Options};
use crate::model::{Role, operation_in};
use std::{collections::BTreeMap, collections::BTreeSet, fmt};

const EXPORTED: [&str; 6] = ["blank", "sheet", "midline", "trim", "axis", "bead"];

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct ToolId {
    /// Number of the operation; `None` for the only one and for layers without a number.
    pub operation: Option<u32>,
    pub role: Role,
}

impl fmt::Display for ToolId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.operation.map_or(Ok(()), |number| write!(f, "OP{number} "))?;
        f.write_str(self.role.name())
    }
}

pub(super) type Layers = BTreeMap<String, ToolId>;

pub(super) fn layers(entities: &[Placed], options: &Options, frame: &Frame) -> Result<(Layers, String, Vec<String>)> {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for Placed { source, .. } in entities.iter().filter(|entity| !entity.source.on_paper) {
        *counts.entry(&source.layer).or_default() += 1;
    }
    let what = "the drawing is empty: there is no entity in its model space";
    let help = "check what was saved; entities on paper sheets are not read";
    ensure(!counts.is_empty(), || ImportError::new(what, help))?;
    let counted = |(layer, count): (&&str, &usize)| format!("\"{}\" ({})", cut(layer), count_entities(*count));
    let all = list(counts.iter().map(counted));
    let is_same = |layer: &str, name: &str| layer.to_lowercase() == name.to_lowercase();
    if let Some((name, _)) = options.layers.iter().find(|(name, _)| !counts.keys().any(|layer| is_same(layer, name))) {
        let what = format!("there is no layer \"{name}\" with entities; there are {all}");
        return Err(ImportError::new(what, "check the name after --layer"));
    }
    let mut layers = Layers::new();
    for layer in counts.keys() {
        let option = options.layers.iter().rev().find(|(name, _)| is_same(layer, name)).map(|(_, role)| *role);
        if let Some(role) = option.map_or_else(|| by_name(layer), Ok)? {
            layers.insert((*layer).to_owned(), ToolId { operation: operation_in(layer), role });
        }
    }
    counts.retain(|layer, _| !layers.contains_key(*layer) && exported(layer).is_none());
    if !counts.is_empty() {
        frame.note(format!("layers that are no tool are left out: {}", list(counts.iter().map(counted))));
    }
    Ok((ordered(layers), all, counts.into_keys().map(str::to_owned).collect()))
}

/// Number of the operation and name of a layer that `export` draws beside the tools: 20 and `sheet` of `OP20_SHEET`.
pub(super) fn exported(layer: &str) -> Option<(Option<u32>, &'static str)> {
    let (lower, number) = (layer.to_lowercase(), operation_in(layer));
    let name = EXPORTED.into_iter().find(|name| lower.ends_with(name))?;
    (number.is_some() || lower == name).then_some((number, name))
}

pub(super) fn list(mut entries: impl Iterator<Item = String>) -> String {
    let first = entries.by_ref().take(20).collect::<Vec<_>>().join(", ");
    let more = entries.count();
    if more == 0 { first } else { format!("{first} and {more} more") }
}

pub(super) fn count_entities(count: usize) -> String {
    if count == 1 { "1 entity".to_owned() } else { format!("{count} entities") }
}

fn by_name(layer: &str) -> Result<Option<Role>> {
    let roles = Role::named_in(layer);
    let names: Vec<&str> = roles.iter().map(|role| role.name()).collect();
    if names.len() < 2 {
        return Ok(roles.first().copied());
    }
    let layer = cut(layer);
    let what = format!("layer \"{layer}\" has the name of more than one tool: {}", names.join(", "));
    Err(ImportError::new(what, format!("say which it is: --layer \"{layer}={}\", or =none", names[0])))
}

/// Assigns layers without a number to the first operation, or to one before it if that has these tools itself.
fn ordered(mut layers: Layers) -> Layers {
    let numbers: BTreeSet<u32> = layers.values().filter_map(|tool| tool.operation).collect();
    let first = numbers.first().copied();
    let has = |operation, role| layers.values().any(|tool| *tool == ToolId { operation, role });
    let apart = Role::ALL.iter().any(|role| has(None, *role) && has(first, *role));
    for tool in layers.values_mut() {
        tool.operation = match tool.operation {
            _ if numbers.len() == 1 && !apart => None,
            None if !apart => first,
            number => number,
        };
    }
    layers
}
