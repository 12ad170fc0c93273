//! Who may know whom: rooms use only what lies below them, files never go round in a circle, and each outside crate has
//! its room.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Rooms of `src/` from the top down; a room may use those on its own line (itself) and on lines below.
const FLOORS: &[&[&str]] = &[
    &["main", "cli"],
    &["author", "import", "report"],
    &["study"],
    &["results"],
    &["plot"],
    &["assess"],
    &["case"],
    &["measure", "table"],
    &["solver"],
    &["model"],
    &["element", "contact"],
    &["geometry", "material", "forming_limit"],
    &["numerics", "units"],
];

/// Sideways uses that the picture allows.
const SIDEWAYS: &[(&str, &str)] = &[("main", "cli"), ("author", "import"), ("forming_limit", "material")];

/// Upward uses that stand: error bars are values of `study/verify`, which tables and pictures show.
const KNOWN_UPWARD: &[(&str, &str)] =
    &[("results/", "study/verify/mod.rs"), ("plot/stage_view.rs", "study/verify/mod.rs")];

/// Circles that stand: the beginnings of the paths of their files, and the reason.
const KNOWN_CIRCLES: &[(&[&str], &str)] = &[
    (&["assess/"], "findings share the run's numbers, and the run lists the findings"),
    (&["author/from_drawing"], "a drawing's sizes and the case that is made of them"),
    (&["author/templates/"], "templates and their list"),
    (&["case/build/"], "tools that are derived from other tools"),
    (&["case/complaint.rs", "case/source.rs"], "errors show the text that they are of"),
    (&["cli/code.rs", "cli/say.rs", "cli/table.rs"], "printing returns an exit code"),
    (&["element/kinematics.rs", "element/surface.rs"], "stations lie on elements, whose contact areas are theirs"),
    (&["plot/chart.rs", "plot/palette.rs"], "looks have colours, and colours looks"),
    (&["plot/svg/"], "parts of one drawing"),
    (&["report/"], "sections of one page"),
    (&["results/"], "tables and the list of all outputs"),
    (&["study/charts.rs", "study/scatter.rs", "study/sweep.rs"], "studies and their charts"),
    (
        &["study/evaluate.rs", "study/report.rs", "study/run_table.rs", "study/shard.rs"],
        "runs and the table that they go to",
    ),
];

/// Outside crates and the rooms that alone may name them.
const CRATES: &[(&str, &[&str])] = &[
    ("ab_glyph", &["plot"]),
    ("anyhow", &["cli", "main"]),
    ("clap", &["cli", "main"]),
    ("comfy_table", &["cli"]),
    ("contour", &["study"]),
    ("csv", &["results", "study", "table"]),
    ("fontdb", &["plot"]),
    ("gif", &["plot"]),
    ("indicatif", &["cli"]),
    ("maud", &["report"]),
    ("miette", &["case"]),
    ("plotters", &["plot"]),
    ("plotters_backend", &["plot"]),
    ("png", &["plot"]),
    ("rayon", &["cli", "results", "study"]),
    ("resvg", &["plot"]),
    ("rustix", &["results"]),
    ("serde_json", &["author", "case", "cli", "material", "plot", "report", "results", "study"]),
    ("sha2", &["case"]),
    ("signal_hook", &["cli"]),
    ("sobol_burley", &["study"]),
    ("statrs", &["study"]),
    ("textwrap", &["cli"]),
    ("tiny_skia", &["plot"]),
    ("toml", &["case", "study"]),
    ("toml_edit", &["author", "case", "study"]),
    ("usvg", &["plot"]),
];

/// A file of `src/`: its module path, its text without tests and comments, and the modules below it.
struct File {
    path: PathBuf,
    module: Vec<String>,
    code: String,
}

impl File {
    fn room(&self) -> &str {
        self.module.first().map_or("lib", String::as_str)
    }
}

fn sources() -> Vec<File> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let (mut folders, mut files) = (vec![root.clone()], Vec::new());
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("readable") {
            let path = entry.expect("readable").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") && !path.ends_with("tests.rs") {
                let inside = path.strip_prefix(&root).expect("below src").with_extension("");
                let mut module: Vec<String> = inside.iter().map(|part| part.to_string_lossy().into_owned()).collect();
                if matches!(module.last().map(String::as_str), Some("mod" | "lib")) {
                    module.pop();
                }
                let code = code(&fs::read_to_string(&path).expect("readable"));
                files.push(File { path: path.strip_prefix(&root).expect("below src").to_owned(), module, code });
            }
        }
    }
    files.sort_by(|a, b| a.path.cmp(&b.path));
    files
}

