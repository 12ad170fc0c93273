//! What a report says, whatever file it goes to.

use crate::assess::Light;

/// A report: its title and its sections in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// Its heading.
    pub title: String,
    /// What stands below, in order.
    pub sections: Vec<Section>,
}

/// A heading and what stands below it.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Its heading.
    pub heading: String,
    /// What stands below it, in order.
    pub blocks: Vec<Block>,
}

/// One thing below a heading.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// Running text.
    Paragraph(String),
    /// One entry each.
    List(Vec<String>),
    /// As many cells in each row as in the head.
    Table {
        /// Names of the columns.
        head: Vec<&'static str>,
        /// From the top.
        rows: Vec<Row>,
    },
    /// A drawing with its caption.
    Picture(Picture),
}

/// One row of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// From the left.
    pub cells: Vec<String>,
    /// Colours the first cell, whose word says the same.
    pub light: Option<Light>,
}

/// A drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Name of a file that it may be written to, without number and ending.
    pub name: String,
    /// What it shows, without a full stop.
    pub caption: String,
    /// A standalone SVG.
    pub svg: String,
}

impl Row {
    /// A row without a light.
    pub fn plain(cells: impl IntoIterator<Item = String>) -> Self {
        Self { cells: cells.into_iter().collect(), light: None }
    }
}

impl Document {
    /// All pictures in order.
    pub fn pictures(&self) -> impl Iterator<Item = &Picture> {
        self.sections.iter().flat_map(|section| &section.blocks).filter_map(|block| match block {
            Block::Picture(picture) => Some(picture),
            _ => None,
        })
    }
}
