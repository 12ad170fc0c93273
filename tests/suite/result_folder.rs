//! Results in their folder: one whole set or another, whatever ends a run, and nothing of anyone else's is written over.
//!
//! That each single change of the disk may be the last is tested beside the code, in `output::result_folder`; here are the
//! same promises as a user meets them.

use crate::common::cli::{COMPARE, CUP, STAGES, endless, folder, stampflow, text};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

/// All files below a folder by their paths from it, what a summary says of the clock left out.
type Tree = BTreeMap<PathBuf, Vec<u8>>;

fn tree(dir: &Path) -> Tree {
    let mut found = Tree::new();
    for entry in fs::read_dir(dir).into_iter().flatten().map(Result::unwrap) {
        let (path, name) = (entry.path(), PathBuf::from(entry.file_name()));
        if path.is_dir() {
            found.extend(tree(&path).into_iter().map(|(below, bytes)| (name.join(below), bytes)));
        } else {
            let bytes = fs::read(&path).unwrap();
            found
                .insert(name.clone(), if name.ends_with("summary.json") { without_clock(text(&bytes)) } else { bytes });
        }
    }
    found
}

fn without_clock(summary: &str) -> Vec<u8> {
    summary.lines().filter(|line| !line.contains("wall_time")).collect::<Vec<_>>().join("\n").into_bytes()
}

fn names(dir: &Path) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(dir).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

