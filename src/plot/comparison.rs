//! Computed curve and reference: points with their difference below, or a band.

use super::chart::{Panel, Series, Style, bounds};
use super::palette::{BLACK, GREY, color};
use crate::table::{Axis, Unit};

const TOLERANCE: Style = Style::Line { color: GREY, width: 1.6, dash: &[6.0, 4.0] };
/// Tints of the reference's colour for its band, and for the band widened by its measurement error.
const MEASURED: Style = Style::Area { fill: (238, 174, 132), edge: Some((213, 94, 0)) };
const WIDENED: Style = Style::Area { fill: (249, 224, 206), edge: Some((213, 94, 0)) };

/// Computed curve against reference points.
#[derive(Clone, Debug)]
pub struct CurveComparison {
    /// Axes of both curves.
    pub axes: [Axis; 2],
    /// Computed curve.
    pub computed: Vec<(f64, f64)>,
    /// Reference points.
    pub reference: Vec<(f64, f64)>,
    /// Relative differences over x \[%\].
    pub differences: Vec<(f64, f64)>,
    /// Accepted difference \[%\].
    pub tolerance: f64,
}

/// Computed curve against a band of reference values.
#[derive(Clone, Debug)]
pub struct BandComparison {
    /// Axes.
    pub axes: [Axis; 2],
    /// Computed curve.
    pub computed: Vec<(f64, f64)>,
    /// Computed points that are compared, with their legend entry.
    pub compared: (String, Vec<(f64, f64)>),
    /// Reference values from the lowest to the highest, with their legend entry.
    pub measured: (String, [f64; 2]),
    /// Reference widened by its error, if it has one.
    pub widened: Option<(String, [f64; 2])>,
}

impl CurveComparison {
    /// Reference as circles, computed as a line; the difference and its tolerance below.
    pub fn panels(self) -> Vec<Panel> {
        let [x, y] = self.axes;
        let (low, high) = bounds(self.reference.iter().chain(&self.computed).map(|p| p.0));
        let level = |value: f64| vec![(low, value), (high, value)];
        let above = [
            Series::new("Computed", self.computed, Style::curve(0)),
            Series::new("Reference", self.reference, Style::Circles { color: color(1) }),
        ];
        let below = [
            Series::new(format!("Tolerance ±{} %", self.tolerance), level(self.tolerance), TOLERANCE),
            Series::silent(level(-self.tolerance), TOLERANCE),
            Series::silent(self.differences.clone(), Style::solid(BLACK, 1.6)),
            Series::silent(self.differences, Style::Circles { color: BLACK }),
        ];
        let difference = Axis::named("Difference", Unit::Percent);
        vec![Panel::fit(x.clone(), y, 270.0, 0.0).with(above), Panel::fit(x, difference, 150.0, 0.0).with(below)]
    }
}

impl BandComparison {
    /// Band over the whole width, the computed curve in front, circles at the compared values.
    pub fn panel(self) -> Panel {
        let [x, y] = self.axes;
        let ends = bounds(self.computed.iter().map(|p| p.0));
        let area = |(label, [low, high]): (String, [f64; 2]), style| {
            Series::new(label, vec![(ends.0, low), (ends.1, low), (ends.1, high), (ends.0, high)], style)
        };
        let widened = self.widened.map(|band| area(band, WIDENED));
        let measured = area(self.measured, MEASURED);
        let (label, points) = self.compared;
        let compared = (!points.is_empty()).then(|| Series::new(label, points, Style::Circles { color: BLACK }));
        let computed = Series::new("Computed", self.computed, Style::curve(0));
        Panel::fit(x, y, 350.0, 0.0).with(widened.into_iter().chain([measured, computed]).chain(compared))
    }
}
