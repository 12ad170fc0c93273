//! The book is true: its blocks are what the program prints, its pictures what it draws, and its links lead somewhere.
//!
//! ```text
//! <!-- file: tests/drawings/die.dxf as die.dxf -->      a file of the project that the page's commands find
//! ```console                                            a block: commands, each with the first lines of what it prints,
//! $ stampflow run cup.toml                              and `...` where more follow
//! cup: AMBER: ...
//! <!-- picture: out/cup/part.png as cup_part.png -->    a picture of the page, as its commands draw it
//! <!-- printed: stampflow verify cases/quickstart.toml --> Markdown that a command prints, all of it, up to
//! <!-- end -->
//! ```
//! How long something took is told as `…`.
//!
//! `UPDATE=1` writes the lines and the pictures anew.

use crate::common::prelude::*;

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

fn pages() -> Vec<(PathBuf, String)> {
    let paths = files(Path::new(ROOT).join("docs"), "md").into_iter().chain([Path::new(ROOT).join("README.md")]);
    paths.map(|path| (path.clone(), fs::read_to_string(path).expect("readable"))).collect()
}

/// What a command of a page prints on its output, line by line.
fn printed(command: &str, folder: &Path) -> Vec<String> {
    let program = Path::new(env!("CARGO_BIN_EXE_stampflow")).parent().expect("a folder");
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap_or_default());
    let mut shell = Command::new("sh");
    let shell = shell.envs([("PATH", path.as_str()), ("COLUMNS", "80"), ("NO_COLOR", "1")]);
    let done = shell.args(["-c", command]).current_dir(folder).output().expect("a shell");
    assert!(done.status.success(), "{command}: {}", String::from_utf8_lossy(&done.stderr));
    let time = Regex::new(r" in [0-9.]+ (ms|s|min|h)\b").expect("a pattern");
    let lines = String::from_utf8_lossy(&done.stdout).into_owned();
    lines.lines().map(|line| time.replace(line.trim_end(), " in … $1").into_owned()).collect()
}

/// The page as it would be if its commands were run now, and its pictures: their places in the book and what was drawn.
fn made_anew(page: &str) -> (String, Vec<(PathBuf, Vec<u8>)>) {
    let folder = TempDir::new().expect("writable");
    let done = Command::new("cp").args(["-r", "cases", "reference_data"]).arg(folder.path()).current_dir(ROOT).status();
    assert!(done.expect("runs").success());
    let directive = Regex::new(r"^<!-- (file|picture): (\S+) as (\S+) -->$").expect("a pattern");
    let markdown = Regex::new(r"^<!-- printed: (.+) -->$").expect("a pattern");
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
        if let Some(parts) = markdown.captures(line) {
            anew += &format!("{}\n", printed(&parts[1], folder.path()).join("\n"));
            while lines.peek().unwrap_or_else(|| panic!("no end of {line}")) != &"<!-- end -->" {
                lines.next();
            }
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
    let wrong = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for (path, page) in pages() {
            let wrong = &wrong;
            scope.spawn(move || {
                let (anew, pictures) = made_anew(&page);
                if update {
                    fs::write(&path, &anew).expect("writable");
                    for (path, drawn) in &pictures {
                        fs::write(path, drawn).expect("writable");
                    }
                }
                let mut found = Vec::new();
                if page != anew {
                    let (old, new) = page.lines().zip(anew.lines()).find(|(old, new)| old != new).unwrap_or_default();
                    found.push(format!("{}:\n  shown   {old}\n  printed {new}", path.display()));
                }
                for (path, drawn) in pictures {
                    let share = fs::read(&path).map_or(1.0, |shown| difference(&shown, &drawn));
                    if share > 0.01 {
                        found.push(format!("{}: {:.1} % of it is drawn otherwise", path.display(), 100.0 * share));
                    }
                }
                wrong.lock().expect("whole").extend(found);
            });
        }
    });
    let wrong = wrong.into_inner().expect("whole");
    assert!(wrong.is_empty(), "run with UPDATE=1 where that is meant:\n{}", wrong.join("\n"));
}

