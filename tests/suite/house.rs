//! Budgets of lines: growth of a room is a decision.

use crate::common::prelude::*;

/// Lines of the rooms of `src/`; any other may have 300.
const ROOMS: [(&str, usize); 19] = [
    ("numerics", 800),
    ("units", 1100),
    ("geometry", 1500),
    ("material", 3700),
    ("element", 800),
    ("contact", 600),
    ("forming_limit", 1200),
    ("model", 1600),
    ("solver", 5800),
    ("measure", 1200),
    ("case", 4800),
    ("author", 1800),
    ("import", 1800),
    ("assess", 3400),
    ("results", 2200),
    ("plot", 3200),
    ("report", 900),
    ("study", 4800),
    ("cli", 2000),
];

/// Files below a folder of the project, with their texts.
fn texts(folder: &str, ending: &str) -> Vec<(PathBuf, String)> {
    let inside = |path: &PathBuf| path.strip_prefix(env!("CARGO_MANIFEST_DIR")).expect("inside").to_owned();
    below(folder, ending).iter().map(|path| (inside(path), fs::read_to_string(path).expect("text"))).collect()
}

#[test]
fn every_room_keeps_to_its_budget() {
    let source = texts("src", "rs");
    let mut sizes: BTreeMap<String, (usize, usize)> = BTreeMap::new();
    for (path, text) in &source {
        let room = path.iter().nth(1).expect("below src").to_string_lossy().replace(".rs", "");
        let budget = ROOMS.iter().find(|(name, _)| *name == room).map_or(300, |room| room.1);
        sizes.entry(room).or_insert((0, budget)).0 += text.lines().count();
        let largest = if path.ends_with("tests.rs") { usize::MAX } else { 350 };
        sizes.insert(path.display().to_string(), (text.lines().count(), largest));
    }
    let lines = |all: &[(PathBuf, String)]| all.iter().map(|(_, text)| text.lines().count()).sum::<usize>();
    let gates = source.iter().map(|(_, text)| text.matches("feature = ").count()).sum();
    sizes.insert("feature gates".into(), (gates, 60));
    for (name, size, budget) in [
        ("src", lines(&source), 44_000),
        ("tests", lines(&texts("tests", "rs")), 14_000),
        ("docs", lines(&texts("docs", "md")), 3_500),
    ] {
        sizes.insert(format!("{name}/"), (size, budget));
    }
    sizes.retain(|_, (size, budget)| size > budget);
    assert!(sizes.is_empty(), "lines and budgets: {sizes:#?}");
}