/// A text without its tests, comments and strings.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]").next().expect("a first part");
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    let mut code = String::new();
    for line in lines {
        for (i, part) in line.split('"').enumerate() {
            if i % 2 == 0 {
                code += part;
            }
        }
        code.push('\n');
    }
    code
}

/// All paths that begin at one of the given words, braces written out: `a::{b, c::d as e}` is `a::b`, `a::c::d`.
fn paths(code: &str, is_start: impl Fn(&str) -> bool) -> Vec<Vec<String>> {
    let mut found = Vec::new();
    let bytes = code.as_bytes();
    let mut at = 0;
    while at < code.len() {
        let Some(len) = word(&code[at..]) else {
            at += code[at..].chars().next().map_or(1, char::len_utf8);
            continue;
        };
        let name = &code[at..at + len];
        let continues = at >= 2 && &bytes[at - 2..at] == b"::" || at >= 1 && bytes[at - 1] == b'.';
        if !continues && code[at + len..].starts_with("::") && is_start(name) {
            tree(&code[at..], &mut Vec::new(), &mut found);
        }
        at += len;
    }
    found
}

/// Length of the identifier that a text begins with.
fn word(text: &str) -> Option<usize> {
    let len = text.find(|c: char| !(c.is_alphanumeric() || c == '_')).unwrap_or(text.len());
    (len > 0).then_some(len)
}

/// Reads one path or brace, adds what it leads to, and returns what follows.
fn tree<'a>(text: &'a str, before: &mut Vec<String>, found: &mut Vec<Vec<String>>) -> &'a str {
    let text = text.trim_start();
    if let Some(mut rest) = text.strip_prefix('{') {
        loop {
            rest = rest.trim_start();
            if let Some(after) = rest.strip_prefix('}') {
                return after;
            }
            if rest.is_empty() {
                return rest;
            }
            rest = tree(rest, before, found);
            let end = rest.find([',', '}', '\n']).unwrap_or(rest.len());
            rest = rest[end..].trim_start_matches(',');
        }
    }
    let Some(len) = word(text) else {
        found.push(before.clone());
        return text.strip_prefix('*').unwrap_or(text.get(1..).unwrap_or(""));
    };
    before.push(text[..len].to_owned());
    let rest = match text[len..].strip_prefix("::") {
        Some(rest) if !rest.starts_with('<') => tree(rest, before, found),
        _ => {
            found.push(before.clone());
            &text[len..]
        }
    };
    before.pop();
    rest
}

/// The modules of the crate, and the names that they hand on.
struct House {
    files: Vec<File>,
    modules: BTreeMap<Vec<String>, usize>,
    handed_on: BTreeMap<(Vec<String>, String), Vec<String>>,
}

impl House {
    fn new() -> Self {
        let files = sources();
        let modules: BTreeMap<_, _> = files.iter().enumerate().map(|(i, file)| (file.module.clone(), i)).collect();
        let mut house = Self { files, modules, handed_on: BTreeMap::new() };
        for i in 0..house.files.len() {
            let file = &house.files[i];
            for statement in file.code.split(';').filter(|s| s.contains("pub use ") || s.contains(") use ")) {
                let statement = &statement[statement.rfind("use ").map_or(0, |at| at + 4)..];
                let mut found = Vec::new();
                tree(statement, &mut Vec::new(), &mut found);
                for path in found.into_iter().filter(|path| !path.is_empty()) {
                    let target = house.absolute(&house.files[i].module, &path);
                    let name = path.last().expect("a name").clone();
                    house.handed_on.insert((house.files[i].module.clone(), name), target);
                }
            }
        }
        house
    }

    /// A path from the root of the crate.
    fn absolute(&self, module: &[String], path: &[String]) -> Vec<String> {
        match path.first().map_or("", String::as_str) {
            "crate" | "stampflow" => path[1..].to_vec(),
            "self" => [module, &path[1..]].concat(),
            "super" => {
                let ups = path.iter().take_while(|p| *p == "super").count();
                [&module[..module.len().saturating_sub(ups)], &path[ups..]].concat()
            }
            _ => [module, path].concat(),
        }
    }

    /// The file in which the item at the end of a path from the root is defined.
    fn file_of(&self, path: &[String], depth: usize) -> Option<usize> {
        let known = (0..=path.len()).rev().find(|&n| self.modules.contains_key(&path[..n]))?;
        let module = path[..known].to_vec();
        if let (Some(name), true) = (path.get(known), depth < 8)
            && let Some(target) = self.handed_on.get(&(module.clone(), name.clone()))
        {
            return self.file_of(&[target, &path[known + 1..]].concat(), depth + 1);
        }
        self.modules.get(&module).copied()
    }

