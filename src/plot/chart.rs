//! What a plot shows, apart from how it is drawn: panels of series with labelled axes, a title and notes.

use crate::table::Axis;

/// A picture: panels below each other, one legend above them, notes below.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Above the panels.
    pub title: String,
    /// What the legend's entries have in common; may be empty.
    pub legend: String,
    /// From the top down.
    pub panels: Vec<Panel>,
    /// Small print: assumptions and sources; long lines are wrapped.
    pub notes: Vec<String>,
}

/// One pair of axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// What is drawn, from the back to the front.
    pub series: Vec<Series>,
    /// How the axes are scaled.
    pub scale: Scale,
}

/// How the axes are scaled.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Scale {
    /// Everything fits into this height [px of a picture 800 wide]; zero is shown where it is near. The y axis spans
    /// `least` or more, so that it does not zoom in on noise.
    Fit {
        /// Height of the panel \[px of a picture 800 wide\].
        height: f64,
        /// Least span of the y axis, in its unit.
        least: f64,
    },
    /// Both axes alike and y pointing down the page; at least this window is shown, areas are cut at its border.
    Section {
        /// Least window along x, in the unit of the axis.
        x: (f64, f64),
        /// Least window along y, in the unit of the axis.
        y: (f64, f64),
    },
    /// A section without axes and a third as wide: such panels stand side by side, each below its caption, which is the
    /// label of its series that is [`Look::Text`] without points.
    Small {
        /// Least window along x, in the unit of the axis.
        x: (f64, f64),
        /// Least window along y, in the unit of the axis.
        y: (f64, f64),
    },
    /// As a window, about half as wide: such panels stand side by side with axes of their own, each below its caption, as
    /// small ones.
    Multiple {
        /// Height of the panel \[px\].
        height: f64,
        /// Along x, in the unit of the axis.
        x: (f64, f64),
        /// Along y, in the unit of the axis.
        y: (f64, f64),
    },
    /// A bar filled from side to side, y from 0 to 1: a scale of colours over the values of x.
    Bar,
    /// This window and no more; areas are cut at its border.
    Window {
        /// Height of the panel \[px\].
        height: f64,
        /// Along x, in the unit of the axis.
        x: (f64, f64),
        /// Along y, in the unit of the axis.
        y: (f64, f64),
    },
}

/// One curve, set of points or filled outline.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// What the legend says; a series without a label is not in it.
    pub label: Option<String>,
    /// x and y in the units of the axes.
    pub points: Vec<(f64, f64)>,
    /// How it is drawn.
    pub look: Look,
}

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Look {
    /// `dash` is a pattern of drawn and left-out lengths, solid when empty; lengths in px of a picture 800 wide.
    Line {
        /// Of the line.
        color: Color,
        /// Thickness \[px of a picture 800 wide\].
        width: f64,
        /// Lengths drawn and left out in turn \[px of a picture 800 wide\]; solid when empty.
        dash: &'static [f64],
    },
    /// Open circles at the points.
    Circles {
        /// Of the outlines.
        color: Color,
    },
    /// Dots at the points.
    Dots {
        /// Of the dots.
        color: Color,
    },
    /// Triangles on the points, apart from dots in grey print.
    Triangles {
        /// Of the triangles.
        color: Color,
    },
    /// The inside of the outline that the points make.
    Area {
        /// Of the inside.
        fill: Color,
        /// Of the outline; `None` without one.
        edge: Option<Color>,
    },
    /// The inside of the outline that the points make, with parallel lines: apart from its neighbours in grey print, and seen
    /// through by what lies under it.
    Hatched {
        /// Of the inside; `None` where what lies under it is seen between the lines.
        fill: Option<Color>,
        /// Of the lines.
        line: Color,
        /// How they rise from left to right \[degrees\].
        rise: f64,
    },
    /// The label itself, on white: each point is the middle of its left end. The legend leaves it out.
    Text,
    /// The same, and each point is the middle of its right end.
    Before,
    /// The label itself, on white about each point. The legend leaves it out.
    Name,
    /// The label on white about the second point, with a line to a dot at the first. The legend leaves it out.
    Callout,
    /// A thin upright line at each point, with a dot there and the label above all curves, none on another. The legend leaves
    /// it out.
    Flag,
}

/// Red, green, blue.
pub type Color = (u8, u8, u8);

/// The paper.
pub const WHITE: Color = (255, 255, 255);
/// Text and axes.
pub const BLACK: Color = (0, 0, 0);
/// What stays in the background.
pub const GREY: Color = (120, 120, 120);
/// Tool bodies.
pub const PALE: Color = (222, 222, 222);

/// How many things of a picture have a colour of their own.
pub const COLORS: usize = PALETTE.len();

/// Colours that stay apart for colour-blind readers.
///
/// # References
/// M. Okabe, K. Ito, Color Universal Design (2008); yellow is left out, it is lost on white.
const PALETTE: [Color; 7] =
    [(0, 114, 178), (213, 94, 0), (0, 158, 115), (204, 121, 167), (230, 159, 0), (86, 180, 233), BLACK];

/// Patterns that keep curves apart in black and white.
const DASHES: [&[f64]; 5] = [&[], &[9.0, 4.0], &[2.5, 3.0], &[12.0, 3.5, 2.5, 3.5], &[18.0, 5.0]];

/// Colour of the `i`-th thing of a picture.
pub fn color(i: usize) -> Color {
    PALETTE[i % PALETTE.len()]
}

/// The colour, two thirds of the way to white.
pub fn pale(color: Color) -> Color {
    let pale = |c: u8| 255 - (255 - c) / 3;
    (pale(color.0), pale(color.1), pale(color.2))
}

