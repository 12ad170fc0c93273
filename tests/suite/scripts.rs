//! What programs and shells read: JSON, completions, manual pages.

use crate::common::cli::{CUP, STAGES, folder, stampflow, text};
use crate::common::files::files;
use serde_json::Value;
use std::fs;
use std::process::Output;

fn json(bytes: &[u8]) -> Value {
    serde_json::from_slice(bytes).unwrap_or_else(|error| panic!("{error}: {}", text(bytes)))
}

/// The output of a call that has nothing to say on the error stream.
fn silent(done: &Output, code: i32) -> Value {
    assert_eq!((done.status.code(), text(&done.stderr)), (Some(code), ""), "{}", text(&done.stdout));
    json(&done.stdout)
}

#[test]
fn a_run_prints_its_summary_as_json_an_array_for_several() {
    let dir = folder(CUP);
    let one = silent(&stampflow(dir.path(), &["run", "cases/cup.toml", "--json"]), 0);
    let written = json(&fs::read(dir.path().join("out/cup/summary.json")).unwrap());
    for (key, value) in written.as_object().unwrap() {
        assert_eq!(&one[key], value, "{key}");
    }
    assert_eq!(one["folder"], "out/cup");
    let listed = one["files"].as_array().unwrap();
    assert_eq!(listed.len(), files(dir.path().join("out/cup"), "").len());
    assert!(listed.iter().all(|file| dir.path().join(file.as_str().unwrap()).is_file()), "{listed:?}");

    fs::write(dir.path().join("cases/bowl.toml"), format!("{CUP}{STAGES}")).unwrap();
    let both = silent(&stampflow(dir.path(), &["run", "cases/cup.toml", "cases/bowl.toml", "--json"]), 0);
    assert_eq!((both[0]["case"].as_str(), both[1]["case"].as_str()), (Some("cup"), Some("bowl")));
    assert_eq!(both[0]["peak_punch_force_N"], one["peak_punch_force_N"]);
    let stages = both[1]["stages"].as_array().unwrap();
    assert_eq!(stages.len(), 2);
    assert_eq!(stages[1]["case"], "bowl/2-retract");
    assert_eq!(both[1]["complete"], true);
}

#[test]
fn materials_templates_and_drawings_answer_in_json() {
    let dir = folder(CUP);
    let all = silent(&stampflow(dir.path(), &["materials", "--json"]), 0);
    let first = &all.as_array().unwrap()[0];
    assert_eq!(&silent(&stampflow(dir.path(), &["materials", first["name"].as_str().unwrap(), "--json"]), 0), first);
    assert!(first["source"].as_str().is_some_and(|source| !source.is_empty()), "{first}");

    let templates = silent(&stampflow(dir.path(), &["new", "--list", "--json"]), 0);
    for template in templates.as_array().unwrap() {
        let name = template["name"].as_str().unwrap();
        let printed = stampflow(dir.path(), &["new", name]);
        assert_eq!(
            silent(&stampflow(dir.path(), &["new", name, "--json"]), 0)["case"],
            text(&printed.stdout),
            "{name}"
        );
    }
    let drawing = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/drawings/ezdxf_lines_and_arcs.dxf");
    let said = silent(&stampflow(dir.path(), &["import", drawing, "-o", "drawn.toml", "--json"]), 0);
    assert!(["case", "picture"].iter().all(|key| dir.path().join(said[key].as_str().unwrap()).is_file()), "{said}");
    assert!(said["tools"].as_array().is_some_and(|tools| tools.len() >= 2), "{said}");
}

#[test]
fn a_check_is_json_with_all_that_is_printed() {
    let dir = folder(CUP);
    let check = silent(&stampflow(dir.path(), &["check", "cases/cup.toml", "--json"]), 0);
    assert_eq!(check["title"], "Cup");
    let one_line = |bytes: &[u8]| text(bytes).split_whitespace().collect::<Vec<_>>().join(" ");
    let printed = one_line(&stampflow(dir.path(), &["check", "cases/cup.toml"]).stdout);
    for line in check["lines"].as_array().unwrap() {
        let said = format!("{} {}", line["value"].as_str().unwrap(), line["meaning"].as_str().unwrap());
        assert!(printed.contains(said.trim_end()), "{said}");
    }
}

