//! The text of a case and where each key stands in it.

use super::wording::Wording;
use super::{CaseError, CaseFile, reader, syntax};
use miette::NamedSource;
use std::ops::Range;
use std::sync::Arc;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A case's text, parsed as TOML, in the words of case files; knows the place of every key path.
#[derive(Clone)]
pub(super) struct Source<'t> {
    shown: Arc<NamedSource<String>>,
    text: &'t str,
    tree: Spanned<DeTable<'t>>,
    wording: Wording,
    /// The later stage whose tools are meant by `tools.…`.
    stage: Option<usize>,
}

impl<'t> Source<'t> {
    /// Parses the text as TOML.
    pub fn parse(name: &str, text: &'t str) -> Result<Self, CaseError> {
        let shown = Arc::new(NamedSource::new(name, text.to_owned()));
        let mut tree = match DeTable::parse(text) {
            Ok(tree) => tree,
            Err(error) => return Err(syntax::error(&error, text, shown)),
        };
        match Wording::of(tree.get_mut(), text) {
            Ok(wording) => Ok(Self { shown, text, tree, wording, stage: None }),
            Err(found) => Err(CaseError::at(shown, found.span, found.what, found.label, found.help)),
        }
    }

    /// What the keys say, each in its own type.
    pub fn read(&self) -> Result<CaseFile, reader::Error> {
        reader::read(self.tree.get_ref())
    }

    /// What was written in other words than those of case files.
    pub fn notes(&self) -> Option<String> {
        self.wording.notes()
    }

    /// The same text, in which `tools.…` means what a later stage, from 0, writes of a tool, where it does.
    pub fn of_stage(&self, stage: usize) -> Self {
        Self { stage: Some(stage), ..self.clone() }
    }

    /// A key path of the whole case.
    fn whole(&self, path: &str) -> String {
        let of_stage = self.stage.zip(path.strip_prefix("tools.")).map(|(i, rest)| (format!("stages.{i}."), rest));
        match of_stage {
            Some((stage, rest)) if self.locate(&format!("{stage}{}", rest.split('.').next().unwrap_or(rest))).1 => {
                stage + rest
            }
            _ => path.to_owned(),
        }
    }

    /// The text that was parsed.
    pub fn text(&self) -> &'t str {
        self.text
    }

    /// Whether there is no key in it.
    pub fn is_empty(&self) -> bool {
        self.tree.get_ref().is_empty()
    }

    /// An error at a dotted key path (entries of arrays by index); what is missing is shown at its table.
    pub fn error(&self, path: &str, what: impl Into<String>, help: impl Into<String>) -> CaseError {
        let path = &self.whole(path);
        let (span, _) = self.locate(path);
        let label = if path.is_empty() { "here".into() } else { self.wording.written(path) };
        CaseError::at(self.shown.clone(), span, what.into(), label, help.into())
    }

    /// Whether a key was written.
    pub fn has(&self, path: &str) -> bool {
        self.locate(&self.whole(path)).1
    }

    /// The deepest place on the path that was written, and whether that is all of the path.
    fn locate(&self, path: &str) -> (Range<usize>, bool) {
        let mut here = 0..0;
        let mut table = Some(self.tree.get_ref());
        let mut array: Option<&[Spanned<DeValue>]> = None;
        for segment in path.split('.') {
            let found = match (table, array) {
                (Some(table), _) => table.get_key_value(segment).map(|(key, value)| (key.span(), value)),
                (_, Some(array)) => {
                    segment.parse::<usize>().ok().and_then(|i| array.get(i)).map(|value| (value.span(), value))
                }
                _ => None,
            };
            let Some((key, value)) = found else { return (here, false) };
            // A table or a long array is shown by its key, so that the message stays short.
            let one_line = !self.text[value.span()].contains('\n');
            here = if one_line && !value.span().is_empty() { value.span() } else { key };
            table = value.get_ref().as_table();
            array = value.get_ref().as_array().map(|array| &array[..]);
        }
        (here, true)
    }

    /// A key path in the words that were written.
    pub fn written(&self, path: &str) -> String {
        self.wording.written(path)
    }

    /// The key path whose key or value stands exactly at `span`; "" for the whole file.
    pub fn path_at(&self, span: &Range<usize>) -> Option<String> {
        search(self.tree.get_ref(), span)
    }

    /// The word or value at `span` of an error, made into one.
    pub fn error_at(&self, span: Range<usize>, what: String, label: String, help: String) -> CaseError {
        CaseError::at(self.shown.clone(), span, what, label, help)
    }
}

fn search(table: &DeTable, span: &Range<usize>) -> Option<String> {
    table.iter().find_map(|(key, value)| {
        let key_text = key.get_ref();
        if key.span() == *span || value.span() == *span {
            return Some(key_text.to_string());
        }
        search_value(value.get_ref(), span).map(|rest| format!("{key_text}.{rest}"))
    })
}

fn search_value(value: &DeValue, span: &Range<usize>) -> Option<String> {
    if let Some(table) = value.as_table() {
        return search(table, span);
    }
    value.as_array()?.iter().enumerate().find_map(|(i, value)| {
        if value.span() == *span {
            return Some(i.to_string());
        }
        search_value(value.get_ref(), span).map(|rest| format!("{i}.{rest}"))
    })
}
