//! Files as large as they may be, and larger: read once from end to end, or refused before.

use super::{BESIDE, CUP, LONGEST, PUNCH, forget_peak_memory, peak_memory};
use stampflow::case;
use stampflow::case::files::{CASE, CSV, Disk, Files};
use stampflow::import::{self, Options};
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::Path;
use std::time::{Duration, Instant};
use temp_dir::TempDir;

/// A beginning, what is repeated behind it, and an end.
struct Kind {
    begins: String,
    repeated: &'static str,
    ends: &'static str,
    /// How the file is read: whether it was refused.
    read: fn(&Path) -> bool,
    /// The largest that is read \[bytes\].
    most: usize,
}

impl Kind {
    /// Writes a file of so many bytes, little by little: what is measured is the memory of the reader.
    fn write(&self, path: &Path, bytes: usize) -> io::Result<()> {
        let mut file = BufWriter::new(File::create(path)?);
        file.write_all(self.begins.as_bytes())?;
        let room = bytes - self.begins.len() - self.ends.len();
        for _ in 0..room / self.repeated.len() {
            file.write_all(self.repeated.as_bytes())?;
        }
        file.write_all(self.ends.as_bytes())?;
        file.flush()
    }
}

fn refuses_case(path: &Path) -> bool {
    case::load(path, &[]).is_err()
}

/// The case stands beside the file that it names.
fn refuses_table(path: &Path) -> bool {
    case::load(path.with_file_name("case.toml"), &[]).is_err()
}

fn refuses_drawing(path: &Path) -> bool {
    let bytes = Disk.read(path, import::LARGEST);
    bytes.is_err() || bytes.is_ok_and(|bytes| import::read(&bytes, &Options::default()).is_err())
}

fn cases() -> Vec<Kind> {
    let cup = [CUP, PUNCH].join("\n");
    let of = |more: &str, repeated, ends| Kind {
        begins: format!("{cup}{more}"),
        repeated,
        ends,
        read: refuses_case,
        most: CASE,
    };
    vec![
        of("notes = [", "'a',", "]"),
        of("[output]\nframes = [", "\"1 mm\",", "]"),
        of("[output]\nframes = ", "[", ""),
        of("", "a.", "b = 1"),
        of("", "[[compare]]\n", ""),
        of("[solver]\ntolerance = 1", "0", ""),
    ]
}

/// Rows of what a table holds, one endless line, and nothing but quotes.
fn tables() -> Vec<Kind> {
    let rows = BESIDE.iter().map(|(_, table)| {
        let mut lines = table.lines().filter(|line| !line.starts_with('#'));
        (format!("{}\n", lines.next().expect("a header")), ["1,2\n", "30,150\n"])
    });
    let mut kinds: Vec<(String, &'static str)> =
        rows.flat_map(|(header, rows)| rows.map(|row| (header.clone(), row))).collect();
    kinds.extend(["travel_mm,", "travel_mm\n,", "\"", "a\n\""].map(|begins| (begins.to_owned(), ",")));
    let of = |(begins, repeated)| Kind { begins, repeated, ends: "", read: refuses_table, most: CSV };
    kinds.into_iter().map(of).collect()
}

fn drawings() -> Vec<Kind> {
    let line = "0\nLINE\n8\nPUNCH\n10\n1.0\n20\n0.0\n11\n2.0\n21\n0.0\n";
    let entities = "0\nSECTION\n2\nENTITIES\n";
    let of = |more: &str, repeated| {
        let (begins, ends) = (format!("{entities}{more}"), "0\nENDSEC\n0\nEOF\n");
        Kind { begins, repeated, ends, read: refuses_drawing, most: import::LARGEST }
    };
    vec![
        of("", line),
        of("", "0\nLINE\n"),
        of("0\nLWPOLYLINE\n8\nPUNCH\n", "10\n1.0\n20\n0.5\n"),
        of("0\nPOLYLINE\n8\nPUNCH\n", "0\nVERTEX\n10\n1.0\n20\n0.5\n"),
        of("0\nSPLINE\n8\nPUNCH\n71\n3\n", "40\n0.5\n10\n1.0\n20\n0.5\n"),
        of("0\nLINE\n8\n", "W"),
        of("", "0\n"),
    ]
}

/// Reads a file of every kind, of so large a share of the most that is read; the longest time.
fn read_all(share: f64) -> Duration {
    let folder = TempDir::new().expect("a folder");
    let path = folder.path().join("beside.csv");
    let mut longest = Duration::ZERO;
    for kind in cases().into_iter().chain(tables()).chain(drawings()) {
        kind.write(&path, (share * kind.most as f64) as usize).expect("room");
        let cases = BESIDE.iter().map(|(case, _)| case.join("\n"));
        for case in cases.take(if kind.most == CSV { BESIDE.len() } else { 1 }) {
            fs::write(folder.path().join("case.toml"), case).expect("room");
            let start = Instant::now();
            assert!((kind.read)(&path), "{:?}… is accepted", &kind.repeated);
            longest = longest.max(start.elapsed());
        }
    }
    longest
}

#[test]
fn large_files_of_every_kind_are_refused_in_time() {
    let longest = read_all(0.1);
    assert!(longest < LONGEST, "{longest:?}");
}

/// Trust: one reading of 50 MB from a disk takes a tenth of a second, and a text is held twice while it is read.
#[test]
#[ignore = "writes 50 MB several times; run it alone"]
fn the_largest_files_of_every_kind_are_refused_in_two_seconds_and_200_mb() {
    let before = forget_peak_memory();
    // As large as may be, and larger.
    let longest = read_all(0.99).max(read_all(1.01));
    let memory = peak_memory().zip(before).map(|(peak, before)| peak.saturating_sub(before) / 1_000_000);
    println!("longest {longest:?}, memory {memory:?} MB");
    assert!(longest < Duration::from_secs(2), "{longest:?}");
    assert!(memory.is_none_or(|megabytes| megabytes < 200), "{memory:?} MB");
}
