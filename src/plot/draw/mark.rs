//! What a drawing is made of.

use crate::plot::chart::Color;
use plotters::style::text_anchor::HPos;

/// Width of a picture where nothing else is asked for; its height follows from what it holds.
pub(crate) const WIDTH: f64 = 800.0;

/// A place on the page \[px\].
pub(super) type Point = (f64, f64);

/// What is drawn with one pen.
pub(crate) enum Mark {
    Area {
        outline: Vec<Point>,
        fill: Color,
    },
    /// The pieces of one line; joins are round, ends are not.
    Line {
        pieces: Vec<Vec<Point>>,
        color: Color,
        width: f64,
    },
    /// White inside.
    Circle {
        at: Point,
        radius: f64,
        color: Color,
        width: f64,
    },
    /// A line of text; `at` is on its baseline, and it goes up the page where it is turned.
    Text {
        text: String,
        size: f64,
        color: Color,
        at: Point,
        anchor: HPos,
        turned: bool,
    },
}

impl Mark {
    /// Of its pen.
    pub(super) fn color(&self) -> Color {
        match self {
            Self::Area { fill, .. } => *fill,
            Self::Line { color, .. } | Self::Circle { color, .. } | Self::Text { color, .. } => *color,
        }
    }
}
