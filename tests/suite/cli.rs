//! The command line as a user meets it: files, exit codes, and what is left behind.

use crate::common::cli::{COMPARE, CUP, STAGES, endless, folder, stampflow, text};
use crate::common::files::files;
use std::fs;
use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

#[test]
fn a_run_writes_every_file_and_sums_up() {
    let dir = folder(CUP);
    let done = stampflow(dir.path(), &["run", "cases/cup.toml", "--trace", "trace.csv", "--verbose"]);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    for output in stampflow::results::OUTPUTS {
        let path = dir.path().join("out/cup").join(output.file);
        let sheets = ["pressure_cycle", "porosity", "temperature", "forming_limit", "strain_paths"];
        let releases_and_stages = ["springback", "residual_stress", "stages.csv", "compare_"];
        let asked_for = ["section.pvd", "revolved.pvd", "tools.pvd", "shapes.gif", "error_bars"];
        let mut special = sheets.iter().chain(&releases_and_stages).chain(&asked_for);
        if special.any(|special| output.file.starts_with(special)) {
            assert!(!path.exists(), "a plain cup has no {}", output.file);
            continue;
        }
        let size = fs::metadata(path).unwrap().len();
        assert!(size > 200, "{}: {size} bytes", output.file);
    }
    let summary = text(&done.stdout);
    for says in ["Peak punch force", "full travel reached", "declared: all of it", "out/cup"] {
        assert!(summary.contains(says), "{summary}");
    }
    let progress = text(&done.stderr);
    // Others come seconds apart.
    assert!(progress.contains("cup: 100 %"), "{progress}");
    let trace = fs::read_to_string(dir.path().join("trace.csv")).unwrap();
    assert!(trace.starts_with("step,travel_mm,iteration,velocity_norm") && trace.lines().count() > 50);
}

#[test]
fn several_cases_go_to_folders_of_their_own_without_progress_when_quiet() {
    let dir = folder(CUP);
    fs::copy(dir.path().join("cases/cup.toml"), dir.path().join("cases/bowl.toml")).unwrap();
    let done = stampflow(dir.path(), &["run", "cases/cup.toml", "cases/bowl.toml", "--out", "r", "--quiet"]);
    assert_eq!((done.status.code(), text(&done.stderr)), (Some(0), ""));
    assert!(dir.path().join("r/cup/shapes.png").exists() && dir.path().join("r/bowl/shapes.png").exists());
    let summary = text(&done.stdout);
    assert!(summary.find("in r/cup").unwrap() < summary.find("in r/bowl").unwrap(), "in the order asked for");
}

#[test]
fn bad_input_ends_with_2_and_writes_nothing() {
    let dir = folder(CUP);
    fs::write(dir.path().join("cases/curveless.toml"), format!("{CUP}{COMPARE}")).unwrap();
    for args in [
        &["run", "cases/none.toml"][..],
        &["run", "cases/cup.toml", "--set", "blank.thickness=thin"],
        &["run", "cases/cup.toml", "--set", "no equals sign"],
        &["run", "cases/cup.toml", "cases/cup.toml"],
        &["run", "cases/curveless.toml"],
        &["run", "cases/cup.toml", "cases/curveless.toml", "--trace", "t.csv"],
        &["check", "cases/none.toml"],
        &["run"],
        &["fly"],
    ] {
        let done = stampflow(dir.path(), args);
        assert_eq!(done.status.code(), Some(2), "{args:?}: {}", text(&done.stderr));
        assert!(!done.stderr.is_empty() && done.stdout.is_empty(), "{args:?}");
        assert_eq!(files(dir.path(), "").len(), 1, "{args:?} left something behind");
    }
}

