//! How a drawing is to be understood.

use crate::model::Role;
use crate::units::parse;
use std::str::FromStr;

/// Options of the reader.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Tools of layers by name, `None` for no tool, in place of what their names say.
    pub layers: Vec<(String, Option<Role>)>,
    /// Unit of the drawing; the header's when `None`.
    pub unit: Option<DrawingUnit>,
    /// x of the axis or symmetry plane in the drawing \[mm\]; 0 when `None`, and tools away from it are refused.
    pub axis: Option<f64>,
    /// Largest gap between ends that meet \[mm\].
    pub join: f64,
    /// Largest distance of a spline from its arcs \[mm\].
    pub tolerance: f64,
    /// Direction of the punch in the drawing; found from the tools' walls when `None`.
    pub punch_moves: Option<Heading>,
}

impl Default for Options {
    fn default() -> Self {
        Self { layers: Vec::new(), unit: None, axis: None, join: 0.01, tolerance: 0.001, punch_moves: None }
    }
}

/// Unit of length of a drawing: its symbol, as `--unit` takes it, and its length \[mm\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DrawingUnit(pub &'static str, pub f64);

impl DrawingUnit {
    /// Millimetre.
    pub const MM: Self = Self("mm", 1.0);
    /// Inch.
    pub const INCH: Self = Self("in", 25.4);
    /// Symbols of every unit, the likeliest first.
    pub const ALL: [&str; 7] = ["mm", "cm", "m", "in", "ft", "mil", "um"];
}

named! {
    /// Direction of the punch in the drawing, where y goes up.
    pub enum Heading;
    /// `down` or `up`.
    fn name;
    Down: "down", "Towards smaller y.";
    Up: "up", "Towards larger y.";
}

impl FromStr for DrawingUnit {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = if ["inch", "inches"].contains(&text) { "in" } else { text };
        let symbol = Self::ALL.into_iter().find(|symbol| *symbol == text);
        let unit = symbol.and_then(|symbol| Some(Self(symbol, parse(&format!("1 {symbol}")).ok()?.value)));
        unit.ok_or_else(|| format!("give {}", Self::ALL.join(", ")))
    }
}

impl FromStr for Heading {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        Self::ALL.into_iter().find(|way| way.name() == text).ok_or_else(|| "give down, up".to_owned())
    }
}

/// Reads `NAME=TOOL`, the tool that a layer draws; `None` for `NAME=none`. Fails when no layer or no tool is named.
pub fn layer(text: &str) -> Result<(String, Option<Role>), String> {
    let (name, tool) = text.rsplit_once('=').ok_or("write NAME=punch, NAME=die, NAME=holder or NAME=none")?;
    match Role::named_in(tool)[..] {
        [role] => Ok((name.to_owned(), Some(role))),
        _ if tool == "none" => Ok((name.to_owned(), None)),
        _ => Err("give punch, die, holder, none".to_owned()),
    }
}
