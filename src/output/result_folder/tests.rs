//! A run that fails at every change of the disk in turn, and what the next one makes of that.

use super::site::entries;
use super::*;
use crate::output::disk::{Fault, calls_left, fail_after};
use crate::output::stages;
use std::collections::BTreeMap;

/// By which a run finds out whether a folder can be written to.
const PROBE: &str = ".probe.part";

/// Files of a run by their paths, and what stands in them.
type Tree = BTreeMap<PathBuf, String>;

const OLD: [&str; 4] = ["r-plot", "stages.csv", "1-draw/r-table", "2-back/r-table"];
const NEW: [&str; 4] = ["r-plot", "r-more", "stages.csv", "1-draw/r-table"];
const NEXT: [&str; 2] = ["r-plot", "r-table"];

fn is_ours(path: &Path) -> bool {
    let name = path.file_name().unwrap().to_str().unwrap();
    name.starts_with("r-") || name == stages::FILE
}

fn text(run: &str, name: &str) -> String {
    match name {
        "stages.csv" if run == "old" => "stage,name,stop\n1,draw,full\n2,back,full\n".to_owned(),
        "stages.csv" => "stage,name,stop\n1,draw,full\n".to_owned(),
        _ => format!("{name} of the {run} run"),
    }
}

fn tree(run: &str, names: &[&str]) -> Tree {
    names.iter().map(|name| (name.into(), text(run, name))).collect()
}

fn run(dir: &Path, run: &str, names: &[&str]) -> Result<Vec<PathBuf>, WriteError> {
    let mut folder = ResultFolder::open(dir, is_ours)?;
    names.iter().for_each(|name| folder.write(name, text(run, name).as_bytes()));
    folder.publish()
}

/// All files below a folder; an empty folder as a file without a name in it.
fn found(dir: &Path) -> Tree {
    let mut found = Tree::new();
    for (name, kind) in entries(dir).unwrap() {
        match kind.is_dir() {
            false => _ = found.insert(name.clone(), fs::read_to_string(dir.join(&name)).unwrap()),
            true => {
                let below = self::found(&dir.join(&name));
                if below.is_empty() {
                    found.insert(name.join(""), String::new());
                }
                found.extend(below.into_iter().map(|(path, text)| (name.join(path), text)));
            }
        }
    }
    found
}

/// Of a user's own: in the folder, in one of a stage and, where asked for, in a folder that cannot be linked.
fn mine(folder_too: bool) -> Tree {
    let names = ["notes.txt", "2-back/photo.jpg", "measured/forces.csv"];
    names[..if folder_too { 3 } else { 2 }].iter().map(|name| (name.into(), format!("my {name}"))).collect()
}

fn with_files(dir: &Path, files: &Tree) {
    for (name, text) in files {
        fs::create_dir_all(dir.join(name).parent().unwrap()).unwrap();
        fs::write(dir.join(name), text).unwrap();
    }
}

fn both(a: &Tree, b: &Tree) -> Tree {
    a.iter().chain(b).map(|(path, text)| (path.clone(), text.clone())).collect()
}

/// Lets a run fail at every change of the disk in turn, and hands what is then there to `check`; then what is there
/// after the next run must be whole, with the user's files and nothing else.
fn at_every_call(fault: Fault, old: &Tree, mine: &Tree, check: impl Fn(&Tree, &str)) {
    for calls in 0.. {
        let root = temp_dir::TempDir::new().unwrap();
        let dir = root.path().join("out/cup");
        with_files(&dir, &both(old, mine));
        fail_after(calls, fault);
        let done = run(&dir, "new", &NEW);
        let is_through = calls_left() > 0;
        fail_after(usize::MAX, fault);
        let label = format!("{fault:?} after {calls} calls: {done:?}");
        if is_through {
            assert!(done.is_ok() && calls > 2 * NEW.len(), "{label}");
            assert_eq!(found(&dir), both(&tree("new", &NEW), mine), "{label}");
            assert_eq!(found(root.path()).len(), found(&dir).len(), "{label}: litter");
            return;
        }
        let mut left = found(&dir);
        left.remove(Path::new(PROBE));
        check(&left, &label);
        assert_eq!(run(&dir, "next", &NEXT).unwrap().len(), NEXT.len());
        assert_eq!(found(&dir), both(&tree("next", &NEXT), mine), "{label}");
        assert_eq!(found(root.path()).len(), found(&dir).len(), "{label}: litter {:?}", found(root.path()));
    }
}

#[test]
fn a_run_that_fails_anywhere_leaves_one_whole_result_and_what_is_not_its_own() {
    let (old, new) = (tree("old", &OLD), tree("new", &NEW));
    for fault in [Fault::Everything, Fault::Full] {
        at_every_call(fault, &old, &mine(false), |found, label| {
            assert!(*found == both(&old, &mine(false)) || *found == both(&new, &mine(false)), "{label}: {found:#?}");
        });
        at_every_call(fault, &Tree::new(), &Tree::new(), |found, label| {
            assert!(found.is_empty() || *found == new, "{label}: {found:#?}");
        });
    }
}

