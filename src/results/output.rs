//! Entry of the list of outputs: a file, its content, and how it is made.

use super::{Chart, Extra, Format, Results, StageView, comparison, csv, vtk};
use crate::solver::solution::Frame;
use crate::table::Table;

/// Files with their names.
pub type Files = Vec<(String, Vec<u8>)>;

/// Function that makes an output; `None` or no files where the solution has no such thing.
#[derive(Clone, Copy, Debug)]
pub enum Make {
    /// Table of a stage.
    Table(fn(&StageView) -> Option<Table>),
    /// Text of a stage.
    Text(fn(&StageView) -> Option<String>),
    /// Picture of a stage.
    Plot(fn(&StageView) -> Option<Chart>),
    /// Files from the recorded frames of a stage, rising in time.
    Moving(Extra, fn(&StageView, &[&Frame]) -> Files),
    /// Files of the whole case, beside the folders of its stages.
    OfCase(fn(&Results) -> Files),
}

/// A file, or a family of files.
#[derive(Clone, Copy, Debug)]
pub struct Output {
    /// Name of the file, or of the first of a family; pictures may have other endings.
    pub file: &'static str,
    /// Content, for help texts and captions.
    pub about: &'static str,
    /// Its making.
    pub make: Make,
}

impl Output {
    /// Tells whether a file's name is one of this output.
    pub fn is_named(&self, name: &str) -> bool {
        let is_other = match self.make {
            Make::Plot(_) => Format::stem(name) == Some(self.stem()),
            Make::Moving(extra, _) => extra == Extra::Vtu && vtk::is_ours(name),
            Make::OfCase(_) => self.file.starts_with(comparison::PREFIX) && comparison::is_comparison(name),
            Make::Table(_) | Make::Text(_) => false,
        };
        self.file == name || is_other
    }

    /// Files of a stage, a plot in every chosen format.
    pub fn files(&self, view: &StageView) -> Files {
        let file = |bytes| vec![(self.file.to_owned(), bytes)];
        let files = match self.make {
            Make::Table(make) => make(view).map(|table| file(csv(&table))),
            Make::Text(make) => make(view).map(|text| file(text.into_bytes())),
            Make::Plot(_) => self.chart(view).map(|chart| view.pictures.files(self.stem(), &chart)),
            Make::Moving(..) | Make::OfCase(_) => None,
        };
        files.unwrap_or_default()
    }

    /// Picture of a stage in display units; `None` if there is nothing to draw or this is no plot.
    pub fn chart(&self, view: &StageView) -> Option<Chart> {
        let Make::Plot(make) = self.make else { return None };
        Some(make(view)?.displayed())
    }

    /// Name without the ending of a picture.
    pub fn stem(&self) -> &'static str {
        Format::stem(self.file).unwrap_or(self.file)
    }
}

pub(super) const fn output(file: &'static str, about: &'static str, make: Make) -> Output {
    Output { file, about, make }
}

pub(super) const fn table(file: &'static str, about: &'static str, make: fn(&StageView) -> Option<Table>) -> Output {
    output(file, about, Make::Table(make))
}

pub(super) const fn picture(file: &'static str, about: &'static str, make: fn(&StageView) -> Option<Chart>) -> Output {
    output(file, about, Make::Plot(make))
}
