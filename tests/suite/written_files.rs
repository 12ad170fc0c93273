//! Files appear complete or not at all.

use stampflow::results::{can_write, write};
use std::fs;
use std::path::Path;

fn names(dir: &Path) -> Vec<String> {
    let mut names: Vec<_> = fs::read_dir(dir).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn a_file_is_replaced_and_its_neighbours_are_left_alone() {
    let dir = temp_dir::TempDir::new().unwrap();
    let path = dir.path().join("deep/er/a.csv");
    write(&path, b"old").unwrap();
    fs::write(path.with_file_name("mine.txt"), "mine").unwrap();
    write(&path, b"new").unwrap();
    assert_eq!(fs::read(&path).unwrap(), b"new");
    assert_eq!(names(path.parent().unwrap()), ["a.csv", "mine.txt"]);
}

/// Trust: the rename is made to fail (a folder stands where the file should go) after the bytes were written.
#[test]
fn a_failure_leaves_neither_half_a_file_nor_a_changed_one() {
    let dir = temp_dir::TempDir::new().unwrap();
    let taken = dir.path().join("a.csv");
    fs::create_dir(&taken).unwrap();
    fs::write(taken.join("inside"), "old").unwrap();
    let error = write(&taken, b"new").unwrap_err();
    assert!(error.to_string().contains("a.csv"), "{error}");
    assert_eq!(fs::read(taken.join("inside")).unwrap(), b"old");
    assert_eq!(names(dir.path()), ["a.csv"]);
}

/// A process was killed while it wrote, or while it tried whether it could.
#[test]
fn what_a_killed_process_left_is_used_up() {
    let dir = temp_dir::TempDir::new().unwrap();
    let path = dir.path().join("a.csv");
    for step in [write as fn(&Path, &[u8]) -> _, |path, _| can_write(path)] {
        fs::write(dir.path().join(".a.csv.part"), "much that was never ended").unwrap();
        step(&path, b"whole").unwrap();
        assert_eq!((names(dir.path()), fs::read(&path).unwrap()), (vec!["a.csv".to_owned()], b"whole".to_vec()));
    }
}

/// 255 bytes are the longest name of usual file systems.
#[test]
fn a_name_that_is_too_long_is_known_before_and_no_folder_is_left() {
    let dir = temp_dir::TempDir::new().unwrap();
    let long = "a".repeat(300);
    for path in [long.clone(), format!("{long}/a.csv"), format!("new/{long}/a.csv"), format!("new/{long}")] {
        can_write(&dir.path().join(&path)).unwrap_err();
        assert_eq!(names(dir.path()), [""; 0], "{path}");
    }
}

#[test]
fn what_cannot_be_written_is_known_before() {
    let dir = temp_dir::TempDir::new().unwrap();
    fs::write(dir.path().join("file"), "mine").unwrap();
    for (path, can) in [("a.csv", true), ("deep/er/a.csv", true), ("file", true), ("file/a.csv", false), ("", false)] {
        assert_eq!(can_write(&dir.path().join(path)).is_ok(), can, "{path}");
        assert_eq!(names(dir.path()), ["file"], "{path} left something behind");
    }
}

#[test]
fn a_temporary_file_that_cannot_be_made_leaves_the_old_file_intact() {
    let dir = temp_dir::TempDir::new().unwrap();
    let path = dir.path().join("a.csv");
    write(&path, b"old").unwrap();
    fs::create_dir(dir.path().join(".a.csv.part")).unwrap();
    write(&path, b"new").unwrap_err();
    assert_eq!(fs::read(&path).unwrap(), b"old");
}
