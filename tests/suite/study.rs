//! The study engine: designs in order, rows whole and the same on any machine, resumed and merged tables.

use crate::common::prelude::*;
use stampflow::study::{EarlierRuns, Evaluated, FailureMode, Sweep, evaluate};
use std::{ops::ControlFlow, sync::atomic::AtomicUsize, sync::atomic::Ordering};

/// The quickstart on a coarse mesh in long steps, with overrides.
pub fn base(set: &[&str]) -> BaseCase {
    let set = owned(&[&["blank.elements=30", "solver.max_step=0.05"], set].concat());
    BaseCase::load("cases/quickstart.toml", set).unwrap_or_else(|error| panic!("{error}"))
}

pub fn sweep(vary: &[&str], one_at_a_time: bool) -> Result<Sweep, StudyError> {
    Sweep::new(base(&[]), &owned(vary), one_at_a_time)
}

pub fn run(study: &mut dyn Study, threads: usize, watch: &dyn Watch) -> RunTable {
    let settings = Evaluation { threads, shard: Shard::WHOLE, watch };
    let runs = begin(study, &settings).unwrap_or_else(|error| panic!("{error}"));
    evaluate(study, &settings, runs, &EarlierRuns::new(), &mut |_, _: &Evaluated| ControlFlow::Continue(()))
}

/// Trust: two grids by hand, the last key fastest.
#[test]
fn designs_are_counted_with_the_last_key_fastest() {
    let mut sweep = sweep(&["friction=0.05,0.1", "tools.die.shoulder=5,6 mm"], false).expect("a sweep");
    let runs = begin(&mut sweep, &Evaluation { threads: 1, shard: Shard::WHOLE, watch: &() }).expect("a run");
    let values: Vec<Vec<String>> = (0..sweep.known(&runs)).map(|index| sweep.design(index).values).collect();
    assert_eq!(values, [["0.05", "5"], ["0.05", "6"], ["0.1", "5"], ["0.1", "6"]]);
}

/// Trust: the same on any number of threads; friction raises the force.
#[test]
fn rows_come_in_order_and_are_the_same_on_any_number_of_threads() {
    let tables = [1, 3].map(|count| run(&mut sweep(&["friction=0.04..0.2/3"], false).expect("a sweep"), count, &()));
    assert_eq!(tables[0].csv(), tables[1].csv());
    let force = tables[0].response("punch_force").expect("a force");
    let runs = &tables[0].runs;
    assert!(runs.windows(2).all(|pair| pair[0].numbers[force] < pair[1].numbers[force]));
}

/// Trust: a die whose throat is narrower than its punch cannot be built, the other can.
#[test]
fn a_design_that_cannot_be_built_is_a_row_with_its_reason() {
    let table = run(&mut sweep(&["tools.die.throat=20,31.25 mm"], false).expect("a sweep"), 2, &());
    assert!(table.runs[0].failures == [FailureMode::NoResult] && table.runs[0].reason.contains("throat"));
    assert!(table.runs[1].is_known());
}

/// Trust: one key at a time changes one key at a time; the larger friction moves the force more.
#[test]
fn one_at_a_time_gives_the_sensitivity_of_each_key() {
    let mut sweep = sweep(&["friction=0.07,0.09", "tools.punch.friction=0.04,0.2", "tools.die.shoulder=6 mm"], true)
        .expect("a sweep");
    let table = run(&mut sweep, 2, &());
    assert_eq!(table.runs.len(), 6);
    assert_eq!(table.runs[0].numbers, table.base.numbers);
    let all = sweep.sensitivities(&table, table.response("punch_force").expect("a force"));
    assert!(all.windows(2).all(|pair| pair[0].width() >= pair[1].width()) && all.iter().all(|s| s.axis < 2), "{all:?}");
}

pub struct After(pub AtomicUsize, pub usize);

impl Watch for After {
    fn wants_to_stop(&self) -> bool {
        self.0.load(Ordering::Relaxed) >= self.1
    }

    fn ran(&self, done: usize, _: usize) {
        self.0.store(done, Ordering::Relaxed);
    }
}

