//! Text of a case with the place of every key: reads it, words its errors, collects notes.

use super::files::Folder;
use super::schema::example;
use super::{CaseError, CaseFile, complaint};
use crate::units::{Dimensioned, Length, thicknesses};
use miette::NamedSource;
use serde::Deserialize;
use std::cell::RefCell;
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer};

/// Most entries of lists, by the end of their path.
const LISTS: [(&str, usize); 8] = [
    ("beads", 20),
    ("notes", 50),
    ("compare", 50),
    ("band", 20),
    ("output.frames", 1000),
    ("forming_limit.points", 1000),
    ("punch.motion", 1000),
    ("profile", 2000),
];

/// Longest title and longest other text, which plots and messages repeat \[characters\].
const TITLE: usize = 200;
const TEXT: usize = 1000;

/// Parsed TOML text of a case.
pub(super) struct Source<'t> {
    shown: Arc<NamedSource<String>>,
    text: &'t str,
    tree: Spanned<DeTable<'t>>,
    /// Base folder of the files that the case names.
    pub folder: Folder<'t>,
    notes: RefCell<Vec<String>>,
    /// Index and name of the later stage to which `tools.…` refers.
    stage: RefCell<Option<(usize, String)>>,
}

impl<'t> Source<'t> {
    /// Parses the text as TOML.
    pub fn parse(name: &str, text: &'t str, folder: Folder<'t>) -> Result<Self, CaseError> {
        let shown = Arc::new(NamedSource::new(name, text.to_owned()));
        match DeTable::parse(text) {
            Ok(mut tree) => {
                resolve_thicknesses(tree.get_mut());
                Ok(Self { shown, text, tree, folder, notes: RefCell::default(), stage: RefCell::default() })
            }
            Err(error) => Err(complaint::not_toml(&error, text, shown)),
        }
    }

    /// Deserializes the keys, each in its own type.
    pub fn read(&self) -> Result<CaseFile, CaseError> {
        if self.tree.get_ref().is_empty() {
            let what = if self.text.trim().is_empty() { "the file is empty" } else { "the file holds comments only" };
            let help = "a case needs title, geometry, [blank], a law such as [material.hardening.swift], [tools.punch] \
                        and mostly [tools.die] and [tools.holder]; begin with a copy of cases/quickstart.toml";
            return Err(self.error_at(0..0, what.into(), "here".into(), help.into()));
        }
        let file = CaseFile::deserialize(Deserializer::from(self.tree.clone()));
        let file = file.map_err(|error| complaint::wrong_key(&error, self))?;
        self.check_lengths("", &DeValue::Table(self.tree.get_ref().clone()))?;
        Ok(file)
    }

    /// Refuses lists and texts that are longer than any case needs.
    fn check_lengths(&self, path: &str, value: &DeValue) -> Result<(), CaseError> {
        let deeper = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
        match value {
            DeValue::Table(table) => {
                table.iter().try_for_each(|(key, value)| self.check_lengths(&deeper(key.get_ref()), value.get_ref()))
            }
            DeValue::Array(list) => {
                let most = LISTS.iter().find(|(key, _)| path.ends_with(key)).map_or(usize::MAX, |(_, most)| *most);
                let what = format!("`{path}` has {} entries, more than {most}", list.len());
                self.require(list.len() <= most, &deeper(&most.to_string()), what, "leave out what is not needed")?;
                let mut entries = list.iter().enumerate();
                entries.try_for_each(|(i, value)| self.check_lengths(&deeper(&i.to_string()), value.get_ref()))
            }
            DeValue::String(text) => {
                let (length, most) = (text.chars().count(), if path == "title" { TITLE } else { TEXT });
                let what = format!("`{path}` has {length} characters, more than {most}");
                self.require(length <= most, path, what, "plots and messages repeat it: keep it short")
            }
            _ => Ok(()),
        }
    }

    /// Adds a note on what was assumed or changed.
    pub fn note(&self, note: impl Into<String>) {
        let note = match &*self.stage.borrow() {
            Some((_, name)) => format!("stage {name}: {}", note.into()),
            None => note.into(),
        };
        self.notes.borrow_mut().push(note);
    }

