//! A study beyond one process: killed and resumed, in shards, through the lines that schedulers are given.

use crate::common::cli::{CUP, folder, stampflow, text};
use fastrand::Rng;
use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};
use temp_dir::TempDir;

/// A cup of few elements and short travel, in milliseconds.
fn cheap() -> String {
    CUP.replace("elements = 30", "elements = 14\n[solver]\nmax_step = 0.1").replace("5 mm\" }\ndie", "3 mm\" }\ndie")
}

fn sweep(dir: &Path, more: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_stampflow"));
    command.args(["sweep", "cases/cup.toml", "--quiet", "--threads", "2"]).args(more).current_dir(dir);
    command
}

fn began(command: &mut Command) -> Child {
    command.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

fn done(command: &mut Command) -> Output {
    let done = command.output().unwrap();
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    done
}

/// Trust: the bytes of a sweep that nothing ended; moments are spread over its whole time, so that most hit rows on their way.
#[test]
fn a_sweep_that_is_killed_at_twenty_moments_goes_on_to_the_same_table() {
    let dir = folder(CUP);
    let varied = ["--vary", "friction=0.04..0.12/40"];
    let start = Instant::now();
    done(sweep(dir.path(), &varied).args(["--out", "whole"]));
    let duration = start.elapsed();
    let whole = fs::read(dir.path().join("whole/study.csv")).unwrap();
    let (mut rng, mut hits) = (Rng::with_seed(18), 0);
    for i in 0..20 {
        let out = format!("killed-{i}");
        let mut running = began(sweep(dir.path(), &varied).args(["--out", &out]));
        sleep(duration.mul_f64((f64::from(i) + rng.f64()) / 20.0));
        running.kill().unwrap();
        running.wait().unwrap();
        let rows = fs::read_to_string(dir.path().join(&out).join(".study.csv.part")).map_or(0, |t| t.lines().count());
        hits += u32::from((2..=40).contains(&rows));
        done(sweep(dir.path(), &varied).args(["--out", &out, "--resume"]));
        assert_eq!(fs::read(dir.path().join(&out).join("study.csv")).unwrap(), whole, "killed with {rows} lines");
    }
    assert!(hits >= 5, "only {hits} kills of 20 hit a sweep with some of its rows");
}

/// Trust: what a kill in the middle of writing leaves is a beginning of the table, whatever its length.
#[test]
fn half_a_row_and_half_a_header_are_written_anew() {
    let dir = folder(&cheap());
    let varied = ["--vary", "friction=0.04..0.12/6"];
    done(sweep(dir.path(), &varied).args(["--out", "whole"]));
    let whole = fs::read(dir.path().join("whole/study.csv")).unwrap();
    let header = whole.iter().position(|byte| *byte == b'\n').unwrap() + 1;
    fs::create_dir(dir.path().join("cut")).unwrap();
    let mut rng = Rng::with_seed(18);
    let lengths = [0, 7, header - 1, header, whole.len() - 1, whole.len()].into_iter();
    for length in lengths.chain((0..6).map(|_| rng.usize(header..whole.len()))) {
        fs::write(dir.path().join("cut/.study.csv.part"), &whole[..length]).unwrap();
        done(sweep(dir.path(), &varied).args(["--out", "cut", "--resume"]));
        assert_eq!(fs::read(dir.path().join("cut/study.csv")).unwrap(), whole, "cut at {length}");
        fs::remove_file(dir.path().join("cut/study.csv")).unwrap();
    }
}

/// A scheduler begins a shard again while what it has lost is still at it. Trust: one of the two waits, and finds it done.
#[test]
fn a_shard_that_runs_twice_at_once_is_written_once() {
    let dir = folder(&cheap());
    let varied = ["--vary", "friction=0.04..0.12/30", "--resume"];
    let both = [0, 1].map(|_| began(sweep(dir.path(), &varied).args(["--out", "both"])));
    for mut one in both {
        assert_eq!(one.wait().unwrap().code(), Some(0));
    }
    done(sweep(dir.path(), &varied).args(["--out", "one"]));
    let [both, one] = ["both", "one"].map(|out| fs::read(dir.path().join(out).join("study.csv")).unwrap());
    assert_eq!(both, one);
}

/// The sweep that is run in parts.
const SWEEP: [&str; 6] = ["sweep", "study", "--vary", "friction=0.04..0.12/5", "--vary", "tools.holder.force=8,12 kN"];

/// The printed lines of a verb in six shards, run with the program and `stubs` on the path; then its table is that of one
/// process.
fn runs_as_printed([verb, table, varied @ ..]: [&str; 6], scheduler: &str, stubs: &[(&str, &str)]) {
    let dir = folder(&cheap());
    let study = |more: &[&str]| {
        let mut command = Command::new(env!("CARGO_BIN_EXE_stampflow"));
        command.args([verb, "cases/cup.toml", "--quiet"]).args(varied).args(more).current_dir(dir.path());
        done(&mut command)
    };
    let printed = study(&["--out", "in parts", "--shards", "6", "--print", scheduler]);
    let lines = dir.path().join("lines.sh");
    fs::write(&lines, &printed.stdout).unwrap();
    let bin = dir.path().join("bin");
    fs::create_dir(&bin).unwrap();
    for (name, script) in stubs {
        fs::write(bin.join(name), script).unwrap();
        fs::set_permissions(bin.join(name), fs::Permissions::from_mode(0o755)).unwrap();
    }
    let program = Path::new(env!("CARGO_BIN_EXE_stampflow")).parent().unwrap();
    let usual = std::env::var_os("PATH").unwrap();
    let path = [bin.as_path(), program].into_iter().map(Path::to_owned).chain(std::env::split_paths(&usual));
    let path = std::env::join_paths(path).unwrap();
    let bash = |flag: &str| {
        let mut bash = Command::new("bash");
        bash.args([flag, "lines.sh"]).current_dir(dir.path()).env("PATH", &path).output().unwrap()
    };
    let checked = bash("-n");
    assert!(checked.status.success(), "{}", text(&checked.stderr));
    let ran = bash("-e");
    assert!(ran.status.success(), "{}\n{}", text(&printed.stdout), text(&ran.stderr));
    study(&["--out", "one"]);
    let table = format!("{table}.csv");
    let [parts, one] = ["in parts", "one"].map(|out| fs::read(dir.path().join(out).join(&table)).unwrap());
    assert_eq!(parts, one);
}

/// Trust: xargs itself runs them.
#[test]
fn the_lines_for_xargs_run_as_they_are_printed() {
    runs_as_printed(SWEEP, "xargs", &[]);
    runs_as_printed(["scatter", "scatter", "--vary", "friction=uniform 0.05..0.12", "--runs", "32"], "xargs", &[]);
}

/// Trust: a stand-in that does with an array what the manual of sbatch says.
#[test]
fn the_lines_for_slurm_run_as_they_are_printed() {
    let sbatch = r#"#!/bin/sh
for arg in "$@"; do
    case $arg in --array=1-*) last=${arg#--array=1-} ;; esac
    wrapped=$arg
done
for SLURM_ARRAY_TASK_ID in $(seq 1 "$last"); do
    export SLURM_ARRAY_TASK_ID
    sh -c "$wrapped" || exit 1
done
"#;
    runs_as_printed(SWEEP, "slurm", &[("sbatch", sbatch)]);
}

/// Trust: the same of HyperQueue; `tests/schedulers/hyperqueue.sh` asks a real one.
#[test]
fn the_lines_for_hyperqueue_run_as_they_are_printed() {
    let hq = r#"#!/bin/sh
last=${3#1-}
while [ "$1" != -- ]; do shift; done
shift
for HQ_TASK_ID in $(seq 1 "$last"); do
    export HQ_TASK_ID
    "$@" || exit 1
done
"#;
    runs_as_printed(SWEEP, "hq", &[("hq", hq)]);
}

/// Trust: each is one thing wrong with a set of shards that is right without it.
#[test]
fn merge_refuses_what_is_not_each_shard_once_and_writes_nothing() {
    let dir = folder(&cheap());
    let shard = |varied: &str, number: &str, out: &str| {
        done(sweep(dir.path(), &["--vary", varied, "--shard", number]).args(["--out", out]));
    };
    for number in ["1/3", "2/3", "3/3"] {
        shard("friction=0.04..0.12/7", number, "a");
    }
    shard("friction=0.04..0.13/7", "3/3", "of-another");
    shard("tools.punch.friction=0.04..0.12/7", "3/3", "of-other-columns");
    shard("friction=0.04..0.12/7", "2/2", "of-two");
    let merge = |shards: &[&str]| {
        let mut args = vec!["merge"];
        args.extend(shards);
        stampflow(dir.path(), &[&args[..], &["--out", "all.csv"]].concat())
    };
    let [one, two, three] = ["a/study-1-of-3.csv", "a/study-2-of-3.csv", "a/study-3-of-3.csv"];
    let cut = fs::read_to_string(dir.path().join(three)).unwrap();
    let cut: String = cut.split_inclusive('\n').take(2).collect();
    fs::write(dir.path().join("cut.csv"), cut).unwrap();
    fs::write(dir.path().join("notes.csv"), "a,b\n1,2\n").unwrap();
    for (shards, said) in [
        (&[one, two][..], "design 2 of 7 is in no shard"),
        (&[one, two, three, two], "design 1 is both in a/study-2-of-3.csv and in a/study-2-of-3.csv"),
        (&[one, two, three, "of-two/study-2-of-2.csv"], "is both in"),
        (&[one, two, "of-another/study-3-of-3.csv"], "is of another study than a/study-1-of-3.csv"),
        (&[one, two, "of-other-columns/study-3-of-3.csv"], "has other columns than"),
        (&[one, two, "cut.csv"], "design 5 of 7 is in no shard"),
        (&[one, two, "notes.csv"], "notes.csv is no table of a study"),
        (&[one, two, "none.csv"], "none.csv is no table of a study, or cannot be read"),
    ] {
        let done = merge(shards);
        assert_eq!(done.status.code(), Some(2), "{shards:?}");
        assert!(text(&done.stderr).contains(said), "{shards:?}: {}", text(&done.stderr));
        assert!(!dir.path().join("all.csv").exists() && !dir.path().join(".all.csv.merge").exists(), "{shards:?}");
    }
    let done = merge(&[three, one, two]);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
}

/// Largest memory that a shard of so many designs held [kB].
#[cfg(target_os = "linux")]
fn peak_memory(dir: &TempDir, designs: usize) -> u64 {
    let varied = format!("friction=0.04..0.12/{}", 2 * designs);
    let out = format!("out-{designs}");
    let mut running = began(&mut sweep(dir.path(), &["--vary", &varied, "--shard", "1/2", "--out", &out]));
    let mut peak = 0;
    while running.try_wait().unwrap().is_none() {
        let status = fs::read_to_string(format!("/proc/{}/status", running.id())).unwrap_or_default();
        let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        peak = line.and_then(|line| line.trim().trim_end_matches(" kB").parse().ok()).unwrap_or(peak);
        sleep(Duration::from_millis(5));
    }
    assert!(running.wait().unwrap().success());
    peak
}

/// Trust: 2000 results that were kept would hold 10 MB, as one has 25 numbers of 100 bytes and two curves of 50 points; what
/// threads happen to hold at a time differs by less than 2 MB.
#[cfg(target_os = "linux")]
#[test]
fn memory_of_a_shard_does_not_grow_with_the_number_of_designs() {
    let dir = folder(&cheap());
    let [few, many] = [200, 2200].map(|designs| peak_memory(&dir, designs));
    assert!(few > 3000 && many < few + 2000, "{few} kB for 200 designs, {many} kB for 2200");
}

/// Trust: each of these differs in one thing from the study that left the rows, and has as many and the same columns.
#[test]
fn rows_of_another_study_are_never_taken() {
    let dir = folder(&cheap());
    let first = ["--vary", "friction=0.04..0.12/3", "--out", "rows"];
    done(&mut sweep(dir.path(), &first));
    let table = dir.path().join("rows/study.csv");
    let whole = fs::read_to_string(&table).unwrap();
    let refused = |more: &[&str]| {
        let done = sweep(dir.path(), more).args(["--out", "rows", "--resume"]).output().unwrap();
        assert_eq!(done.status.code(), Some(2), "{more:?}: {}", text(&done.stdout));
        for part in ["rows of another study", "--restart", "--out"] {
            assert!(text(&done.stderr).contains(part), "{more:?}: {}", text(&done.stderr));
        }
    };
    let others = [
        &["--vary", "friction=0.3..0.9/3"][..],
        &["--vary", "friction=0.04..0.12/3", "--set", "blank.thickness=\"0.9 mm\""],
        &["--vary", "friction=0.04..0.12/2"],
    ];
    others.iter().for_each(|other| refused(other));
    fs::rename(&table, dir.path().join("rows/.study.csv.part")).unwrap();
    others.iter().for_each(|other| refused(other));
    done(sweep(dir.path(), &first).arg("--resume"));
    assert_eq!(fs::read_to_string(&table).unwrap(), whole);
    fs::write(dir.path().join("cases/cup.toml"), cheap() + "\n# another text\n").unwrap();
    refused(&first[..2]);
}
