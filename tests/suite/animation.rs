//! The moving picture: that it changes nothing else, and what is in it.

use crate::common::cli::{CUP, STAGES, folder, stampflow, text};
use gif::DecodeOptions;
use std::fs;

/// Trust: frames are looked at as they pass; were a step made for one, the tables would differ in their last digits.
#[test]
fn a_run_is_the_same_with_and_without_its_animation_and_its_states() {
    let dir = folder(CUP);
    let out = dir.path().join("out/cup");
    let tables = || ["load_travel.csv", "profile.csv"].map(|name| fs::read(out.join(name)).unwrap());
    assert_eq!(stampflow(dir.path(), &["run", "cases/cup.toml", "-q"]).status.code(), Some(0));
    let without = tables();
    for (option, file) in [("--animate", "shapes.gif"), ("--vtu", "section.pvd")] {
        let done = stampflow(dir.path(), &["run", "cases/cup.toml", "-q", option]);
        assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
        assert!(tables() == without, "{option}");
        assert!(out.join(file).is_file());
    }
    stampflow(dir.path(), &["run", "cases/cup.toml", "-q"]);
    let left = ["shapes.gif", "section.pvd"].map(|file| out.join(file).exists());
    assert_eq!(left, [false, false], "what an earlier run left is removed");
}

/// Each picture differs from the one before (only what changes is stored, and it is never a single row), and together
/// they last the four seconds of the whole run and the pause at its end.
#[test]
fn every_stage_has_an_animation_that_moves_evenly() {
    let dir = folder(&format!("{CUP}{STAGES}"));
    let done = stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--animate"]);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    for stage in ["1-draw", "2-retract"] {
        let bytes = fs::read(dir.path().join("out/cup").join(stage).join("shapes.gif")).unwrap();
        let mut decoder = DecodeOptions::new().read_info(&bytes[..]).unwrap();
        assert_eq!(decoder.width(), 800);
        let mut delays = Vec::new();
        while let Some(frame) = decoder.read_next_frame().unwrap() {
            assert!(frame.height > 1 && frame.width == 800, "{stage}: picture {} changes nothing", delays.len());
            delays.push(frame.delay);
        }
        let (last, moving) = delays.split_last().unwrap();
        assert!((30..=51).contains(&delays.len()), "{stage}: {} pictures", delays.len());
        // Rounded to whole hundredths, each.
        let length: u16 = moving.iter().sum();
        assert!(length.abs_diff(400) <= delays.len() as u16 / 2 && *last == 150, "{stage}: {length}");
    }
}
