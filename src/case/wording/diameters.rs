//! Keys of round parts that may be given across instead of from the axis.

/// A length of a round part from its axis, and the key that gives the same across.
pub(in crate::case) struct Twin {
    /// The tables that have it.
    tables: &'static [&'static str],
    /// From the axis.
    pub radius: &'static str,
    /// Across, twice as much.
    pub diameter: &'static str,
    /// What a strip has instead.
    pub strip: &'static str,
}

const TWINS: [Twin; 7] = [
    Twin { tables: &["blank"], radius: "radius", diameter: "diameter", strip: "half_length" },
    Twin { tables: &["flat", "crowned"], radius: "radius", diameter: "diameter", strip: "half_width" },
    Twin { tables: &["hemispherical"], radius: "radius", diameter: "diameter", strip: "radius" },
    Twin { tables: &["die"], radius: "throat", diameter: "throat_diameter", strip: "throat" },
    Twin { tables: &["holder"], radius: "inner_radius", diameter: "inner_diameter", strip: "inner_half_width" },
    Twin { tables: &["beads"], radius: "at", diameter: "diameter", strip: "at" },
    Twin { tables: &["stages"], radius: "trim", diameter: "trim_diameter", strip: "trim" },
];

/// The twins of a table.
pub(super) fn of(table: &str) -> impl Iterator<Item = &'static Twin> {
    TWINS.iter().filter(move |twin| twin.tables.contains(&table))
}

/// The keys of a table as messages list them: each that may be given across with the key for that.
pub(in crate::case) fn listed<'a>(table: &str, keys: &[&'a str]) -> Vec<&'a str> {
    let twin = |key: &str| of(table).find(|twin| twin.radius == key).map(|twin| twin.diameter);
    keys.iter().flat_map(|key| [Some(*key), twin(key)]).flatten().collect()
}

/// The key across of a key from the axis, of a struct of case files by its name: `StageHolder` is a holder.
pub(in crate::case) fn in_schema(name: &str) -> impl Iterator<Item = &'static Twin> {
    let name = name.strip_prefix("Stage").filter(|tool| !tool.is_empty()).unwrap_or(name).to_lowercase();
    TWINS.iter().filter(move |twin| twin.tables.iter().any(|table| table.trim_end_matches('s') == name))
}