/// A folder of a user's own cannot be linked: files are replaced one by one, and never one of the user's.
#[test]
fn where_folders_are_not_exchanged_the_next_run_ends_what_was_begun() {
    let (old, new, mine) = (tree("old", &OLD), tree("new", &NEW), mine(true));
    at_every_call(Fault::Everything, &old, &mine, |found, label| {
        assert!(mine.iter().all(|(name, text)| found.get(name) == Some(text)), "{label}: {found:#?}");
    });
    at_every_call(Fault::Full, &old, &mine, |found, label| {
        assert!(*found == both(&old, &mine) || *found == both(&new, &mine), "{label}: {found:#?}");
    });
}

/// The half-done work of a killed run is ended before anything new is begun.
#[test]
fn complete_results_that_were_not_put_in_place_are_by_the_next_run() {
    let root = temp_dir::TempDir::new().unwrap();
    let dir = root.path().join("cup");
    with_files(&dir, &both(&tree("old", &OLD), &mine(true)));
    let ready = root.path().join(".cup.ready");
    with_files(&ready, &tree("new", &NEW));
    drop(ResultFolder::open(&dir, is_ours).unwrap());
    assert_eq!(found(&dir), both(&tree("new", &NEW), &mine(true)));
    assert!(!ready.exists());
}

/// A run was killed right after the exchange; meanwhile the user has saved one file anew and written another.
#[test]
fn what_a_user_changed_after_a_killed_run_is_kept() {
    let root = temp_dir::TempDir::new().unwrap();
    let (dir, swap) = (root.path().join("cup"), root.path().join(".cup.swap"));
    with_files(&swap, &both(&tree("old", &OLD), &mine(false)));
    with_files(&dir, &tree("new", &NEW));
    fs::write(dir.join("notes.txt"), "my newer notes").unwrap();
    drop(ResultFolder::open(&dir, is_ours).unwrap());
    let mut expected = both(&tree("new", &NEW), &mine(false));
    expected.insert("notes.txt.1".into(), expected["notes.txt".as_ref() as &Path].clone());
    expected.insert("notes.txt".into(), "my newer notes".to_owned());
    assert_eq!(found(&dir), expected);
    assert!(!swap.exists());
}

#[test]
fn a_folder_that_another_run_has_is_refused_and_a_dead_one_s_is_taken() {
    let root = temp_dir::TempDir::new().unwrap();
    let dir = root.path().join("out/cup");
    let first = ResultFolder::open(&dir, is_ours).unwrap();
    let error = ResultFolder::open(&dir, is_ours).unwrap_err();
    let process = format!("another run, process {},", std::process::id());
    assert!(error.source.to_string().contains(&process), "{}", error.source);
    drop(first);
    assert!(found(root.path()).is_empty(), "nothing is left of a run that wrote nothing");
    // What a killed process leaves: nobody has it.
    fs::create_dir_all(root.path().join("out/.cup.part")).unwrap();
    fs::write(root.path().join("out/.cup.part/r-half"), "ha").unwrap();
    fs::write(root.path().join("out/.cup.lock"), "1").unwrap();
    run(&dir, "new", &NEW).unwrap();
    assert_eq!(found(&root.path().join("out")).len(), NEW.len());
}

/// All of it goes while the run computes: it is made anew. What goes while the files are written is told.
#[test]
fn a_folder_that_is_taken_away_is_made_again_or_missed() {
    let root = temp_dir::TempDir::new().unwrap();
    let out = root.path().join("out");
    let mut folder = ResultFolder::open(&out.join("cup"), is_ours).unwrap();
    fs::remove_dir_all(&out).unwrap();
    folder.write("r-a", b"a");
    folder.write("r-b", b"b");
    assert_eq!(folder.publish().unwrap().len(), 2);
    assert_eq!(found(root.path()).len(), 2);

    let mut folder = ResultFolder::open(&out.join("cup"), is_ours).unwrap();
    folder.write("r-a", b"newer a");
    fs::remove_file(out.join(".cup.part/r-a")).unwrap();
    folder.write("r-b", b"newer b");
    let error = folder.publish().unwrap_err();
    assert!(error.source.to_string().contains("r-a was taken away"), "{}", error.source);
    assert_eq!(fs::read_to_string(out.join("cup/r-a")).unwrap(), "a");
}

/// The first thing that failed is told, and where the rest stands.
#[test]
fn a_full_disk_names_the_file_and_where_the_others_are() {
    let root = temp_dir::TempDir::new().unwrap();
    let mut folder = ResultFolder::open(&root.path().join("cup"), is_ours).unwrap();
    folder.write("r-a", b"a");
    fail_after(0, Fault::Full);
    folder.write("r-b", b"b");
    fail_after(usize::MAX, Fault::Full);
    let error = folder.publish().unwrap_err();
    assert!(error.path.ends_with("cup/r-b"), "{error}");
    let told = error.source.to_string();
    assert!(told.contains("what could be written is until the next run in") && told.contains(".cup.part"), "{told}");
    assert_eq!(found(root.path()).len(), 1);
}

#[cfg(unix)]
#[test]
fn a_link_is_followed_and_stays_one() {
    let root = temp_dir::TempDir::new().unwrap();
    let (there, link) = (root.path().join("there"), root.path().join("link"));
    fs::create_dir(&there).unwrap();
    std::os::unix::fs::symlink(&there, &link).unwrap();
    run(&link, "new", &NEW).unwrap();
    run(&link, "next", &NEXT).unwrap();
    assert_eq!(found(&there), tree("next", &NEXT));
    assert!(link.is_symlink() && entries(root.path()).unwrap().len() == 2);
}