    /// Runs a function whose notes are dropped.
    pub fn silently<T>(&self, run: impl FnOnce() -> T) -> T {
        let before = self.notes.borrow().len();
        let result = run();
        self.notes.borrow_mut().truncate(before);
        result
    }

    /// Removes and returns the notes.
    pub fn take_notes(&self) -> Vec<String> {
        self.notes.take()
    }

    /// Lets `tools.…` refer to the tools of a later stage, counted from 0; `None` for the first stage.
    pub fn enter_stage(&self, stage: Option<(usize, &str)>) {
        *self.stage.borrow_mut() = stage.map(|(i, name)| (i, name.to_owned()));
    }

    /// Key path in the whole case.
    fn whole(&self, path: &str) -> String {
        if let (Some((i, _)), Some(rest)) = (&*self.stage.borrow(), path.strip_prefix("tools.")) {
            let tool = rest.split('.').next().unwrap_or(rest);
            if self.locate(&format!("stages.{i}.{tool}")).1 {
                return format!("stages.{i}.{rest}");
            }
        }
        path.to_owned()
    }

    /// Error at a dotted key path, array entries by index; a missing key is shown at its table.
    pub fn error(&self, path: &str, what: impl Into<String>, help: impl Into<String>) -> CaseError {
        let path = self.whole(path);
        let path = diameter_key(&path).filter(|twin| !self.locate(&path).1 && self.locate(twin).1).unwrap_or(path);
        let (span, _) = self.locate(&path);
        let label = if path.is_empty() { "here".into() } else { path };
        self.error_at(span, what.into(), label, help.into())
    }

    /// Returns [`error`](Self::error) unless `ok`.
    pub fn require(
        &self,
        ok: bool,
        path: &str,
        what: impl Into<String>,
        help: impl Into<String>,
    ) -> Result<(), CaseError> {
        if ok { Ok(()) } else { Err(self.error(path, what, help)) }
    }

    /// Those of some keys of a table that the case writes.
    pub fn written<'k>(&self, table: &str, keys: &[&'k str]) -> Vec<&'k str> {
        keys.iter().copied().filter(|key| self.has(&format!("{table}.{key}"))).collect()
    }

    /// Refuses the first written one of some keys of a table; `why` follows its name.
    pub fn refuse(&self, table: &str, keys: &[&str], why: &str, help: &str) -> Result<(), CaseError> {
        let key = self.written(table, keys).first().copied().unwrap_or("");
        self.require(key.is_empty(), &format!("{table}.{key}"), format!("`{key}` {why}"), help)
    }

    /// Refuses the second written one of some keys of a table.
    pub fn one_of(&self, table: &str, keys: &[&str], help: &str) -> Result<(), CaseError> {
        match self.written(table, keys)[..] {
            [first, second, ..] => {
                Err(self.error(&format!("{table}.{second}"), format!("both `{first}` and `{second}` are given"), help))
            }
            _ => Ok(()),
        }
    }

    /// Error for a missing key, with a line that could be added.
    pub fn missing(&self, table: &str, key: &str) -> CaseError {
        let (path, name) = match table {
            "" => (key.to_owned(), "the case".to_owned()),
            _ => (format!("{table}.{key}"), format!("[{table}]")),
        };
        let help =
            example(&path).map_or_else(|| format!("add it: [{path}]"), |line| format!("add a line such as {line}"));
        self.error(table, format!("`{key}` is missing in {name}"), help)
    }

    /// Error at a range of bytes.
    pub fn error_at(&self, span: Range<usize>, what: String, label: String, help: String) -> CaseError {
        CaseError::at(self.shown.clone(), span, what, label, help)
    }

    /// True if the key is in the text.
    pub fn has(&self, path: &str) -> bool {
        self.locate(&self.whole(path)).1
    }

    /// Span of the deepest written part of a path, and whether the whole path was written.
    fn locate(&self, path: &str) -> (Range<usize>, bool) {
        let (mut span, mut here) = (0..0, None);
        for segment in path.split('.') {
            let table = here.map_or(Some(self.tree.get_ref()), DeValue::as_table);
            let array = here.and_then(DeValue::as_array).zip(segment.parse::<usize>().ok());
            let entry = table.and_then(|table| table.get_key_value(segment)).map(|(key, value)| (key.span(), value));
            let entry = entry.or_else(|| array.and_then(|(array, i)| array.get(i)).map(|value| (value.span(), value)));
            let Some((key, value)) = entry else { return (span, false) };
            // A table or a long array is shown by its key, so that the message stays short.
            let one_line = !self.text[value.span()].contains('\n');
            span = if one_line && !value.span().is_empty() { value.span() } else { key };
            here = Some(value.get_ref());
        }
        (span, true)
    }

    /// Key path whose key or value has exactly this span; `None` for the whole file.
    pub fn path_at(&self, span: &Range<usize>) -> Option<String> {
        path_in_table(self.tree.get_ref(), span)
    }
}

