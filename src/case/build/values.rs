//! Checks and conversions shared by all tables.

use crate::case::file::{Extensive, Given};
use crate::case::{CaseError, source::Source};
use crate::geometry::Point;
use crate::model::{Extent, Geometry};
use crate::numerics::PiecewiseLinear;
use crate::units::{Dimensioned, Length, Positive, rounded};
use std::ops::RangeInclusive;

/// Least force that differs from round-off \[N or N/mm\].
const LEAST: f64 = 1e-6;

/// Distance from the axis or symmetry plane \[mm\], and the key that gives it. The keys and their lengths are radius and
/// diameter of a round part, and the half-width in plane strain.
pub(super) fn radius_of(
    source: &Source,
    table: &str,
    geometry: Geometry,
    keys: [&'static str; 3],
    lengths: [Option<Positive<Length>>; 3],
) -> Result<(&'static str, f64), CaseError> {
    let path = |key: &str| format!("{table}.{key}");
    let (name, other, own, foreign) = match geometry {
        Geometry::Axisymmetric => ("axisymmetric", "plane-strain", 0, &[2][..]),
        Geometry::PlaneStrain => ("plane strain", "axisymmetric", 2, &[0, 1][..]),
    };
    let foreign = foreign.iter().find_map(|&i| Some((i, lengths[i].filter(|_| keys[i] != keys[own])?)));
    if let Some((i, length)) = foreign {
        let half = if i == 1 { 0.5 } else { 1.0 } * length.value();
        let what = format!("`{}` belongs to {other} cases, this one is {name}", keys[i]);
        let help = format!("write {} = \"{} mm\", or change `geometry`", keys[own], rounded(half));
        return Err(source.error(&path(keys[i]), what, help));
    }
    source.one_of(table, &keys[..2], "keep one of them")?;
    match (lengths[own], lengths[1]) {
        (Some(radius), _) => Ok((keys[own], radius.value())),
        (None, Some(across)) => Ok((keys[1], 0.5 * across.value())),
        (None, None) => Err(source.missing(table, keys[own])),
    }
}

/// Whole number within limits.
pub(super) fn count(source: &Source, path: &str, value: i64, range: RangeInclusive<i64>) -> Result<usize, CaseError> {
    let key = path.rsplit('.').next().unwrap_or(path);
    let (least, most) = (range.start(), range.end());
    let what = format!("`{key}` must lie between {least} and {most}, found {value}");
    let help = format!("the nearest that can be solved: {key} = {}", value.clamp(*least, *most));
    source.require(range.contains(&value), path, what, help)?;
    Ok(value as usize)
}

/// Force in the units of the extent.
pub(super) fn force<W: Dimensioned, D: Dimensioned>(
    force: Extensive<W, D>,
    path: &str,
    extent: Extent,
    source: &Source,
) -> Result<f64, CaseError> {
    let key = path.split('.').rfind(|key| key.parse::<usize>().is_err()).unwrap_or(path);
    let stiffness = key == "stiffness";
    let force = force.in_extent(extent).map_err(|case| {
        let (refers, help) = match (extent, stiffness) {
            (Extent::Ring, true) => ("that of the whole ring", "such as stiffness = \"5 kN/mm\"".to_owned()),
            (Extent::Ring, _) => ("that of the whole ring", format!("write a force, such as {key} = \"80 kN\"")),
            (_, true) => ("per mm of depth", "such as stiffness = \"50 N/mm^2\"".to_owned()),
            _ => (
                "per mm of depth",
                format!("write a force per length, such as {key} = \"2600 N/mm\", or give blank.depth"),
            ),
        };
        source.error(path, format!("{case} `{key}` is {refers}"), help)
    })?;
    let what = format!("this `{key}` is next to nothing");
    source.require(force == 0.0 || force >= LEAST, path, what, "check the unit, or write 0 for none")?;
    Ok(force)
}

/// Piecewise linear history with rising x, which error messages call `axis`; `value` converts at a key path.
pub(super) fn history<X: Dimensioned, V: Copy>(
    given: &Given<X, V>,
    path: &str,
    axis: &str,
    source: &Source,
    value: impl Fn(V, &str) -> Result<f64, CaseError>,
) -> Result<PiecewiseLinear, CaseError> {
    let points = match given {
        Given::Constant(constant) => return Ok(value(*constant, path)?.into()),
        Given::Points(points) => points.iter().enumerate(),
    };
    let convert = |(i, (x, y)): (usize, &(X, V))| Ok((x.value(), value(*y, &format!("{path}.{i}"))?));
    let points = points.map(convert).collect::<Result<Vec<(f64, f64)>, CaseError>>()?;
    source.require(!points.is_empty(), path, "the list of points is empty", "write [x, value] pairs, or one value")?;
    if let Some(i) = points.windows(2).position(|w| w[1].0 <= w[0].0) {
        let what = format!("the {axis} of the points must rise, found {} after {}", points[i + 1].0, points[i].0);
        return Err(source.error(&format!("{path}.{}", i + 1), what, "sort the points, each place once"));
    }
    Ok(PiecewiseLinear::new(points).expect("checked above"))
}

/// Coordinates as text.
pub(super) fn place_of(at: Point) -> String {
    // Adding 0 takes the sign from a rounded −0.
    let round = |x: f64| (x * 1e4).round() / 1e4 + 0.0;
    format!("r = {} mm, z = {} mm", round(at.x), round(at.y))
}
