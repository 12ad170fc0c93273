//! How a drawing is to be understood.

use crate::model::Role;
use crate::units::factor;
use std::str::FromStr;

/// How a drawing is to be understood.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Layers by name and the tool that each draws (`None`: no tool), before what their names say.
    pub layers: Vec<(String, Option<Role>)>,
    /// Unit of the drawing; the header's when `None`.
    pub unit: Option<DrawingUnit>,
    /// x of the axis or symmetry plane in the drawing \[mm\]; where `None` it is 0, and tools that are drawn elsewhere are
    /// refused.
    pub axis: Option<f64>,
    /// Ends that are no farther apart meet \[mm\].
    pub join: f64,
    /// How far the arcs that replace a spline may leave it \[mm\].
    pub tolerance: f64,
    /// Which way the punch moves in the drawing; found from the tools' walls when `None`.
    pub punch_moves: Option<Heading>,
}

impl Default for Options {
    fn default() -> Self {
        Self { layers: Vec::new(), unit: None, axis: None, join: 0.01, tolerance: 0.001, punch_moves: None }
    }
}

/// A unit of length that drawings are made in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DrawingUnit {
    /// 10⁻³ mm.
    Micrometre,
    /// 1 mm.
    Mm,
    /// 10 mm.
    Cm,
    /// 10³ mm.
    M,
    /// 0.0254 mm.
    Mil,
    /// 25.4 mm.
    Inch,
    /// 304.8 mm.
    Foot,
}

impl DrawingUnit {
    /// Every unit, the likeliest first.
    pub const ALL: [Self; 7] = [Self::Mm, Self::Cm, Self::M, Self::Inch, Self::Foot, Self::Mil, Self::Micrometre];

    /// Its symbol, as `--units` takes it.
    pub fn symbol(self) -> &'static str {
        match self {
            Self::Micrometre => "um",
            Self::Mm => "mm",
            Self::Cm => "cm",
            Self::M => "m",
            Self::Mil => "mil",
            Self::Inch => "in",
            Self::Foot => "ft",
        }
    }

    /// Its length \[mm\].
    pub fn mm(self) -> f64 {
        factor(self.symbol()).expect("every unit of a drawing is one of a case file")
    }
}

/// Which way the punch moves in the drawing, where y goes up.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Heading {
    /// Towards smaller y.
    Down,
    /// Towards larger y.
    Up,
}

impl Heading {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Down, Self::Up];

    /// `down` or `up`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Down => "down",
            Self::Up => "up",
        }
    }
}

impl FromStr for DrawingUnit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        one_of(text, &Self::ALL.map(|unit| (unit.symbol(), unit)))
    }
}

impl FromStr for Heading {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        one_of(text, &Self::ALL.map(|heading| (heading.name(), heading)))
    }
}

/// One of a list, by its name.
fn one_of<T: Copy>(text: &str, all: &[(&'static str, T)]) -> Result<T, String> {
    let found = all.iter().find(|(name, _)| *name == text).map(|(_, value)| *value);
    found.ok_or_else(|| format!("give {}", all.iter().map(|(name, _)| *name).collect::<Vec<_>>().join(", ")))
}

/// Which tool a layer draws, `NAME=TOOL`; `None` of `NAME=none`.
///
/// # Errors
/// When no layer is named, or no tool is.
pub fn layer(text: &str) -> Result<(String, Option<Role>), String> {
    let (name, tool) = text.rsplit_once('=').ok_or("write NAME=punch, NAME=die, NAME=holder or NAME=none")?;
    match Role::from_word(tool) {
        None if tool != "none" => Err("give punch, die, holder, none".to_owned()),
        role => Ok((name.to_owned(), role)),
    }
}