/// A title, notes, names of files, columns and keys, and what stands around an error: nothing that a terminal obeys comes
/// out of any of them, in words or in JSON.
#[test]
fn no_control_character_reaches_the_terminal() {
    let obeyed = "\u{1b}]0;owned\u{7}\u{1b}[31m\u{9b}2J";
    let dir =
        folder(&CUP.replace("\"Cup\"", "\"Cup \\u001b[31m\\u0007\"").replace("all of it", "all \\u001b[2J\\u009b"));
    let cases = dir.path().join("cases");
    fs::copy(cases.join("cup.toml"), cases.join(format!("n{obeyed}.toml"))).unwrap();
    fs::write(cases.join("raw.toml"), format!("title = \"{obeyed}\"\r\n")).unwrap();
    fs::write(cases.join("key.toml"), "[\"\\u001b[31m\"]\n").unwrap();
    fs::write(cases.join("curve.csv"), format!("travel_mm,punch_force_kN\n1,{obeyed}\n")).unwrap();
    fs::write(cases.join("other.csv"), format!("{obeyed}\n")).unwrap();
    fs::write(cases.join("curved.toml"), format!("{CUP}{COMPARE}")).unwrap();
    fs::write(cases.join("hot.toml"), format!("{CUP}[heat]\ninitial = \"curve.csv\"\n")).unwrap();
    fs::write(cases.join("other.toml"), format!("{CUP}[heat]\ninitial = \"other.csv\"\n")).unwrap();
    let drawing = fs::read_to_string("tests/drawings/ezdxf_lines_and_arcs.dxf").unwrap();
    fs::write(dir.path().join("d.dxf"), drawing.replace("\nPUNCH\n", "\nPUNCH\u{1b}[31m\n")).unwrap();
    let (named, missing) = (format!("cases/n{obeyed}.toml"), format!("cases/{obeyed}"));
    let (set, verb) = (format!("blank.{obeyed}=1"), format!("ru{obeyed}n"));
    for (args, code) in [
        (&["check", "cases/cup.toml"][..], 0),
        (&["check", "cases/cup.toml", "--run"], 0),
        (&["run", "cases/cup.toml"], 0),
        (&["run", "cases/cup.toml", "--json"], 0),
        (&["run", &named], 0),
        (&["report", &named], 0),
        (&["import", "d.dxf"], 0),
        (&["check", "cases/raw.toml"], 2),
        (&["check", "cases/raw.toml", "--json"], 2),
        (&["check", "cases/key.toml"], 2),
        (&["check", "cases/curved.toml"], 2),
        (&["check", "cases/hot.toml"], 2),
        (&["check", "cases/other.toml"], 2),
        (&["check", "cases/cup.toml", "--set", &set], 2),
        (&["check", &missing], 2),
        (&[&verb], 2),
    ] {
        let done = stampflow(dir.path(), args);
        assert_eq!(done.status.code(), Some(code), "{args:?}: {}", text(&done.stderr));
        for printed in [text(&done.stdout), text(&done.stderr)] {
            let found = printed.chars().find(|c| c.is_control() && *c != '\n');
            assert_eq!(found, None, "{args:?}: {printed:?}");
        }
    }
}

/// Trust: one good case among two bad ones, read before, between and after them.
#[test]
fn every_bad_case_of_a_command_is_named() {
    let dir = folder(CUP);
    let cases = dir.path().join("cases");
    fs::write(cases.join("curve.csv"), "").unwrap();
    fs::write(cases.join("curved.toml"), format!("{CUP}{COMPARE}")).unwrap();
    fs::write(cases.join("empty.toml"), "").unwrap();
    {
        let args = &["run", "cases/curved.toml", "cases/cup.toml", "cases/empty.toml"];
        let done = stampflow(dir.path(), args);
        assert_eq!(done.status.code(), Some(2), "{args:?}");
        let said = text(&done.stderr);
        assert!(said.contains("the reference file is empty") && said.contains("empty.toml"), "{said}");
    }
    let out = dir.path().join("out");
    assert!(out.join("cup/summary.json").is_file() && !out.join("curved").exists());
}

/// `check` and `report` read the references too.
#[test]
fn a_bad_reference_is_found_by_every_verb() {
    let dir = folder(&format!("{CUP}{COMPARE}"));
    fs::write(dir.path().join("cases/curve.csv"), "travel_mm,punch_force_kN\n1,3\n2,nan\n").unwrap();
    for verb in ["check", "run", "report"] {
        let done = stampflow(dir.path(), &[verb, "cases/cup.toml"]);
        let says = "curve.csv, line 3, column `punch_force_kN`: \"nan\" is no finite number";
        assert_eq!(done.status.code(), Some(2), "{verb}");
        assert!(text(&done.stderr).contains(says), "{verb}: {}", text(&done.stderr));
    }
}

