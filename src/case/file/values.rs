//! Values that several tables share: histories, forces in all or per depth, lengths from the axis; enums by the kind of TOML value.

use super::*;
use crate::units::{Force, Kind, LineForce, parse};
use schemars::{Schema, SchemaGenerator, json_schema};
use serde::de::Error;
use std::borrow::Cow;

/// Least force that differs from round-off \[N or N/mm\].
const LEAST: f64 = 1e-6;

/// Implements `Deserialize` for an enum with one variant per kind of value; errors inside a variant keep their place.
macro_rules! untagged {
    (
        [$($generic:ident: $bound:ident),*] $type:ty, $expecting:expr
        $(, switch($switch:ident) => $of_switch:expr)?
        $(, text($text:ident) => $of_text:expr)?
        $(, number($number:ident) => $of_number:expr)?
        $(, list => $of_list:expr)?
        $(, table => $of_table:expr)?
    ) => {
        impl<'de, $($generic: $bound + serde::Deserialize<'de>),*> serde::Deserialize<'de> for $type {
            fn deserialize<D: serde::Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
                struct Kinds<T>(std::marker::PhantomData<T>);
                impl<'de, $($generic: $bound + serde::Deserialize<'de>),*> serde::de::Visitor<'de> for Kinds<$type> {
                    type Value = $type;

                    fn expecting(&self, f: &mut std::fmt::Formatter) -> std::fmt::Result {
                        f.write_str($expecting)
                    }
                    $(fn visit_bool<E: serde::de::Error>(self, $switch: bool) -> Result<$type, E> { $of_switch })?
                    $(fn visit_str<E: serde::de::Error>(self, $text: &str) -> Result<$type, E> { $of_text })?
                    $(
                    fn visit_i64<E: serde::de::Error>(self, n: i64) -> Result<$type, E> { self.visit_f64(n as f64) }
                    fn visit_f64<E: serde::de::Error>(self, $number: f64) -> Result<$type, E> { $of_number }
                    )?
                    $(
                    fn visit_seq<A: serde::de::SeqAccess<'de>>(self, list: A) -> Result<$type, A::Error> {
                        serde::Deserialize::deserialize(serde::de::value::SeqAccessDeserializer::new(list)).map($of_list)
                    }
                    )?
                    $(
                    fn visit_map<A: serde::de::MapAccess<'de>>(self, table: A) -> Result<$type, A::Error> {
                        serde::Deserialize::deserialize(serde::de::value::MapAccessDeserializer::new(table)).map($of_table)
                    }
                    )?
                }
                from.deserialize_any(Kinds::<$type>(std::marker::PhantomData))
            }
        }
    };
}
pub(super) use untagged;

/// Value as text, or a list of points `[x, value]` with x rising.
#[derive(Clone, Debug, JsonSchema)]
#[schemars(untagged, inline)]
pub enum History<X, V> {
    Constant(V),
    // Straight between the points.
    Points(Vec<(X, V)>),
}

untagged!(
    [X: Sized, V: Sized] History<X, V>, "a value with its unit, or a list of points [x, value]",
    text(text) => V::deserialize(text.into_deserializer()).map(History::Constant),
    number(value) => V::deserialize(value.into_deserializer()).map(History::Constant),
    list => History::Points
);

impl<X: Dimensioned, V: Copy> History<X, V> {
    /// Curve with rising x, which error messages call `axis`; `value` converts at a key path.
    pub fn curve(
        &self, path: &str, axis: &str, source: &Source, value: impl Fn(V, &str) -> Result<f64>,
    ) -> Result<PiecewiseLinear> {
        let points = match self {
            Self::Constant(constant) => return Ok(value(*constant, path)?.into()),
            Self::Points(points) => points.iter().enumerate(),
        };
        let convert = |(i, (x, y)): (usize, &(X, V))| Ok((x.value(), value(*y, &format!("{path}.{i}"))?));
        let points = points.map(convert).collect::<Result<Vec<(f64, f64)>>>()?;
        let help = "write [x, value] pairs, or one value";
        source.require(!points.is_empty(), path, "the list of points is empty", help)?;
        if let Some(i) = points.windows(2).position(|w| w[1].0 <= w[0].0) {
            let what = format!("the {axis} of the points must rise, found {} after {}", points[i + 1].0, points[i].0);
            return Err(source.error(&format!("{path}.{}", i + 1), what, "sort the points, each place once"));
        }
        Ok(PiecewiseLinear::new(points).expect("checked above"))
    }
}

/// Force of the whole section, or per mm of its depth.
pub type HolderForce = Extensive<Force, LineForce>;
/// Stiffness of the whole holder: force per length, or force per length and depth.
pub type Stiffness = Extensive<LineForce, Stress>;

