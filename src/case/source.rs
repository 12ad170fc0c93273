//! Text of a case with the place of every key: reads it, words its errors, collects notes.

use super::{schema::example, *};
use crate::units::{Dimensioned, Length, thicknesses};
use miette::NamedSource;
use serde::de::DeserializeOwned;
use std::{cell::RefCell, ops::Range, sync::Arc};
use toml::Spanned;
use toml::de::{DeTable, DeValue, Deserializer};

const ENTRIES: usize = 10_000;
/// Longest title and longest other text, which plots and messages repeat \[characters\].
const TITLE: usize = 200;
const TEXT: usize = 1000;

pub struct Source<'t> {
    shown: Arc<NamedSource<String>>,
    text: &'t str,
    tree: Spanned<DeTable<'t>>,
    pub root: DeValue<'t>,
    pub folder: Folder<'t>,
    pub notes: RefCell<Vec<String>>,
    /// Paths of the files that were read beside the case, in order.
    pub read: RefCell<Vec<PathBuf>>,
    /// Index and name of the later stage to which `tools.…` refers.
    stage: RefCell<Option<(usize, String)>>,
}

impl<'t> Source<'t> {
    pub fn parse(name: &str, text: &'t str, folder: Folder<'t>) -> Result<Self> {
        let shown = Arc::new(NamedSource::new(name, text.to_owned()));
        match DeTable::parse(text) {
            Ok(mut tree) => {
                resolve_thicknesses(tree.get_mut());
                let (notes, read, stage) = Default::default();
                Ok(Self { shown, text, root: DeValue::Table(tree.get_ref().clone()), tree, folder, notes, read, stage })
            }
            Err(error) => Err(error::not_toml(&error, text, shown)),
        }
    }

    pub fn file(&self, path: &Path, limit: usize) -> io::Result<String> {
        self.folder.files.text(path, limit).inspect(|_| self.read.borrow_mut().push(path.to_owned()))
    }

    pub fn case(&self) -> Result<CaseFile> {
        if self.tree.get_ref().is_empty() {
            let what = if self.text.trim().is_empty() { "the file is empty" } else { "the file holds comments only" };
            let help = "a case needs title, geometry, [blank], a law such as [material.hardening.swift], [tools.punch] \
                        and mostly [tools.die] and [tools.holder]; begin with a copy of cases/quickstart.toml";
            return Err(self.error_at(0..0, what.into(), "here".into(), help.into()));
        }
        let file = self.deserialised()?;
        self.check_lengths("", &self.root)?;
        Ok(file)
    }

    pub fn deserialised<T: DeserializeOwned>(&self) -> Result<T> {
        T::deserialize(Deserializer::from(self.tree.clone())).map_err(|error| error::wrong_key(&error, self))
    }

    fn check_lengths(&self, path: &str, value: &DeValue) -> Result<()> {
        let (size, most, unit) = match value {
            DeValue::Array(list) => (list.len(), ENTRIES, "entries"),
            DeValue::String(text) => (text.chars().count(), if path == "title" { TITLE } else { TEXT }, "characters"),
            _ => (0, 0, ""),
        };
        let what = format!("`{path}` has {size} {unit}, more than {most}");
        self.require(size <= most, path, what, "plots and messages repeat it: keep it short")?;
        let deeper = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
        entries(value).into_iter().try_for_each(|(key, _, value)| self.check_lengths(&deeper(&key), value.get_ref()))
    }

    pub fn note(&self, note: impl Into<String>) {
        let note = match &*self.stage.borrow() {
            Some((_, name)) => format!("stage {name}: {}", note.into()),
            None => note.into(),
        };
        self.notes.borrow_mut().push(note);
    }

    pub fn silently<T>(&self, run: impl FnOnce() -> T) -> T {
        let before = self.notes.borrow().len();
        let result = run();
        self.notes.borrow_mut().truncate(before);
        result
    }