#[test]
fn errors_are_json_where_it_is_asked_for() {
    let dir = folder(&CUP.replace("thickness =", "thicknes ="));
    let error = |args: &[&str]| {
        let done = stampflow(dir.path(), args);
        assert_eq!((done.status.code(), text(&done.stdout)), (Some(2), ""), "{args:?}");
        json(&done.stderr)
    };
    let case = error(&["run", "cases/cup.toml", "--json"]);
    assert!(case["error"].as_str().unwrap().contains("thicknes"), "{case}");
    assert_eq!((&case["file"], &case["line"]), (&Value::from("cases/cup.toml"), &Value::from(7)), "{case}");
    assert!(case["help"].is_string() && case["column"].is_u64(), "{case}");
    let missing = error(&["check", "cases/none.toml", "--json"]);
    assert!(missing["error"].as_str().unwrap().contains("there is no file") && missing["line"].is_null());
    let drawing = |name: &str| format!("{}/tests/drawings/{name}.dxf", env!("CARGO_MANIFEST_DIR"));
    let gap = error(&["import", &drawing("faulty/gap"), "-o", "gap.toml", "--json"]);
    // The line that the message names.
    assert_eq!((&gap["file"], &gap["line"]), (&Value::from(drawing("faulty/gap")), &Value::from(200)), "{gap}");
    assert!(gap["help"].as_str().unwrap().contains("--join"), "{gap}");
    assert!(!gap["error"].as_str().unwrap().contains("--join"), "{gap}");
    let refused = error(&["import", &drawing("ezdxf_cone_inches"), "-o", "cone.toml", "--travel", "49 mm", "--json"]);
    assert_eq!(
        (&refused["file"], &refused["line"]),
        (&Value::from(drawing("ezdxf_cone_inches")), &Value::Null),
        "{refused}"
    );
    assert!(refused["help"].as_str().unwrap().contains("--travel"), "{refused}");
    fs::write(dir.path().join("taken"), "mine").unwrap();
    fs::write(dir.path().join("cases/good.toml"), CUP).unwrap();
    let lines = drawing("ezdxf_lines_and_arcs");
    for (args, file) in [
        (&["run", "cases/good.toml", "--out", "taken", "--json"][..], "taken"),
        (&["new", "cup", "-o", "taken/cup.toml", "--json"], "taken/cup.toml"),
        (&["new", "cup", "-o", "taken", "--json"], "taken"),
        (&["import", "none.dxf", "--json"], "none.dxf"),
        (&["import", &lines, "-o", "taken", "--json"], "taken"),
        (&["import", &lines, "-o", "taken/a.toml", "--json"], "taken/a.toml"),
    ] {
        let error = error(args);
        assert_eq!(error["file"], file, "{error}");
        assert!(error["help"].is_string() && error["line"].is_null(), "{error}");
    }
    for args in [&["run", "--json"][..], &["check", "--fly", "--json"]] {
        assert!(error(args)["error"].is_string(), "{args:?}");
    }
    let help = stampflow(dir.path(), &["run", "--json", "--help"]);
    assert_eq!(help.status.code(), Some(0));
    assert!(text(&help.stdout).contains("Usage"));
}

/// The verbs that the help names.
fn verbs() -> Vec<String> {
    let help = stampflow(std::env::temp_dir().as_path(), &["--help"]);
    let commands = text(&help.stdout).split("Commands:\n").nth(1).unwrap().split("\n\n").next().unwrap();
    let verbs: Vec<String> = commands
        .lines()
        .filter_map(|l| l.strip_prefix("  ")?.split(' ').next().map(str::to_owned))
        .filter(|verb| !verb.is_empty())
        .collect();
    assert!(verbs.len() > 6 && verbs.iter().any(|verb| verb == "run"), "{verbs:?}");
    verbs
}