fn spawn(dir: &Path, args: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_stampflow"));
    command.args(args).current_dir(dir).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

/// Calls the program through a shell, which puts the streams where it is told.
fn shell(dir: &Path, line: &str) -> Output {
    let line = line.replace("stampflow", env!("CARGO_BIN_EXE_stampflow"));
    Command::new("sh").args(["-c", &line]).current_dir(dir).output().unwrap()
}

const MOVING: [&str; 5] = ["run", "cases/cup.toml", "--quiet", "--vtu", "--animate"];
const OTHER: [&str; 2] = ["--set", "tools.punch.travel=3 mm"];

/// Ends runs by a signal at random moments, every other one in a folder with older results and a file of a user's own.
fn ended_at_random(times: u32) {
    let dir = folder(CUP);
    let out = dir.path().join("out/cup");
    stampflow(dir.path(), &[&MOVING[..], &OTHER[..]].concat());
    let old = tree(&out);
    fs::remove_dir_all(&out).unwrap();
    let begin = Instant::now();
    stampflow(dir.path(), &MOVING);
    let whole_run = begin.elapsed();
    let new = tree(&out);
    assert!(new.len() > 60 && new != old);
    let mut random = fastrand::Rng::with_seed(7);
    let mut outcomes = BTreeMap::new();
    for i in 0..times {
        let is_used = i % 2 == 0;
        let signal = ["-KILL", "-INT", "-TERM"][i as usize / 2 % 3];
        fs::remove_dir_all(dir.path().join("out")).unwrap();
        let mut before = Tree::new();
        if is_used {
            before = old.clone();
            before.insert("notes.txt".into(), b"mine".to_vec());
            fs::create_dir_all(&out).unwrap();
            before.iter().for_each(|(name, bytes)| fs::write(out.join(name), bytes).unwrap());
            // A summary without its clock is still the mark of a run.
            assert_eq!(tree(&out), before);
        }
        let mine = |results: &Tree| {
            let mut all = results.clone();
            all.extend(before.get(Path::new("notes.txt")).map(|bytes| ("notes.txt".into(), bytes.clone())));
            all
        };
        let mut run = spawn(dir.path(), &MOVING);
        sleep(whole_run.mul_f64(1.1 * random.f64()));
        let _ = Command::new("kill").args([signal, &run.id().to_string()]).stderr(Stdio::null()).status();
        run.wait().unwrap();
        let found = tree(&out);
        let outcome = if found == before {
            "as before"
        } else if found == mine(&new) {
            "new"
        } else {
            assert_ne!(signal, "-KILL", "{i}: a killed run leaves what it ended only: {:?}", found.keys());
            is_whole_interrupted_run(&found, &new, &old);
            assert_eq!(found.get(Path::new("notes.txt")), before.get(Path::new("notes.txt")));
            "interrupted"
        };
        *outcomes.entry((signal, is_used, outcome)).or_insert(0) += 1;
        // The next run puts all in order.
        assert_eq!(stampflow(dir.path(), &MOVING).status.code(), Some(0));
        assert!(tree(&out) == mine(&new), "{i}: {:?}", tree(&out).keys());
        assert_eq!(names(&dir.path().join("out")), ["cup"], "{i}: litter");
    }
    println!("{outcomes:#?}");
}

/// What its summary says is what its table ends with, and every state that its collections name is there, no more.
fn is_whole_interrupted_run(found: &Tree, new: &Tree, old: &Tree) {
    let file = |name: &str| text(&found[Path::new(name)]);
    let summary: serde_json::Value = serde_json::from_str(file("summary.json")).unwrap();
    assert_eq!(summary["complete"], false);
    let last: f64 = file("load_travel.csv").lines().last().unwrap().split(',').next().unwrap().parse().unwrap_or(0.0);
    let travel = summary["travel_mm"].as_f64().unwrap();
    // Trust: both are rounded to nine digits.
    assert!((last - travel).abs() < 1e-6, "{last} mm in the table, {travel} mm in the summary");
    let mut states = 0;
    for collection in ["section", "revolved", "tools"].map(|name| format!("{name}.pvd")) {
        let Some(bytes) = found.get(Path::new(&collection)) else { continue };
        for state in text(bytes).split("file=\"").skip(1).map(|rest| rest.split('"').next().unwrap()) {
            assert!(found.contains_key(Path::new(state)), "{state} is missing");
            states += 1;
        }
    }
    let is_state = |name: &&PathBuf| name.extension().is_some_and(|e| e == "vtu");
    assert_eq!(found.keys().filter(is_state).count(), states);
    let foreign = |name: &&PathBuf| name.as_path() != Path::new("notes.txt");
    assert!(found.keys().filter(foreign).all(|name| new.contains_key(name)));
    assert_ne!(found[Path::new("load_travel.csv")], old[Path::new("load_travel.csv")]);
}

#[cfg(unix)]
#[test]
fn a_run_that_is_ended_at_any_moment_leaves_one_whole_result_or_none() {
    ended_at_random(12);
}

#[cfg(unix)]
#[test]
#[ignore = "some minutes"]
fn three_hundred_runs_that_are_ended_leave_one_whole_result_or_none() {
    ended_at_random(300);
}

/// Trust: both begin at once and take far longer than to begin; whoever comes second is told who is first.
#[cfg(unix)]
#[test]
fn of_two_runs_into_one_folder_one_is_refused_with_the_reason() {
    let dir = folder(CUP);
    stampflow(dir.path(), &MOVING);
    let whole = tree(&dir.path().join("out/cup"));
    let mut refused = 0;
    for _ in 0..20 {
        let runs = [spawn(dir.path(), &MOVING), spawn(dir.path(), &MOVING)];
        let ids = runs.each_ref().map(Child::id);
        let done = runs.map(|run| run.wait_with_output().unwrap());
        for (i, run) in done.iter().enumerate() {
            if run.status.code() != Some(0) {
                let first = format!("another run, process {}, is writing there", ids[1 - i]);
                assert_eq!(run.status.code(), Some(2), "{}", text(&run.stderr));
                assert!(text(&run.stderr).contains(&first), "{}", text(&run.stderr));
                refused += 1;
            }
        }
        assert!(done.iter().any(|run| run.status.code() == Some(0)));
        assert!(tree(&dir.path().join("out/cup")) == whole);
        assert_eq!(names(&dir.path().join("out")), ["cup"]);
    }
    assert!(refused > 0, "the runs never met");
}

#[test]
fn folders_of_older_stages_go_and_what_a_user_put_there_stays() {
    let dir = folder(&format!("{CUP}{STAGES}"));
    let out = dir.path().join("out/cup");
    stampflow(dir.path(), &["run", "cases/cup.toml", "-q"]);
    for name in ["1-draw/photo.jpg", "notes.txt", "2-mine/summary.json"] {
        fs::create_dir_all(out.join(name).parent().unwrap()).unwrap();
        fs::write(out.join(name), "mine").unwrap();
    }
    fs::write(dir.path().join("cases/cup.toml"), CUP).unwrap();
    assert_eq!(stampflow(dir.path(), &["run", "cases/cup.toml", "-q"]).status.code(), Some(0));
    for name in ["1-draw/photo.jpg", "notes.txt", "2-mine/summary.json"] {
        assert_eq!(fs::read_to_string(out.join(name)).unwrap(), "mine", "{name}");
    }
    assert_eq!(names(&out.join("1-draw")), ["photo.jpg"]);
    assert!(!out.join("2-retract").exists() && !out.join("stages.csv").exists() && out.join("summary.json").exists());
    assert_eq!(names(&dir.path().join("out")), ["cup"]);
}

/// What it holds of the user's stays, folders too, and whoever stands in it stays there.
#[test]
fn the_present_folder_may_be_that_of_the_results() {
    let dir = folder(CUP);
    fs::write(dir.path().join("notes.txt"), "mine").unwrap();
    for _ in 0..2 {
        let done = shell(dir.path(), "stampflow run cases/cup.toml -q --out . && ls summary.json");
        assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
        assert!(text(&done.stdout).ends_with("\nsummary.json\n"));
    }
    assert_eq!(fs::read_to_string(dir.path().join("notes.txt")).unwrap(), "mine");
    assert!(dir.path().join("cases/cup.toml").is_file() && names(dir.path()).iter().all(|name| !name.starts_with('.')));
}

/// The folder beside that of the results is the last thing to be made before a case is solved.
#[cfg(unix)]
fn wait_until_it_solves(dir: &Path) {
    let begin = Instant::now();
    while !dir.join("out/.cup.part").exists() {
        assert!(begin.elapsed() < Duration::from_secs(60), "it never begins");
        sleep(Duration::from_millis(10));
    }
    sleep(Duration::from_millis(500));
}

/// A run that takes long, what happens meanwhile, and Ctrl-C.
#[cfg(unix)]
fn meanwhile(dir: &Path, happens: impl Fn()) -> Output {
    let run = spawn(dir, &["run", "cases/cup.toml", "-q"]);
    wait_until_it_solves(dir);
    happens();
    assert!(Command::new("kill").args(["-INT", &run.id().to_string()]).status().unwrap().success());
    run.wait_with_output().unwrap()
}

#[cfg(unix)]
#[test]
fn what_goes_away_during_a_run_takes_no_result_with_it() {
    let dir = folder(&format!("{}{COMPARE}", endless()));
    let reference = dir.path().join("cases/curve.csv");
    fs::write(&reference, "travel_mm,punch_force_kN\n0.001,1\n0.002,2\n").unwrap();
    let done = meanwhile(dir.path(), || {
        fs::remove_file(&reference).unwrap();
        fs::remove_dir_all(dir.path().join("out")).unwrap();
    });
    assert_eq!(done.status.code(), Some(130), "{}", text(&done.stderr));
    let out = dir.path().join("out/cup");
    assert!(out.join("load_travel.csv").is_file() && out.join("compare_1_punch_force.csv").is_file());
    assert_eq!(names(&dir.path().join("out")), ["cup"]);
}

#[cfg(unix)]
#[test]
fn results_that_cannot_be_written_are_summed_up_nevertheless() {
    let dir = folder(&endless());
    let done = meanwhile(dir.path(), || {
        fs::remove_dir_all(dir.path().join("out")).unwrap();
        fs::write(dir.path().join("out"), "in the way").unwrap();
    });
    assert_eq!(done.status.code(), Some(1), "{}", text(&done.stderr));
    assert!(text(&done.stderr).contains("cannot write out/cup/"), "{}", text(&done.stderr));
    assert!(text(&done.stdout).contains("Punch force"), "{}", text(&done.stdout));
    assert_eq!(fs::read_to_string(dir.path().join("out")).unwrap(), "in the way");
}

/// No file may be longer than 16 kB, which is what a full disk comes to.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_earlier_results_and_tells_where_the_new_ones_are() {
    let dir = folder(CUP);
    let run = "stampflow run cases/cup.toml -q --trace trace.csv";
    assert_eq!(shell(dir.path(), run).status.code(), Some(0));
    let whole = tree(dir.path());
    let done = shell(
        dir.path(),
        &format!("trap '' XFSZ; ulimit -f 32; {run} --set tools.punch.travel='4 mm' --set solver.max_step=0.005"),
    );
    let said = text(&done.stderr);
    assert_eq!(done.status.code(), Some(1), "{said}");
    assert!(said.contains("cannot write out/cup/") && said.contains("cannot write trace.csv"), "{said}");
    assert!(
        said.contains("what could be written is until the next run in") && said.contains("out/.cup.part"),
        "{said}"
    );
    assert!(text(&done.stdout).contains("Punch force") && !text(&done.stdout).contains("files in"));
    let left = dir.path().join("out/.cup.part");
    assert!(left.join("summary.json").is_file());
    fs::remove_dir_all(left).unwrap();
    assert!(tree(dir.path()) == whole, "{:?}", tree(dir.path()).keys());
}

