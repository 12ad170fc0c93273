//! What shops write, as the keys of a case file: `binder` is the holder, a diameter twice a radius, `"6 t"` six thicknesses
//! of the sheet. Words and values change their meaning in the tree that was read; every place stays where it was written.

mod diameters;
mod synonyms;

pub(super) use diameters::in_schema;
pub(super) use diameters::listed;

use crate::units::{self, Length, Quantity};
use std::collections::BTreeMap;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Keys whose values are words for people or names.
const WORDS: [&str; 6] = ["title", "notes", "name", "source", "file", "quantity"];

/// Keys of forces, of which "250 t" is no length: it is told as what it is.
const FORCES: [&str; 2] = ["force", "preload"];

/// What was written otherwise than it is read.
#[derive(Clone, Debug, Default)]
pub(super) struct Wording {
    /// Key paths as they are read, each with the key that was written there.
    written: BTreeMap<String, String>,
    /// Words that are read as others, in the order of reading.
    read: Vec<String>,
}

/// A place whose words do not go together.
pub(super) struct Mistake {
    pub span: Range<usize>,
    pub label: String,
    pub what: String,
    pub help: String,
}

/// A table on its way.
struct Place<'a> {
    /// Its path as it is read.
    path: &'a str,
    /// The key that says what kind of table it is.
    table: &'a str,
}

impl Place<'_> {
    fn path_of(&self, key: &str) -> String {
        if self.path.is_empty() { key.to_owned() } else { format!("{}.{key}", self.path) }
    }
}

/// What the whole case says of itself.
struct Case<'t> {
    /// The text that was read.
    text: &'t str,
    /// Whether the part is a strip.
    is_strip: bool,
    /// Thickness of the blank \[mm\], where it is written as a length.
    thickness: Option<f64>,
}

impl Wording {
    /// Reads the words of a shop in a case's tree.
    pub fn of(tree: &mut DeTable, text: &str) -> Result<Self, Mistake> {
        let mut wording = Self::default();
        let root = Place { path: "", table: "" };
        wording.synonyms(tree, &root)?;
        let said = |table: Option<&Spanned<DeValue>>, key: &str| {
            Some(table?.get_ref().as_table()?.get(key)?.get_ref().as_str()?.to_owned())
        };
        let thickness = said(tree.get("blank"), "thickness").and_then(|text| text.parse::<Length>().ok());
        let is_strip = tree.get("geometry").and_then(|g| g.get_ref().as_str()) == Some("plane_strain");
        let case = Case { text, is_strip, thickness: thickness.map(Length::value) };
        wording.lengths(tree, &root, &case)?;
        Ok(wording)
    }

    /// A key path as it was written.
    pub fn written(&self, path: &str) -> String {
        let ends = path.match_indices('.').map(|(at, _)| at).chain([path.len()]);
        let key = |end: usize| {
            let key = path[..end].rsplit('.').next().unwrap_or(path);
            self.written.get(&path[..end]).map_or(key, String::as_str)
        };
        ends.map(key).collect::<Vec<_>>().join(".")
    }

    /// Gives every key its own name.
    fn synonyms(&mut self, table: &mut DeTable, place: &Place) -> Result<(), Mistake> {
        let keys: Vec<String> = table.keys().map(|key| key.get_ref().to_string()).collect();
        for word in keys {
            if let Some(key) = synonyms::key(place.table, &word) {
                self.rename(table, place, &word, key)?;
                self.note(&word, key);
            }
        }
        for (key, value) in table.iter_mut() {
            let path = place.path_of(key.get_ref());
            self.synonyms_in(value, &Place { path: &path, table: key.get_ref() })?;
        }
        Ok(())
    }

    fn synonyms_in(&mut self, value: &mut Spanned<DeValue>, place: &Place) -> Result<(), Mistake> {
        match value.get_mut() {
            DeValue::Table(table) => self.synonyms(table, place)?,
            DeValue::Array(array) => {
                for (i, value) in array.iter_mut().enumerate() {
                    self.synonyms_in(value, &Place { path: &place.path_of(&i.to_string()), table: place.table })?;
                }
            }
            DeValue::String(word) => {
                if let Some(tool) = synonyms::value(place.table, word) {
                    self.note(word, tool);
                    *word = tool.into();
                }
            }
            _ => {}
        }
        Ok(())
    }

