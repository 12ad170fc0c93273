//! The drawing's unit and axis: from its coordinates to mm, and back for messages.

use super::ImportError;
use super::dxf::Drawing;
use super::options::{DrawingUnit, Options};
use crate::geometry::Point;
use crate::units::rounded;

/// Names of the units of $INSUNITS, from 1.
const UNITS: &str = "inches, feet, miles, mm, cm, m, km, microinches, mils, yards, ångströms, nanometres, micrometres, decimetres, \
    decametres, hectometres, gigametres, astronomical units, light years, parsecs, US survey feet, US survey inches, US survey \
    yards, US survey miles";

/// Unit and axis, which turn a drawing's coordinates into a section's.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    unit: DrawingUnit,
    /// \[mm\]
    axis: f64,
    /// \[mm\]
    pub join: f64,
    pub tolerance: f64,
}

impl Frame {
    /// Unit and axis of the options, or else the header's unit ($INSUNITS, then a metric $MEASUREMENT).
    pub fn new(drawing: &Drawing, options: &Options, notes: &mut Vec<String>) -> Result<Self, ImportError> {
        let (unit, from) = match options.unit {
            Some(unit) => (unit, "as asked for"),
            None => header_unit(drawing)?,
        };
        notes.push(format!("1 drawing unit is 1 {} ({from})", unit.symbol()));
        let axis = options.axis.unwrap_or(0.0);
        if axis != 0.0 {
            notes.push(format!("the axis is at x = {} mm of the drawing", rounded(axis)));
        }
        Ok(Self { unit, axis, join: options.join, tolerance: options.tolerance })
    }

    /// \[mm\], x from the axis.
    pub fn point(&self, p: Point) -> Point {
        Point::new(p.x * self.unit.mm() - self.axis, p.y * self.unit.mm())
    }

    /// \[mm\]
    pub fn length(&self, length: f64) -> f64 {
        length * self.unit.mm()
    }

    /// Point in the drawing's unit: `x = 30 mm, y = -6 mm`.
    pub fn place(&self, p: Point) -> String {
        format!("x = {}, y = {}", self.along(p.x + self.axis), self.along(p.y))
    }

    /// Length \[mm\] in the drawing's unit: `1.5 in`.
    pub fn along(&self, mm: f64) -> String {
        let written = (mm / self.unit.mm() * 1e6).round() / 1e6 + 0.0;
        format!("{written} {}", self.unit.symbol())
    }
}

fn header_unit(drawing: &Drawing) -> Result<(DrawingUnit, &'static str), ImportError> {
    let unit = match drawing.unit {
        1 => DrawingUnit::Inch,
        2 => DrawingUnit::Foot,
        4 => DrawingUnit::Mm,
        5 => DrawingUnit::Cm,
        6 => DrawingUnit::M,
        9 => DrawingUnit::Mil,
        13 => DrawingUnit::Micrometre,
        number => {
            let help = "mm (or in, cm, m)";
            if let Some(unit) = number.checked_sub(1).and_then(|i| UNITS.split(", ").nth(i)) {
                let what = format!("the drawing's unit is {unit} ($INSUNITS), which no tool is drawn in");
                return Err(ImportError::new(what, format!("say what it is drawn in: --unit {help}")));
            }
            if drawing.is_metric {
                return Ok((DrawingUnit::Mm, "$MEASUREMENT says metric, $INSUNITS names no unit"));
            }
            let what = "the drawing names no unit: neither $INSUNITS nor a metric $MEASUREMENT is in its header";
            return Err(ImportError::new(what, format!("say which: --unit {help}")));
        }
    };
    Ok((unit, "$INSUNITS of the drawing"))
}
