//! All that changes the disk, each call once and counted: tests let every call fail from any one on, which is what a full
//! disk, a folder that has become read-only and a killed process come to.

use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::path::Path;

/// Makes a folder and those on the way to it.
pub fn create_dir_all(path: &Path) -> io::Result<()> {
    count_room()?;
    fs::create_dir_all(path)
}

/// Makes a folder.
pub fn create_dir(path: &Path) -> io::Result<()> {
    count_room()?;
    fs::create_dir(path)
}

/// Opens a file for writing as it is, and makes it where there is none.
pub fn open(path: &Path) -> io::Result<File> {
    count_room()?;
    File::options().read(true).write(true).create(true).truncate(false).open(path)
}

/// Replaces what a file holds; in two calls, so that it can fail half way.
pub fn fill(mut file: &File, bytes: &[u8]) -> io::Result<()> {
    let (first, rest) = bytes.split_at(bytes.len() / 2);
    count_room()?;
    file.set_len(0)?;
    file.write_all(first)?;
    count_room()?;
    file.write_all(rest)
}

/// Lets a folder be used as another is.
pub fn set_permissions(path: &Path, permissions: Permissions) -> io::Result<()> {
    count()?;
    fs::set_permissions(path, permissions)
}

/// Gives a file a second name.
pub fn link(from: &Path, to: &Path) -> io::Result<()> {
    count_room()?;
    fs::hard_link(from, to)
}

/// Copies a file, and returns when the copy would outlast a loss of power.
pub fn copy(from: &Path, to: &Path) -> io::Result<()> {
    count_room()?;
    fs::copy(from, to)?;
    sync(to)
}

/// Gives a file or folder another name; a file that has it goes.
pub fn rename(from: &Path, to: &Path) -> io::Result<()> {
    count()?;
    fs::rename(from, to)
}

/// Lets two files or folders change their names in one step.
///
/// # Errors
/// Also where the system or the file system cannot do so.
pub fn exchange(a: &Path, b: &Path) -> io::Result<()> {
    count()?;
    #[cfg(any(target_os = "linux", target_os = "macos"))]
    {
        use rustix::fs::{CWD, RenameFlags, renameat_with};
        Ok(renameat_with(CWD, a, CWD, b, RenameFlags::EXCHANGE)?)
    }
    #[cfg(not(any(target_os = "linux", target_os = "macos")))]
    {
        let _ = (a, b);
        Err(io::ErrorKind::Unsupported.into())
    }
}

/// Removes a file.
pub fn remove_file(path: &Path) -> io::Result<()> {
    count()?;
    fs::remove_file(path)
}

/// Removes an empty folder.
pub fn remove_dir(path: &Path) -> io::Result<()> {
    count()?;
    fs::remove_dir(path)
}

/// Removes a folder with all that is in it.
pub fn remove_dir_all(path: &Path) -> io::Result<()> {
    for entry in fs::read_dir(path)? {
        let entry = entry?;
        if entry.file_type()?.is_dir() { remove_dir_all(&entry.path())? } else { remove_file(&entry.path())? }
    }
    remove_dir(path)
}

/// Returns when what a file holds would outlast a loss of power.
pub fn sync(path: &Path) -> io::Result<()> {
    File::options().write(true).open(path)?.sync_all()
}

/// The same of the names in a folder, where the system knows of such a thing.
pub fn sync_names(folder: &Path) {
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
}

/// Any change.
#[cfg(not(test))]
fn count() -> io::Result<()> {
    Ok(())
}

/// A change that takes room.
#[cfg(not(test))]
fn count_room() -> io::Result<()> {
    Ok(())
}

#[cfg(test)]
pub use faults::{Fault, calls_left, fail_after};
#[cfg(test)]
use faults::{count, count_room};

#[cfg(test)]
mod faults {
    use std::cell::Cell;
    use std::io::{self, ErrorKind};

    /// Which calls fail.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Fault {
        /// All: the process was killed, or nothing may be changed any more.
        Everything,
        /// Those that take room: the disk is full.
        Full,
    }

    thread_local! {
        /// Calls of this thread that still do something.
        static LEFT: Cell<usize> = const { Cell::new(usize::MAX) };
        static FAULT: Cell<Fault> = const { Cell::new(Fault::Full) };
    }

    /// Lets so many calls of this thread pass; after them there is a fault.
    pub fn fail_after(calls: usize, fault: Fault) {
        LEFT.set(calls);
        FAULT.set(fault);
    }

    pub fn calls_left() -> usize {
        LEFT.get()
    }

    pub fn count() -> io::Result<()> {
        if FAULT.get() == Fault::Everything { spend(ErrorKind::ReadOnlyFilesystem) } else { Ok(()) }
    }

    pub fn count_room() -> io::Result<()> {
        spend(ErrorKind::StorageFull)
    }

    fn spend(fault: ErrorKind) -> io::Result<()> {
        LEFT.set(LEFT.get().checked_sub(1).ok_or(fault)?);
        Ok(())
    }
}
