//! Points and cells with numbers on them, and the file they become.

use super::base64::base64;
use crate::table::Column;
use std::f64::consts::TAU;
use std::fmt::Write;

/// Cells by their numbers in VTK.
#[derive(Clone, Copy, Debug, PartialEq)]
enum CellType {
    Line = 3,
    Quad = 9,
    Hexahedron = 12,
    Wedge = 13,
}

/// An unstructured grid with one entry of every field per cell.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Grid {
    /// x, y, z of each point \[mm\].
    points: Vec<[f64; 3]>,
    /// Numbers of each cell's points, in VTK's order.
    cells: Vec<(CellType, Vec<u64>)>,
    /// The first one is what a viewer colours by.
    fields: Vec<Column>,
}

impl Grid {
    /// Quadrilaterals between two lines of points; `faces` holds a point of the one, then of the other.
    pub fn strip(faces: Vec<(f64, f64)>, fields: Vec<Column>) -> Self {
        let corners = |e: u64| vec![2 * e, 2 * e + 1, 2 * e + 3, 2 * e + 2];
        let elements = (faces.len() as u64 / 2).saturating_sub(1);
        Self {
            points: faces.into_iter().map(|(x, y)| [x, y, 0.0]).collect(),
            cells: (0..elements).map(|e| (CellType::Quad, corners(e))).collect(),
            fields,
        }
    }

    /// Open lines through lists of points, a cell for every piece: not all readers know lines of many points. `fields` has
    /// an entry for each line.
    pub fn lines(lines: Vec<Vec<(f64, f64)>>, fields: Vec<Column>) -> Self {
        let (mut points, mut cells, mut pieces) = (Vec::new(), Vec::new(), Vec::new());
        for mut line in lines {
            line.dedup();
            let first = points.len() as u64;
            pieces.push(line.len() - 1);
            points.extend(line.into_iter().map(|(x, y)| [x, y, 0.0]));
            cells.extend((first + 1..points.len() as u64).map(|i| (CellType::Line, vec![i - 1, i])));
        }
        let repeated = |field: Column| {
            let values = field.values.iter().zip(&pieces).flat_map(|(value, n)| std::iter::repeat_n(*value, *n));
            Column { values: values.collect(), ..field }
        };
        let fields = fields.into_iter().map(repeated).collect();
        Self { points, cells, fields }
    }

    /// A strip turned about x = 0: hexahedra, and wedges where a quadrilateral lies on the axis, sector by sector.
    pub fn turned(self, sectors: usize) -> Self {
        let count = self.points.len() as u64;
        let around = |k: usize| (TAU * k as f64 / sectors as f64).sin_cos();
        let points = (0..sectors).flat_map(|k| {
            let (sin, cos) = around(k);
            self.points.iter().map(move |[r, z, _]| [r * cos, r * sin, *z])
        });
        let points = points.collect();
        let on_axis = |corner: u64| self.points[corner as usize][0] == 0.0;
        let cells = (0..sectors).flat_map(|k| {
            let (here, there) = (k as u64 * count, (k + 1) as u64 % sectors as u64 * count);
            self.cells.iter().map(move |(_, quad)| {
                let [a, b, c, d] = [quad[0], quad[1], quad[2], quad[3]];
                // Points of all sectors coincide on the axis: those of the first are taken.
                if on_axis(a) && on_axis(b) {
                    (CellType::Wedge, vec![a, d + there, d + here, b, c + there, c + here])
                } else {
                    (CellType::Hexahedron, [here, there].iter().flat_map(|at| [a, d, c, b].map(|n| n + at)).collect())
                }
            })
        });
        let cells = cells.collect();
        let fields = self.fields.into_iter();
        let fields = fields.map(|field| Column { values: field.values.repeat(sectors), ..field }).collect();
        Self { points, cells, fields }
    }

    /// A `.vtu` file: XML with little-endian arrays in base64.
    pub fn bytes(&self) -> Vec<u8> {
        let doubles = |values: &[f64]| values.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<u8>>();
        let counts = |counts: &mut dyn Iterator<Item = u64>| counts.flat_map(u64::to_le_bytes).collect::<Vec<u8>>();
        let corners = counts(&mut self.cells.iter().flat_map(|(_, corners)| corners.iter().copied()));
        let ends = counts(&mut self.cells.iter().scan(0, |end, (_, corners)| {
            *end += corners.len() as u64;
            Some(*end)
        }));
        let types: Vec<u8> = self.cells.iter().map(|(kind, _)| *kind as u8).collect();
        let mut text = format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\">\n<UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
            self.points.len(),
            self.cells.len()
        );
        array(
            &mut text,
            "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"",
            &doubles(self.points.as_flattened()),
        );
        text.push_str("</Points>\n<Cells>\n");
        array(&mut text, "type=\"Int64\" Name=\"connectivity\"", &corners);
        array(&mut text, "type=\"Int64\" Name=\"offsets\"", &ends);
        array(&mut text, "type=\"UInt8\" Name=\"types\"", &types);
        text.push_str("</Cells>\n");
        let _ = writeln!(text, "<CellData Scalars=\"{}\">", self.fields.first().map_or_else(String::new, name));
        for column in &self.fields {
            array(&mut text, &format!("type=\"Float64\" Name=\"{}\"", name(column)), &doubles(&column.values));
        }
        text.push_str("</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
        text.into_bytes()
    }
}

/// `thickness [mm]`
fn name(column: &Column) -> String {
    let unit = match column.unit.spelled() {
        "" => "-",
        "percent" => "%",
        unit => unit,
    };
    format!("{} [{unit}]", column.key)
}

/// One array: how many bytes it has, and the bytes.
fn array(text: &mut String, attributes: &str, bytes: &[u8]) {
    let counted = [&(bytes.len() as u64).to_le_bytes(), bytes].concat();
    let _ = writeln!(text, "<DataArray {attributes} format=\"binary\">{}</DataArray>", base64(&counted));
}