/// Trust: three iterations do not find equilibrium, and steps may not be made smaller.
#[test]
fn an_early_end_is_3_and_keeps_its_results() {
    let dir = folder(CUP);
    let args = ["run", "cases/cup.toml", "-q", "--set", "solver.max_iterations=3", "--set", "solver.min_step=0.002"];
    let done = stampflow(dir.path(), &args);
    assert_eq!(done.status.code(), Some(3), "{}{}", text(&done.stdout), text(&done.stderr));
    assert!(text(&done.stdout).contains("no equilibrium"));
    let json = fs::read_to_string(dir.path().join("out/cup/summary.json")).unwrap();
    assert!(json.contains("\"complete\": false"));
}

/// Found before solving: the progress, which the run would show, is not there.
#[test]
fn a_place_that_cannot_be_written_to_is_2_before_anything_is_solved() {
    let dir = folder(&format!("{CUP}{COMPARE}optional = true\n"));
    fs::write(dir.path().join("taken"), "mine").unwrap();
    fs::create_dir(dir.path().join("folder")).unwrap();
    fs::create_dir_all(dir.path().join("half/summary.json")).unwrap();
    for (args, says) in [
        (&["run", "cases/cup.toml", "--out", "taken"][..], "cannot write taken: not a directory"),
        (&["run", "cases/cup.toml", "--out", "taken/deeper"], "--out"),
        (&["run", "cases/cup.toml", "--out", "half"], "cannot write half/summary.json: is a directory"),
        (&["run", "cases/cup.toml", "--trace", "folder"], "another place with --trace"),
        (&["run", "cases/cup.toml", "--trace", "taken/t.csv"], "cannot write taken/t.csv"),
    ] {
        let done = stampflow(dir.path(), args);
        assert_eq!(done.status.code(), Some(2), "{args:?}: {}", text(&done.stderr));
        assert!(text(&done.stderr).contains(says), "{args:?}: {}", text(&done.stderr));
        assert!(!text(&done.stderr).contains("10 %"), "{args:?} was solved first");
        assert_eq!(files(dir.path(), "").len(), 4, "{args:?} left something behind");
    }
    assert_eq!(fs::read_to_string(dir.path().join("taken")).unwrap(), "mine");
}

/// One spelling is as good as the other.
#[test]
fn out_and_output_are_one_option() {
    let dir = folder(CUP);
    let drawing = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/drawings/ezdxf_lines_and_arcs.dxf");
    for (args, file) in [
        (&["run", "cases/cup.toml", "-q", "--output", "a"][..], "a/summary.json"),
        (&["report", "cases/cup.toml", "-q", "--out", "b.html"], "b.html"),
        (&["new", "cup", "--out", "c.toml"], "c.toml"),
        (&["import", drawing, "--output", "d.toml"], "d.toml"),
    ] {
        let done = stampflow(dir.path(), args);
        assert_eq!(done.status.code(), Some(0), "{args:?}: {}", text(&done.stderr));
        assert!(dir.path().join(file).is_file(), "{args:?}");
    }
}

#[test]
fn the_help_has_thirteen_verbs_and_the_short_one_of_run_fits_a_screen() {
    let dir = temp_dir::TempDir::new().unwrap();
    let help = stampflow(dir.path(), &["--help"]);
    let verbs = text(&help.stdout).split("Commands:\n").nth(1).unwrap().split("\n\n").next().unwrap();
    let verbs = verbs.lines().filter(|line| line.starts_with("  ") && !line.starts_with("   "));
    let verbs: Vec<&str> =
        verbs.filter_map(|line| line.split_whitespace().next()).filter(|verb| *verb != "help").collect();
    for verb in
        ["new", "import", "check", "run", "report", "sweep", "search", "scatter", "fit", "compare", "verify", "trace"]
    {
        assert!(verbs.contains(&verb), "{verb}: {verbs:?}");
    }
    assert!(!verbs.contains(&"schema") && !verbs.contains(&"man"), "{verbs:?}");
    let short = stampflow(dir.path(), &["run", "-h"]);
    assert!(text(&short.stdout).lines().count() <= 40, "{}", text(&short.stdout));
    let long = stampflow(dir.path(), &["run", "--help"]);
    assert!(text(&long.stdout).contains("load_travel.csv") && text(&long.stdout).contains("--dpi"));
}

