//! Where a folder of results is: how complete results take the place of others, and what a killed run left half done.

use crate::output::file::{self, folder_of};
use crate::output::lock::is_same;
use crate::output::{disk, stages};
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Before the name of a folder, where results that could not be put in place stay.
const COMPLETE: &str = "; the new results are complete in";

/// Where a folder of results is, and the names beside it.
#[derive(Debug)]
pub(super) struct Site {
    /// The folder, no link.
    pub(super) path: PathBuf,
    /// What the names begin with: `out/.cup`, or `out/cup/.stampflow`.
    pub(super) stem: PathBuf,
    /// Whether a file, by its path, is of a run.
    pub(super) is_ours: fn(&Path) -> bool,
}

/// What stands in a folder of results, by its path from it.
#[derive(Debug, Default)]
struct Contents {
    /// Files of a run, and the folders of its stages after what stands in them; the list of stages last.
    ours: Vec<PathBuf>,
    /// Everything else; a folder as one.
    others: Vec<PathBuf>,
}

pub(super) fn with_ending(stem: &Path, ending: &str) -> PathBuf {
    let mut name = stem.as_os_str().to_owned();
    name.push(".");
    name.push(ending);
    name.into()
}

impl Site {
    pub(super) fn named(&self, ending: &str) -> PathBuf {
        with_ending(&self.stem, ending)
    }

    pub(super) fn part(&self) -> PathBuf {
        self.named("part")
    }

    /// Ends what a killed run left half done.
    pub(super) fn recover(&self) -> io::Result<()> {
        if self.named("ready").exists() {
            self.merge()?;
        }
        if self.named("swap").exists() {
            self.sweep()?;
        }
        if self.part().exists() { disk::remove_dir_all(&self.part()) } else { Ok(()) }
    }

    /// Puts complete results in the place of those that are there.
    pub(super) fn publish(&self, is_empty: bool) -> io::Result<()> {
        let [part, swap, ready] = ["part", "swap", "ready"].map(|ending| self.named(ending));
        if self.path.symlink_metadata().is_err() {
            if !is_empty {
                renamed(&part, &self.path)?;
                disk::sync_names(folder_of(&self.path));
            }
            return Ok(());
        }
        let mut complete = part;
        if self.can_be_exchanged() && self.link_others().map_err(|error| with(&error, COMPLETE, &complete))? {
            renamed(&complete, &swap)?;
            complete = swap;
            if disk::exchange(&complete, &self.path).is_ok() {
                // Or a loss of power could undo the exchange and not what is removed after it.
                disk::sync_names(folder_of(&self.path));
                return self.sweep();
            }
        }
        renamed(&complete, &ready)?;
        self.merge()
    }

    /// Whether the names stand beside the folder, and this process not in it.
    fn can_be_exchanged(&self) -> bool {
        let stands_in = std::env::current_dir().is_ok_and(|here| here.starts_with(&self.path));
        cfg!(unix) && !self.stem.starts_with(&self.path) && !stands_in
    }

    /// Gives all that is not ours a second name among the new results; or says that this cannot be done.
    fn link_others(&self) -> io::Result<bool> {
        let (part, others) = (self.part(), self.contents(&self.path)?.others);
        disk::set_permissions(&part, fs::metadata(&self.path)?.permissions())?;
        for name in others {
            let (from, to) = (self.path.join(&name), part.join(&name));
            if !from.symlink_metadata()?.is_file() {
                return Ok(false);
            }
            disk::create_dir_all(folder_of(&to))?;
            match disk::link(&from, &to) {
                Err(error) if error.kind() == ErrorKind::StorageFull => return Err(error),
                Err(_) => return Ok(false),
                Ok(()) => {}
            }
        }
        Ok(true)
    }

    /// Removes the results that were exchanged for new ones; what is not ours goes to the new ones where it is not there yet.
    fn sweep(&self) -> io::Result<()> {
        let swap = self.named("swap");
        self.swept(&swap).map_err(|error| {
            with(&error, "; the folder has the new results, and what is left of the old ones is", &swap)
        })
    }

    fn swept(&self, swap: &Path) -> io::Result<()> {
        let Contents { ours, others } = self.contents(swap)?;
        for name in others {
            keep(&swap.join(&name), &self.path.join(&name))?;
        }
        for name in ours {
            remove(&swap.join(name))?;
        }
        disk::remove_dir(swap)
    }

    /// Puts complete results into the folder file by file; can be begun anew at any instant.
    fn merge(&self) -> io::Result<()> {
        let ready = self.named("ready");
        self.merged(&ready).map_err(|error| with(&error, COMPLETE, &ready))
    }

