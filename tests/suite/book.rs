//! The book is true: its blocks are what the program prints, its pictures what it draws, and its links lead somewhere.
//!
//! ```text
//! <!-- file: tests/drawings/die.dxf as die.dxf -->      a file of the project that the page's commands find
//! ```console                                            a block: commands, each with the first lines of what it prints,
//! $ stampflow run cup.toml                              and `...` where more follow
//! cup: AMBER: ...
//! <!-- picture: out/cup/part.png as cup_part.png -->    a picture of the page, as its commands draw it
//! ```
//!
//! `UPDATE=1` writes the lines and the pictures anew.

use regex::Regex;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use temp_dir::TempDir;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// The pages of the book, in alphabetical order.
fn pages() -> Vec<PathBuf> {
    let entries = fs::read_dir(Path::new(ROOT).join("docs")).expect("shipped");
    let mut pages: Vec<PathBuf> = entries.map(|entry| entry.expect("readable").path()).collect();
    pages.retain(|page| page.extension().is_some_and(|ending| ending == "md"));
    pages.sort();
    pages
}

fn copy_folder(name: &str, to: &Path) {
    fs::create_dir_all(to.join(name)).expect("writable");
    for entry in fs::read_dir(Path::new(ROOT).join(name)).expect("shipped") {
        let path = entry.expect("readable").path();
        let inside = Path::new(name).join(path.file_name().expect("a name"));
        match path.is_dir() {
            true => copy_folder(&inside.to_string_lossy(), to),
            false => fs::copy(&path, to.join(inside)).map(drop).expect("writable"),
        }
    }
}

/// What a command of a page prints on its output, line by line.
fn printed(command: &str, folder: &Path) -> Vec<String> {
    let program = Path::new(env!("CARGO_BIN_EXE_stampflow")).parent().expect("a folder");
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap_or_default());
    let done = Command::new("sh")
        .args(["-c", command])
        .current_dir(folder)
        .envs([("PATH", path.as_str()), ("COLUMNS", "80"), ("NO_COLOR", "1")])
        .output()
        .expect("a shell");
    assert!(done.status.success(), "{command}: {}", String::from_utf8_lossy(&done.stderr));
    String::from_utf8_lossy(&done.stdout).lines().map(|line| line.trim_end().to_owned()).collect()
}

/// The page as it would be if its commands were run now, and its pictures: their places in the book and what was drawn.
fn made_anew(page: &str) -> (String, Vec<(PathBuf, Vec<u8>)>) {
    let folder = TempDir::new().expect("writable");
    for name in ["cases", "reference_data"] {
        copy_folder(name, folder.path());
    }
    let directive = Regex::new(r"^<!-- (file|picture): (\S+) as (\S+) -->$").expect("a pattern");
    let (mut anew, mut pictures, mut in_block) = (String::new(), Vec::new(), false);
    let mut lines = page.lines().peekable();
    while let Some(line) = lines.next() {
        anew += &format!("{line}\n");
        match directive.captures(line).map(|parts| parts.extract::<3>().1) {
            Some(["file", from, to]) => {
                fs::copy(Path::new(ROOT).join(from), folder.path().join(to)).expect("shipped");
            }
            Some([_, from, to]) => {
                let drawn = fs::read(folder.path().join(from)).unwrap_or_else(|error| panic!("{from}: {error}"));
                pictures.push((Path::new(ROOT).join("docs").join(to), drawn));
            }
            None => {}
        }
        if line.starts_with("```") {
            in_block = line == "```console";
        }
        let Some(command) = line.strip_prefix("$ ").filter(|_| in_block) else { continue };
        let printed = printed(command, folder.path());
        let mut shown = 0;
        while lines.peek().is_some_and(|line| !line.starts_with("$ ") && !line.starts_with("```")) {
            shown += usize::from(lines.next() != Some("..."));
        }
        for line in printed.iter().take(shown) {
            anew += &format!("{line}\n");
        }
        if printed.iter().skip(shown).any(|line| !line.is_empty()) {
            anew += "...\n";
        }
    }
    (anew, pictures)
}

/// Share of the pixels of two pictures that differ; all where they differ in size.
fn difference(a: &[u8], b: &[u8]) -> f64 {
    let pixels = |bytes: &[u8]| {
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes.to_vec())).read_info().expect("a PNG");
        let mut pixels = vec![0; reader.output_buffer_size().expect("a size")];
        let info = reader.next_frame(&mut pixels).expect("a picture");
        ((info.width, info.height), pixels)
    };
    let ((size, a), (other, b)) = (pixels(a), pixels(b));
    if size != other || a.len() != b.len() {
        return 1.0;
    }
    a.iter().zip(&b).filter(|(a, b)| a != b).count() as f64 / a.len() as f64
}

/// Trust: the program itself. Pictures are the same but for pixels that rounding on another machine moves.
#[test]
fn pages_show_what_the_program_prints_and_draws() {
    let update = std::env::var_os("UPDATE").is_some();
    let mut wrong = Vec::new();
    for path in pages() {
        let page = fs::read_to_string(&path).expect("readable");
        if !page.contains("```console") {
            continue;
        }
        let (anew, pictures) = made_anew(&page);
        if update {
            fs::write(&path, &anew).expect("writable");
            for (path, drawn) in &pictures {
                fs::write(path, drawn).expect("writable");
            }
        }
        if let Some((old, new)) = page.lines().zip(anew.lines()).find(|(old, new)| old != new) {
            wrong.push(format!("{}:\n  shown   {old}\n  printed {new}", path.display()));
        }
        for (path, drawn) in pictures {
            let share = fs::read(&path).map_or(1.0, |shown| difference(&shown, &drawn));
            if share > 0.01 {
                wrong.push(format!("{}: {:.1} % of it is drawn otherwise", path.display(), 100.0 * share));
            }
        }
    }
    assert!(wrong.is_empty(), "run with UPDATE=1 where that is meant:\n{}", wrong.join("\n"));
}

/// Trust: the files themselves.
#[test]
fn every_page_is_in_the_summary_and_every_link_and_picture_is_there() {
    let docs = Path::new(ROOT).join("docs");
    let summary = fs::read_to_string(docs.join("SUMMARY.md")).expect("shipped");
    let link = Regex::new(r"\]\(([^)#]+)(?:#[^)]*)?\)").expect("a pattern");
    let mut missing = Vec::new();
    for page in pages().into_iter().chain([Path::new(ROOT).join("README.md")]) {
        let name = page.file_name().expect("a name").to_string_lossy().into_owned();
        if !["SUMMARY.md", "README.md"].contains(&name.as_str()) && !summary.contains(&format!("({name})")) {
            missing.push(format!("SUMMARY.md has no {name}"));
        }
        let text = fs::read_to_string(&page).expect("readable");
        for target in link.captures_iter(&text).map(|parts| parts[1].to_owned()) {
            let is_elsewhere = target.starts_with("http");
            if !is_elsewhere && !page.parent().expect("a folder").join(&target).exists() {
                missing.push(format!("{name} leads to {target}, which is not there"));
            }
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

/// Trust: what a newcomer reads in five minutes; the rest is in the book.
#[test]
fn the_readme_is_short() {
    let readme = fs::read_to_string(Path::new(ROOT).join("README.md")).expect("shipped");
    assert!(readme.len() <= 8 * 1024, "{} bytes", readme.len());
}
