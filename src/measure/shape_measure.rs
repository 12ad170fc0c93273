//! Angles and lengths measured on a shape, with the digits of a tolerance.

use super::Shape;
use crate::units::{Amount, Digits, Unit};
use std::fmt;

/// Decimals of a released shape's angles \[°\] and lengths \[mm\]: of tolerances; error bars are 0.2 to 3°, 0.1 to 1.2 mm.
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
    /// Measures a shape; `None` where it has no such part.
    pub of: fn(&Shape) -> Option<f64>,
}

/// Angle of the wall to the direction of the punch \[°\].
pub const WALL_ANGLE: ShapeMeasure = angle("wall_angle", "Wall to the punch direction", Shape::wall_angle);
/// Angle between both walls \[°\].
pub const OPENING_ANGLE: ShapeMeasure = angle("opening_angle", "Opening angle", Shape::opening_angle);
/// Angle of the flange to the horizontal \[°\].
pub const FLANGE_ANGLE: ShapeMeasure = angle("flange_angle", "Flange to the horizontal", Shape::flange_angle);
/// Distance of the edge from the axis or the symmetry plane \[mm\].
pub const EDGE: ShapeMeasure = length("edge", "Distance of the edge", |shape| shape.edge);
const CURL_RADIUS: ShapeMeasure = length("curl_radius", "Wall curl radius, ρ", Shape::curl_radius);

/// All measures in the order of tables.
pub const SHAPE_MEASURES: &[ShapeMeasure] = &[
    WALL_ANGLE,
    OPENING_ANGLE,
    angle("bottom_to_wall", "Bottom to wall, θ₁", Shape::bottom_to_wall),
    angle("wall_to_flange", "Wall to flange, θ₂", Shape::wall_to_flange),
    FLANGE_ANGLE,
    CURL_RADIUS,
    length("part_height", "Height over all", |shape| shape.height),
    EDGE,
];

const fn angle(key: &'static str, label: &'static str, of: fn(&Shape) -> Option<f64>) -> ShapeMeasure {
    ShapeMeasure { key, label, unit: Unit::Degree, of }
}

const fn length(key: &'static str, label: &'static str, of: fn(&Shape) -> Option<f64>) -> ShapeMeasure {
    ShapeMeasure { key, label, unit: Unit::Mm, of }
}

impl ShapeMeasure {
    /// Formats a value: `47.5°`, `224 mm`, `straight`.
    pub fn text(&self, value: f64) -> String {
        if self.key != CURL_RADIUS.key {
            return Amount::new(value, self.unit, Digits::Decimals(DECIMALS)).to_string();
        }
        let radius = Amount::new(value.abs(), self.unit, Digits::Decimals(0));
        match value {
            r if r.is_infinite() => "straight".into(),
            r if r < 0.0 => format!("{radius} inward"),
            _ => radius.to_string(),
        }
    }

    /// Formats a difference of values: `+7.9°`.
    pub fn signed_text(&self, difference: f64) -> String {
        let by = self.difference_text(difference);
        if difference > 0.0 && by != self.difference_text(0.0) { format!("+{by}") } else { by }
    }

    pub(crate) fn difference_text(&self, difference: f64) -> String {
        Amount::new(difference, self.unit, Digits::Decimals(DECIMALS)).to_string()
    }
}

/// A measure of two shapes.
#[derive(Clone, Copy, Debug)]
pub struct Change {
    /// The measure.
    pub quantity: &'static ShapeMeasure,
    /// Value of the first shape, in the unit of the measure.
    pub before: Option<f64>,
    /// Value of the second shape.
    pub after: Option<f64>,
}

impl Change {
    /// After minus before, where both are finite.
    pub fn change(&self) -> Option<f64> {
        Some(self.after? - self.before?).filter(|change| change.is_finite())
    }
}

impl fmt::Display for Change {
    /// `0.3° → 8.2°`
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let text = |value: Option<f64>| value.map_or("none".into(), |value| self.quantity.text(value));
        write!(f, "{} → {}", text(self.before), text(self.after))
    }
}

/// All measures that one of the two shapes has; the curl of a wall where it is curled.
pub fn changes(before: &Shape, after: &Shape) -> Vec<Change> {
    let all = SHAPE_MEASURES.iter().map(|of| Change { quantity: of, before: (of.of)(before), after: (of.of)(after) });
    all.filter(|change| [change.before, change.after].into_iter().flatten().any(f64::is_finite)).collect()
}
