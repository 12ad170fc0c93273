//! Writer of DXF text: a group code and a value, each on a line of its own.
//!
//! The rest of a file, with the tables that AutoCAD asks for, stands in `r12.dxf` and `r2000.dxf`.
//!
//! # References
//! Autodesk, DXF Reference (not read: group codes as commonly used); $INSUNITS is younger than R12, whose readers pass over it.

use crate::geometry::{Arc, Piece, Point};
use crate::import::DrawingUnit;
use crate::plot::drawing::{Layer, coordinate, extent};
use std::{f64::consts::TAU, fmt::Display, fmt::Write};

const FIRST: u32 = 0x100;
const OWNERS: [&str; 2] = ["1", "17"];
/// Height of texts over the drawing's width \[–\].
const TEXT: f64 = 0.02;

struct Writer {
    out: String,
    is_2000: bool,
    handle: u32,
    /// Length of a drawing unit \[mm\].
    unit: f64,
}

pub(super) fn write(layers: &[Layer], unit: DrawingUnit, is_2000: bool) -> String {
    let mut writer = Writer { out: String::new(), is_2000, handle: FIRST, unit: unit.1 };
    let (low, high) = extent(layers);
    writer.layer("0", 7);
    layers.iter().for_each(|layer| writer.layer(&layer.name, layer.color.0));
    let table = std::mem::take(&mut writer.out);
    layers.iter().for_each(|layer| writer.entities(layer, TEXT * (high.x - low.x)));
    let template = if is_2000 { include_str!("r2000.dxf") } else { include_str!("r12.dxf") };
    let (middle, size) = (0.5 * (low + high), 1.2 * (high - low).max());
    let lengths = [low.x, low.y, high.x, high.y, middle.x, middle.y, size].map(|mm| coordinate(mm / unit.1));
    let places = ["<left>", "<low>", "<right>", "<high>", "<middle_x>", "<middle_y>", "<height>"];
    let others = [
        ("<insunits>", unit.code().to_string()),
        ("<measurement>", u8::from(unit.0.ends_with('m')).to_string()),
        ("<count>", (layers.len() + 1).to_string()),
        ("<layers>\n", table),
        ("<entities>\n", writer.out),
        ("<next_handle>", format!("{:X}", writer.handle)),
    ];
    let values = places.into_iter().zip(lengths).chain(others);
    values.fold(template.to_owned(), |text, (place, value)| text.replacen(place, &value, 1))
}

impl Writer {
    /// Code and value; handle, owner and class are of release 2000.
    fn group(&mut self, code: i32, value: impl Display) {
        if self.is_2000 || ![5, 330, 100].contains(&code) {
            let _ = writeln!(self.out, "{code}\n{value}");
        }
    }

    fn point(&mut self, x: i32, p: Point, has_height: bool) {
        let [across, up] = [p.x, p.y].map(|mm| coordinate(mm / self.unit));
        let height = if has_height { format!("\n{}\n0.0", x + 20) } else { String::new() };
        let _ = writeln!(self.out, "{x}\n{across}\n{}\n{up}{height}", x + 10);
    }

    fn begin(&mut self, kind: &str, owner: &str, class: &str) {
        self.group(0, kind);
        self.group(5, format!("{:X}", self.handle));
        self.group(330, owner);
        self.group(100, class);
        self.handle += 1;
    }

    fn layer(&mut self, name: &str, color: u8) {
        self.begin("LAYER", OWNERS[0], "AcDbSymbolTableRecord");
        self.group(100, "AcDbLayerTableRecord");
        self.group(2, name);
        self.group(70, 0);
        self.group(62, color);
        self.group(6, "CONTINUOUS");
    }

    fn entity(&mut self, kind: &str, layer: &str, class: &str) {
        self.begin(kind, OWNERS[1], "AcDbEntity");
        self.group(8, layer);
        self.group(100, class);
    }

    fn entities(&mut self, layer: &Layer, height: f64) {
        let name = &layer.name;
        if layer.is_joined {
            self.polyline(name, &layer.pieces);
        }
        for piece in layer.pieces.iter().filter(|_| !layer.is_joined) {
            match piece {
                Piece::Segment(line) => {
                    self.entity("LINE", name, "AcDbLine");
                    self.point(10, line.from, true);
                    self.point(11, line.to, true);
                }
                Piece::Arc(arc) => self.arc(name, arc),
            }
        }
        if let Some((at, text)) = &layer.label {
            self.entity("TEXT", name, "AcDbText");
            self.point(10, *at, true);
            self.group(40, coordinate(height / self.unit));
            self.group(1, text.replace('Ø', "%%c"));
            self.group(100, "AcDbText");
        }
    }

    fn polyline(&mut self, layer: &str, pieces: &[Piece]) {
        let (first, last) = (pieces[0].first(), pieces[pieces.len() - 1].last());
        let end = Some(last).filter(|last| *last != first);
        let points: Vec<Point> = pieces.iter().map(Piece::first).chain(end).collect();
        let is_closed = u8::from(end.is_none());
        if self.is_2000 {
            self.entity("LWPOLYLINE", layer, "AcDbPolyline");
            self.group(90, points.len());
            self.group(70, is_closed);
            points.iter().for_each(|p| self.point(10, *p, false));
            return;
        }
        self.entity("POLYLINE", layer, "");
        self.group(66, 1);
        self.point(10, Point::zeros(), true);
        self.group(70, is_closed);
        for p in points {
            self.entity("VERTEX", layer, "");
            self.point(10, p, true);
        }
        self.entity("SEQEND", layer, "");
    }

    fn arc(&mut self, layer: &str, arc: &Arc) {
        let from = arc.start + arc.sweep.min(0.0);
        self.entity("ARC", layer, "AcDbCircle");
        self.point(10, arc.center, true);
        self.group(40, coordinate(arc.radius / self.unit));
        self.group(100, "AcDbArc");
        for (code, angle) in [(50, from), (51, from + arc.sweep.abs())] {
            self.group(code, coordinate(angle.rem_euclid(TAU).to_degrees()));
        }
    }
}
