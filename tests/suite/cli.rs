//! The command line as a user meets it: exit codes, files, and what is left behind.

use crate::common::prelude::*;
use std::time::SystemTime;

/// Arguments, the exit code, and what stands on the error stream: nothing at all if empty.
type Call<'a> = (&'a [&'a str], i32, &'a str);

fn check_calls(dir: &Path, calls: &[Call]) {
    for (args, code, says) in calls {
        let done = stampflow(dir, args);
        let errors = text(&done.stderr).replace("\n  │ ", " ");
        assert_eq!(done.status.code(), Some(*code), "{args:?}: {errors}{}", text(&done.stdout));
        assert!(if says.is_empty() { errors.is_empty() } else { errors.contains(says) }, "{args:?}: {errors}");
    }
}

#[test]
fn a_run_writes_every_file_and_a_trace() {
    let dir = folder(CUP);
    check_calls(dir.path(), &[(&["run", "cases/cup.toml", "--trace", "trace.csv", "--verbose"], 0, "")]);
    let absent = "pressure_cycle porosity damage temperature springback residual_stress stages.csv \
                  compare_ section.pvd shapes.gif error_bars beads";
    for output in stampflow::results::OUTPUTS {
        let path = dir.path().join("out/cup").join(output.file);
        let is_absent = absent.split(' ').any(|begin| output.file.starts_with(begin));
        assert_eq!(fs::metadata(path).is_ok_and(|file| file.len() > 200), !is_absent, "{}", output.file);
    }
    assert!(fs::read_to_string(dir.path().join("trace.csv")).unwrap().lines().count() > 50);
}

/// Files below a folder with their lengths and times.
fn snapshot(folder: &Path) -> Vec<(PathBuf, u64, SystemTime)> {
    let below = files(folder, "").into_iter().flat_map(|path| {
        let data = fs::metadata(&path).unwrap();
        if data.is_dir() { snapshot(&path) } else { vec![(path, data.len(), data.modified().unwrap())] }
    });
    below.collect()
}

