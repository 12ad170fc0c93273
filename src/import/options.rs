//! How a drawing is to be understood.

use crate::model::Role;
use crate::units::factor;

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
