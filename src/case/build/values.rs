//! Checks and conversions shared by all tables.

use crate::case::{CaseError, source::Source};
use crate::geometry::Point;
use crate::model::Geometry;
use crate::units::{Dimensioned, Length, Positive, rounded};

/// Key and the length that it may give.
pub(super) type Key = (&'static str, Option<Positive<Length>>);

/// Distance from the axis or symmetry plane \[mm\], and the key that gives it: a radius or a diameter of a round part, the key
/// `strip` in plane strain.
pub(super) fn radius_of(
    source: &Source,
    table: &str,
    geometry: Geometry,
    radius: Key,
    diameter: Key,
    strip: Key,
) -> Result<(&'static str, f64), CaseError> {
    let path = |key: &str| format!("{table}.{key}");
    let (name, other, key, foreign) = match geometry {
        Geometry::Axisymmetric => ("axisymmetric", "plane-strain", radius, [strip, strip]),
        Geometry::PlaneStrain => ("plane strain", "axisymmetric", strip, [radius, diameter]),
    };
    if let Some((wrong, Some(value))) = foreign.into_iter().find(|(wrong, value)| *wrong != key.0 && value.is_some()) {
        let half = if wrong == diameter.0 { 0.5 } else { 1.0 } * value.value();
        let what = format!("`{wrong}` belongs to {other} cases, this one is {name}");
        let help = format!("write {} = \"{} mm\", or change `geometry`", key.0, rounded(half));
        return Err(source.error(&path(wrong), what, help));
    }
    match (key.1, diameter.1.filter(|_| geometry == Geometry::Axisymmetric)) {
        (Some(_), Some(_)) => {
            let what = format!("both `{}` and `{}` are given", key.0, diameter.0);
            Err(source.error(&path(diameter.0), what, "keep one of them"))
        }
        (Some(radius), None) => Ok((key.0, radius.value())),
        (None, Some(across)) => Ok((diameter.0, 0.5 * across.value())),
        (None, None) => Err(source.missing(table, key.0)),
    }
}

/// Whole number within limits.
pub(super) fn count(
    source: &Source,
    path: &str,
    value: i64,
    range: std::ops::RangeInclusive<i64>,
) -> Result<usize, CaseError> {
    let key = path.rsplit('.').next().unwrap_or(path);
    let (least, most) = (range.start(), range.end());
    let what = format!("`{key}` must lie between {least} and {most}, found {value}");
    let help = format!("the nearest that can be solved: {key} = {}", value.clamp(*least, *most));
    source.require(range.contains(&value), path, what, help)?;
    Ok(value as usize)
}

/// Names of the given ones of some keys.
pub(super) fn keys_present<const N: usize>(keys: [(&'static str, bool); N]) -> Vec<&'static str> {
    keys.into_iter().filter(|(_, given)| *given).map(|(name, _)| name).collect()
}

/// Coordinates as text.
pub(super) fn place_of(at: Point) -> String {
    // Adding 0 takes the sign from a rounded −0.
    let round = |x: f64| (x * 1e4).round() / 1e4 + 0.0;
    format!("r = {} mm, z = {} mm", round(at.x), round(at.y))
}
