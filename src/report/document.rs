//! What a report says, whatever file it goes to.

use crate::assess::Light;
use crate::results::Chart;

/// A report: its first page, which answers, and its sections in order.
#[derive(Clone, Debug, PartialEq)]
pub struct Document {
    /// Its heading.
    pub title: String,
    /// Who answers for it; empty where nobody is named.
    pub author: String,
    /// Names and values of the title block, in order.
    pub title_block: Vec<[String; 2]>,
    /// What stands below them on the first page, in order.
    pub front: Vec<Block>,
    /// What follows from the second page on, in order.
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
    /// One sentence that stands out, in the colour of a light whose word it says.
    Sentence(Light, String),
    /// The numbers that are asked for first.
    Numbers(Vec<KeyNumber>),
    /// What is beyond or near its limit, each with what to change below it.
    Issues(Vec<Issue>),
    /// One entry each.
    List(Vec<String>),
    /// As many cells in each row as in the head.
    Table {
        /// Names of the columns.
        head: Vec<String>,
        /// From the top.
        rows: Vec<Row>,
    },
    /// A drawing with its caption.
    Picture(Picture),
}

/// A number that stands out.
#[derive(Clone, Debug, PartialEq)]
pub struct KeyNumber {
    /// What it is of: `Peak punch force`.
    pub label: String,
    /// The number with its unit; a word where there is none.
    pub value: String,
    /// Where, when or of what; may be empty.
    pub detail: String,
}

/// A row of the verdict by itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Issue {
    /// How it stands to its limit.
    pub light: Light,
    /// Its question: `Thinning`.
    pub label: String,
    /// The number or the words, with the unit, and where.
    pub found: String,
    /// The limit in words.
    pub limit: String,
    /// What to change, for it and for those right above it that say nothing of it; may be empty.
    pub advice: String,
}

/// One row of a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// From the left.
    pub cells: Vec<String>,
    /// Colours the first cell, whose word says the same.
    pub light: Option<Light>,
    /// Whether it belongs to the row above, and is indented.
    pub belongs: bool,
}

/// A drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// Name of a file that it may be written to, without number and ending.
    pub name: String,
    /// What it shows, without a full stop.
    pub caption: String,
    /// What is drawn.
    pub chart: Chart,
}

impl Block {
    /// The drawing that it is.
    pub(super) fn picture(&self) -> Option<&Picture> {
        match self {
            Self::Picture(picture) => Some(picture),
            _ => None,
        }
    }

    /// A table whose columns have these names.
    pub(super) fn table<const N: usize>(head: [&'static str; N], rows: Vec<Row>) -> Self {
        Self::Table { head: head.map(|name| String::from(name)).to_vec(), rows }
    }
}

impl Issue {
    /// What was found, and the limit.
    pub(super) fn judged(&self) -> String {
        let found = self.found.clone();
        match self.limit.as_str() {
            "" => found.into(),
            limit => format!("{found} (limit: {limit})"),
        }
    }

    /// What to change; empty where nothing is advised.
    pub(super) fn advised(&self) -> String {
        match self.advice.as_str() {
            "" => String::new(),
            advice => format!("What to change: {advice}"),
        }
    }
}

impl Picture {
    /// What stands below the `n`-th picture.
    pub(super) fn below(&self, n: usize) -> String {
        format!("Figure {n}: {caption}", caption = self.caption)
    }
}

impl Row {
    /// A row without a light.
    pub fn plain(cells: impl IntoIterator<Item = String>) -> Self {
        Self { cells: cells.into_iter().collect(), light: None, belongs: false }
    }
}

impl Document {
    /// Everything below a heading and on the first page, in order.
    pub fn blocks(&self) -> impl Iterator<Item = &Block> {
        self.front.iter().chain(self.sections.iter().flat_map(|section| &section.blocks))
    }

    /// All pictures in order.
    pub fn pictures(&self) -> impl Iterator<Item = &Picture> {
        self.blocks().filter_map(Block::picture)
    }
}

/// Sign and word of a light: the colour only repeats them.
pub(super) fn word(light: Light) -> String {
    let sign = match light {
        Light::Grey => '○',
        Light::Green => '●',
        Light::Amber => '▲',
        Light::Red => '■',
    };
    format!("{sign} {}", String::from(light.name()))
}
