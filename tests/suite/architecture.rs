//! Who may know whom: rooms use only what lies below them, and each outside crate has its room.

use crate::common::prelude::*;

/// Rooms of `src/` from the top down; a room may use those on its own line (itself) and on lines below.
const FLOORS: &[&[&str]] = &[
    &["main", "cli", "author", "import"],
    &["study", "report"],
    &["results", "plot"],
    &["assess"],
    &["case"],
    &["solver", "measure", "table"],
    &["model"],
    &["element", "contact"],
    &["geometry", "material", "forming_limit"],
    &["numerics", "units"],
];

/// Uses on one floor, each in one direction only.
const SIDEWAYS: &[(&str, &str)] = &[
    ("main", "cli"),
    ("cli", "author"),
    ("cli", "import"),
    ("author", "import"),
    ("report", "study"),
    ("results", "plot"),
    ("measure", "solver"),
    ("forming_limit", "material"),
];

/// Rooms, and the outside crates that they alone may name.
const CRATES: &[(&str, &str)] = &[
    ("author case cli material plot report results study", "serde_json"),
    ("author case study", "toml_edit"),
    ("case", "miette sha2"),
    ("author case study", "toml"),
    ("cli", "comfy_table indicatif signal_hook"),
    ("cli main", "anyhow clap"),
    ("cli results study", "rayon"),
    ("cli plot", "textwrap"),
    ("plot", "ab_glyph fontdb gif kurbo plotters png resvg tiny_skia usvg"),
    ("report", "maud"),
    ("results", "rustix"),
    ("results study table", "csv"),
    ("study", "contour sobol_burley"),
    ("numerics study", "statrs"),
];

/// A file of `src/`: its path, its modules, and its text without tests, comments and strings.
struct File {
    path: PathBuf,
    module: Vec<String>,
    code: String,
}

impl File {
    fn room(&self) -> &str {
        self.module.first().map_or("lib", String::as_str)
    }

    /// Paths from the root of the crate that the file names, two words long: `results::folder`.
    fn uses(&self) -> BTreeSet<String> {
        let path = Regex::new(r"\b((?:crate::)|(?:stampflow::)|(?:super::)+)(\w+)(?:::(\w+))?").expect("a pattern");
        let reaches_root = |start: &str| match start.matches("super").count() {
            0 => true,
            ups => ups >= self.module.len(),
        };
        let all = path.captures_iter(&self.code).filter(|parts| reaches_root(&parts[1]));
        all.map(|parts| format!("{}::{}", &parts[2], parts.get(3).map_or("", |word| word.as_str()))).collect()
    }
}

fn sources() -> Vec<File> {
    let files = below("src", "rs").into_iter().filter(|path| !path.ends_with("tests.rs")).map(|path| {
        let inside = path.strip_prefix(concat!(env!("CARGO_MANIFEST_DIR"), "/src")).expect("below src").to_owned();
        let parts = inside.with_extension("");
        let parts = parts.iter().map(|part| part.to_string_lossy().into_owned());
        let module = parts.filter(|part| !["mod", "lib"].contains(&part.as_str())).collect();
        File { path: inside, module, code: code(&fs::read_to_string(&path).expect("readable")) }
    });
    files.collect()
}

fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]").next().expect("a first part");
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines.map(|line| line.split('"').step_by(2).collect::<String>() + "\n").collect()
}

fn floor(room: &str) -> usize {
    FLOORS.iter().position(|f| f.contains(&room)).unwrap_or_else(|| panic!("room {room} is on no floor"))
}

#[test]
fn rooms_use_only_what_lies_below() {
    let files = sources();
    let library = &files.iter().find(|file| file.room() == "lib").expect("lib.rs").code;
    let handed_on = |name: &str| library.lines().find(|line| line.starts_with("pub use") && line.contains(name));
    let (mut wrong, mut seen) = (BTreeSet::new(), 0);
    for file in files.iter().filter(|file| file.room() != "lib") {
        let from = file.room();
        for used in file.uses() {
            let name = used.split("::").next().expect("a name");
            let room = if name.starts_with(char::is_lowercase) {
                name
            } else {
                handed_on(name).and_then(|line| line["pub use ".len()..].split("::").next()).unwrap_or(name)
            };
            if from == room || SIDEWAYS.contains(&(from, room)) {
                continue;
            }
            seen += 1;
            if floor(from) >= floor(room) {
                wrong.insert(format!("{} uses {used}", file.path.display()));
            }
        }
    }
    assert!(wrong.is_empty() && seen > 200, "{seen} uses, {wrong:#?}");
}

#[test]
fn outside_crates_have_their_rooms() {
    let mut wrong = Vec::new();
    for file in sources() {
        let others = CRATES.iter().filter(|(rooms, _)| !rooms.split(' ').any(|room| room == file.room()));
        for name in others.flat_map(|(_, crates)| crates.split(' ')) {
            let named = Regex::new(&format!(r"(^|[^:.\w]){name}::")).expect("a pattern");
            if named.is_match(&file.code) {
                wrong.push(format!("{} knows {name}", file.path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Trust: [`FLOORS`], from the top down.
#[test]
fn the_developers_guide_has_the_map() {
    let page = include_str!("../../docs/developer.md");
    let rows = page.lines().filter_map(|line| line.strip_prefix("| `")?.split_once("` |"));
    let map: Vec<Vec<&str>> = rows.map(|(rooms, _)| rooms.split("`, `").collect()).collect();
    assert_eq!(map, FLOORS);
}

/// Trust: written out by hand; so that the other tests see what they judge.
#[test]
fn paths_are_read_where_they_reach_the_root() {
    let text =
        "use crate::a::{self, b};\n// crate::c::d\nlet x = super::super::g::h(1) + crate::I::new() + super::k::l();";
    let file = File { path: PathBuf::new(), module: vec!["x".into(), "y".into()], code: code(text) };
    assert_eq!(file.uses().into_iter().collect::<Vec<_>>(), ["I::new", "a::", "g::h"]);
}
