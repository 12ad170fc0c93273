//! Tool and operation of a layer.

use crate::model::Role;
use std::collections::{BTreeMap, BTreeSet};

/// Words before the number of an operation: `OP20`, `AFO 20` (Arbeitsfolge), `Stufe 2`, `passe_2`.
const WORDS: [&str; 7] = ["op", "afo", "operation", "stage", "station", "stufe", "passe"];

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Part {
    /// Number of the operation; `None` for the only one and for layers without a number.
    pub operation: Option<u32>,
    pub role: Role,
}

impl Part {
    pub fn name(self) -> String {
        let role = self.role.name();
        self.operation.map_or_else(|| role.to_owned(), |number| format!("OP{number} {role}"))
    }
}

/// Parts by the layer's name.
pub(super) type Parts = BTreeMap<String, Part>;

pub(super) fn operation(layer: &str) -> Option<u32> {
    let lower = layer.to_lowercase();
    let is_word = |word: &str| WORDS.contains(&word);
    let mut parts = lower.split_inclusive(|c: char| !c.is_alphabetic()).peekable();
    while let Some(part) = parts.next() {
        // A word of letters, and what separates it from what follows; or a single digit or separator.
        let letters = part.trim_end_matches(|c: char| !c.is_alphabetic());
        if !is_word(letters) {
            continue;
        }
        let after = part[letters.len()..].to_owned() + &parts.clone().collect::<String>();
        let number = after.trim_start_matches(|c: char| " _-.#".contains(c));
        let digits: String = number.chars().take_while(char::is_ascii_digit).collect();
        if let Ok(number) = digits.parse() {
            return Some(number);
        }
    }
    None
}

/// Assigns layers without a number to the first operation, or to one before it if that has these tools itself.
pub(super) fn ordered(mut parts: Parts) -> Parts {
    let of = |parts: &Parts, operation: Option<u32>| -> Vec<Role> {
        parts.values().filter(|part| part.operation == operation).map(|part| part.role).collect()
    };
    let numbers: BTreeSet<u32> = parts.values().filter_map(|part| part.operation).collect();
    let first = numbers.first().copied();
    let apart = of(&parts, None).iter().any(|role| of(&parts, first).contains(role));
    for part in parts.values_mut() {
        part.operation = match part.operation {
            _ if numbers.len() == 1 && !apart => None,
            None if !apart => first,
            number => number,
        };
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_layer_tells_its_operation() {
        for (layer, number) in [
            ("OP20_PUNCH", Some(20)),
            ("op 30 - die", Some(30)),
            ("Punch OP-40", Some(40)),
            ("PUNCH_OP5", Some(5)),
            ("Stempel AFO20", Some(20)),
            ("Stufe 2 Matrize", Some(2)),
            ("Die 1", None),
            ("OPEN2_DIE", None),
            ("LOOP2", None),
            ("OP_DIE", None),
            ("OP99999999999", None),
            ("", None),
        ] {
            assert_eq!(operation(layer), number, "{layer}");
        }
    }

    #[test]
    fn layers_without_a_number_are_the_first_operations() {
        use Role::{Die, Holder, Punch};
        let ordered = |given: &[(Option<u32>, Role)]| {
            let part = |(i, (operation, role)): (usize, &(Option<u32>, Role))| {
                (i.to_string(), Part { operation: *operation, role: *role })
            };
            let parts = ordered(given.iter().enumerate().map(part).collect());
            parts.values().map(|part| part.operation).collect::<Vec<_>>()
        };
        assert_eq!(ordered(&[(None, Punch), (None, Die)]), [None, None]);
        assert_eq!(ordered(&[(Some(20), Punch), (None, Die)]), [None, None]);
        assert_eq!(ordered(&[(Some(20), Punch), (None, Holder), (Some(30), Punch)]), [Some(20), Some(20), Some(30)]);
        assert_eq!(ordered(&[(None, Punch), (None, Die), (Some(20), Punch)]), [None, None, Some(20)]);
    }
}
