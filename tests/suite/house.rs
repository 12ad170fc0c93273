//! Budgets of lines: growth of a room is a decision.

use crate::common::prelude::*;

/// Budgets and rules of rooms.
#[derive(serde::Deserialize)]
pub struct Rooms {
    totals: BTreeMap<String, usize>,
    lines: BTreeMap<String, usize>,
    /// Uses on one floor.
    pub sideways: BTreeMap<String, Vec<String>>,
    /// Outside crates with the rooms that alone may name them.
    pub crates: BTreeMap<String, String>,
}

pub fn rooms() -> Rooms {
    toml::from_str(include_str!("../rooms.toml")).expect("a table")
}

fn texts(folder: &str, ending: &str) -> Vec<(PathBuf, String)> {
    let inside = |path: &PathBuf| path.strip_prefix(env!("CARGO_MANIFEST_DIR")).expect("inside").to_owned();
    below(folder, ending).iter().map(|path| (inside(path), fs::read_to_string(path).expect("text"))).collect()
}

#[test]
fn every_room_keeps_to_its_budget() {
    let (source, Rooms { totals, lines, .. }) = (texts("src", "rs"), rooms());
    let mut sizes: BTreeMap<String, (usize, usize)> = BTreeMap::new();
    for (path, text) in &source {
        let room = path.iter().nth(1).expect("below src").to_string_lossy().replace(".rs", "");
        let budget = lines.get(&room).copied().unwrap_or(300);
        sizes.entry(room).or_insert((0, budget)).0 += text.lines().count();
        let largest = if path.ends_with("tests.rs") { usize::MAX } else { totals["file"] };
        sizes.insert(path.display().to_string(), (text.lines().count(), largest));
    }
    let count = |all: &[(PathBuf, String)]| all.iter().map(|(_, text)| text.lines().count()).sum::<usize>();
    let gates = source.iter().map(|(_, text)| text.matches("feature = ").count()).sum();
    sizes.insert("feature gates".into(), (gates, totals["feature_gates"]));
    for (name, ending) in [("src", "rs"), ("tests", "rs"), ("docs", "md")] {
        sizes.insert(format!("{name}/"), (count(&texts(name, ending)), totals[name]));
    }
    sizes.retain(|_, (size, budget)| size > budget);
    assert!(sizes.is_empty(), "lines and budgets: {sizes:#?}");
}
