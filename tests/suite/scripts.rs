//! What programs and shells read: JSON, the schema, completions, manual pages.

use crate::common::prelude::*;

/// What a successful call prints as JSON, with nothing on the error stream.
pub fn json(dir: &Path, line: &str) -> Value {
    let done = stampflow(dir, &line.split(' ').collect::<Vec<_>>());
    assert_eq!((done.status.code(), text(&done.stderr)), (Some(0), ""), "{line}: {}", text(&done.stdout));
    serde_json::from_slice(&done.stdout).unwrap_or_else(|error| panic!("{line}: {error}"))
}

fn by_key<'a>(list: &'a Value, key: &str) -> &'a Value {
    list.as_array().unwrap().iter().find(|one| one["key"] == key).unwrap_or_else(|| panic!("no {key}"))
}

/// Trust: the summary that the run has written, key by key.
#[test]
fn a_run_prints_its_summary_as_json_an_array_for_several() {
    let dir = folder(CUP);
    let one = json(dir.path(), "run cases/cup.toml --json");
    for (key, value) in read_json(dir.path().join("out/cup/summary.json")).as_object().unwrap() {
        assert_eq!(&one[key], value, "{key}");
    }
    assert_eq!(one["folder"], "out/cup");
    let listed = one["files"].as_array().unwrap();
    assert_eq!(listed.len(), files(dir.path().join("out/cup"), "").len());
    assert!(listed.iter().all(|file| dir.path().join(file.as_str().unwrap()).is_file()), "{listed:?}");
    for printed in [&one, &json(dir.path(), "check cases/cup.toml --run --json")] {
        let verdict = &printed["verdict"];
        assert!(verdict["light"].is_string() && verdict["sentence"].is_string(), "{verdict}");
        let (thinnest, force) = (by_key(&verdict["numbers"], "thinnest"), by_key(&verdict["numbers"], "punch_force"));
        assert!(thinnest["value"].as_f64() < Some(1.0) && thinnest["unit"] == "mm" && force["unit"] == "N");
        let tearing = by_key(&verdict["findings"], "tearing");
        assert_eq!((&tearing["unit"], &tearing["limits"]["sense"]), (&"percent".into(), &"at_most".into()));
        assert_eq!(tearing["limits"]["amber"].as_f64(), Some(90.0));
    }

    fs::write(dir.path().join("cases/bowl.toml"), format!("{CUP}{STAGES}")).unwrap();
    let both = json(dir.path(), "run cases/cup.toml cases/bowl.toml --json");
    assert_eq!((&both[0]["case"], &both[1]["case"]), (&"cup".into(), &"bowl".into()));
    assert_eq!(both[0]["peak_punch_force_N"], one["peak_punch_force_N"]);
    assert_eq!(both[1]["stages"][1]["case"], "bowl/2-retract");
    for file in ["1-draw/summary.json", "2-retract/summary.json"] {
        assert_eq!(read_json(dir.path().join("out/bowl").join(file))["verdict"], both[1]["verdict"], "{file}");
    }
}

/// Trust: the long table of the released stage.
#[test]
fn a_bend_is_known_by_its_angle() {
    let dir = folder(CUP);
    assert_eq!(stampflow(dir.path(), &["new", "v-bend", "-o", "v.toml"]).status.code(), Some(0));
    let value = json(dir.path(), "run v.toml --json");
    let angle = by_key(&value["verdict"]["numbers"], "opening_angle");
    let change = by_key(&value["stages"][1]["springback"], "opening_angle");
    assert!(angle["value"] == change["after"] && angle["unit"] == "deg", "{angle} {change}");
}

#[test]
fn materials_templates_drawings_and_checks_answer_in_json() {
    let dir = folder(CUP);
    let all = json(dir.path(), "materials --json");
    let name = all[0]["name"].as_str().unwrap();
    assert_eq!(json(dir.path(), &format!("materials {name} --json")), all[0]);
    for template in json(dir.path(), "new --list --json").as_array().unwrap() {
        let name = template["name"].as_str().unwrap();
        let printed = stampflow(dir.path(), &["new", name]);
        assert_eq!(json(dir.path(), &format!("new {name} --json"))["case"], text(&printed.stdout), "{name}");
    }
    let drawing = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/drawings/ezdxf_lines_and_arcs.dxf");
    let drawn = json(dir.path(), &format!("import {drawing} -o drawn.toml --json"));
    assert!(["case", "picture"].iter().all(|key| dir.path().join(drawn[key].as_str().unwrap()).is_file()), "{drawn}");
    assert!(drawn["tools"].as_array().is_some_and(|tools| tools.len() >= 2), "{drawn}");
    let check = json(dir.path(), "check cases/cup.toml --json");
    assert!(check["title"] == "Cup" && check["lines"].as_array().is_some_and(|lines| lines.len() > 8), "{check}");
    assert!(json(dir.path(), "schema").is_object() && !dir.path().join("out").exists());
}

#[test]
fn errors_are_json_where_it_is_asked_for() {
    let dir = folder(&CUP.replace("thickness =", "thicknes ="));
    fs::write(dir.path().join("taken"), "mine").unwrap();
    fs::write(dir.path().join("cases/good.toml"), CUP).unwrap();
    let drawing = |name: &str| format!("{}/tests/drawings/{name}.dxf", env!("CARGO_MANIFEST_DIR"));
    let [gap, cone, lines] = ["faulty/gap", "ezdxf_cone_inches", "ezdxf_lines_and_arcs"].map(drawing);
    for (args, file, line) in [
        (&["run", "cases/cup.toml"][..], "cases/cup.toml", Some(7)),
        (&["import", &gap, "-o", "gap.toml"], &gap, Some(200)),
        (&["import", &cone, "-o", "cone.toml", "--travel", "49 mm"], &cone, None),
        (&["run", "cases/good.toml", "--out", "taken"], "taken", None),
        (&["new", "cup", "-o", "taken/cup.toml"], "taken/cup.toml", None),
        (&["new", "cup", "-o", "taken"], "taken", None),
        (&["import", "none.dxf"], "none.dxf", None),
        (&["import", &lines, "-o", "taken"], "taken", None),
        (&["import", &lines, "-o", "taken/a.toml"], "taken/a.toml", None),
    ] {
        let done = stampflow(dir.path(), &[args, &["--json"]].concat());
        assert_eq!((done.status.code(), text(&done.stdout)), (Some(2), ""), "{args:?}");
        let error: Value = serde_json::from_slice(&done.stderr).unwrap();
        assert_eq!((&error["file"], error["line"].as_u64()), (&Value::from(file), line), "{error}");
        assert!(error["error"].is_string() && error["help"].is_string(), "{error}");
    }
    for args in [&["run", "--json"][..], &["check", "--fly", "--json"]] {
        let error: Value = serde_json::from_slice(&stampflow(dir.path(), args).stderr).unwrap();
        assert!(error["error"].is_string(), "{args:?}");
    }
}

const VERBS: &str = "new import check run report sweep search scatter fit compare verify trace materials";

#[test]
fn completions_and_manual_pages_name_every_verb() {
    let dir = temp_dir::TempDir::new().unwrap();
    let print = |args: &[&str]| text(&stampflow(dir.path(), args).stdout).replace("\\-", "-");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = print(&["completions", shell]);
        assert!(VERBS.split(' ').all(|verb| script.contains(verb)), "{shell}");
    }
    let whole = print(&["man"]);
    assert!(VERBS.split(' ').all(|verb| whole.contains(&format!("stampflow-{verb}"))), "{whole}");
    assert!(print(&["man", "run"]).contains("--animate"));
}
