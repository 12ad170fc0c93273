//! A folder of results that goes over from those of one run to those of the next in one step.
//!
//! A run writes beside its folder `cup`, and what it has written takes the folder's place when it is complete:
//!
//! | name | what | left by a killed run, the next one |
//! |---|---|---|
//! | `.cup.lock` | the process that writes | takes it over |
//! | `.cup.part` | results that are being written | removes it |
//! | `.cup.swap` | exchanged with `cup`: new results before, old ones after | removes the results in it |
//! | `.cup.ready` | complete results that go into `cup` file by file | puts them there |
//!
//! Files of a user's own in the folder are linked into the new one before the exchange, so that they are there at
//! every instant; no step removes a file that a run has not written. The results go in file by file, and an interruption of
//! that is visible until the next run, where folders cannot be exchanged: the file system does not know how, a disk is
//! mounted there, a program stands in the folder (the shell that calls, `--out .`), or it has folders of a user's own, which
//! cannot be linked. Where nothing may be made beside the folder the names stand inside it, as `.stampflow.part`.

use super::file::{Way, folder_of};
use super::lock::{Lock, is_same};
use super::{WriteError, can_write, disk, file, stages};
use std::ffi::OsString;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// So many files at a time are waited for until the disk has them: one after the other takes several times as long.
const AT_A_TIME: usize = 16;

/// Before the name of a folder, where results that could not be put in place stay.
const COMPLETE: &str = "; the new results are complete in";

/// A folder of results, held by this process until it is published or dropped.
#[derive(Debug)]
pub struct ResultFolder {
    /// As it was named.
    named: PathBuf,
    site: Site,
    lock: Lock,
    /// What was written, by its path from the folder.
    written: Vec<PathBuf>,
    /// The first thing that could not be written.
    failure: Option<WriteError>,
    /// Whether what was written stays, though it is not published.
    is_kept: bool,
    /// Dropped last, when nothing of ours stands on it.
    _way: Way,
}

/// Where a folder of results is, and the names beside it.
#[derive(Debug)]
struct Site {
    /// The folder, no link.
    path: PathBuf,
    /// What the names begin with: `out/.cup`, or `out/cup/.stampflow`.
    stem: PathBuf,
    is_ours: fn(&str) -> bool,
}

/// What stands in a folder of results, by its path from it.
#[derive(Debug, Default)]
struct Contents {
    /// Files of a run, and the folders of its stages after what stands in them; the list of stages last.
    ours: Vec<PathBuf>,
    /// Everything else; a folder as one.
    others: Vec<PathBuf>,
}

impl ResultFolder {
    /// Takes a folder, which need not exist, for results whose files are `is_ours` by their names; ends what a killed run
    /// left half done.
    ///
    /// # Errors
    /// When it is no folder, cannot be written to, or another process writes there.
    pub fn open(named: &Path, is_ours: fn(&str) -> bool) -> Result<Self, WriteError> {
        Self::take(named, is_ours).map_err(|source| WriteError { path: named.to_owned(), source })
    }

    fn take(named: &Path, is_ours: fn(&str) -> bool) -> io::Result<Self> {
        let (path, way) = located(named)?;
        let (stem, lock) = claimed(&path)?;
        let site = Site { path, stem, is_ours };
        site.recover()?;
        if site.path.exists() {
            can_write(&site.path.join("probe")).map_err(|error| error.source)?;
        }
        disk::create_dir(&site.part())?;
        let named = named.to_owned();
        Ok(Self { named, site, lock, written: Vec::new(), failure: None, is_kept: false, _way: way })
    }

    /// Writes a file of the results to come, by its path from the folder. When that fails, publishing will say so: what
    /// else there is can still be written.
    pub fn write(&mut self, name: impl AsRef<Path>, bytes: &[u8]) {
        let name = name.as_ref();
        match self.put(&self.site.part().join(name), bytes) {
            Ok(()) => self.written.push(name.to_owned()),
            Err(source) => {
                self.failure.get_or_insert(WriteError { path: self.named.join(name), source });
            }
        }
    }

    fn put(&mut self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        if !self.lock.stands() {
            // Someone has removed all of it.
            disk::create_dir_all(folder_of(&self.site.stem))?;
            self.lock = Lock::wait(&self.site.named("lock"))?;
            self.site.recover()?;
        }
        disk::create_dir_all(folder_of(path))?;
        disk::fill(&disk::open(path)?, bytes).inspect_err(|_| _ = disk::remove_file(path))
    }

    /// Puts what was written in the place of the results that were there; returns its files.
    ///
    /// # Errors
    /// When something could not be written, or not be put there: the message says where the new results are, and the
    /// folder is as it was.
    pub fn publish(mut self) -> Result<Vec<PathBuf>, WriteError> {
        let part = self.site.part();
        if let Some(WriteError { path, source }) = self.failure.take() {
            self.is_kept = !self.written.is_empty();
            let what = "; what could be written is until the next run in";
            return Err(WriteError { path, source: if self.is_kept { with(&source, what, &part) } else { source } });
        }
        let published = match self.written.iter().find(|name| !part.join(name).exists()) {
            Some(gone) => Err(io::Error::other(format!("{} was taken away", part.join(gone).display()))),
            None => self.sync().and_then(|()| self.site.publish(self.written.is_empty())),
        };
        self.is_kept = published.is_err();
        published.map_err(|source| WriteError { path: self.named.clone(), source })?;
        Ok(self.written.iter().map(|name| self.named.join(name)).collect())
    }

