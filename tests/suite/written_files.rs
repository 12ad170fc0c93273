//! Files appear complete or not at all.

use stampflow::output::{can_write, write};
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
    fs::create_dir(dir.path().join(format!(".a.csv.{}.part", std::process::id()))).unwrap();
    write(&path, b"new").unwrap_err();
    assert_eq!(fs::read(&path).unwrap(), b"old");
}