/// Trust: rows that were cut short are not handed on, and those of an earlier run are not run again.
#[test]
fn a_stopped_study_keeps_its_rows() {
    let mut sweep = sweep(&["friction=0.04..0.2/4"], false).expect("a sweep");
    let whole = run(&mut sweep, 1, &());
    let part = run(&mut sweep, 1, &After(AtomicUsize::new(0), 2));
    assert_eq!(part.runs, whole.runs[..2]);
    let earlier: EarlierRuns = part.runs.iter().map(|run| (run.index, run.clone())).collect();
    let settings = Evaluation { threads: 2, shard: Shard::WHOLE, watch: &() };
    let begun = begin(&mut sweep, &settings).expect("a run");
    let mut new = Vec::new();
    let resumed = evaluate(&mut sweep, &settings, begun, &earlier, &mut |_, evaluated| {
        new.push(evaluated.run.index);
        ControlFlow::Continue(())
    });
    assert_eq!((resumed.csv(), new), (whole.csv(), vec![2, 3]));
}

/// Trust: beginnings of cells that spreadsheets run, as OWASP lists them; what is written with a mark is read without it.
#[test]
fn no_cell_of_a_table_is_a_formula_and_every_row_is_read_as_it_was() {
    let table = run(&mut sweep(&["title==1+1,@a,-2+3,'b,plain,-5 mm"], false).expect("a sweep"), 2, &());
    let rows: Vec<_> = csv::Reader::from_reader(&table.csv()[..]).into_records().map(Result::unwrap).collect();
    let cells: Vec<&str> = rows.iter().map(|row| &row[4]).collect();
    assert_eq!(cells, ["'=1+1", "'@a", "'-2+3", "''b", "plain", "-5 mm"]);
    let values = rows.iter().map(|row| table.read(row).expect("a row").values);
    assert!(values.eq(table.runs.iter().map(|run| run.values.clone())));
}

const VARY: [&str; 5] = ["--vary", "title==1+1,@a", "--vary", "friction=0.05..0.15/3", "--quiet"];

fn swept(dir: &Path, more: &[&str]) -> Output {
    stampflow(dir, &[&["sweep", "cases/cup.toml"], &VARY[..], more].concat())
}

/// Trust: the rows of a whole run, cut in the middle of a row, are completed to the same bytes.
#[test]
fn a_killed_study_is_resumed_to_the_same_bytes() {
    let dir = folder(CUP);
    ends(&swept(dir.path(), &["--out", "a"]), 0, "");
    let whole = fs::read(dir.path().join("a/study.csv")).unwrap();
    assert!(dir.path().join("a/sweep.png").is_file());
    ends(&swept(dir.path(), &["--out", "a"]), 2, "--restart");
    ends(&swept(dir.path(), &["--out", "a", "--resume", "--format", "svg"]), 0, "");
    assert!(!dir.path().join("a/sweep.png").exists() && dir.path().join("a/sweep.svg").is_file());
    fs::create_dir(dir.path().join("b")).unwrap();
    let rows: Vec<usize> = whole.iter().enumerate().filter(|(_, byte)| **byte == b'\n').map(|(i, _)| i + 1).collect();
    for end in [rows[2] + 30, rows[0], 20] {
        fs::write(dir.path().join("b/.study.csv.rows"), &whole[..end]).unwrap();
        ends(&swept(dir.path(), &["--out", "b"]), 2, "--resume");
        ends(&swept(dir.path(), &["--out", "b", "--resume"]), 0, "");
        let [table, rows] = ["b/study.csv", "b/.study.csv.rows"].map(|path| fs::read(dir.path().join(path)).ok());
        assert!(table.is_some_and(|table| table == whole) && rows.is_none());
        fs::remove_file(dir.path().join("b/study.csv")).unwrap();
    }
    // Rows of another study are refused, and so is a file that is no table.
    fs::write(dir.path().join("b/.study.csv.rows"), &whole[..rows[2]]).unwrap();
    let other = ["sweep", "cases/cup.toml", "--vary", "friction=0.1,0.2", "--out", "b", "--resume"];
    ends(&stampflow(dir.path(), &other), 2, "another study");
    fs::write(dir.path().join("b/study.csv"), "mine\n").unwrap();
    ends(&swept(dir.path(), &["--out", "b", "--restart"]), 2, "no table of a study");
}