    /// Lets `tools.…` refer to the tools of a later stage, counted from 0; `None` for the first stage.
    pub fn enter_stage(&self, stage: Option<(usize, &str)>) {
        *self.stage.borrow_mut() = stage.map(|(i, name)| (i, name.to_owned()));
    }

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
        self.error_at(span, what.into(), if path.is_empty() { "here".into() } else { path }, help.into())
    }

    pub fn require(&self, ok: bool, path: &str, what: impl Into<String>, help: impl Into<String>) -> Result<()> {
        if ok { Ok(()) } else { Err(self.error(path, what, help)) }
    }

    pub fn written<'k>(&self, table: &str, keys: &[&'k str]) -> Vec<&'k str> {
        keys.iter().copied().filter(|key| self.has(&format!("{table}.{key}"))).collect()
    }

    /// Refuses the first written one of some keys of a table; `why` follows its name.
    pub fn refuse(&self, table: &str, keys: &[&str], why: &str, help: &str) -> Result<()> {
        let key = self.written(table, keys).first().copied().unwrap_or("");
        self.require(key.is_empty(), &format!("{table}.{key}"), format!("`{key}` {why}"), help)
    }

    /// Refuses the second written one of some keys of a table.
    pub fn one_of(&self, table: &str, keys: &[&str], help: &str) -> Result<()> {
        match self.written(table, keys)[..] {
            [first, second, ..] => {
                Err(self.error(&format!("{table}.{second}"), format!("both `{first}` and `{second}` are given"), help))
            }
            _ => Ok(()),
        }
    }

    pub fn missing(&self, table: &str, key: &str) -> CaseError {
        let (path, name) = match table {
            "" => (key.to_owned(), "the case".to_owned()),
            _ => (format!("{table}.{key}"), format!("[{table}]")),
        };
        let line = example(&path).or_else(|| (key == "friction").then(|| "friction = 0.1".into()));
        let help = line.map_or_else(|| format!("add [{path}]"), |line| format!("add a line such as {line}"));
        self.error(table, format!("`{key}` is missing in {name}"), help)
    }

    pub fn error_at(&self, span: Range<usize>, what: String, label: String, help: String) -> CaseError {
        CaseError::at(self.shown.clone(), span, what, label, help)
    }

    pub fn has(&self, path: &str) -> bool {
        self.locate(&self.whole(path)).1
    }

    fn locate(&self, path: &str) -> (Range<usize>, bool) {
        let (mut span, mut here) = (0..0, &self.root);
        for segment in path.split('.') {
            let entry = entries(here).into_iter().find(|(name, ..)| name == segment);
            let Some((_, key, value)) = entry else { return (span, false) };
            // A table or a long array is shown by its key, so that the message stays short.
            let one_line = !self.text[value.span()].contains('\n');
            span = if one_line && !value.span().is_empty() { value.span() } else { key };
            here = value.get_ref();
        }
        (span, true)
    }
}

/// Top keys of most cases and studies; other TOML files share one of them at most.
const OWN_KEYS: [&str; 9] = ["title", "geometry", "blank", "material", "tools", "case", "vary", "set", "to"];

/// Whether a text has two of the own keys, wherever else its syntax is wrong, or holds nothing: messages quote no other file.
pub(super) fn is_own(text: &str) -> bool {
    let (tree, errors) = DeTable::parse_recoverable(text);
    let count = OWN_KEYS.iter().filter(|key| tree.get_ref().contains_key(**key)).count();
    count > 1 || tree.get_ref().is_empty() && errors.is_empty()
}

fn entries<'a>(value: &'a DeValue<'a>) -> Vec<(String, Range<usize>, &'a Spanned<DeValue<'a>>)> {
    match value {
        DeValue::Table(all) => all.iter().map(|(key, value)| (key.get_ref().to_string(), key.span(), value)).collect(),
        DeValue::Array(all) => all.iter().enumerate().map(|(i, value)| (i.to_string(), value.span(), value)).collect(),
        _ => Vec::new(),
    }
}

/// Key path whose key or value has exactly this span; `None` for the whole file.
pub fn path_at(value: &DeValue, span: &Range<usize>) -> Option<String> {
    entries(value).into_iter().find_map(|(name, key, value)| match key == *span || value.span() == *span {
        true => Some(name),
        false => Some(format!("{name}.{}", path_at(value.get_ref(), span)?)),
    })
}

/// Keys of which a table has one; the first six are lengths from the axis, each with the key of its diameter.
const ALTERNATIVES: [&[&str]; 10] = [
    &["radius", "diameter"],
    &["throat", "throat_diameter"],
    &["mouth", "mouth_diameter"],
    &["inner_radius", "inner_diameter"],
    &["at", "diameter"],
    &["trim", "trim_diameter"],
    &["force", "pressure", "gap", "spring"],
    &["cone", "tractrix"],
    &["frames", "count"],
    &["tolerance", "wall_tolerance"],
];

fn diameter_key(path: &str) -> Option<String> {
    let (table, key) = path.rsplit_once('.')?;
    Some(format!("{table}.{}", ALTERNATIVES[..6].iter().find(|keys| keys[0] == key)?[1]))
}

/// Keys that a table cannot have beside one, such as the diameter beside the radius.
pub(super) fn alternatives(key: &str) -> impl Iterator<Item = &'static str> {
    ALTERNATIVES.into_iter().filter(move |keys| keys.contains(&key)).flatten().copied().filter(move |one| *one != key)
}

/// Keys of texts, in which "6 t" is no length, and of forces, in which "250 t" is no length either.
const NO_LENGTHS: [&str; 8] = ["title", "notes", "name", "source", "file", "quantity", "force", "preload"];

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