#[test]
fn completions_of_every_shell_name_every_verb() {
    let dir = temp_dir::TempDir::new().unwrap();
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let done = stampflow(dir.path(), &["completions", shell]);
        assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
        let script = text(&done.stdout);
        assert!(script.contains("friction") || script.contains("--set") || script.contains("-l set"), "{shell}");
        for verb in verbs() {
            assert!(script.contains(&verb), "{shell}: {verb}");
        }
    }
    assert_eq!(stampflow(dir.path(), &["completions", "dos"]).status.code(), Some(2));
}

#[test]
fn completions_offer_the_sheets_and_the_keys_of_a_case() {
    let dir = temp_dir::TempDir::new().unwrap();
    for shell in ["bash", "zsh", "fish"] {
        let done = stampflow(dir.path(), &["completions", shell]);
        let script = text(&done.stdout);
        for word in [
            "drawing-steel",
            "DC04",
            "tools.punch.friction=",
            "blank.diameter=",
            "stages.0.trim=",
            "tools.holder.force=",
        ] {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
    // What is offered is no limit of what is taken.
    let cup = folder(CUP);
    let done = stampflow(cup.path(), &["check", "cases/cup.toml", "--material", "woo", "--set", "tools.beads=[]"]);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    assert!(text(&done.stdout).contains("material woo read as woo-1968"), "{}", text(&done.stdout));
}

/// Trust: over the whole schema: every example of a quantity is a number with a unit.
#[test]
fn the_examples_of_the_schema_are_quantities_and_diameters_are_keys() {
    let schema: Value = serde_json::from_str(&stampflow::case::schema()).unwrap();
    let mut tried = 0;
    for (name, table) in schema["$defs"].as_object().unwrap() {
        for (key, property) in table["properties"].as_object().into_iter().flatten() {
            let quantity = property["x-quantity"].is_string();
            for example in property["examples"].as_array().into_iter().flatten().filter(|_| quantity) {
                let parsed = example.as_str().map(stampflow::units::parse);
                assert!(parsed.is_some_and(|parsed| parsed.is_ok_and(|p| p.has_unit)), "{name}.{key}: {example}");
                tried += 1;
            }
        }
    }
    assert!(tried > 50, "{tried}");
    let of = |name: &str| schema["$defs"][name]["properties"].as_object().unwrap().keys().cloned().collect::<Vec<_>>();
    for (table, key) in [("Blank", "diameter"), ("Die", "throat_diameter"), ("Holder", "inner_diameter")] {
        assert!(of(table).contains(&key.to_owned()), "{table}: {:?}", of(table));
    }
    assert!(schema["$defs"]["Hemispherical"]["oneOf"].is_array(), "a radius or a diameter is wanted");
}

#[test]
fn manual_pages_name_every_verb_and_its_options() {
    let dir = temp_dir::TempDir::new().unwrap();
    let page = |args: &[&str]| {
        let done = stampflow(dir.path(), args);
        assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
        text(&done.stdout).replace("\\-", "-")
    };
    let whole = page(&["man"]);
    assert!(whole.contains(".TH stampflow 1"), "{whole}");
    for verb in verbs().iter().filter(|verb| *verb != "help") {
        assert!(whole.contains(&format!("stampflow-{verb}")), "{verb}: {whole}");
        let own = page(&["man", verb]);
        assert!(own.contains(&format!(".TH stampflow-{verb} 1")) && own.contains("--help"), "{own}");
    }
    assert!(page(&["man", "run"]).contains("--animate"));
    let none = stampflow(dir.path(), &["man", "fly"]);
    assert_eq!(none.status.code(), Some(2));
    assert!(text(&none.stderr).contains("no verb `fly`"), "{}", text(&none.stderr));
}