    /// Turns diameters into radii, and thicknesses into millimetres.
    fn lengths(&mut self, table: &mut DeTable, place: &Place, case: &Case) -> Result<(), Mistake> {
        for (key, value) in table.iter_mut() {
            let path = place.path_of(key.get_ref());
            self.lengths_in(value, &Place { path: &path, table: key.get_ref() }, case)?;
        }
        for twin in diameters::of(place.table) {
            let Some((key, _)) = table.get_key_value(twin.diameter) else { continue };
            let span = key.span();
            let label = self.written(&place.path_of(twin.diameter));
            if case.is_strip {
                let what = format!("`{}` is of a round part, and this one is a strip (plane strain)", last(&label));
                let help = match twin.strip {
                    strip if strip == twin.radius && strip == "radius" => "write radius".to_owned(),
                    strip => format!("write {strip}, from the symmetry plane: half of the width"),
                };
                return Err(Mistake { span, label, what, help });
            }
            let across = self.written.get(&place.path_of(twin.diameter)).cloned();
            self.written.remove(&place.path_of(twin.diameter));
            let across = across.unwrap_or_else(|| twin.diameter.to_owned());
            if let Some((other, _)) = table.get_key_value(twin.radius) {
                let lines = [other.span(), span.clone()].map(|span| line_of(case.text, span.start));
                let radius = self.written(&place.path_of(twin.radius));
                let what = format!(
                    "both `{}` (line {}) and `{across}` (line {}) are given",
                    last(&radius),
                    lines[0],
                    lines[1]
                );
                return Err(Mistake { span, label, what, help: "keep one of them".to_owned() });
            }
            if let Some(value) = table.get_mut(twin.diameter) {
                halve(value);
            }
            self.rename(table, place, twin.diameter, twin.radius)?;
            self.written.insert(place.path_of(twin.radius), across);
        }
        Ok(())
    }

    fn lengths_in(&mut self, value: &mut Spanned<DeValue>, place: &Place, case: &Case) -> Result<(), Mistake> {
        match value.get_mut() {
            DeValue::Table(table) => self.lengths(table, place, case)?,
            DeValue::Array(array) => {
                for (i, value) in array.iter_mut().enumerate() {
                    self.lengths_in(value, &Place { path: &place.path_of(&i.to_string()), table: place.table }, case)?;
                }
            }
            DeValue::String(text) if !WORDS.contains(&place.table) && !FORCES.contains(&last(place.path)) => {
                if let Some((count, thickness)) = units::thicknesses(text).zip(case.thickness) {
                    *text = millimetres(count * thickness).into();
                }
            }
            _ => {}
        }
        Ok(())
    }

    fn rename(&mut self, table: &mut DeTable, place: &Place, word: &str, key: &str) -> Result<(), Mistake> {
        let Some((old, value)) = table.remove_entry(word) else { return Ok(()) };
        if table.contains_key(key) {
            let what = format!("`{word}` is another word for `{key}`, and both are given");
            return Err(Mistake {
                span: old.span(),
                label: place.path_of(word),
                what,
                help: "keep one of them".into(),
            });
        }
        table.insert(Spanned::new(old.span(), key.to_owned().into()), value);
        self.written.insert(place.path_of(key), word.to_owned());
        Ok(())
    }

    fn note(&mut self, word: &str, key: &str) {
        let note = format!("{word} as {key}");
        if !self.read.contains(&note) {
            self.read.push(note);
        }
    }

    /// What a reader should know of it.
    pub fn notes(&self) -> Option<String> {
        (!self.read.is_empty()).then(|| format!("read {}", self.read.join(", ")))
    }
}

/// The key that a word means in a table, which may be the word itself.
pub(super) fn key<'w>(table: &str, word: &'w str) -> &'w str {
    synonyms::key(table, word).unwrap_or(word)
}

/// Whether two keys of a table mean the same, be it another word, or the same length across and from the axis.
pub(super) fn is_same(table: &str, a: &str, b: &str) -> bool {
    let meaning = |word: &str| {
        let key = key(table, word).to_owned();
        diameters::of(table).find(|twin| twin.diameter == key).map_or(key, |twin| twin.radius.to_owned())
    };
    a == b || meaning(a) == meaning(b)
}

/// Half of a length; what is no length stays, to be refused where it is read.
fn halve(value: &mut Spanned<DeValue>) {
    if let DeValue::String(text) = value.get_mut()
        && let Ok(across) = text.parse::<Length>()
    {
        *text = millimetres(0.5 * across.value()).into();
    }
}

/// The shortest text that reads back as the same length \[mm\].
fn millimetres(length: f64) -> String {
    format!("{length} mm")
}

fn last(path: &str) -> &str {
    path.rsplit('.').next().unwrap_or(path)
}

/// The line of a byte, from 1.
fn line_of(text: &str, at: usize) -> usize {
    text.get(..at).unwrap_or_default().matches('\n').count() + 1
}