/// Trust: a name may have 255 bytes; the folder's neighbours have one of five letters more.
#[test]
fn a_name_that_is_too_long_is_found_before_solving() {
    let dir = folder(CUP);
    let name = "a".repeat(250);
    fs::rename(dir.path().join("cases/cup.toml"), dir.path().join(format!("cases/{name}.toml"))).unwrap();
    let case = format!("cases/{name}.toml");
    for args in [
        &["run", &case][..],
        &["run", &case, "--out", &"b".repeat(300)],
        &["report", &case, "-o", &format!("new/{name}a.html")],
    ] {
        let done = stampflow(dir.path(), args);
        assert_eq!(done.status.code(), Some(2), "{args:?}: {}", text(&done.stderr));
        assert!(text(&done.stderr).contains("name too long"), "{args:?}: {}", text(&done.stderr));
        assert!(!text(&done.stderr).contains("10 %"), "{args:?} was solved first");
        assert_eq!(names(dir.path()), ["cases"], "{args:?} left something behind");
    }
    assert_eq!(stampflow(dir.path(), &["run", &case, "-q", "--out", "short"]).status.code(), Some(0));
}

/// What is read, what a user has made, and what is none of the kind that is written.
#[test]
fn nothing_of_anyone_else_is_written_over() {
    let dir = folder(CUP);
    let drawing = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/drawings/ezdxf_lines_and_arcs.dxf");
    fs::copy(drawing, dir.path().join("die.png")).unwrap();
    fs::create_dir_all(dir.path().join("mine")).unwrap();
    fs::create_dir_all(dir.path().join("read")).unwrap();
    for name in ["notes.txt", "mine/strains.png", "summary.json"] {
        fs::write(dir.path().join(name), "mine").unwrap();
    }
    fs::write(dir.path().join("read/profile.csv"), "r_mm,z_mm\n0,0\n30,0\n30,-60\n").unwrap();
    let profile = CUP.replace(r#"flat = { radius = "30 mm", nose = "6 mm" }"#, "profile = \"../read/profile.csv\"");
    fs::write(dir.path().join("cases/profile.toml"), profile).unwrap();
    fs::copy(dir.path().join("cases/cup.toml"), dir.path().join("...toml")).unwrap();
    fs::write(dir.path().join("cases/stages.toml"), format!("{CUP}{STAGES}")).unwrap();
    fs::create_dir_all(dir.path().join("copies/1-draw")).unwrap();
    fs::create_dir_all(dir.path().join("file")).unwrap();
    fs::write(dir.path().join("copies/1-draw/profile.csv"), "mine").unwrap();
    fs::write(dir.path().join("file/1-draw"), "mine").unwrap();
    let before = tree(dir.path());
    for (args, says) in [
        (&["run", "cases/cup.toml", "--trace", "cases/cup.toml"][..], "--trace"),
        (&["run", "cases/cup.toml", "--trace", "notes.txt"], "notes.txt is there already"),
        (&["run", "cases/cup.toml", "--trace", "out/cup/profile.csv"], "is the name of a result"),
        (&["run", "cases/cup.toml", "--out", "mine"], "nothing says that a run has written it"),
        (&["run", "cases/cup.toml", "--out", "."], "summary.json: it is there"),
        (&["run", "cases/profile.toml", "--out", "read"], "profile.csv is read by the case"),
        (&["run", "cases/stages.toml", "--out", "copies"], "copies/1-draw/profile.csv: it is there"),
        (&["run", "cases/stages.toml", "--out", "file"], "cannot write file/1-draw"),
        (&["run", "...toml"], "no folder of their own"),
        (&["report", "...toml"], "no folder of their own"),
        (
            &["report", "cases/cup.toml", "-o", "cases/cup.toml", "--format", "html", "--force"],
            "cases/cup.toml is what is read",
        ),
        (&["import", "die.png", "-o", "x.png"], "would be both the case and its picture"),
        (&["import", "die.png", "-o", "x.png", "--force"], "would be both the case and its picture"),
        (&["import", "die.png", "-o", "die.toml", "--force"], "die.png is what is read"),
        (&["materials", "aa6016-t4", "--plot", "notes.txt"], "notes.txt is there already"),
    ] {
        let done = stampflow(dir.path(), args);
        assert_eq!(done.status.code(), Some(2), "{args:?}: {}{}", text(&done.stdout), text(&done.stderr));
        assert!(text(&done.stderr).contains(says), "{args:?}: {}", text(&done.stderr));
        assert!(tree(dir.path()) == before, "{args:?}: {:?}", tree(dir.path()).keys());
    }
    // One's own is replaced.
    for _ in 0..2 {
        for args in [
            &["run", "cases/cup.toml", "-q", "--trace", "trace.csv"][..],
            &["materials", "aa6016-t4", "--plot", "aa.png"],
            &["run", "...toml", "-q", "--out", "dots"],
        ] {
            let done = stampflow(dir.path(), args);
            assert_eq!(done.status.code(), Some(0), "{args:?}: {}", text(&done.stderr));
        }
    }
}

/// Trust: a device that is always full and a reader that has gone; the run tells of its progress there.
#[cfg(unix)]
#[test]
fn a_message_that_cannot_be_shown_ends_no_run() {
    let dir = folder(CUP);
    for (line, code) in [
        ("stampflow run cases/cup.toml 2>/dev/full", 0),
        ("(stampflow run cases/cup.toml; echo $? >code) 2>&1 | head -c 1; exit $(cat code)", 0),
        ("(stampflow run cases/cup.toml -q; echo $? >code) | true; exit $(cat code)", 0),
        ("stampflow run cases/cup.toml -q >/dev/full", 1),
        ("stampflow run none.toml 2>/dev/full", 2),
        ("stampflow fly 2>/dev/full", 2),
        ("stampflow --help >/dev/full", 0),
    ] {
        let _ = fs::remove_dir_all(dir.path().join("out"));
        let done = shell(dir.path(), line);
        assert_eq!(done.status.code(), Some(code), "{line}: {}", text(&done.stderr));
        assert!(!text(&done.stderr).contains("panicked"), "{line}: {}", text(&done.stderr));
        assert_eq!(dir.path().join("out/cup/summary.json").is_file(), line.contains("cup.toml"), "{line}");
    }
}

/// Trust: two signals that wait at the same time; the run alone would take far longer than the test.
#[cfg(unix)]
#[test]
fn a_second_signal_ends_the_program_at_once() {
    let dir = folder(&endless());
    let run = spawn(dir.path(), &["run", "cases/cup.toml", "-q"]);
    wait_until_it_solves(dir.path());
    let id = run.id();
    let both = shell(dir.path(), &format!("kill -STOP {id}; kill -INT {id}; kill -TERM {id}; kill -CONT {id}"));
    assert!(both.status.success());
    let done = run.wait_with_output().unwrap();
    assert_eq!((done.status.code(), text(&done.stdout)), (Some(130), ""), "{}", text(&done.stderr));
    assert!(!dir.path().join("out/cup").exists());
    fs::write(dir.path().join("cases/cup.toml"), CUP).unwrap();
    assert_eq!(stampflow(dir.path(), &["run", "cases/cup.toml", "-q"]).status.code(), Some(0));
    assert_eq!(names(&dir.path().join("out")), ["cup"]);
}