impl Look {
    /// Line of the `i`-th curve: colour and pattern differ from those of its neighbours.
    pub fn curve(i: usize) -> Self {
        Self::Line { color: color(i), width: 2.4, dash: DASHES[i % DASHES.len()] }
    }

    /// Whether the legend says what it is.
    pub fn is_explained(self) -> bool {
        !matches!(self, Self::Text | Self::Before | Self::Name | Self::Flag | Self::Callout)
    }

    /// The same line thin and pale, for the background.
    pub fn faint(self) -> Self {
        match self {
            Self::Line { color, dash, .. } => Self::Line { color: pale(color), width: 1.2, dash },
            other => other,
        }
    }
}

impl Series {
    /// A series in the legend.
    pub fn new(label: impl Into<String>, points: Vec<(f64, f64)>, look: Look) -> Self {
        Self { label: Some(label.into()), points, look }
    }

    /// A series that the legend leaves out.
    pub fn silent(points: Vec<(f64, f64)>, look: Look) -> Self {
        Self { label: None, points, look }
    }
}

impl Panel {
    /// With what lies between two sides of a curve over the same places, in its colour but pale, behind all that is drawn and
    /// last in the legend.
    pub fn with_band(mut self, label: impl Into<String>, x: &[f64], [low, high]: [&[f64]; 2], of: Color) -> Self {
        let side = |side: &[f64]| x.iter().copied().zip(side.iter().copied()).collect::<Vec<_>>();
        let outline = side(low).into_iter().chain(side(high).into_iter().rev()).collect();
        let look = Look::Area { fill: pale(of), edge: None };
        self.series.insert(0, Series::silent(outline, look));
        self.series.push(Series::new(label, Vec::new(), look));
        self
    }

    /// Ranges of x and y that hold every point of the series, or the window of a section.
    pub fn ranges(&self) -> [(f64, f64); 2] {
        match self.scale {
            Scale::Section { x, y } | Scale::Small { x, y } => [x, y],
            Scale::Window { x, y, .. } | Scale::Multiple { x, y, .. } => [x, y],
            Scale::Bar => {
                let ends = self.series.iter().flat_map(|s| &s.points).map(|p| p.0);
                let (low, high) =
                    ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (x.min(low), x.max(high)));
                [(low, high), (0.0, 1.0)]
            }
            Scale::Fit { least, .. } => {
                let points = || self.series.iter().flat_map(|s| &s.points);
                let [x, y] = [fitted(points().map(|p| p.0), 0.02), fitted(points().map(|p| p.1), 0.05)];
                [x, widened(y, least)]
            }
        }
    }
}

/// What is larger is not drawn: ranges must not overflow.
const HUGE: f64 = 1e300;

/// Least range of the values with a margin, zero included where leaving it out would save less than half.
fn fitted(values: impl Iterator<Item = f64>, margin: f64) -> (f64, f64) {
    let (mut low, mut high) = values
        .filter(|v| v.abs() < HUGE)
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    if low > high {
        return (0.0, 1.0);
    }
    if low > 0.0 && low < 0.5 * high {
        low = 0.0;
    }
    if high < 0.0 && high > 0.5 * low {
        high = 0.0;
    }
    let span = if high - low > 1e-9 * high.abs().max(low.abs()) { high - low } else { high.abs().max(1e-6) };
    let pad = if high - low < span { 0.5 * span } else { margin * span };
    (if low == 0.0 { 0.0 } else { low - pad }, if high == 0.0 && low < 0.0 { 0.0 } else { high + pad })
}

/// The range about the same middle, `least` wide or more.
fn widened((low, high): (f64, f64), least: f64) -> (f64, f64) {
    let more = 0.5 * (least - (high - low)).max(0.0);
    (low - more, high + more)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_hold_all_values_and_zero_where_it_is_near() {
        let range = |values: &[f64]| fitted(values.iter().copied(), 0.0);
        assert_eq!(range(&[1.0, 10.0]), (0.0, 10.0));
        assert_eq!(range(&[8.0, 10.0]), (8.0, 10.0));
        assert_eq!(range(&[-3.0, -1.0]), (-3.0, 0.0));
        assert_eq!(range(&[]), (0.0, 1.0));
        for values in [[2.0, 2.0], [0.0, 0.0], [-1.0, -1.0], [f64::NAN, 4.0]] {
            let (low, high) = range(&values);
            assert!(low < high && values.iter().all(|v| v.is_nan() || (low..=high).contains(v)), "{values:?}");
        }
    }

    /// Trust: a thickness that is constant to round-off, and one that is not.
    #[test]
    fn an_axis_does_not_zoom_in_on_noise() {
        let range = |thickness: &[f64]| {
            let points = thickness.iter().enumerate().map(|(i, t)| (i as f64, *t)).collect();
            let axis = crate::table::Column::new("x", "X", crate::table::Unit::Mm, vec![]).axis();
            let scale = Scale::Fit { height: 350.0, least: 0.02 };
            Panel { x: axis.clone(), y: axis, series: vec![Series::silent(points, Look::curve(0))], scale }.ranges()[1]
        };
        let (low, high) = range(&[1.0, 1.000_001]);
        assert!((low - 0.99).abs() < 1e-5 && (high - 1.01).abs() < 1e-5, "{low} {high}");
        let (low, high) = range(&[0.8, 1.0]);
        assert!((low - 0.79).abs() < 1e-9 && (high - 1.01).abs() < 1e-9, "{low} {high}");
    }

    #[test]
    fn the_first_curves_differ_in_colour_and_pattern() {
        for i in 0..DASHES.len() * PALETTE.len() {
            for j in 0..i {
                assert_ne!(Look::curve(i), Look::curve(j));
            }
        }
    }
}