/// Quantity of the whole section, or the same per mm of depth.
#[derive(Clone, Copy, Debug)]
pub enum Extensive<W, P> {
    /// Axisymmetric, or in plane strain over a known depth.
    InAll(NonNegative<W>),
    /// Plane strain.
    PerDepth(NonNegative<P>),
}

untagged!(
    [W: Dimensioned, P: Dimensioned] Extensive<W, P>, "a value with its unit, of the whole section or per mm of depth",
    text(text) => Extensive::read(text),
    number(value) => Extensive::read(&value.to_string())
);

impl<W: Dimensioned, P: Dimensioned> JsonSchema for Extensive<W, P> {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        format!("{} in all or per depth", W::KIND.name).into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let quantity = [W::KIND, P::KIND].map(Kind::measured).join(", or ");
        let examples = [W::KIND.examples[0], P::KIND.examples[0]];
        json_schema!({ "type": "string", "examples": examples, "x-quantity": quantity })
    }
}

impl<W: Dimensioned, P: Dimensioned> Extensive<W, P> {
    fn read<E: Error>(text: &str) -> Result<Self, E> {
        match parse(text).is_ok_and(|parsed| parsed.dimension == P::KIND.dimension()) {
            true => NonNegative::deserialize(text.into_deserializer()).map(Self::PerDepth),
            false => NonNegative::deserialize(text.into_deserializer()).map(Self::InAll),
        }
    }

    /// Value in the units of the extent.
    pub fn in_extent(self, path: &str, extent: Extent, source: &Source) -> Result<f64> {
        let key = path.split('.').rfind(|key| key.parse::<usize>().is_err()).unwrap_or(path);
        let wrong = |what: String, force: String, stiffness: &str| {
            let stiffness = format!("such as stiffness = \"{stiffness}\"");
            Err(source.error(path, what, if key == "stiffness" { stiffness } else { force }))
        };
        let value = match (self, extent) {
            (Self::InAll(_), Extent::PerDepth) => {
                let force = format!("write a force per length, such as {key} = \"2600 N/mm\", or give blank.depth");
                let what = format!("in plane strain without blank.depth `{key}` is per mm of depth");
                return wrong(what, force, "50 N/mm^2");
            }
            (Self::PerDepth(_), Extent::Ring) => {
                let what = format!("in an axisymmetric case `{key}` is that of the whole ring");
                return wrong(what, format!("write a force, such as {key} = \"80 kN\""), "5 kN/mm");
            }
            (Self::PerDepth(value), Extent::Depth(depth)) => value.value() * depth,
            (Self::PerDepth(value), Extent::PerDepth) => value.value(),
            (Self::InAll(value), _) => value.value(),
        };
        let what = format!("this `{key}` is next to nothing");
        source.require(value == 0.0 || value >= LEAST, path, what, "check the unit, or write 0 for none")?;
        Ok(value)
    }
}

/// Distance from the axis or symmetry plane \[mm\] and its key: radius, diameter, or half-width in plane strain.
pub fn radius_of(
    source: &Source, table: &str, geometry: Geometry, keys: [&'static str; 3], lengths: [Option<Positive<Length>>; 3],
) -> Result<(&'static str, f64)> {
    let (name, other, own, mut foreign) = match geometry {
        Geometry::Axisymmetric => ("axisymmetric", "plane-strain", 0, 2..3),
        Geometry::PlaneStrain => ("plane strain", "axisymmetric", 2, 0..2),
    };
    if let Some((i, length)) = foreign.find_map(|i: usize| Some((i, lengths[i].filter(|_| keys[i] != keys[own])?))) {
        let half = if i == 1 { 0.5 } else { 1.0 } * length.value();
        let what = format!("`{}` belongs to {other} cases, this one is {name}", keys[i]);
        let help = format!("write {} = \"{} mm\", or change `geometry`", keys[own], rounded(half));
        return Err(source.error(&format!("{table}.{}", keys[i]), what, help));
    }
    source.one_of(table, &keys[..2], "keep one of them")?;
    match (lengths[own], lengths[1]) {
        (Some(radius), _) => Ok((keys[own], radius.value())),
        (None, Some(across)) => Ok((keys[1], 0.5 * across.value())),
        (None, None) => Err(source.missing(table, keys[own])),
    }
}

pub fn count(source: &Source, path: &str, value: i64, range: RangeInclusive<i64>) -> Result<usize> {
    let key = path.rsplit('.').next().unwrap_or(path);
    let (least, most) = (range.start(), range.end());
    let what = format!("`{key}` must lie between {least} and {most}, found {value}");
    let help = format!("the nearest that can be solved: {key} = {}", value.clamp(*least, *most));
    source.require(range.contains(&value), path, what, help)?;
    Ok(value as usize)
}

pub fn place_of(at: Point) -> String {
    // Adding 0 takes the sign from a rounded −0.
    let round = |x: f64| (x * 1e4).round() / 1e4 + 0.0;
    format!("r = {} mm, z = {} mm", round(at.x), round(at.y))
}