#[test]
fn schema_and_check_only_print() {
    let dir = folder(CUP);
    let schema = stampflow(dir.path(), &["schema"]);
    assert!(serde_json::from_slice::<serde_json::Value>(&schema.stdout).unwrap().is_object());
    let check = stampflow(dir.path(), &["check", "cases/cup.toml"]);
    assert_eq!(check.status.code(), Some(0), "{}", text(&check.stderr));
    assert!(!check.stdout.is_empty());
    assert_eq!(files(dir.path(), "").len(), 1);
}

const APART: &str = r#"
[[stages]]
name = "apart"
die = { move = "3 mm", aside = "4 mm" }
remove = ["holder"]
"#;

#[test]
fn every_stage_has_its_folder_and_its_line() {
    let dir = folder(&format!("{CUP}{STAGES}{APART}"));
    let done = stampflow(dir.path(), &["run", "cases/cup.toml"]);
    assert_eq!(done.status.code(), Some(0), "{}{}", text(&done.stderr), text(&done.stdout));
    let out = dir.path().join("out/cup");
    for stage in ["1-draw", "2-retract", "3-apart"] {
        for file in ["summary.json", "load_travel.csv", "profile.csv", "shapes.png"] {
            assert!(out.join(stage).join(file).is_file(), "{stage}/{file}");
        }
        assert!(text(&done.stderr).contains(&format!("cup/{stage}: 100 %")), "{}", text(&done.stderr));
    }
    assert!(!out.join("summary.json").exists());
    let table = fs::read_to_string(out.join("stages.csv")).unwrap();
    let lines: Vec<&str> = table.lines().collect();
    assert_eq!(
        lines[0],
        "stage,name,stop,end_time_s,travel_mm,punch_force_N,holder_force_N,thinnest_mm,edge_r_mm,pole_height_mm"
    );
    assert_eq!(lines.len(), 4, "{table}");
    assert!(lines[1].starts_with("1,draw,full travel,5,5,"), "{table}");
    assert!(lines[2].starts_with("2,retract,full travel,6,6,0,19.99"), "{table}");
    assert!(lines[3].starts_with("3,apart,full travel,5,5,0,0,"), "{table}");
    for says in [" 1 draw", " 2 retract", " 3 apart"] {
        assert!(text(&done.stdout).contains(says), "{says}: {}", text(&done.stdout));
    }
    let checked = stampflow(dir.path(), &["check", "cases/cup.toml"]);
    assert!(text(&checked.stdout).contains("punch goes -6 mm"), "{}", text(&checked.stdout));

    // A case of one stage leaves nothing of several beside it.
    fs::write(dir.path().join("cases/cup.toml"), CUP).unwrap();
    assert_eq!(stampflow(dir.path(), &["run", "cases/cup.toml", "--quiet"]).status.code(), Some(0));
    assert!(out.join("summary.json").is_file() && !out.join("stages.csv").exists());
}

/// The punch comes up to the die's bottom: what was computed is kept, the rest is said not to have been run.
#[test]
fn a_stage_that_stops_early_ends_the_sequence_with_code_three() {
    let dir = folder(&format!("{CUP}{STAGES}{APART}"));
    let done = stampflow(dir.path(), &["run", "cases/cup.toml", "--quiet", "--set", "stages.0.punch.move=80 mm"]);
    assert_eq!(done.status.code(), Some(3), "{}{}", text(&done.stderr), text(&done.stdout));
    let out = dir.path().join("out/cup");
    assert!(out.join("2-retract/summary.json").is_file() && !out.join("3-apart").exists());
    let table = fs::read_to_string(out.join("stages.csv")).unwrap();
    assert!(table.lines().nth(3).unwrap().ends_with("3,apart,not run,,,,,,,"), "{table}");
}

