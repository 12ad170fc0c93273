//! What an output is: a file, what it holds, and how it is made.

use super::{Chart, Format, Results, StageView, csv};
use crate::solver::solution::Frame;
use crate::table::Table;

/// Files by name, each made as it is asked for.
pub type Files<'a> = Box<dyn Iterator<Item = (String, Vec<u8>)> + 'a>;

/// What is written only where it is asked for, of the frames of a [`FrameRecorder`](super::FrameRecorder).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extra {
    /// Files for ParaView.
    Vtu,
    /// The moving picture.
    Animation,
}

/// How a file is made.
#[derive(Clone, Copy, Debug)]
pub enum Make {
    /// Of a stage; nothing where it has no such thing.
    Table(fn(&StageView) -> Option<Table>),
    /// Text that is no table; nothing where a stage has no such thing.
    Text(fn(&StageView) -> Option<String>),
    /// Nothing where there is nothing to draw.
    Plot(fn(&StageView) -> Option<Chart>),
    /// Of the recorded frames of a stage, rising in time, where it is asked for.
    Moving(Extra, for<'a> fn(&'a StageView, &'a [&Frame]) -> Files<'a>),
    /// Of the whole case: stands beside the folders of its stages.
    OfCase(for<'a> fn(&'a Results<'a>) -> Files<'a>),
}

/// A file that is written, or a family of them, where a solution has what it holds.
#[derive(Clone, Copy, Debug)]
pub struct Output {
    /// Its name, or that of the first of a family; a plot may be written in other formats, with their endings.
    pub file: &'static str,
    /// What it holds, for help texts and below pictures.
    pub about: &'static str,
    /// How it is made.
    pub make: Make,
    /// Whether the second name is one of the family that the first, [`Output::file`], stands for; `None` of a single file.
    pub family: Option<fn(&str, &str) -> bool>,
}

impl Output {
    pub(super) const fn table(file: &'static str, about: &'static str, make: fn(&StageView) -> Option<Table>) -> Self {
        Self { file, about, make: Make::Table(make), family: None }
    }

    pub(super) const fn text(file: &'static str, about: &'static str, make: fn(&StageView) -> Option<String>) -> Self {
        Self { file, about, make: Make::Text(make), family: None }
    }

    pub(super) const fn plot(file: &'static str, about: &'static str, make: fn(&StageView) -> Option<Chart>) -> Self {
        Self { file, about, make: Make::Plot(make), family: None }
    }

    /// Whether a file of this name is written here.
    pub fn is_named(&self, name: &str) -> bool {
        let is_picture = || matches!(self.make, Make::Plot(_)) && Format::stem(name) == Some(self.stem());
        self.file == name || is_picture() || self.family.is_some_and(|is_one| is_one(self.file, name))
    }

    /// Its files of a stage, a plot in every format that is asked for; none for a plot or a table of nothing.
    pub fn files(&self, view: &StageView) -> Vec<(String, Vec<u8>)> {
        let whole = |bytes| vec![(self.file.to_owned(), bytes)];
        match self.make {
            Make::Table(make) => make(view).map(|table| whole(csv(&table))),
            Make::Text(make) => make(view).map(|text| whole(text.into_bytes())),
            Make::Plot(_) => self.chart(view).map(|chart| view.pictures.files(self.stem(), &chart)),
            Make::Moving(..) | Make::OfCase(_) => None,
        }
        .unwrap_or_default()
    }

    /// Its picture of a stage, in the view's form; nothing where there is nothing to draw, or where it is no plot.
    pub fn chart(&self, view: &StageView) -> Option<Chart> {
        let Make::Plot(make) = self.make else { return None };
        Some(make(view)?.displayed())
    }

    /// The content of the first of them.
    pub fn bytes(&self, view: &StageView) -> Option<Vec<u8>> {
        self.files(view).into_iter().next().map(|(_, bytes)| bytes)
    }

    /// Its name without the ending of a picture.
    pub fn stem(&self) -> &'static str {
        Format::stem(self.file).unwrap_or(self.file)
    }
}
