//! Who may know whom: rooms use only what lies below them, and each outside crate has its room.

use crate::common::prelude::*;
use crate::house::rooms;

/// Rooms of `src/` from the top down; a room may use those on its own line (itself) and on lines below.
fn floors() -> Vec<Vec<&'static str>> {
    let rows = include_str!("../../docs/developer.md").lines();
    let rows = rows.filter_map(|line| line.strip_prefix("| `")?.split_once("` |"));
    rows.map(|(rooms, _)| rooms.split("`, `").collect()).collect()
}

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

#[test]
fn rooms_use_only_what_lies_below() {
    let (files, floors, sideways) = (sources(), floors(), rooms().sideways);
    let floor = |room: &str| {
        floors.iter().position(|f| f.contains(&room)).unwrap_or_else(|| panic!("room {room} is on no floor"))
    };
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
            if from == room || sideways.get(from).is_some_and(|rooms| rooms.iter().any(|one| one == room)) {
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
    let (mut wrong, crates) = (Vec::new(), rooms().crates);
    for file in sources() {
        for (name, _) in crates.iter().filter(|(_, rooms)| !rooms.split(' ').any(|room| room == file.room())) {
            let named = Regex::new(&format!(r"(^|[^:.\w]){name}::")).expect("a pattern");
            if named.is_match(&file.code) {
                wrong.push(format!("{} knows {name}", file.path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Trust: written out by hand; so that the other tests see what they judge.
#[test]
fn paths_are_read_where_they_reach_the_root() {
    let text =
        "use crate::a::{self, b};\n// crate::c::d\nlet x = super::super::g::h(1) + crate::I::new() + super::k::l();";
    let file = File { path: PathBuf::new(), module: vec!["x".into(), "y".into()], code: code(text) };
    assert_eq!(file.uses().into_iter().collect::<Vec<_>>(), ["I::new", "a::", "g::h"]);
}
