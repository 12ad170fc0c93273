//! Files on the disk and in memory.

use stampflow::case::files::{Disk, FileError, Files, Memory};
use std::fs::{self, File};
use std::path::Path;

#[test]
fn paths_in_memory_are_the_same_however_they_are_written() {
    let mut files = Memory::default();
    files.insert("cases/../data/./a.csv", "1");
    files.insert("../up.csv", "2");
    for (path, found) in [("data/a.csv", "1"), ("./data/b/../a.csv", "1"), ("x/../../up.csv", "2")] {
        assert_eq!(files.read(Path::new(path), 1), Ok(found.into()), "{path}");
    }
    assert_eq!(files.read(Path::new("up.csv"), 1), Err(FileError::Missing));
    assert_eq!(files.read(Path::new("../up.csv"), 0), Err(FileError::TooLarge { limit: 0 }));
}

#[test]
fn the_disk_gives_whole_files_and_refuses_the_rest() {
    let folder = temp_dir::TempDir::new().unwrap();
    let path = folder.path().join("a");
    fs::write(&path, "12345").unwrap();
    assert_eq!(Disk.read(&path, 5).unwrap(), b"12345");
    assert_eq!(Disk.read(&path, 4), Err(FileError::TooLarge { limit: 4 }));
    assert_eq!(Disk.read(folder.path(), 4), Err(FileError::Folder));
    assert_eq!(Disk.read(&folder.path().join("b"), 4), Err(FileError::Missing));
    // Nothing of it is read: its length is enough.
    File::create(&path).and_then(|file| file.set_len(1 << 42)).unwrap();
    assert_eq!(Disk.read(&path, 50_000_000), Err(FileError::TooLarge { limit: 50_000_000 }));
}
