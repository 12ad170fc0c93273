//! Chart values: panels of series with labelled axes, a title and notes, free of any drawing library.

use super::*;
use serde::Serialize;

/// Picture: panels below each other, one legend above them, notes below.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Chart {
    /// Text above the panels.
    pub title: String,
    /// Heading of the legend; may be empty.
    pub legend: String,
    /// Panels from the top down.
    pub panels: Vec<Panel>,
    /// Small print: assumptions and sources; long lines are wrapped.
    pub notes: Vec<String>,
}

/// One pair of axes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Panel {
    /// Text above a small panel.
    pub caption: String,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Curves, points and areas from the back to the front.
    pub series: Vec<Series>,
    /// Texts in front of all series.
    pub annotations: Vec<Annotation>,
    /// Ranges and size.
    pub scale: Scale,
    /// True if such panels stand side by side; a small section has no axes.
    pub is_small: bool,
}

/// Ranges and size of a panel; heights are in px of a picture 800 px wide.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Scale {
    /// All points fit; zero is included if it is near.
    Fit {
        /// Height \[px\].
        height: f64,
        /// Least span of the y axis in its unit, so that it does not zoom in on noise.
        least: f64,
    },
    /// Given ranges; areas are clipped.
    Window {
        /// Height \[px\].
        height: f64,
        /// Range of x in the unit of the axis.
        x: (f64, f64),
        /// Range of y in the unit of the axis.
        y: (f64, f64),
    },
    /// Equal scales with y pointing down the page; shows at least this window, areas are clipped.
    Section {
        /// Range of x in the unit of the axis.
        x: (f64, f64),
        /// Range of y in the unit of the axis.
        y: (f64, f64),
    },
    /// Colour bar over the values of x, y from 0 to 1.
    Bar,
}

/// Curve, set of points or filled outline.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Series {
    /// Legend entry; `None` leaves the series out of the legend.
    pub label: Option<String>,
    /// x and y in the units of the axes; a series without points is a legend entry only.
    pub points: Vec<(f64, f64)>,
    /// Line, marker or fill.
    pub style: Style,
}

/// Line, marker or fill of a series; lengths are in px of a picture 800 px wide.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Style {
    /// Line through the points.
    Line {
        /// Colour of the line.
        color: Color,
        /// Thickness \[px\].
        width: f64,
        /// Lengths drawn and left out in turn \[px\]; solid if empty.
        dash: &'static [f64],
    },
    /// Open circles.
    Circles {
        /// Colour of the outlines.
        color: Color,
    },
    /// Filled circles.
    Dots {
        /// Colour of the dots.
        color: Color,
    },
    /// Filled triangles, distinct from dots in grey print.
    Triangles {
        /// Colour of the triangles.
        color: Color,
    },
    /// Filled polygon.
    Area {
        /// Colour of the inside.
        fill: Color,
        /// Colour of the outline, if there is one.
        edge: Option<Color>,
    },
}

/// Text in a panel; points are in the units of the axes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Annotation {
    /// Point that the text belongs to.
    pub at: (f64, f64),
    /// Text itself.
    pub text: String,
    /// Position of the text.
    pub kind: AnnotationKind,
}

/// Position of an annotation's text.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum AnnotationKind {
    /// Text begins at the point.
    Start,
    /// Text ends at the point.
    End,
    /// Text above all curves, with a thin vertical line to a dot at the point; flags never overlap.
    Flag,
}

/// Red, green, blue.
pub type Color = (u8, u8, u8);

impl Series {
    /// Series with a legend entry; of many circles few are drawn.
    pub fn new(label: impl Into<String>, points: Vec<(f64, f64)>, style: Style) -> Self {
        Self { label: Some(label.into()), ..Self::silent(points, style) }
    }

    /// Series without a legend entry.
    pub fn silent(points: Vec<(f64, f64)>, style: Style) -> Self {
        let points = if matches!(style, Style::Circles { .. }) { thinned(points) } else { points };
        Self { label: None, points, style }
    }
}

const MARKERS: usize = 400;

/// Points that are drawn as markers, evenly picked of many.
pub fn thinned(points: Vec<(f64, f64)>) -> Vec<(f64, f64)> {
    let every = points.len().div_ceil(MARKERS).max(1);
    points.into_iter().step_by(every).collect()
}