/// Trust: a signal while the base case is solved, which takes longer than to send it; the table of a study that nobody ended.
#[cfg(unix)]
#[test]
fn a_study_that_is_ended_before_its_first_run_is_resumed() {
    let dir = folder(&CUP.replace("elements = 30", "elements = 150"));
    for (shard, signal) in [("1/1", "-TERM"), ("2/2", "-HUP")] {
        let line =
            |out| format!("sweep cases/cup.toml -q --vary friction=0.05,0.1 --shard {shard} --resume --out {out}");
        let swept = |out| stampflow(dir.path(), &line(out).split(' ').collect::<Vec<_>>());
        ends(&swept("whole"), 0, "");
        let mut command = Command::new("env");
        command.args(["--default-signal=HUP", env!("CARGO_BIN_EXE_stampflow")]).args(line("cut").split(' '));
        let run = command.current_dir(dir.path()).stderr(Stdio::null()).spawn();
        let is_lock = |name: &std::ffi::OsStr| name.to_string_lossy().ends_with(".lock");
        let files = |out: &str| fs::read_dir(dir.path().join(out)).into_iter().flatten().map(|entry| entry.unwrap());
        let mut run = run.unwrap();
        while !files("cut").any(|file| is_lock(&file.file_name())) {
            sleep(Duration::from_millis(2));
        }
        assert!(Command::new("kill").args([signal, &run.id().to_string()]).status().unwrap().success());
        assert_eq!(run.wait().unwrap().code(), Some(130));
        ends(&swept("cut"), 0, "");
        let [cut, whole] = ["cut", "whole"].map(|out| {
            files(out).map(|file| (file.file_name(), fs::read(file.path()).unwrap())).collect::<BTreeMap<_, _>>()
        });
        assert!(cut == whole, "{shard}");
    }
}

/// Trust: by hand, 999 999 999 = 1000³ − 1 has the last value of every key; 1 000 000 rows of a kilobyte are a gigabyte.
#[test]
fn designs_beyond_memory_are_refused_and_their_shards_begin() {
    let vary = ["friction=0.05..0.1/1000", "tools.holder.force=5..9 kN/1000", "tools.die.shoulder=5..6 mm/1000"];
    let mut sweep = sweep(&vary, false).expect("a sweep");
    assert_eq!(sweep.design(999_999_999).values, ["0.1", "9", "6"]);
    let begun = |sweep: &mut Sweep, shard: &str| {
        let settings = Evaluation { threads: 1, shard: shard.parse().expect("a shard"), watch: &() };
        begin(sweep, &settings).map(|_| ()).map_err(|error| error.to_string())
    };
    let refused = begun(&mut sweep, "3/999").expect_err("too many");
    assert!(refused.contains("1001001 runs") && refused.contains("1000 shards"), "{refused}");
    assert_eq!(begun(&mut sweep, "7/1000"), Ok(()));
}

