//! Computed curve and reference: points with their difference below, or a band.

use super::chart::{Panel, Series, Style, bounds};
use super::palette::{BLACK, GREY, color};
use crate::plot::Axis;
use crate::table::Unit;

const TOLERANCE: Style = Style::Line { color: GREY, width: 1.6, dash: &[6.0, 4.0] };
/// Tints of the reference's colour for its band, and for the band widened by its measurement error.
const MEASURED: Style = Style::Area { fill: (238, 174, 132), edge: Some((213, 94, 0)) };
const WIDENED: Style = Style::Area { fill: (249, 224, 206), edge: Some((213, 94, 0)) };

type Points = Vec<(f64, f64)>;

/// Computed line and reference points; below them the differences and their tolerance \[%\].
pub fn curve_panels(
    [x, y]: [Axis; 2],
    computed: Points,
    reference: Points,
    differences: Points,
    tolerance: f64,
) -> Vec<Panel> {
    let (low, high) = bounds(reference.iter().chain(&computed).map(|p| p.0));
    let level = |value: f64| vec![(low, value), (high, value)];
    let above = [
        Series::new("Computed", computed, Style::curve(0)),
        Series::new("Reference", reference, Style::Circles { color: color(1) }),
    ];
    let below = [
        Series::new(format!("Tolerance ±{tolerance} %"), level(tolerance), TOLERANCE),
        Series::silent(level(-tolerance), TOLERANCE),
        Series::silent(differences.clone(), Style::solid(BLACK, 1.6)),
        Series::silent(differences, Style::Circles { color: BLACK }),
    ];
    let difference = Axis::named("Difference", Unit::Percent);
    vec![Panel::fit(x.clone(), y, 270.0, 0.0).with(above), Panel::fit(x, difference, 150.0, 0.0).with(below)]
}

/// Band of reference values, if given also widened by its error, and the computed line with circles at the compared points;
/// texts are legend entries.
pub fn band_panel(
    [x, y]: [Axis; 2],
    computed: Points,
    compared: (String, Points),
    measured: (String, [f64; 2]),
    widened: Option<(String, [f64; 2])>,
) -> Panel {
    let ends = bounds(computed.iter().map(|p| p.0));
    let area = |(label, [low, high]): (String, [f64; 2]), style| {
        Series::new(label, vec![(ends.0, low), (ends.1, low), (ends.1, high), (ends.0, high)], style)
    };
    let bands = widened.map(|band| area(band, WIDENED)).into_iter().chain([area(measured, MEASURED)]);
    let line = Series::new("Computed", computed, Style::curve(0));
    let circles = Series::new(compared.0, compared.1, Style::Circles { color: BLACK });
    let circles = Some(circles).filter(|series| !series.points.is_empty());
    Panel::fit(x, y, 350.0, 0.0).with(bands.chain([line]).chain(circles))
}