impl Annotation {
    /// Text above all curves with a line to its point.
    pub fn flag(text: impl Into<String>, at: (f64, f64)) -> Self {
        Self { at, text: text.into(), kind: AnnotationKind::Flag }
    }
}

impl Chart {
    /// Chart of some panels.
    pub fn new(title: impl Into<String>, panels: Vec<Panel>, notes: Vec<String>) -> Self {
        Self { title: title.into(), legend: String::new(), panels, notes }
    }

    /// Chart in the units of [`DisplaySettings`](crate::units::DisplaySettings); converted once only.
    pub fn displayed(self) -> Self {
        Self { panels: self.panels.into_iter().map(Panel::displayed).collect(), ..self }
    }
}

impl Panel {
    /// Empty panel.
    pub fn new(x: Axis, y: Axis, scale: Scale) -> Self {
        let (series, annotations) = (Vec::new(), Vec::new());
        Self { caption: String::new(), x, y, series, annotations, scale, is_small: false }
    }

    /// Panel whose ranges fit its series.
    pub fn fit(x: Axis, y: Axis, height: f64, least: f64) -> Self {
        Self::new(x, y, Scale::Fit { height, least })
    }

    /// Adds series in front of the others.
    pub fn with(mut self, series: impl IntoIterator<Item = Series>) -> Self {
        self.series.extend(series);
        self
    }

    /// Adds annotations.
    pub fn annotated(mut self, annotations: impl IntoIterator<Item = Annotation>) -> Self {
        self.annotations.extend(annotations);
        self
    }

    pub(super) fn is_section(&self) -> bool {
        matches!(self.scale, Scale::Section { .. })
    }

    /// True for a small section, which is drawn without axes.
    pub fn has_no_axes(&self) -> bool {
        self.is_small && self.is_section()
    }

    fn displayed(mut self) -> Self {
        let points = self.series.iter().flat_map(|series| series.points.iter().copied());
        let (xs, ys): (Vec<f64>, Vec<f64>) = points.unzip();
        let (along, up) = (self.x.displayed(&xs), self.y.displayed(&ys));
        let points = self.series.iter_mut().flat_map(|series| &mut series.points);
        let points = points.chain(self.annotations.iter_mut().map(|annotation| &mut annotation.at));
        points.for_each(|(x, y)| (*x, *y) = (along(*x), up(*y)));
        match &mut self.scale {
            Scale::Fit { least, .. } => *least = up(*least) - up(0.0),
            Scale::Section { x, y } | Scale::Window { x, y, .. } => {
                (*x, *y) = ((along(x.0), along(x.1)), (up(y.0), up(y.1)));
            }
            Scale::Bar => {}
        }
        self
    }

    /// Ranges of x and y: the given window, or the least one that holds every point.
    pub fn ranges(&self) -> [(f64, f64); 2] {
        let points = || self.series.iter().flat_map(|s| &s.points).chain(self.annotations.iter().map(|a| &a.at));
        match self.scale {
            Scale::Section { x, y } | Scale::Window { x, y, .. } => [x, y],
            Scale::Bar => [bounds(points().map(|p| p.0)), (0.0, 1.0)],
            Scale::Fit { least, .. } => {
                let y = fitted(points().map(|p| p.1), 0.05);
                let more = 0.5 * (least - (y.1 - y.0)).max(0.0);
                [fitted(points().map(|p| p.0), 0.02), (y.0 - more, y.1 + more)]
            }
        }
    }
}

const LARGEST: f64 = 1e300;

pub(crate) fn bounds(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let finite = values.filter(|v| v.abs() < LARGEST);
    finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)))
}

fn fitted(values: impl Iterator<Item = f64>, margin: f64) -> (f64, f64) {
    let (low, high) = bounds(values);
    if low > high {
        return (0.0, 1.0);
    }
    let low = if low > 0.0 && low < 0.5 * high { 0.0 } else { low };
    let high = if high < 0.0 && high > 0.5 * low { 0.0 } else { high };
    let is_point = high - low <= 1e-9 * high.abs().max(low.abs());
    let pad = if is_point { 0.5 * high.abs().max(1e-6) } else { margin * (high - low) };
    (if low == 0.0 { 0.0 } else { low - pad }, if high == 0.0 && low < 0.0 { 0.0 } else { high + pad })
}
