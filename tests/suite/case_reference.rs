//! The reference of case files that the program writes.

use regex::Regex;
use serde_json::Value;
use stampflow::{author, case};
use std::collections::BTreeSet;

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

#[test]
fn every_link_of_the_reference_leads_to_one_heading() {
    let page = author::case_reference();
    let anchor =
        |heading: &str| heading.chars().filter(|c| c.is_alphanumeric() || "-_".contains(*c)).collect::<String>();
    let headings: Vec<String> = page.lines().filter(|line| line.starts_with("##")).map(anchor).collect();
    assert_eq!(headings.iter().collect::<BTreeSet<_>>().len(), headings.len(), "{headings:?}");
    let link = Regex::new(r"\]\(#([^)]+)\)").expect("a pattern");
    let links: Vec<&str> = link.captures_iter(&page).map(|parts| parts.extract::<1>().1[0]).collect();
    assert!(links.len() > 50 && links.iter().all(|to| headings.iter().any(|heading| heading == to)), "{links:?}");
}

/// A table of the schema, a key of it, what that needs, and a setting with the one and without the other.
type Need = (&'static str, &'static str, &'static str, &'static str);

const NEEDS: [Need; 29] = [
    ("Compare", "error", "band", r#"compare=[{reference="sources.toml",quantity="peak_force",reason="r",error="e"}]"#),
    (
        "Compare",
        "x",
        "y",
        r#"compare=[{reference="sources.toml",quantity="punch_force",reason="r",tolerance="5 %",x="x_mm"}]"#,
    ),
    (
        "Compare",
        "y",
        "x",
        r#"compare=[{reference="sources.toml",quantity="punch_force",reason="r",tolerance="5 %",y="y_N"}]"#,
    ),
    ("Die", "throat", "shoulder", r#"tools.die={throat="31.25 mm"}"#),
    ("Die", "throat_diameter", "shoulder", r#"tools.die={throat_diameter="62.5 mm"}"#),
    ("FormingLimit", "points", "strain", "forming_limit={points=[[-0.2, 0.5], [0, 0.3]]}"),
    ("FormingLimit", "strain", "points", r#"forming_limit={hill=true,strain="logarithmic"}"#),
    ("GasFace", "max_pressure", "strain_rate", r#"gas={lower={pressure="5 MPa",max_pressure="2 MPa"}}"#),
    ("GasFace", "max_pressure_rate", "strain_rate", r#"gas={lower={pressure="5 MPa",max_pressure_rate="2 MPa/s"}}"#),
    ("GasFace", "norm", "strain_rate", r#"gas={lower={pressure="5 MPa",norm=10}}"#),
    ("Heat", "conductivity", "density", r#"heat={initial="20 °C",conductivity="130 W/m/K"}"#),
    ("Heat", "density", "specific_heat", r#"heat={initial="20 °C",density="2700 kg/m^3"}"#),
    ("Heat", "die", "density", r#"heat={initial="20 °C",die={temperature="25 °C",transfer="1 kW/m^2/K"}}"#),
    ("Heat", "holder", "density", r#"heat={initial="20 °C",holder={temperature="25 °C",transfer="1 kW/m^2/K"}}"#),
    ("Heat", "plastic_share", "density", r#"heat={initial="20 °C",plastic_share=0.9}"#),
    ("Heat", "punch", "density", r#"heat={initial="20 °C",punch={temperature="25 °C",transfer="1 kW/m^2/K"}}"#),
    ("Heat", "specific_heat", "density", r#"heat={initial="20 °C",specific_heat="900 J/kg/K"}"#),
    ("Material", "poisson", "young", "material.poisson=0.3"),
    ("Material", "young", "poisson", r#"material.young="210 GPa""#),
    (
        "ProfileStep",
        "arc_to",
        "center",
        r#"tools.die={profile=[{from=["55 mm","0 mm"]},{arc_to=["40 mm","9 mm"],turn="right"}]}"#,
    ),
    (
        "ProfileStep",
        "arc_to",
        "turn",
        r#"tools.die={profile=[{from=["55 mm","0 mm"]},{arc_to=["40 mm","9 mm"],center=["40 mm","0 mm"]}]}"#,
    ),
    (
        "ProfileStep",
        "center",
        "arc_to",
        r#"tools.die={profile=[{from=["55 mm","0 mm"]},{center=["40 mm","0 mm"],turn="right"}]}"#,
    ),
    (
        "ProfileStep",
        "turn",
        "arc_to",
        r#"tools.die={profile=[{from=["55 mm","0 mm"]},{to=["40 mm","9 mm"],turn="right"}]}"#,
    ),
    ("SectionTable", "by", "offset_of", r#"tools.die={profile={by="1.2 mm"}}"#),
    (
        "SectionTable",
        "closed_at",
        "shoulder",
        r#"tools.die={profile={offset_of="punch",by="1.2 mm",closed_at="6 mm"}}"#,
    ),
    ("SectionTable", "offset_of", "by", r#"tools.die={profile={offset_of="punch"}}"#),
    ("SectionTable", "shoulder", "offset_of", r#"tools.die={profile={mirror_of="holder",shoulder="6 mm"}}"#),
    ("Table", "strain", "stress", r#"material.hardening={table={extrapolation="hold",strain=[0,0.1]}}"#),
    ("Table", "stress", "strain", r#"material.hardening={table={extrapolation="hold",stress=["200 MPa","300 MPa"]}}"#),
];

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
    let tried = NEEDS.iter().map(|(table, key, need, _)| (*table, *key, *need)).chain(IMPLIED);
    let mut tried: Vec<_> = tried.map(|(table, key, need)| [table, key, need].map(str::to_owned)).collect();
    tried.sort();
    said.sort();
    assert_eq!(said, tried);
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/cases/quickstart.toml");
    case::parse(QUICKSTART, path, &[]).unwrap_or_else(|e| panic!("{}", e.render(false)));
    for (table, key, need, setting) in NEEDS {
        assert!(case::parse(QUICKSTART, path, &[setting.to_owned()]).is_err(), "{table}.{key} goes without {need}");
    }
}