    /// The files that a file uses.
    fn uses(&self, i: usize) -> BTreeSet<usize> {
        let file = &self.files[i];
        let below = |name: &str| self.modules.contains_key(&[file.module.as_slice(), &[name.to_owned()]].concat());
        let handed = file.code.split(';').filter(|s| !(s.contains("pub use ") || s.contains(") use ")));
        let own = handed.collect::<Vec<_>>().join(";");
        let is_start = |name: &str| matches!(name, "crate" | "stampflow" | "self" | "super") || below(name);
        let used = paths(&own, is_start).into_iter().filter_map(|path| {
            let path = self.absolute(&file.module, &path);
            self.file_of(&path, 0)
        });
        used.filter(|&j| j != i).collect()
    }
}

fn floor(room: &str) -> usize {
    FLOORS.iter().position(|f| f.contains(&room)).unwrap_or_else(|| panic!("room {room} is on no floor"))
}

#[test]
fn rooms_use_only_what_lies_below() {
    let house = House::new();
    let mut wrong = BTreeSet::new();
    for (i, file) in house.files.iter().enumerate().filter(|(_, file)| file.room() != "lib") {
        for j in house.uses(i) {
            let (from, to) = (file.room(), house.files[j].room());
            let (path, used) = (file.path.to_string_lossy(), house.files[j].path.to_string_lossy());
            let known = KNOWN_UPWARD.iter().any(|(begin, file)| path.starts_with(begin) && used == *file);
            let allowed = from == to || to == "lib" || floor(from) < floor(to) || SIDEWAYS.contains(&(from, to));
            if !allowed && !known {
                wrong.insert(format!("{} uses {}", file.path.display(), house.files[j].path.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn no_files_go_round_in_a_circle() {
    let house = House::new();
    let uses: Vec<BTreeSet<usize>> = (0..house.files.len()).map(|i| house.uses(i)).collect();
    let reached = |from: usize| {
        let (mut seen, mut open) = (BTreeSet::new(), vec![from]);
        while let Some(i) = open.pop() {
            open.extend(uses[i].iter().copied().filter(|j| seen.insert(*j)));
        }
        seen
    };
    let reached: Vec<_> = (0..uses.len()).map(reached).collect();
    let mut circles = BTreeSet::new();
    for i in 0..uses.len() {
        let circle: Vec<usize> =
            (0..uses.len()).filter(|&j| reached[i].contains(&j) && reached[j].contains(&i)).collect();
        let circle: Vec<String> = circle.iter().map(|&j| house.files[j].path.display().to_string()).collect();
        let is_of = |begins: &[&str]| circle.iter().all(|path| begins.iter().any(|begin| path.starts_with(begin)));
        if circle.len() > 1 && !KNOWN_CIRCLES.iter().any(|(begins, _)| is_of(begins)) {
            circles.insert(circle);
        }
    }
    assert!(circles.is_empty(), "{} circles: {circles:#?}", circles.len());
}

#[test]
fn outside_crates_have_their_rooms() {
    let files = sources();
    let mut wrong = Vec::new();
    for (name, rooms) in CRATES {
        for file in files.iter().filter(|file| !rooms.contains(&file.room())) {
            if !paths(&file.code, |start| start == *name).is_empty() {
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
fn paths_are_read_through_braces_and_aliases() {
    let text = "use crate::a::{self, b::{C, D as E}, f};\nlet x = super::super::g::h(1) + crate::I::new();";
    let found: Vec<String> =
        paths(text, |name| matches!(name, "crate" | "super")).iter().map(|p| p.join("::")).collect();
    assert_eq!(
        found,
        ["crate::a::self", "crate::a::b::C", "crate::a::b::D", "crate::a::f", "super::super::g::h", "crate::I::new"]
    );
    let house = House::new();
    let file = |path: &str| house.files.iter().position(|f| f.path.ends_with(path)).expect("a file");
    let written = |path: &[&str]| path.iter().map(|p| (*p).to_owned()).collect::<Vec<_>>();
    assert_eq!(
        house.file_of(&written(&["numerics", "PiecewiseLinear"]), 0),
        Some(file("numerics/piecewise_linear.rs"))
    );
    assert!(house.uses(file("model/mesh.rs")).contains(&file("model/mod.rs")));
}
