//! Who may know whom: modules use only what lies below them.

use std::fs;
use std::path::Path;

/// From the top down; a module may use those on its own line (itself) and on lines below.
const FLOORS: &[&[&str]] = &[
    &["main", "cli"],
    &["report"],
    &["author", "output"],
    &["assess"],
    &["case"],
    &["compare", "rules"],
    &["solver"],
    &["measure", "import"],
    &["table"],
    &["solution", "state"],
    &["model"],
    &["element", "contact", "forming_limit"],
    &["material", "geometry"],
    &["units", "numerics"],
];

/// Sideways uses that the picture allows.
const SIDEWAYS: &[(&str, &str)] = &[
    ("main", "cli"),
    ("state", "solution"), // a state writes its frame
    ("solution", "state"), // a solution keeps its last state
];

fn floor(module: &str) -> usize {
    FLOORS.iter().position(|f| f.contains(&module)).unwrap_or_else(|| panic!("module {module} is on no floor"))
}

fn sources(dir: &Path, found: &mut Vec<std::path::PathBuf>) {
    for entry in fs::read_dir(dir).expect("readable") {
        let path = entry.expect("readable").path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

#[test]
fn modules_use_only_what_lies_below() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    sources(&root, &mut files);
    let mut wrong = Vec::new();
    for file in files {
        let inside = file.strip_prefix(&root).expect("below src");
        let first = inside.components().next().expect("a name").as_os_str().to_string_lossy();
        let module = first.trim_end_matches(".rs").to_string();
        if module == "lib" {
            continue;
        }
        let text = fs::read_to_string(&file).expect("readable");
        let code = text.split("#[cfg(test)]").next().expect("a first part");
        for line in code.lines().filter(|l| !l.trim_start().starts_with("//")) {
            for used in line.split("crate::").skip(1) {
                let used: String = used.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect();
                if used == module || used.is_empty() || used.starts_with(char::is_uppercase) {
                    continue;
                }
                let down = floor(&module) < floor(&used);
                if !down && !SIDEWAYS.contains(&(module.as_str(), used.as_str())) {
                    wrong.push(format!("{} uses crate::{used}", inside.display()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Third-party crates stay where they belong.
#[test]
fn outside_crates_have_one_room_each() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = Vec::new();
    sources(&root, &mut files);
    for (name, room) in [
        ("plotters::", "output/draw"),
        ("plotters_backend::", "output/draw"),
        ("ttf_parser::", "output"),
        ("miniz_oxide::", "output"),
        ("clap::", "cli|main"),
        ("indicatif::", "cli"),
        ("gif::", "output"),
        ("comfy_table::", "cli"),
        ("toml::", "case|compare"),
        ("maud::", "report"),
    ] {
        for file in &files {
            let inside = file.strip_prefix(&root).expect("below src").to_string_lossy().to_string();
            let text = fs::read_to_string(file).expect("readable");
            let here = room.split('|').any(|r| inside.starts_with(r));
            assert!(here || !text.contains(name), "{inside} knows {name}");
        }
    }
}
