//! The program as a user calls it, and small cases for it.

use crate::common::prelude::*;

pub const CUP: &str = include_str!("cup.toml");

/// The case of the documentation of `stampflow::case`: no key of it can be left out.
pub const MINIMAL: &str = include_str!("minimal.toml");

/// Its law.
pub const LAW: &str = "[material.hardening]\nswift = { k = \"520 MPa\", n = 0.22, offset = 0.005 }\n";

pub const STAGES: &str = include_str!("stages.toml");

/// Compares the punch's force of a case with `curve.csv`.
pub const COMPARE: &str = include_str!("compare.toml");

/// So many elements and so short steps that a run of [`CUP`] takes far longer than a test.
pub fn endless() -> String {
    CUP.replace("elements = 30", "elements = 2000\n[solver]\nmax_step = 1e-5\nfirst_step = 1e-5")
}

pub fn stampflow(dir: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_stampflow")).args(args).current_dir(dir).output().unwrap()
}

/// Holds a call to its exit code, and its errors to a part of their text.
pub fn ends(done: &Output, code: i32, says: &str) {
    let errors = text(&done.stderr);
    assert!(done.status.code() == Some(code) && errors.contains(says), "{says}: {errors}{}", text(&done.stdout));
}

pub fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

/// A folder with a case in `cases/cup.toml`.
pub fn folder(case: &str) -> temp_dir::TempDir {
    let dir = temp_dir::TempDir::new().unwrap();
    fs::create_dir(dir.path().join("cases")).unwrap();
    fs::write(dir.path().join("cases/cup.toml"), case).unwrap();
    dir
}

pub fn read_json(path: impl AsRef<Path>) -> serde_json::Value {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}
