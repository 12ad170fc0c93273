//! Promises on written files: one whole set or the other, whatever ends a verb, and nothing of another origin is touched.

use crate::common::prelude::*;
use rayon::prelude::*;
use stampflow::results::{can_write, write};
use std::{process::Child, time::Instant};

/// Files below a folder without wall times, which no two runs share.
type Tree = BTreeMap<PathBuf, Vec<u8>>;

fn tree(dir: &Path) -> Tree {
    let clock = Regex::new(r#"(?i)wall[ _](time|s)[^0-9]*[0-9.e-]+[^,\n<]*"#).unwrap();
    let mut found = Tree::new();
    for entry in fs::read_dir(dir).into_iter().flatten().map(Result::unwrap) {
        let (path, name) = (entry.path(), PathBuf::from(entry.file_name()));
        if path.is_dir() {
            found.extend(tree(&path).into_iter().map(|(below, bytes)| (name.join(below), bytes)));
        } else {
            let bytes = fs::read(&path).unwrap();
            let plain = std::str::from_utf8(&bytes).map(|text| clock.replace_all(text, "").into_owned().into_bytes());
            found.insert(name, plain.unwrap_or(bytes));
        }
    }
    found
}

/// The tree without files on their way, such as the rows of a study that was ended.
fn visible(mut tree: Tree) -> Tree {
    tree.retain(|path, _| !path.to_string_lossy().split('/').any(|name| name.starts_with('.')));
    tree
}

fn names(dir: &Path) -> Vec<String> {
    files(dir, "").iter().map(|path| path.file_name().unwrap().to_str().unwrap().to_owned()).collect()
}

fn spawn(dir: &Path, args: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_stampflow"));
    command.args(args).current_dir(dir).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

fn shell(dir: &Path, line: &str) -> Output {
    let line = line.replace("stampflow", env!("CARGO_BIN_EXE_stampflow"));
    Command::new("sh").args(["-c", &line]).current_dir(dir).output().unwrap()
}

/// Verbs that write: arguments, those that give other results, and what is written.
const COARSE: &str = "--set blank.elements=20 --format svg";
const VERBS: [[&str; 3]; 11] = [
    ["run cases/cup.toml -q --vtu --animate", "--set tools.punch.travel=3mm", "out/cup"],
    ["run cases/staged.toml -q --report", "--set tools.punch.travel=3mm", "out/staged"],
    ["report cases/cup.toml -q", "--set tools.punch.travel=3mm", "out/cup"],
    ["sweep cases/cup.toml -q --restart --vary friction=0.05,0.1", COARSE, "out/cup-sweep"],
    [
        "search cases/cup.toml -q --restart --vary friction=0.05..0.15/3 --largest --while punch_force<1MN",
        COARSE,
        "out/cup-search-friction",
    ],
    ["scatter cases/cup.toml -q --restart --runs 8 --vary friction=uniform\t0.05..0.12", COARSE, "out/cup-scatter"],
    ["fit cases/fit.toml -q", "--set blank.elements=20", "out/fit-fit"],
    ["compare cases/cup.toml -q --also friction=0.12", COARSE, "out/cup-compare"],
    ["verify cases/cup.toml -q --out bars --set tools.punch.travel=2mm", "--set blank.elements=20", "bars"],
    ["trace cases/cup.toml --step 3 --out step.csv", "--set blank.elements=20", "step.csv"],
    ["new cup -o new.toml --force", "--height 20mm", "new.toml"],
];

/// Kills of each verb: 88 in all.
const KILLS: u32 = 8;

fn arguments(args: &'static str) -> Vec<&'static str> {
    args.split(' ').collect()
}

fn written(dir: &Path, output: &str) -> Tree {
    let path = dir.join(output);
    if path.is_dir() { tree(&path) } else { Tree::from_iter(fs::read(&path).map(|bytes| (PathBuf::new(), bytes))) }
}

fn line([args, other, _]: [&'static str; 3], is_other: bool) -> Vec<&'static str> {
    [arguments(args), if is_other { arguments(other) } else { Vec::new() }].concat()
}

fn done(dir: &Path, verb: [&'static str; 3], is_other: bool) -> Tree {
    let done = stampflow(dir, &line(verb, is_other));
    assert_eq!(done.status.code(), Some(0), "{verb:?}: {}", text(&done.stderr));
    written(dir, verb[2])
}

fn cases() -> temp_dir::TempDir {
    let dir = folder(CUP);
    let write = |name: &str, content: String| fs::write(dir.path().join("cases").join(name), content).unwrap();
    write("staged.toml", format!("{CUP}{STAGES}"));
    write("curve.csv", "travel_mm,punch_force_kN\n1,5\n2,9\n3,13\n4.5,19\n".to_owned());
    let vary = "[vary]\nfriction = \"0.1 in 0.01..0.3\"\n";
    write("fit.toml", format!("case = \"cup.toml\"\nto = \"curve.csv\"\n{vary}"));
    dir
}

/// Trust: signals at even distances, half of them in the last quarter, where files are written; beside another file.
#[cfg(unix)]
#[test]
fn a_verb_that_is_ended_at_any_moment_leaves_one_whole_set() {
    VERBS.into_par_iter().for_each(|verb| {
        let (dir, [args, _, output]) = (cases(), verb);
        let root = dir.path();
        let mut sets = [done(root, verb, true), done(root, verb, false)];
        assert!(sets[0] != sets[1], "{args}");
        if root.join(output).is_dir() {
            fs::write(root.join(output).join("notes.txt"), "mine").unwrap();
            sets.iter_mut().for_each(|set| drop(set.insert("notes.txt".into(), b"mine".to_vec())));
        }
        let begin = Instant::now();
        done(root, verb, false);
        let whole = begin.elapsed();
        let mut last = written(root, output);
        for kill in 0..KILLS {
            let signal = if kill % 5 == 2 { ["-INT", "-TERM"][(kill / 5 % 2) as usize] } else { "-KILL" };
            let mut run = spawn(root, &line(verb, kill % 4 < 2));
            let (is_late, done) = (kill % 2 == 1, f64::from(kill) / f64::from(KILLS));
            let share = if is_late { 0.75 + 0.35 * done } else { 0.75 * done };
            sleep(whole.mul_f64(share));
            let _ = Command::new("kill").args([signal, &run.id().to_string()]).stderr(Stdio::null()).status();
            run.wait().unwrap();
            let found = visible(written(root, output));
            // An interrupted run ends with what it has.
            let is_known = |name: &PathBuf| sets.iter().any(|set| set.contains_key(name));
            let is_partial = signal != "-KILL" && found.keys().all(is_known);
            let is_whole = sets.contains(&found) || found == last;
            assert!(is_whole || is_partial, "{args} {signal} at {share:.2}: {:?}", found.keys());
            last = found;
        }
        assert_eq!(done(root, verb, false), sets[1], "{args}");
        assert!(visible(tree(root)) == tree(root), "{args}: litter");
    });
}

/// Trust: no file may be longer than half a kilobyte, which is what a full disk comes to.
#[cfg(unix)]
#[test]
fn a_full_disk_leaves_the_earlier_set_and_says_so() {
    for verb in VERBS {
        let (dir, [args, ..]) = (cases(), verb);
        done(dir.path(), verb, true);
        let before = tree(dir.path());
        let failed =
            shell(dir.path(), &format!("ulimit -f 1; stampflow {}", args.replace('<', "\\<").replace('\t', "\\\t")));
        let message = text(&failed.stderr);
        assert!(matches!(failed.status.code(), Some(1 | 2)), "{args}: {message}");
        assert!(message.contains("cannot write"), "{args}: {message}");
        assert!(args.starts_with("new") || !failed.stdout.is_empty(), "{args}: no answer");
        assert!(visible(tree(dir.path())) == before, "{args}: {:?}", tree(dir.path()).keys());
    }
}

/// Trust: both begin at once and take far longer than to begin.
#[cfg(unix)]
#[test]
fn of_two_runs_into_one_folder_one_is_refused_with_the_reason() {
    let mut refused = 0;
    for verb in [0, 0, 0, 0, 0, 3, 4, 5, 6, 7].map(|i: usize| VERBS[i]) {
        let (dir, args) = (cases(), arguments(verb[0]));
        let done = [spawn(dir.path(), &args), spawn(dir.path(), &args)].map(|run| run.wait_with_output().unwrap());
        for run in done.iter().filter(|run| run.status.code() != Some(0)) {
            ends(run, 2, "is writing there");
            refused += 1;
        }
        assert!(done.iter().any(|run| run.status.code() == Some(0)));
        assert_eq!(names(&dir.path().join("out")), [verb[2].trim_start_matches("out/")]);
    }
    assert!(refused > 0, "the runs never met");
}

#[test]
fn folders_of_older_stages_go_and_other_files_stay() {
    let dir = folder(&format!("{CUP}{STAGES}"));
    let out = dir.path().join("out/cup");
    stampflow(dir.path(), &["run", "cases/cup.toml", "-q"]);
    let mine = ["1-draw/photo.jpg", "notes.txt", "2-mine/summary.json"];
    for name in mine {
        fs::create_dir_all(out.join(name).parent().unwrap()).unwrap();
        fs::write(out.join(name), "mine").unwrap();
    }
    fs::write(dir.path().join("cases/cup.toml"), CUP).unwrap();
    assert_eq!(stampflow(dir.path(), &["run", "cases/cup.toml", "-q"]).status.code(), Some(0));
    assert!(mine.iter().all(|name| fs::read_to_string(out.join(name)).unwrap() == "mine"));
    assert_eq!(names(&out.join("1-draw")), ["photo.jpg"]);
    assert!(!out.join("2-retract").exists() && !out.join("stages.csv").exists() && out.join("summary.json").exists());
    assert_eq!(names(&dir.path().join("out")), ["cup"]);
}

#[test]
fn the_working_directory_may_be_the_folder() {
    let dir = folder(CUP);
    fs::write(dir.path().join("notes.txt"), "mine").unwrap();
    for _ in 0..2 {
        ends(&shell(dir.path(), "stampflow run cases/cup.toml -q --out . && ls summary.json"), 0, "");
    }
    assert_eq!(fs::read_to_string(dir.path().join("notes.txt")).unwrap(), "mine");
    assert!(dir.path().join("cases/cup.toml").is_file() && names(dir.path()).iter().all(|name| !name.starts_with('.')));
}

/// Starts a run that takes long, by the command `before` if it is not empty, lets something happen, and interrupts it.
#[cfg(unix)]
fn meanwhile(dir: &Path, before: &str, happens: impl Fn()) -> Output {
    let line = format!("exec {before} {} run cases/cup.toml -q", env!("CARGO_BIN_EXE_stampflow"));
    let mut shell = Command::new("sh");
    let shell = shell.args(["-c", &line]).current_dir(dir).stdout(Stdio::piped()).stderr(Stdio::piped());
    let run = shell.spawn().unwrap();
    let begin = Instant::now();
    while !dir.join("out/.cup.lock").exists() {
        assert!(begin.elapsed() < Duration::from_secs(60), "it never begins");
        sleep(Duration::from_millis(10));
    }
    sleep(Duration::from_millis(500));
    happens();
    assert!(Command::new("kill").args(["-INT", &run.id().to_string()]).status().unwrap().success());
    run.wait_with_output().unwrap()
}

#[cfg(unix)]
#[test]
fn a_folder_that_goes_away_or_is_blocked_during_a_run_loses_no_result() {
    let dir = folder(&format!("{}{COMPARE}", endless()));
    fs::write(dir.path().join("cases/curve.csv"), "travel_mm,punch_force_kN\n0.001,1\n0.002,2\n").unwrap();
    let done = meanwhile(dir.path(), "", || fs::remove_dir_all(dir.path().join("out")).unwrap());
    assert_eq!(done.status.code(), Some(130), "{}", text(&done.stderr));
    let out = dir.path().join("out/cup");
    assert!(out.join("load_travel.csv").is_file() && out.join("compare_1_punch_force.csv").is_file());
    assert_eq!(names(&dir.path().join("out")), ["cup"]);

    let done = meanwhile(dir.path(), "", || {
        fs::remove_dir_all(dir.path().join("out")).unwrap();
        fs::write(dir.path().join("out"), "in the way").unwrap();
    });
    ends(&done, 1, "cannot write out/cup/");
    assert!(text(&done.stdout).contains("Punch force"), "{}", text(&done.stdout));
}

/// Trust: signals that wait at once, and a shell that ignores one, as nohup does; the run alone takes far longer.
#[cfg(unix)]
#[test]
fn a_second_signal_ends_the_program_at_once_but_not_that_of_a_closed_terminal() {
    let until_ended = "kill -HUP ID ID; kill -CONT ID; until ps -o stat= -p ID | grep -q Z; do sleep 0.1; done";
    for (before, signals, is_kept) in [
        ("", "kill -INT ID; kill -TERM ID; kill -CONT ID", false),
        ("env --default-signal=HUP", until_ended, true),
        ("env --ignore-signal=HUP", "kill -HUP ID; kill -CONT ID", true),
    ] {
        let dir = folder(&endless());
        let done = meanwhile(dir.path(), before, || {
            let id = fs::read_to_string(dir.path().join("out/.cup.lock")).unwrap();
            assert!(shell(dir.path(), &format!("kill -STOP {id}; {}", signals.replace("ID", &id))).status.success());
        });
        assert_eq!(done.status.code(), Some(130), "{before}{signals}: {}", text(&done.stderr));
        let found = (!done.stdout.is_empty(), dir.path().join("out/cup").exists());
        assert_eq!(found, (is_kept, is_kept), "{before}{signals}");
    }
}

/// Trust: the rename is made to fail by a folder; 255 bytes are the longest name of usual file systems.
#[test]
fn a_single_file_is_whole_or_as_it_was() {
    let dir = temp_dir::TempDir::new().unwrap();
    let (path, taken, long) = (dir.path().join("deep/er/a.csv"), dir.path().join("taken"), "a".repeat(300));
    fs::create_dir_all(taken.join("inside")).unwrap();
    write(&path, b"old").unwrap();
    fs::write(path.with_file_name(".a.csv.part"), "half of a killed process").unwrap();
    write(&path, b"new").unwrap();
    assert_eq!((fs::read(&path).unwrap(), names(path.parent().unwrap())), (b"new".to_vec(), vec!["a.csv".to_owned()]));
    assert!(write(&taken, b"new").unwrap_err().to_string().contains("taken"));
    let before = tree(dir.path());
    for (path, can) in [
        ("a.csv".to_owned(), true),
        ("new/er/a.csv".to_owned(), true),
        ("deep/er/a.csv/b".to_owned(), false),
        (String::new(), false),
        (format!("new/{long}"), false),
        (format!("{long}/a.csv"), false),
    ] {
        assert_eq!(can_write(&dir.path().join(&path)).is_ok(), can, "{path}");
        assert_eq!((tree(dir.path()), names(dir.path()).len()), (before.clone(), 2), "{path} left something behind");
    }
}