    /// Returns when all that was written would outlast a loss of power.
    fn sync(&self) -> io::Result<()> {
        let part = self.site.part();
        for names in self.written.chunks(AT_A_TIME) {
            std::thread::scope(|scope| {
                let paths = names.iter().map(|name| part.join(name));
                let syncs: Vec<_> = paths.map(|path| scope.spawn(move || disk::sync(&path))).collect();
                syncs.into_iter().try_for_each(|sync| sync.join().expect("no panic in a call of the system"))
            })?;
        }
        disk::sync_names(&part);
        Ok(())
    }
}

impl Drop for ResultFolder {
    fn drop(&mut self) {
        if !self.is_kept && self.lock.stands() {
            let _ = disk::remove_dir_all(&self.site.part());
        }
    }
}

/// Where a folder is, behind links, and the way that was made to it.
fn located(named: &Path) -> io::Result<(PathBuf, Way)> {
    let named = if named.as_os_str().is_empty() { Path::new(".") } else { named };
    let folder = folder_of(named);
    let way = Way::to(folder)?;
    if named.symlink_metadata().is_err() {
        let name = named.file_name().ok_or(ErrorKind::InvalidInput)?;
        return Ok((fs::canonicalize(folder)?.join(name), way));
    }
    let path = fs::canonicalize(named)?;
    if path.is_dir() { Ok((path, way)) } else { Err(ErrorKind::NotADirectory.into()) }
}

/// Takes the lock beside a folder, or inside it where nothing can be made beside it.
fn claimed(path: &Path) -> io::Result<(PathBuf, Lock)> {
    let beside = path.file_name().map(|name| {
        let mut stem = OsString::from(".");
        stem.push(name);
        path.with_file_name(stem)
    });
    let inside = path.is_dir().then(|| path.join(concat!(".", env!("CARGO_PKG_NAME"))));
    let mut failure = io::Error::from(ErrorKind::InvalidInput);
    for (i, stem) in [beside, inside].into_iter().flatten().enumerate() {
        match Lock::take(&with_ending(&stem, "lock")) {
            Ok(lock) => return Ok((stem, lock)),
            Err(error) if error.kind() == ErrorKind::ResourceBusy => return Err(error),
            Err(error) if i == 0 => failure = error,
            Err(_) => {}
        }
    }
    Err(failure)
}

fn with_ending(stem: &Path, ending: &str) -> PathBuf {
    let mut name = stem.as_os_str().to_owned();
    name.push(".");
    name.push(ending);
    name.into()
}

impl Site {
    fn named(&self, ending: &str) -> PathBuf {
        with_ending(&self.stem, ending)
    }

    fn part(&self) -> PathBuf {
        self.named("part")
    }

    /// Ends what a killed run left half done.
    fn recover(&self) -> io::Result<()> {
        if self.named("ready").exists() {
            self.merge()?;
        }
        if self.named("swap").exists() {
            self.sweep()?;
        }
        if self.part().exists() { disk::remove_dir_all(&self.part()) } else { Ok(()) }
    }

    /// Puts complete results in the place of those that are there.
    fn publish(&self, is_empty: bool) -> io::Result<()> {
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
        let list = fs::read_to_string(folder.join(stages::FILE)).ok().filter(|_| (self.is_ours)(stages::FILE));
        let stages = list.map_or_else(Vec::new, |list| stages::folders(&list));
        for (name, kind) in entries(folder)? {
            if kind.is_dir() && name.to_str().is_some_and(|name| stages.iter().any(|stage| stage == name)) {
                for (inner, kind) in entries(&folder.join(&name))? {
                    found.add(name.join(&inner), kind.is_file() && self.is_named(&inner));
                }
                found.ours.push(name);
            } else {
                let is_ours = kind.is_file() && self.is_named(&name);
                found.add(name, is_ours);
            }
        }
        found.ours.sort_by_key(|name| name == Path::new(stages::FILE));
        Ok(found)
    }

    fn is_named(&self, name: &Path) -> bool {
        name.to_str().is_some_and(self.is_ours)
    }
}

impl Contents {
    fn add(&mut self, name: PathBuf, is_ours: bool) {
        if is_ours { self.ours.push(name) } else { self.others.push(name) }
    }
}

/// Names in a folder and what they are, links as such; none where there is no folder.
fn entries(folder: &Path) -> io::Result<Vec<(PathBuf, fs::FileType)>> {
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
fn with(error: &io::Error, what: &str, path: &Path) -> io::Error {
    io::Error::new(error.kind(), format!("{error}{what} {}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::super::disk::{Fault, calls_left, fail_after};
    use super::*;
    use std::collections::BTreeMap;

    /// By which a run finds out whether a folder can be written to.
    const PROBE: &str = ".probe.part";

    /// Files of a run by their paths, and what stands in them.
    type Tree = BTreeMap<PathBuf, String>;

    const OLD: [&str; 4] = ["r-plot", "stages.csv", "1-draw/r-table", "2-back/r-table"];
    const NEW: [&str; 4] = ["r-plot", "r-more", "stages.csv", "1-draw/r-table"];
    const NEXT: [&str; 2] = ["r-plot", "r-table"];

    fn is_ours(name: &str) -> bool {
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
                assert!(
                    *found == both(&old, &mine(false)) || *found == both(&new, &mine(false)),
                    "{label}: {found:#?}"
                );
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
        assert!(
            told.contains("what could be written is until the next run in") && told.contains(".cup.part"),
            "{told}"
        );
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
}
