//! Words that shops use for keys of a case file.

use crate::model::Role;

/// The tables whose keys are tools.
const OF_TOOLS: [&str; 3] = ["tools", "stages", "heat"];
/// Keys whose values are tools.
const ARE_TOOLS: [&str; 3] = ["remove", "offset_of", "mirror_of"];

/// What is also written for a key of a table; the file itself is the table "".
const KEYS: &[(&str, &str, &[&str])] = &[
    ("", "blank", &["sheet"]),
    ("blank", "thickness", &["gauge", "gage", "sheet_thickness"]),
    ("blank", "half_length", &["half_width"]),
    ("material", "name", &["grade", "sheet"]),
    ("material", "young", &["youngs_modulus", "elastic_modulus", "E"]),
    ("material", "poisson", &["poissons_ratio", "poisson_ratio", "nu"]),
    ("material", "anisotropy", &["r", "r_bar", "r_value", "lankford"]),
    ("punch", "travel", &["stroke"]),
    ("punch", "speed", &["velocity"]),
    ("flat", "nose", &["nose_radius", "corner", "corner_radius", "punch_radius"]),
    ("crowned", "nose", &["nose_radius", "corner", "corner_radius"]),
    ("die", "throat", &["throat_radius", "opening_radius"]),
    // An opening is measured across.
    ("die", "throat_diameter", &["opening", "die_opening", "opening_diameter"]),
    ("die", "shoulder", &["shoulder_radius", "die_radius", "entry_radius", "draw_radius"]),
    ("holder", "force", &["holder_force", "binder_force", "blank_holder_force", "bhf"]),
    ("holder", "pressure", &["holder_pressure", "binder_pressure", "blank_holder_pressure"]),
    ("holder", "gap", &["distance", "spacer"]),
];
/// What is also written for friction, of every tool.
const FRICTION: [&str; 4] = ["mu", "µ", "μ", "friction_coefficient"];

/// The key that a word means in a table; `None` where it is no other word for one.
pub(super) fn key(table: &str, word: &str) -> Option<&'static str> {
    let listed = KEYS.iter().find(|(of, _, words)| *of == table && words.contains(&word)).map(|(_, key, _)| *key);
    let tool = || OF_TOOLS.contains(&table).then(|| self::tool(word)).flatten();
    let friction = || (FRICTION.contains(&word) && tool_named(table)).then_some("friction");
    listed.or_else(tool).or_else(friction)
}

/// The tool that the value of a key means; `None` where it is no other word for one.
pub(super) fn value(key: &str, word: &str) -> Option<&'static str> {
    ARE_TOOLS.contains(&key).then(|| tool(word)).flatten()
}

fn tool(word: &str) -> Option<&'static str> {
    Role::from_word(word).map(Role::name).filter(|name| *name != word)
}

fn tool_named(table: &str) -> bool {
    Role::ALL.iter().any(|role| role.name() == table)
}