/// Trust: by the table; what is refused is refused before anything is solved, and no file is touched.
#[test]
fn bad_calls_end_with_2_and_leave_everything_as_it_was() {
    let dir = temp_dir::TempDir::new().unwrap();
    let root = dir.path();
    let copied = Command::new("cp").args(["-r", "tests/bad_cases/calls/."]).arg(root).status();
    assert!(copied.unwrap().success());
    fs::create_dir(root.join("folder")).unwrap();
    fs::create_dir_all(root.join("half/summary.json")).unwrap();
    fs::write(root.join("cases/large.toml"), "# a comment that goes on\n".repeat(100_000)).unwrap();
    fs::File::create(root.join("die.dxf")).unwrap().set_len(3_000_000_000).unwrap();
    let before = snapshot(root);
    let rows = include_str!("../bad_cases/calls.txt").lines().filter(|line| !line.starts_with('#'));
    let wrong: Vec<String> = rows
        .filter_map(|row| {
            let (line, says) = row.split_once(" | ").expect("arguments and a message");
            let command = format!("exec {} {line}", env!("CARGO_BIN_EXE_stampflow"));
            let drawings = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/drawings");
            let mut shell = Command::new("sh");
            let done = shell.args(["-c", &command]).env("DRAWINGS", drawings).current_dir(root).output().unwrap();
            let errors = text(&done.stderr).replace("\n  │ ", " ").replace("\n ", "");
            let is_refused = done.status.code() == Some(2) && done.stdout.is_empty() && snapshot(root) == before;
            let is_named = errors.contains(says) && !errors.contains("secret") && !errors.contains("10 %");
            (!is_refused || !is_named).then(|| format!("{row}\n{:?} {errors}", done.status.code()))
        })
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Trust: three iterations do not find equilibrium, and steps may not be made smaller; Hill's limit of AA6016 is passed.
#[test]
fn early_ends_and_red_lights_have_their_codes_and_keep_their_results() {
    let dir = folder(CUP);
    let stuck = ["--set", "solver.max_iterations=3", "--set", "solver.min_step=0.002", "-q"];
    let with = |args: &[&'static str]| [args, &stuck].concat();
    let torn = "new hemispherical-cup --material aa6016 --friction 0.15 --height 52mm -o torn.toml";
    let bead = "tools.beads=[{at=\"46 mm\",round={radius=\"1 mm\",height=\"9 mm\",shoulder=\"1 mm\"}}]";
    // Between the forming limit and the neck that ends the run.
    let before = "tools.punch.travel=29mm";
    check_calls(
        dir.path(),
        &[
            (&with(&["run", "cases/cup.toml"]), 3, ""),
            (&with(&["check", "cases/cup.toml", "--run"]), 3, ""),
            (&with(&["verify", "cases/cup.toml", "--out", "bars"]), 3, ""),
            (&["check", "cases/cup.toml", "--set", bead], 3, "no strip comes through the bead at 46 mm"),
            (&torn.split(' ').collect::<Vec<_>>(), 0, ""),
            (&["run", "torn.toml", "-q", "--no-advice", "--set", before], 0, ""),
            (&["run", "torn.toml", "-q", "--no-advice", "--set", before, "--strict", "--out", "strict"], 4, ""),
            (&["check", "torn.toml", "--run", "-q", "--no-advice", "--set", before, "--strict"], 4, ""),
        ],
    );
    assert_eq!(read_json(dir.path().join("out/cup/summary.json"))["complete"], false);
    for folder in ["out/torn", "strict"] {
        let verdict = read_json(dir.path().join(folder).join("summary.json"))["verdict"].clone();
        assert_eq!((&verdict["light"], verdict["sentence"].as_str().unwrap().contains("tears")), (&"red".into(), true));
    }
}

/// Trust: one good case between two bad ones.
#[test]
fn every_bad_case_of_a_command_is_named_and_the_good_one_runs() {
    let dir = folder(CUP);
    let cases = dir.path().join("cases");
    fs::write(cases.join("curve.csv"), "").unwrap();
    fs::write(cases.join("curved.toml"), format!("{CUP}{COMPARE}")).unwrap();
    fs::write(cases.join("empty.toml"), "").unwrap();
    let args = ["run", "cases/curved.toml", "cases/cup.toml", "cases/empty.toml"];
    check_calls(dir.path(), &[(&args, 2, "the reference file is empty"), (&args, 2, "empty.toml")]);
    let out = dir.path().join("out");
    assert!(out.join("cup/summary.json").is_file() && !out.join("curved").exists());
}

#[test]
fn no_control_character_reaches_the_terminal() {
    let obeyed = "\u{1b}]0;owned\u{7}\u{1b}[31m\u{9b}2J";
    let dir =
        folder(&CUP.replace("\"Cup\"", "\"Cup \\u001b[31m\\u0007\"").replace("all of it", "all \\u001b[2J\\u009b"));
    let cases = dir.path().join("cases");
    fs::copy(cases.join("cup.toml"), cases.join(format!("n{obeyed}.toml"))).unwrap();
    for (name, content) in [
        ("raw.toml", format!("title = \"{obeyed}\"\r\n")),
        ("key.toml", "[\"\\u001b[31m\"]\n".to_owned()),
        ("curve.csv", format!("travel_mm,punch_force_kN\n1,{obeyed}\n")),
        ("other.csv", format!("{obeyed}\n")),
        ("curved.toml", format!("{CUP}{COMPARE}")),
        ("hot.toml", format!("{CUP}[heat]\ninitial = \"curve.csv\"\n")),
        ("other.toml", format!("{CUP}[heat]\ninitial = \"other.csv\"\n")),
    ] {
        fs::write(cases.join(name), content).unwrap();
    }
    let drawing = fs::read_to_string("tests/drawings/ezdxf_lines_and_arcs.dxf").unwrap();
    fs::write(dir.path().join("d.dxf"), drawing.replace("\nPUNCH\n", "\nPUNCH\u{1b}[31m\n")).unwrap();
    let (named, missing) = (format!("cases/n{obeyed}.toml"), format!("cases/{obeyed}"));
    let (set, verb) = (format!("blank.{obeyed}=1"), format!("ru{obeyed}n"));
    let cup = "cases/cup.toml";
    let done = format!("check {cup} --run|run {cup}|run {cup} --json|report {named}|import d.dxf");
    let bad = ["raw", "key", "curved", "hot", "other"].map(|name| format!("check cases/{name}.toml|")).concat();
    let bad = format!("{bad}check cases/raw.toml --json|check {cup} --set {set}|check {missing}|{verb}");
    for (args, code) in done.split('|').map(|args| (args, 0)).chain(bad.split('|').map(|args| (args, 2))) {
        let done = stampflow(dir.path(), &args.split(' ').collect::<Vec<_>>());
        assert_eq!(done.status.code(), Some(code), "{args:?}: {}", text(&done.stderr));
        let printed = [text(&done.stdout), text(&done.stderr)].concat();
        assert_eq!(printed.chars().find(|c| c.is_control() && *c != '\n'), None, "{args:?}: {printed:?}");
    }
}

const APART: &str = r#"
[[stages]]
name = "apart"
die = { move = "3 mm", aside = "4 mm" }
remove = ["holder"]
"#;

/// Trust: what the stages say of their motions; the punch of the last run comes up to the die's bottom.
#[test]
fn every_stage_has_its_folder_and_its_row() {
    let dir = folder(&format!("{CUP}{STAGES}{APART}"));
    let out = dir.path().join("out/cup");
    check_calls(dir.path(), &[(&["run", "cases/cup.toml"], 0, "")]);
    for stage in ["1-draw", "2-retract", "3-apart"] {
        for file in ["summary.json", "load_travel.csv", "profile.csv", "shapes.png"] {
            assert!(out.join(stage).join(file).is_file(), "{stage}/{file}");
        }
    }
    let rows = || fs::read_to_string(out.join("stages.csv")).unwrap().lines().map(str::to_owned).collect::<Vec<_>>();
    let head = "stage,name,stop,end_time_s,travel_mm,punch_force_N,holder_force_N,thinnest_mm,edge_r_mm,pole_height_mm";
    let begins = [head, "1,draw,full travel,5,5,", "2,retract,full travel,6,6,0,19.99", "3,apart,full travel,5,5,0,0,"];
    assert!(rows().len() == 4 && rows().iter().zip(begins).all(|(row, begin)| row.starts_with(begin)), "{:?}", rows());
    assert!(!out.join("summary.json").exists());
    check_calls(dir.path(), &[(&["run", "cases/cup.toml", "-q", "--set", "stages.0.punch.move=80 mm"], 3, "")]);
    assert!(out.join("2-retract/summary.json").is_file() && !out.join("3-apart").exists());
    assert!(rows()[3].starts_with("3,apart,not run,,,,,,,,,"), "{:?}", rows());
}

/// Trust: `script` gives the program a terminal; the first run takes longer than it may be without a bar.
#[cfg(target_os = "linux")]
#[test]
fn a_terminal_has_a_bar_before_the_first_result_and_none_if_it_is_to_be_quiet() {
    let dir = folder(&CUP.replace("elements = 30", "elements = 200"));
    for (args, bar, mark) in [
        ("compare cases/cup.toml --also friction=0.1", "cup, compared", "  0 %"),
        ("sweep cases/cup.toml --vary friction=0.05 --restart --set blank.elements=2000", "cup, runs", "  0 %"),
        ("trace cases/cup.toml --step 90 --set blank.elements=2000", "cup", "░"),
    ] {
        let is_shown = |more: &str| {
            let line = format!("{} {args} {more}", env!("CARGO_BIN_EXE_stampflow"));
            let done =
                Command::new("script").args(["-qec", &line, "/dev/null"]).current_dir(dir.path()).output().unwrap();
            assert!(done.status.success(), "{args}: {}", text(&done.stdout));
            text(&done.stdout).split('\r').any(|frame| frame.contains(bar) && frame.contains(mark))
        };
        assert_eq!((is_shown(""), is_shown("--quiet")), (true, false), "{args}");
    }
}

/// Neither is read: a pipe that nobody writes into waits for ever, a device never ends.
#[cfg(unix)]
#[test]
fn pipes_and_devices_are_refused() {
    let dir = folder(CUP);
    let [pipe, device] = ["pipe.csv", "device.csv"].map(|name| dir.path().join(name));
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    std::os::unix::fs::symlink("/dev/zero", &device).unwrap();
    for file in [pipe.to_str().unwrap(), device.to_str().unwrap()] {
        let punch = format!("profile = \"{file}\"");
        for (name, case) in [
            ("profile", CUP.replace(r#"flat = { radius = "30 mm", nose = "6 mm" }"#, &punch)),
            ("heat", format!("{CUP}[heat]\ninitial = \"{file}\"\n")),
            ("reference", format!("{CUP}{}", COMPARE.replace("curve.csv", file))),
        ] {
            fs::write(dir.path().join(format!("cases/{name}.toml")), case).unwrap();
        }
        for args in [
            &["check", file][..],
            &["import", file, "-o", "none.toml"],
            &["check", "cases/profile.toml"],
            &["check", "cases/heat.toml"],
            &["run", "cases/reference.toml"],
        ] {
            check_calls(dir.path(), &[(args, 2, "it is a pipe or a device, not a file")]);
        }
    }
    assert!(!dir.path().join("none.toml").exists() && !dir.path().join("out").exists());
}

/// A report is of the numbers beside it, or gone; a dropped case has one; what someone else calls report.html stays.
#[test]
fn one_run_writes_the_report_and_the_next_does_not_leave_it_behind() {
    let dir = folder(CUP);
    let page = dir.path().join("out/cup/report.html");
    let (plain, reported) = (&["run", "cases/cup.toml", "-q"][..], &["run", "cases/cup.toml", "-q", "--report"][..]);
    check_calls(dir.path(), &[(reported, 0, ""), (&["cases/cup.toml"], 0, "")]);
    let is_report = |path| fs::read_to_string(path).unwrap().contains("stampflow report, version");
    assert!(is_report(page.clone()) && is_report(dir.path().join("cases/cup_report.html")));
    check_calls(dir.path(), &[(plain, 0, "")]);
    assert!(!page.exists(), "it was of the numbers before");
    fs::write(&page, "mine").unwrap();
    check_calls(dir.path(), &[(plain, 0, ""), (reported, 2, "no report of ours")]);
    assert_eq!(fs::read_to_string(&page).unwrap(), "mine");
}

/// Trust: frames are looked at as they pass; were a step made for one, the tables would differ in their last digits.
#[test]
fn animations_and_states_change_no_table_and_go_with_their_option() {
    let dir = folder(CUP);
    let out = dir.path().join("out/cup");
    let tables = || ["load_travel.csv", "profile.csv"].map(|name| fs::read(out.join(name)).unwrap());
    let run = |more: &[&'static str]| [&["run", "cases/cup.toml", "-q"], more].concat();
    check_calls(dir.path(), &[(&run(&[]), 0, "")]);
    let plain = tables();
    for (option, file) in [("--animate", "shapes.gif"), ("--vtu", "section.pvd")] {
        check_calls(dir.path(), &[(&run(&[option]), 0, "")]);
        assert!(tables() == plain && out.join(file).is_file(), "{option}");
    }
    check_calls(dir.path(), &[(&run(&["--format", "svg", "--captions", "none", "--width", "85 mm"]), 0, "")]);
    assert!(!out.join("shapes.gif").exists() && !out.join("section.pvd").exists());
    assert_eq!((files(&out, "png").len(), files(&out, "svg").is_empty()), (0, false), "the earlier format goes");
}