/// Trust: the table of all shards is that of the whole study, byte for byte; what is missing, twice, cut or foreign is refused.
#[test]
fn shards_are_merged_to_the_table_of_the_whole_study() {
    let dir = folder(CUP);
    ends(&swept(dir.path(), &["--out", "whole"]), 0, "");
    ["1/3", "2/3", "3/3"].iter().for_each(|shard| ends(&swept(dir.path(), &["--out", "s", "--shard", shard]), 0, ""));
    let shards = ["s/study-1-of-3.csv", "s/study-2-of-3.csv", "s/study-3-of-3.csv"];
    let merge = |shards: &[&str]| stampflow(dir.path(), &[&["merge"], shards, &["--out", "m/study.csv"]].concat());
    ends(&merge(&shards), 0, "");
    let read = |path: &str| fs::read(dir.path().join(path)).unwrap();
    assert_eq!(read("m/study.csv"), read("whole/study.csv"));
    let second = String::from_utf8(read(shards[1])).unwrap();
    fs::write(dir.path().join("cut.csv"), &second[..second.len() - 20]).unwrap();
    for (name, end) in [("field.csv", second.rfind(',').unwrap()), ("version.csv", second.len() - 2)] {
        fs::write(dir.path().join(name), second[..end].to_owned() + "\n").unwrap();
    }
    fs::write(dir.path().join("short.csv"), second.lines().take(2).map(|line| format!("{line}\n")).collect::<String>())
        .unwrap();
    let key = second.lines().nth(1).unwrap().split(',').next().unwrap();
    fs::write(dir.path().join("foreign.csv"), second.replace(key, "0123456789abcdef")).unwrap();
    fs::write(dir.path().join("columns.csv"), second.replace("title", "tilte")).unwrap();
    fs::write(dir.path().join("no.csv"), "a,b\n1,2\n").unwrap();
    for (others, says) in [
        (vec![shards[0], shards[2]], "is in no shard"),
        (vec![shards[0], shards[1], shards[2], shards[1]], "is both in"),
        (vec![shards[0], "cut.csv", shards[2]], "cut.csv, line 3, is no row of a study"),
        (vec![shards[0], "field.csv", shards[2]], "field.csv, line 3, is no row of a study"),
        (vec![shards[0], "version.csv", shards[2]], "version.csv, line 3, is of another study"),
        (vec!["/dev/zero"], "not a file"),
        (vec![shards[0], "short.csv", shards[2]], "is in no shard"),
        (vec![shards[0], "foreign.csv", shards[2]], "another study"),
        (vec![shards[0], "columns.csv", shards[2]], "other columns"),
        (vec![shards[0], "no.csv"], "no table of a study"),
        (shards.to_vec(), "m/study.csv is there, of a complete study; replace it with --restart"),
    ] {
        ends(&merge(&[&others[..], &["--restart"][usize::from(says.contains("--restart"))..]].concat()), 2, says);
    }
    assert_eq!(read("m/study.csv"), read("whole/study.csv"));
}

/// Trust: a study file says what the command line says; `--keep curves` and JSON are as asked for.
#[test]
fn a_study_file_is_the_command_line() {
    let dir = folder(CUP);
    let study = "case = \"cases/cup.toml\"\nset = [\"blank.elements=24\"]\n[vary]\ntools.die.shoulder = \"5..7 mm/2\"\nfriction = [0.04, 0.08]\n";
    fs::write(dir.path().join("study.toml"), study).unwrap();
    let done = stampflow(dir.path(), &["sweep", "study.toml", "--json", "--out", "a", "--keep", "curves"]);
    ends(&done, 0, "");
    let value: Value = serde_json::from_slice(&done.stdout).unwrap();
    assert_eq!(value["designs"], 4);
    assert!(dir.path().join("a/curves/load-3.csv").is_file() && dir.path().join("a/sweep.png").is_file());
    let all = ["--vary", "tools.die.shoulder=5..7 mm/2", "--vary", "friction=0.04, 0.08", "--set", "blank.elements=24"];
    ends(&stampflow(dir.path(), &[&["sweep", "cases/cup.toml", "--quiet", "--out", "b"], &all[..]].concat()), 0, "");
    let table = |folder: &str| fs::read(dir.path().join(folder).join("study.csv")).unwrap();
    assert_eq!(table("a"), table("b"));
    for (study, says) in
        [("case = \"cases/cup.toml\"\nvari = 1\n", "vari"), ("case = \"no.toml\"\n", "no file"), ("case = 1\n", "case")]
    {
        fs::write(dir.path().join("wrong.toml"), study).unwrap();
        ends(&stampflow(dir.path(), &["sweep", "wrong.toml"]), 2, says);
    }
}

/// Trust: the quickstart on a press of 120 kN wrinkles at a low holder force, and its window has both a sound and a failed part.
#[test]
fn a_window_of_two_keys_shows_where_designs_fail() {
    let mut sweep = sweep(&["tools.holder.force=1..40 kN/4", "friction=0.04..0.2/3"], false).expect("a sweep");
    let table = run(&mut sweep, 2, &());
    assert!(table.runs.iter().any(|run| run.failures.contains(&FailureMode::Wrinkles)));
    assert!(table.runs.iter().any(|run| run.failures.is_empty()));
}
