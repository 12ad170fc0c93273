//! The drawing's unit and axis: from its coordinates to mm, and back for messages.

use super::{ImportError, Result, dxf::Drawing, options::DrawingUnit, options::Options};
use crate::geometry::Point;
use crate::rules::{WIDEST, WIDTHS};
use crate::units::{joined, rounded, significant};
use std::cell::RefCell;

/// Units of $INSUNITS, from 1: symbols of those of tools, names of others.
const UNITS: &str = "in, ft, miles, mm, cm, m, km, microinches, mil, yards, ångströms, nanometres, um, decimetres, decametres, \
    hectometres, gigametres, astronomical units, light years, parsecs, US survey feet, US survey inches, US survey yards, US \
    survey miles";

const LIKELY: [DrawingUnit; 4] =
    [DrawingUnit::MM, DrawingUnit::INCH, DrawingUnit("cm", 10.0), DrawingUnit("m", 1000.0)];

impl DrawingUnit {
    /// Number in the header of a DXF file, $INSUNITS.
    pub fn code(self) -> usize {
        UNITS.split(", ").position(|name| name == self.0).map_or(0, |i| i + 1)
    }
}

#[derive(Clone)]
pub(super) struct Frame {
    pub unit: DrawingUnit,
    /// \[mm\]
    axis: f64,
    /// \[mm\]
    pub join: f64,
    pub tolerance: f64,
    pub notes: RefCell<Vec<String>>,
}

impl Frame {
    pub fn new(drawing: &Drawing, options: &Options) -> Result<Self> {
        let (unit, from) = options.unit.map_or_else(|| header_unit(drawing), |unit| Ok((unit, "as asked for")))?;
        let Options { join, tolerance, .. } = *options;
        let frame = Self { unit, axis: options.axis.unwrap_or(0.0), join, tolerance, notes: RefCell::default() };
        frame.note(format!("1 drawing unit is 1 {} ({from})", unit.0));
        if frame.axis != 0.0 {
            frame.note(format!("the axis is at x = {} mm of the drawing", rounded(frame.axis)));
        }
        Ok(frame)
    }

    /// Refuses a header's unit that makes the tools as wide as no stamping \[mm\]; declared: most wrong headers say inch.
    pub fn check_unit(&self, options: &Options, width: f64) -> Result {
        let most = if self.unit == DrawingUnit::MM { WIDEST } else { *WIDTHS.end() };
        if options.unit.is_some() || (*WIDTHS.start()..=most).contains(&width) {
            return Ok(());
        }
        let fits = LIKELY.iter().map(|own| (own.0, width / self.unit.1 * own.1)).filter(|(_, mm)| WIDTHS.contains(mm));
        let fits = fits.map(|(unit, mm)| format!("try --unit {unit}, {} mm wide", significant(mm, 3)));
        let (mm, unit) = (significant(width, 3), self.unit.0);
        let what = format!("no stamping is {mm} mm wide, as the tools are if 1 drawing unit is 1 {unit}");
        let all = format!("--unit {} says what it is drawn in, whatever its header says", DrawingUnit::ALL.join(", "));
        Err(ImportError::new(what, joined(fits.chain([all]), "; ")))
    }

    pub fn note(&self, note: String) {
        self.notes.borrow_mut().push(note);
    }

    /// \[mm\], x from the axis.
    pub fn point(&self, p: Point) -> Point {
        Point::new(p.x * self.unit.1 - self.axis, p.y * self.unit.1)
    }

    /// Point in the drawing's unit: `x = 30 mm, y = -6 mm`.
    pub fn place(&self, p: Point) -> String {
        format!("x = {}, y = {}", self.along(p.x + self.axis), self.along(p.y))
    }

    /// Length \[mm\] in the drawing's unit: `1.5 in`.
    pub fn along(&self, mm: f64) -> String {
        let written = (mm / self.unit.1 * 1e6).round() / 1e6 + 0.0;
        format!("{written} {}", self.unit.0)
    }
}

fn header_unit(drawing: &Drawing) -> Result<(DrawingUnit, &'static str)> {
    let name = drawing.unit.checked_sub(1).and_then(|i| UNITS.split(", ").nth(i));
    if let Some(unit) = name.and_then(|name| name.parse().ok()) {
        return Ok((unit, "$INSUNITS of the drawing"));
    }
    if let Some(name) = name {
        let what = format!("the drawing's unit is {name} ($INSUNITS), which no tool is drawn in");
        return Err(ImportError::new(what, "say what it is drawn in: --unit mm (or in, cm, m)"));
    }
    if drawing.is_metric {
        return Ok((DrawingUnit::MM, "$MEASUREMENT says metric, $INSUNITS names no unit"));
    }
    let what = "the drawing names no unit: neither $INSUNITS nor a metric $MEASUREMENT is in its header";
    Err(ImportError::new(what, "say which: --unit mm (or in, cm, m)"))
}