/// Trust: the files themselves.
#[test]
fn every_page_is_in_the_summary_and_every_link_and_picture_is_there() {
    let summary = include_str!("../../docs/SUMMARY.md");
    let link = Regex::new(r"\]\(([^)#]+)(?:#[^)]*)?\)").expect("a pattern");
    let mut missing = Vec::new();
    for (page, text) in pages() {
        let name = page.file_name().expect("a name").to_string_lossy().into_owned();
        if !["SUMMARY.md", "README.md"].contains(&name.as_str()) && !summary.contains(&format!("({name})")) {
            missing.push(format!("SUMMARY.md has no {name}"));
        }
        for target in link.captures_iter(&text).map(|parts| parts[1].to_owned()) {
            if !target.starts_with("http") && !page.with_file_name(&target).exists() {
                missing.push(format!("{name} leads to {target}, which is not there"));
            }
        }
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

/// Trust: the files themselves; what no command makes is old one day and nobody sees it.
#[test]
fn every_picture_is_made_by_a_command_of_a_page_and_shown() {
    let book: String = pages().into_iter().map(|(_, text)| text).collect();
    for path in files(Path::new(ROOT).join("docs"), "png") {
        let name = path.file_name().expect("a name").to_string_lossy();
        let is_made = book.contains(&format!(" as {name} -->"));
        let is_shown = book.contains(&format!("({name})")) || book.contains(&format!("(docs/{name})"));
        assert!(is_made && is_shown, "{name}");
    }
}

/// Trust: the rules of prose. Code, comments, equations, headings, tables and pictures are no prose.
#[test]
fn a_page_has_18_words_a_sentence_in_the_mean_and_80_a_paragraph_at_most() {
    let rest = Regex::new(r"(?ms)^```.*?^```$|<!--.*?-->|^\$\$.*?\$\$$|^[#|<!].*?$").expect("a pattern");
    let end = Regex::new(r"[.!?][)*”]*\s").expect("a pattern");
    let paragraph = Regex::new(r"\n\s*(?:\n|[*-] |\d+\. )").expect("a pattern");
    let words = |text: &str| text.split_whitespace().filter(|word| word.contains(char::is_alphanumeric)).count();
    for (page, text) in pages() {
        let prose = rest.replace_all(&text, "\n");
        let sentences = paragraph.split(&prose).flat_map(|text| end.split(text)).filter(|text| words(text) > 0).count();
        let mean = words(&prose) as f64 / sentences as f64;
        let longest = paragraph.split(&prose).map(words).max().unwrap_or(0);
        assert!(mean <= 18.0 && longest <= 80, "{}: {mean:.1} a sentence, {longest} a paragraph", page.display());
    }
}

/// Trust: the code itself: `src/state.rs` is a file of it and `src/state.rs::State` a thing that the file defines.
#[test]
fn what_a_page_names_of_the_code_is_there() {
    let name = Regex::new(r"`((?:src|tests|benches|cases)/[\w./-]+?)(?:::(\w+))?`").expect("a pattern");
    let (mut missing, mut items) = (Vec::new(), 0);
    for (page, text) in pages() {
        for parts in name.captures_iter(&text) {
            let path = Path::new(ROOT).join(&parts[1]);
            let is_there = match parts.get(2) {
                None => path.exists(),
                Some(item) => {
                    items += 1;
                    let defined = format!(r"\b(fn|struct|enum|trait|const|mod|type) {}\b", item.as_str());
                    Regex::new(&defined).expect("a pattern").is_match(&fs::read_to_string(&path).unwrap_or_default())
                }
            };
            if !is_there {
                missing.push(format!("{} names {}", page.display(), &parts[0]));
            }
        }
    }
    assert!(missing.is_empty() && items > 20, "{items} items; {}", missing.join("\n"));
}

/// Trust: the files of the findings: each that is judged or warned of has its row, with the words and the key of its file.
#[test]
fn every_finding_has_a_row_on_the_page_of_the_verdict() {
    let page = fs::read_to_string(Path::new(ROOT).join("docs/verdict.md")).expect("shipped");
    let made = Regex::new(r#"(?:judged|warning|rated|doubted)\(\s*"([a-z_]+)",\s*"([^"]+)""#).expect("a pattern");
    let mut found = 0;
    for path in files("src/assess", "rs") {
        for parts in made.captures_iter(&fs::read_to_string(&path).expect("readable")) {
            let row = format!("\n| {} `{}` |", &parts[2], &parts[1]);
            assert!(page.contains(&row), "{} makes {row}", path.display());
            found += 1;
        }
    }
    assert!(found > 45, "{found} findings");
}
