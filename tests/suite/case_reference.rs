//! The reference of case files that the program writes.

use serde_json::Value;
use stampflow::{author, case};

const QUICKSTART: &str = include_str!("../../cases/quickstart.toml");

fn definitions() -> Vec<(String, Value)> {
    let schema: Value = serde_json::from_str(&case::schema()).expect("JSON");
    let own = schema["$defs"].as_object().expect("definitions").clone();
    own.into_iter().chain([(String::new(), schema)]).collect()
}

/// Trust: over the whole schema.
#[test]
fn every_key_has_a_row_and_every_example_of_one_stands_in_it() {
    let page = author::case_reference();
    for (name, table) in definitions() {
        for (key, property) in table["properties"].as_object().into_iter().flatten() {
            let line = match property["examples"].get(0) {
                Some(example) => format!("\n| `{key} = {example}` |"),
                None => format!("\n| `{key}` |"),
            };
            assert!(page.contains(&line), "{name} has {line}");
        }
    }
}

/// Needs that another one brings about, or that no setting without the other can be written for.
const IMPLIED: [(&str, &str, &str); 2] =
    [("SectionTable", "closed_at", "offset_of"), ("SectionTable", "fillet", "file")];

/// Trust: over the whole schema: each key that is said to need another one is refused without it.
#[test]
fn what_is_said_to_be_needed_is() {
    let mut said = Vec::new();
    for (name, table) in definitions() {
        for (key, needs) in table["dependentRequired"].as_object().into_iter().flatten() {
            said.extend(
                needs
                    .as_array()
                    .expect("keys")
                    .iter()
                    .map(|need| [name.clone(), key.clone(), need.as_str().expect("a key").to_owned()]),
            );
        }
    }
    let rows = include_str!("../bad_cases/needs.txt").lines().filter(|line| !line.starts_with('#'));
    let needs: Vec<Vec<&str>> = rows.map(|line| line.split(" | ").collect()).collect();
    let tried = needs.iter().map(|row| (row[0], row[1], row[2])).chain(IMPLIED);
    let mut tried: Vec<_> = tried.map(|(table, key, need)| [table, key, need].map(str::to_owned)).collect();
    tried.sort();
    said.sort();
    assert_eq!(said, tried);
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/quickstart.toml");
    case::parse(QUICKSTART, path, &[]).unwrap_or_else(|e| panic!("{}", e.render(false)));
    for row in needs {
        assert!(case::parse(QUICKSTART, path, &[row[3].to_owned()]).is_err(), "{row:?}");
    }
}
