//! Places that a verb may write to: never over what it reads.

use super::*;
use std::{fs, fs::File, io::Read};

pub fn folder(others: &Path, case: &Case) -> Result<PathBuf> {
    let (path, name) = (case.path.display(), &case.name);
    let is_folder = Path::new(name).components().map(|part| matches!(part, std::path::Component::Normal(_))).eq([true]);
    let what = || format!("the results of {path} would go to \"{name}\", which is no folder of their own: rename it");
    ensure!(is_folder, bad_request(what()));
    Ok(others.join(name))
}

fn refused(path: &Path, what: &str, option: &str) -> anyhow::Error {
    bad_path(path, what, format!("choose another place with {option}"))
}

/// Refuses a folder for the results of a case that holds a file that the case reads.
pub fn results(case: &Case, dir: &Path) -> Result<()> {
    let folder = real(dir);
    for input in &case.inputs {
        let input_path = real(input);
        let is_inside = input_path.ancestors().skip(1).take(2).any(|parent| parent == folder);
        let what = "is read by the case and would be replaced by its results";
        ensure!(!is_inside || !is_named_as_result(&input_path), refused(input, what, "--out"));
    }
    Ok(())
}

pub fn free(path: &Path, force: bool, inputs: &[PathBuf], option: &str) -> Result<()> {
    let help = format!("choose another name with {option}, or replace it with --force");
    ensure!(force || path.symlink_metadata().is_err(), bad_path(path, "is there already", help));
    file(path, inputs, option)
}

pub fn file(path: &Path, inputs: &[PathBuf], option: &str) -> Result<()> {
    ensure!(inputs.iter().all(|input| real(input) != real(path)), refused(path, "is what is read", option));
    Ok(())
}

/// Refuses a file that is an input, cannot be written, or exists and does not begin like the one to be written.
pub fn replaced(path: &Path, beginning: &[u8], inputs: &[PathBuf], option: &str) -> Result<()> {
    let begins = || {
        let mut bytes = vec![0; beginning.len()];
        File::open(path).and_then(|mut file| file.read_exact(&mut bytes)).is_ok() && bytes == beginning
    };
    // Opening a pipe would wait for a writer.
    let is_free = path.symlink_metadata().is_err() || path.is_dir() || path.is_file() && begins();
    ensure!(is_free, refused(path, "is there already, and it is not what may be replaced here", option));
    file(path, inputs, option)?;
    can_write(path).map_err(unusable(option))
}

/// Refuses a file with the name of a result in the folder of results.
pub fn outside(path: &Path, dir: &Path, option: &str) -> Result<()> {
    let file = real(path);
    let is_result = is_named_as_result(&file) && file.parent() == Some(&real(dir));
    ensure!(!is_result, refused(path, "is the name of a result", option));
    Ok(())
}

fn is_named_as_result(path: &Path) -> bool {
    path.file_name().and_then(|name| name.to_str()).is_some_and(is_result)
}

fn real(path: &Path) -> PathBuf {
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let known = path.ancestors().find_map(|there| Some((there, fs::canonicalize(there).ok()?)));
    known.map_or(path.clone(), |(there, real)| real.join(path.strip_prefix(there).expect("an ancestor")))
}