    /// First what takes room, so that a full disk leaves the folder as it was.
    fn merged(&self, ready: &Path) -> io::Result<()> {
        let (new, old) = (self.contents(ready)?.ours, self.contents(&self.path)?.ours);
        let files: Vec<&PathBuf> = new.iter().filter(|name| ready.join(name).is_file()).collect();
        let placed = files.iter().try_for_each(|name| place(&ready.join(name), &self.path.join(name)));
        if placed.is_err() {
            let parts = files.iter().filter_map(|name| file::neighbour(&self.path.join(name)).ok());
            parts.for_each(|part| _ = disk::remove_file(&part));
        }
        placed?;
        for name in old.iter().filter(|name| !new.contains(name)) {
            remove(&self.path.join(name))?;
        }
        for name in files {
            replace(&self.path.join(name))?;
        }
        disk::sync_names(&self.path);
        let part = self.part();
        if part.exists() {
            disk::remove_dir_all(&part)?;
        }
        disk::rename(ready, &part)?;
        disk::remove_dir_all(&part)
    }

    fn contents(&self, folder: &Path) -> io::Result<Contents> {
        let mut found = Contents::default();
        let list = fs::read_to_string(folder.join(stages::FILE)).ok();
        let list = list.filter(|_| (self.is_ours)(&folder.join(stages::FILE)));
        let stages = list.map_or_else(Vec::new, |list| stages::folders(&list));
        for (name, kind) in entries(folder)? {
            if kind.is_dir() && name.to_str().is_some_and(|name| stages.iter().any(|stage| stage == name)) {
                for (inner, kind) in entries(&folder.join(&name))? {
                    found.add(name.join(&inner), kind.is_file() && (self.is_ours)(&folder.join(&name).join(&inner)));
                }
                found.ours.push(name);
            } else {
                let is_ours = kind.is_file() && (self.is_ours)(&folder.join(&name));
                found.add(name, is_ours);
            }
        }
        found.ours.sort_by_key(|name| name == Path::new(stages::FILE));
        Ok(found)
    }
}

impl Contents {
    fn add(&mut self, name: PathBuf, is_ours: bool) {
        if is_ours { self.ours.push(name) } else { self.others.push(name) }
    }
}

/// Names in a folder and what they are, links as such; none where there is no folder.
pub(super) fn entries(folder: &Path) -> io::Result<Vec<(PathBuf, fs::FileType)>> {
    match fs::read_dir(folder) {
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(Vec::new()),
        entries => entries?.map(|entry| entry.and_then(|e| Ok((e.file_name().into(), e.file_type()?)))).collect(),
    }
}

/// Gives complete results another name.
fn renamed(from: &Path, to: &Path) -> io::Result<()> {
    disk::rename(from, to).map_err(|error| with(&error, COMPLETE, from))
}

/// Moves what is not ours to where it belongs; where something else has that name it gets a number.
fn keep(from: &Path, to: &Path) -> io::Result<()> {
    let is_linked = to.symlink_metadata().is_ok_and(|to| from.symlink_metadata().is_ok_and(|from| is_same(&from, &to)));
    if is_linked {
        return disk::remove_file(from);
    }
    if [from, to].iter().all(|path| path.symlink_metadata().is_ok_and(|about| about.is_dir())) {
        entries(from)?.iter().try_for_each(|(name, _)| keep(&from.join(name), &to.join(name)))?;
        return disk::remove_dir(from);
    }
    disk::create_dir_all(folder_of(to))?;
    let numbered = (1..).map(|n| with_ending(to, &n.to_string()));
    let free = std::iter::once(to.to_owned()).chain(numbered).find(|to| to.symlink_metadata().is_err());
    disk::rename(from, &free.expect("a number that is free"))
}

/// Removes a file or an empty folder.
fn remove(path: &Path) -> io::Result<()> {
    if !path.is_dir() {
        return disk::remove_file(path);
    }
    match disk::remove_dir(path) {
        Err(error) if error.kind() == ErrorKind::DirectoryNotEmpty => Ok(()),
        done => done,
    }
}

/// Puts a file beside where it belongs, by a link where that can be made.
fn place(from: &Path, to: &Path) -> io::Result<()> {
    disk::create_dir_all(folder_of(to))?;
    let part = file::neighbour(to)?;
    if part.exists() {
        disk::remove_file(&part)?;
    }
    disk::link(from, &part).or_else(|_| disk::copy(from, &part))
}

/// Puts it where it belongs.
fn replace(path: &Path) -> io::Result<()> {
    let part = file::neighbour(path)?;
    disk::rename(&part, path)?;
    // Of two names of one file a renaming removes none.
    if part.exists() { disk::remove_file(&part) } else { Ok(()) }
}

/// The same error, and where what it is about stands now.
pub(super) fn with(error: &io::Error, what: &str, path: &Path) -> io::Error {
    io::Error::new(error.kind(), format!("{error}{what} {}", path.display()))
}
