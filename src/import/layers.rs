//! Tools by layer.

use super::blocks::Placed;
use super::error::ImportError;
use super::listing::cut;
use super::options::Options;
use super::parts::{Part, Parts, operation, ordered};
use crate::model::Role;
use std::collections::BTreeMap;

/// Tools by layer: those of `--layer`, then those by name.
pub(super) fn parts(found: &[Placed], options: &Options, notes: &mut Vec<String>) -> Result<Parts, ImportError> {
    let mut layers: BTreeMap<&str, usize> = BTreeMap::new();
    for Placed { listed, .. } in found.iter().filter(|entity| !entity.listed.on_paper) {
        *layers.entry(&listed.layer).or_default() += 1;
    }
    if layers.is_empty() {
        let what = "the drawing is empty: there is no entity in its model space";
        return Err(ImportError::new(what, "check what was saved; entities on paper sheets are not read"));
    }
    let counted = |(layer, count): (&&str, &usize)| format!("\"{}\" ({})", cut(layer), entities(*count));
    let there = || some(layers.iter().map(counted));
    for (name, _) in &options.layers {
        if !layers.keys().any(|layer| same(layer, name)) {
            let what = format!("there is no layer \"{name}\" with entities; there are {}", there());
            return Err(ImportError::new(what, "check the name after --layer"));
        }
    }
    let mut parts = Parts::new();
    for layer in layers.keys() {
        let asked = options.layers.iter().rev().find(|(name, _)| same(layer, name)).map(|(_, role)| *role);
        if let Some(role) = asked.map_or_else(|| by_name(layer), Ok)? {
            parts.insert((*layer).to_owned(), Part { operation: operation(layer), role });
        }
    }
    if parts.is_empty() {
        let what = format!("no layer is a tool: there are {}", there());
        let help = "say which is which, for example --layer NAME=punch --layer OTHER=die; layers whose names hold punch, \
                    die or holder are found by themselves, in German and French too";
        return Err(ImportError::new(what, help));
    }
    let ignored = some(layers.iter().filter(|(layer, _)| !parts.contains_key(**layer)).map(counted));
    if !ignored.is_empty() {
        notes.push(format!("layers that are no tool are left out: {ignored}"));
    }
    Ok(ordered(parts))
}

pub(super) fn nothing_drawn(parts: &Parts) -> ImportError {
    let named = some(parts.iter().map(|(layer, part)| format!("\"{}\" ({})", cut(layer), part.name())));
    let what = format!("no line, arc, polyline or spline is on {named}");
    ImportError::new(what, "draw the side of each tool that meets the sheet as an open line")
}

/// List for a sentence, of twenty entries at most.
pub(super) fn some(entries: impl Iterator<Item = String>) -> String {
    let mut entries = entries.peekable();
    let first: Vec<String> = entries.by_ref().take(20).collect();
    let more = if entries.peek().is_some() { format!(" and {} more", entries.count()) } else { String::new() };
    first.join(", ") + &more
}

pub(super) fn entities(count: usize) -> String {
    if count == 1 { "1 entity".to_owned() } else { format!("{count} entities") }
}

fn same(layer: &str, name: &str) -> bool {
    layer.to_lowercase() == name.to_lowercase()
}

fn by_name(layer: &str) -> Result<Option<Role>, ImportError> {
    let held = Role::named_in(layer);
    match held[..] {
        [] => Ok(None),
        [role] => Ok(Some(role)),
        _ => {
            let names: Vec<&str> = held.iter().map(|role| role.name()).collect();
            let layer = cut(layer);
            let what = format!("layer \"{layer}\" has the name of more than one tool: {}", names.join(", "));
            let help = format!("say which it is: --layer \"{layer}={}\", or =none", names[0]);
            Err(ImportError::new(what, help))
        }
    }
}