/// Neither is read: a pipe that nobody writes into waits for ever, a device never ends. A case, a drawing, and what a case names.
#[cfg(unix)]
#[test]
fn pipes_and_devices_are_refused() {
    let dir = folder(CUP);
    let [pipe, device] = ["pipe.csv", "device.csv"].map(|name| dir.path().join(name));
    assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    std::os::unix::fs::symlink("/dev/zero", &device).unwrap();
    for file in [pipe.to_str().unwrap(), device.to_str().unwrap()] {
        let punch = format!("profile = \"{file}\"");
        let profile = CUP.replace(r#"flat = { radius = "30 mm", nose = "6 mm" }"#, &punch);
        let heat = format!("{CUP}[heat]\ninitial = \"{file}\"\n");
        let reference = format!("{CUP}{}", COMPARE.replace("curve.csv", file));
        for (name, case) in [("profile", profile), ("heat", heat), ("reference", reference)] {
            fs::write(dir.path().join(format!("cases/{name}.toml")), case).unwrap();
        }
        for args in [
            &["check", file][..],
            &["import", file, "-o", "none.toml"],
            &["check", "cases/profile.toml"],
            &["check", "cases/heat.toml"],
            &["run", "cases/reference.toml"],
        ] {
            let done = stampflow(dir.path(), args);
            let said = text(&done.stderr).replace("\n  │ ", " ");
            assert_eq!(done.status.code(), Some(2), "{args:?}: {said}");
            assert!(said.contains("it is a pipe or a device, not a file"), "{args:?}: {said}");
        }
    }
    assert!(!dir.path().join("none.toml").exists() && !dir.path().join("out").exists());
}

/// Refused by its length, which is all that is asked of it: the file is 3 GB long and takes no room.
#[test]
fn a_drawing_that_is_too_large_is_not_read() {
    let dir = folder(CUP);
    fs::File::create(dir.path().join("die.dxf")).unwrap().set_len(3_000_000_000).unwrap();
    let done = stampflow(dir.path(), &["import", "die.dxf"]);
    let said = text(&done.stderr);
    assert_eq!(done.status.code(), Some(2), "{said}");
    assert!(said.contains("die.dxf cannot be read: it is larger than 50 MB; save the tools' layers only"), "{said}");
}

/// Trust: the folder has no results before; the run is far longer than the test, so only the signal can have ended it, and
/// the line of progress is not that of a hundredth of it.
#[cfg(unix)]
#[test]
fn a_long_run_tells_where_it_is_and_an_interrupted_one_writes_what_it_has_computed() {
    let dir = folder(&endless());
    let mut run = Command::new(env!("CARGO_BIN_EXE_stampflow"))
        .args(["run", "cases/cup.toml", "--trace", "trace.csv"])
        .current_dir(dir.path())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut told = String::new();
    let mut stderr = BufReader::new(run.stderr.take().unwrap());
    stderr.read_line(&mut told).unwrap();
    assert!(told.starts_with("cup: 0 %, travel 0.0"), "{told}");
    assert!(run.try_wait().unwrap().is_none(), "still running");
    let killed = Command::new("kill").args(["-INT", &run.id().to_string()]).status().unwrap();
    assert!(killed.success());
    let done = run.wait_with_output().unwrap();
    assert_eq!(done.status.code(), Some(130), "{told}");
    assert!(text(&done.stdout).contains("interrupted at"), "{}", text(&done.stdout));
    let load = fs::read_to_string(dir.path().join("out/cup/load_travel.csv")).unwrap();
    assert!(load.starts_with("travel_mm,") && load.lines().count() > 1);
    let summary = fs::read_to_string(dir.path().join("out/cup/summary.json")).unwrap();
    assert!(summary.contains("\"complete\": false"), "{summary}");
}
