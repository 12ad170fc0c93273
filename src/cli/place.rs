//! Where a verb may write: where the user said, and never over what it reads.

use super::code::{BadPath, BadRequest, unusable};
use stampflow::case::Case;
use stampflow::results::{ResultFolder, WriteError, can_write, is_result};
use std::fs::{self, File};
use std::io::Read;
use std::path::{Component, Path, PathBuf};

/// The folder of a case among others.
pub fn folder(others: &Path, case: &Case) -> Result<PathBuf, BadRequest> {
    let mut parts = Path::new(&case.name).components();
    if let (Some(Component::Normal(_)), None) = (parts.next(), parts.next()) {
        return Ok(others.join(&case.name));
    }
    let path = case.path.display();
    Err(BadRequest(format!(
        "the results of {path} would go to \"{}\", which is no folder of their own: rename it",
        case.name
    )))
}

/// Takes a folder for the results of a case.
pub fn results(
    case: &Case,
    dir: &Path,
    take: impl Fn(&Path) -> Result<ResultFolder, WriteError>,
) -> Result<ResultFolder, BadPath> {
    let among = real(dir);
    let is_among = |input: &&PathBuf| {
        let input = real(input);
        is_named_as_result(&input) && input.ancestors().skip(1).take(2).any(|folder| folder == among)
    };
    if let Some(input) = case.inputs.iter().find(is_among) {
        return Err(BadPath {
            what: format!("{} is read by the case and would be replaced by its results", input.display()),
            help: "choose another place with --out".to_owned(),
            path: input.clone(),
        });
    }
    take(dir).map_err(unusable("--out"))
}

/// Refuses a file that is an input, or that cannot be written.
pub fn file(path: &Path, inputs: &[PathBuf], option: &str) -> Result<(), BadPath> {
    let place = real(path);
    if inputs.iter().any(|input| real(input) == place) {
        let what = format!("{} is what is read", path.display());
        let help = format!("choose another place with {option}");
        return Err(BadPath { what, help, path: path.to_owned() });
    }
    can_write(path).map_err(unusable(option))
}

/// Refuses a file that is there and does not begin as what is to be written.
pub fn replaced(path: &Path, beginning: &[u8], option: &str) -> Result<(), BadPath> {
    let begins = || {
        let mut found = Vec::new();
        let read = File::open(path).and_then(|file| file.take(beginning.len() as u64).read_to_end(&mut found));
        read.is_ok() && found == beginning
    };
    // Opening a pipe waits for someone to write into it.
    if path.symlink_metadata().is_err() || path.is_dir() || path.is_file() && begins() {
        return Ok(());
    }
    let what = format!("{} is there already, and it is not what may be replaced here", path.display());
    Err(BadPath { what, help: format!("choose another place with {option}"), path: path.to_owned() })
}

/// Refuses a file among the results of a folder.
pub fn outside(path: &Path, dir: &Path, option: &str) -> Result<(), BadPath> {
    let file = real(path);
    if !is_named_as_result(&file) || file.parent() != Some(&real(dir)) {
        return Ok(());
    }
    let what = format!("{} is the name of a result", path.display());
    Err(BadPath { what, help: format!("choose another with {option}"), path: path.to_owned() })
}

fn is_named_as_result(path: &Path) -> bool {
    path.file_name().and_then(|name| name.to_str()).is_some_and(is_result)
}

/// A path without links, as far as it exists.
fn real(path: &Path) -> PathBuf {
    let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    let known = path.ancestors().find_map(|there| Some((there, fs::canonicalize(there).ok()?)));
    let Some((there, real)) = known else { return path };
    let rest = path.strip_prefix(there).expect("an ancestor");
    if rest.as_os_str().is_empty() { real } else { real.join(rest) }
}
