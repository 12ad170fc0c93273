//! What is measured on a shape, by name, and how it is written: with the digits that a mesh supports.

use super::Shape;
use crate::table::Unit;
use crate::units::{Amount, Digits};

/// Decimals of an angle \[°\] and of a length \[mm\]. Twice the elements, or four times, move the angle of a bent strip by
/// 0.04°, and those of a channel or a hat that has sprung back by 0.1 to 0.2°; height and edge go with the angle, by
/// 0.1 mm.
const DECIMALS: usize = 1;

/// Something that can be measured on a shape.
#[derive(Clone, Copy, Debug)]
pub struct ShapeMeasure {
    /// Name in files, without the unit.
    pub key: &'static str,
    /// Name in legends.
    pub label: &'static str,
    /// Unit of its values.
    pub unit: Unit,
    /// Measures it; `None` where the shape has no such thing.
    pub of: fn(&Shape) -> Option<f64>,
    /// How a value is told.
    told: fn(f64, Unit) -> String,
}

/// Of the wall to the direction of the punch \[°\].
pub const WALL_ANGLE: ShapeMeasure =
    ShapeMeasure::new("wall_angle", "Wall to the punch direction", Unit::Degree, Shape::wall_angle);
/// Between both walls \[°\].
pub const OPENING_ANGLE: ShapeMeasure =
    ShapeMeasure::new("opening_angle", "Opening angle", Unit::Degree, Shape::opening_angle);
/// Of the flange to the horizontal \[°\].
pub const FLANGE_ANGLE: ShapeMeasure =
    ShapeMeasure::new("flange_angle", "Flange to the horizontal", Unit::Degree, Shape::flange_angle);
/// Of the edge from the axis or the symmetry plane \[mm\].
pub const EDGE: ShapeMeasure = ShapeMeasure::new("edge", "Distance of the edge", Unit::Mm, |shape| shape.edge);

/// Everything that is measured, in the order of tables.
pub const SHAPE_MEASURES: &[ShapeMeasure] = &[
    WALL_ANGLE,
    OPENING_ANGLE,
    ShapeMeasure::new("bottom_to_wall", "Bottom to wall, θ₁", Unit::Degree, Shape::bottom_to_wall),
    ShapeMeasure::new("wall_to_flange", "Wall to flange, θ₂", Unit::Degree, Shape::wall_to_flange),
    FLANGE_ANGLE,
    ShapeMeasure {
        told: radius,
        ..ShapeMeasure::new("curl_radius", "Wall curl radius, ρ", Unit::Mm, Shape::curl_radius)
    },
    ShapeMeasure::new("height", "Height of the middle over the edge", Unit::Mm, |shape| shape.height),
    EDGE,
];

impl ShapeMeasure {
    const fn new(key: &'static str, label: &'static str, unit: Unit, of: fn(&Shape) -> Option<f64>) -> Self {
        Self { key, label, unit, of, told: measured }
    }

    /// A value as a reader is told it: `47.5°`, `224 mm`, `straight`.
    pub fn told(&self, value: f64) -> String {
        (self.told)(value, self.unit)
    }

    /// What is told of it behind its name: `Opening angle 90.0°`.
    pub fn named(&self, told: String) -> String {
        format!("{quantity} {told}", quantity = self.label)
    }

    /// A difference of values: `+7.9°`.
    pub fn signed(&self, difference: f64) -> String {
        let by = (self.told)(difference, self.unit);
        let is_more = difference > 0.0 && by != (self.told)(0.0, self.unit);
        if is_more { format!("+{by}") } else { by }
    }
}

/// `-0.3°`, `12.0 mm`.
fn measured(value: f64, unit: Unit) -> String {
    let least = 0.5 * 0.1_f64.powi(DECIMALS as i32);
    let value = if value.abs() < least { 0.0 } else { value };
    Amount::new(value, unit, Digits::Decimals(DECIMALS)).into()
}

/// `224 mm`, to whole millimetres, for twice the elements move it by a hundredth; an infinite one is that of a straight wall.
fn radius(value: f64, unit: Unit) -> String {
    let radius = Amount::new(value.abs(), unit, Digits::Decimals(0));
    match value {
        r if r.is_infinite() => "straight".into(),
        r if r < 0.0 => format!("{radius} inward"),
        _ => radius.into(),
    }
}

/// A quantity measured on two sheets.
#[derive(Clone, Copy, Debug)]
pub struct Change {
    /// What was measured.
    pub quantity: &'static ShapeMeasure,
    /// On the first sheet, in the unit of the quantity.
    pub before: Option<f64>,
    /// On the second.
    pub after: Option<f64>,
}

impl Change {
    /// After minus before, where both were found and neither is infinite.
    pub fn change(&self) -> Option<f64> {
        Some(self.after? - self.before?).filter(|change| change.is_finite())
    }

    /// `0.3° → 8.2°`.
    pub fn told(&self) -> String {
        let told = |value: Option<f64>| value.map_or("none".into(), |value| self.quantity.told(value));
        format!("{before} → {after}", before = told(self.before), after = told(self.after))
    }
}

/// Every quantity that one of the two shapes has, before and after; a wall's curl where it is curled.
pub fn changes(before: &Shape, after: &Shape) -> Vec<Change> {
    let all = SHAPE_MEASURES.iter().map(|quantity| {
        let of = quantity.of;
        Change { quantity, before: of(before), after: of(after) }
    });
    let is_there = |value: Option<f64>| value.is_some_and(f64::is_finite);
    all.filter(|change| is_there(change.before) || is_there(change.after)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn change(key: &str, before: Option<f64>, after: Option<f64>) -> Change {
        Change { quantity: SHAPE_MEASURES.iter().find(|q| q.key == key).expect("a quantity"), before, after }
    }

    #[test]
    fn values_have_the_digits_that_a_mesh_supports() {
        let angle = change("wall_angle", Some(-0.311), Some(8.234));
        assert_eq!(angle.told().to_string(), "-0.3° → 8.2°");
        assert_eq!(angle.quantity.signed(angle.change().expect("both")).to_string(), "+8.5°");
        assert_eq!(angle.quantity.signed(0.04).to_string(), "0.0°");
        assert_eq!(change("height", Some(28.819_725), Some(27.646_222)).told().to_string(), "28.8 mm → 27.6 mm");
    }

    #[test]
    fn a_wall_without_curl_is_called_straight() {
        let curl = change("curl_radius", Some(f64::INFINITY), Some(223.6));
        assert_eq!((curl.told().to_string(), curl.change()), ("straight → 224 mm".to_owned(), None));
        assert_eq!(change("curl_radius", None, Some(-150.0)).told().to_string(), "none → 150 mm inward");
    }
}