fn path_in_table(table: &DeTable, span: &Range<usize>) -> Option<String> {
    table.iter().find_map(|(key, value)| {
        let name = key.get_ref();
        if key.span() == *span { Some(name.to_string()) } else { path_in_value(name, value, span) }
    })
}

fn path_in_value(name: &str, value: &Spanned<DeValue>, span: &Range<usize>) -> Option<String> {
    if value.span() == *span {
        return Some(name.to_owned());
    }
    let rest = match value.get_ref() {
        DeValue::Table(table) => path_in_table(table, span),
        DeValue::Array(entries) => {
            entries.iter().enumerate().find_map(|(i, entry)| path_in_value(&i.to_string(), entry, span))
        }
        _ => None,
    };
    Some(format!("{name}.{}", rest?))
}

/// Keys of lengths from the axis, each with the key of its diameter.
const DIAMETERS: [(&str, &str); 5] = [
    ("radius", "diameter"),
    ("throat", "throat_diameter"),
    ("inner_radius", "inner_diameter"),
    ("at", "diameter"),
    ("trim", "trim_diameter"),
];

/// Path of the diameter that may be given instead of a radius.
fn diameter_key(path: &str) -> Option<String> {
    let (table, key) = path.rsplit_once('.')?;
    let (_, diameter) = DIAMETERS.iter().find(|(radius, _)| *radius == key)?;
    Some(format!("{table}.{diameter}"))
}

/// True if two keys of a table give the same length, one from the axis and one across.
pub(super) fn is_radius_and_diameter(one: &str, other: &str) -> bool {
    DIAMETERS.iter().any(|pair| *pair == (one, other) || *pair == (other, one))
}

/// Keys of texts, in which "6 t" is no length, and of forces, in which "250 t" is no length either.
const NO_LENGTHS: [&str; 8] = ["title", "notes", "name", "source", "file", "quantity", "force", "preload"];

/// Replaces lengths in thicknesses of the blank, "6 t", by millimetres.
fn resolve_thicknesses(tree: &mut DeTable) {
    let blank = tree.get("blank").and_then(|blank| blank.get_ref().as_table());
    let thickness = blank.and_then(|blank| blank.get("thickness")?.get_ref().as_str()?.parse::<Length>().ok());
    if let Some(thickness) = thickness {
        tree.iter_mut().for_each(|(key, value)| resolve(key.get_ref(), value.get_mut(), thickness.value()));
    }
}

fn resolve(key: &str, value: &mut DeValue, thickness: f64) {
    match value {
        DeValue::Table(table) => {
            table.iter_mut().for_each(|(key, value)| resolve(key.get_ref(), value.get_mut(), thickness));
        }
        DeValue::Array(list) => list.iter_mut().for_each(|value| resolve(key, value.get_mut(), thickness)),
        DeValue::String(text) if !NO_LENGTHS.contains(&key) => {
            if let Some(count) = thicknesses(text) {
                *text = format!("{} mm", count * thickness).into();
            }
        }
        _ => {}
    }
}
