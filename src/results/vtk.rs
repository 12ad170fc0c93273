//! The moving section as VTK files for ParaView: open a `.pvd`, its time is the punch travel.
//!
//! | collection | one file per state | cells |
//! |---|---|---|
//! | `section.pvd` | `section_0001.vtu` … | one quadrilateral per element between the sheet's faces |
//! | `tools.pvd` | `tools_0001.vtu` … | the lines of the tools, by `role [-]`: punch 0, die 1, holder 2 |
//!
//! Cells carry the columns of `profile.csv`, named with their units: `thickness [mm]`, and `thinning [%]`, which viewers show
//! first. Coordinates \[mm\]: x from the axis or the symmetry plane, y along the punch travel.
//!
//! # References
//! VTK XML file formats: Kitware, VTK File Formats (<https://docs.vtk.org>).

use super::{Files, StageView, tables};
use crate::model::Model;
use crate::plot::fields::element::S0;
use crate::plot::thinning::percent;
use crate::plot::{animation, sections};
use crate::solver::solution::Frame;
use crate::table::{Column, Unit};
use std::fmt::{Display, Write};

/// Distance of the tools' chords from their arcs over the blank's length \[–\].
const SAGITTA: f64 = 1e-4;

/// Cell types in VTK.
const LINE: u8 = 3;
const QUADRILATERAL: u8 = 9;

/// Step between the pictures of an animation that are written.
const EVERY: usize = 2;

/// States wanted of a run after its start.
pub const STATES: usize = animation::PICTURES / EVERY;

/// `section.pvd` and its files.
pub(super) fn section_files(view: &StageView, frames: &[&Frame]) -> Files {
    collection("section", view.model(), frames, section)
}

/// `tools.pvd` and its files; none without a tool.
pub(super) fn tool_files(view: &StageView, frames: &[&Frame]) -> Files {
    if view.model().tools.is_empty() { Vec::new() } else { collection("tools", view.model(), frames, tools) }
}

/// Tells whether a file's name is one of the collection that a `.pvd` file names.
pub(super) fn is_of(collection: &str, name: &str) -> bool {
    let rest = collection.strip_suffix(".pvd").and_then(|stem| name.strip_prefix(stem));
    let number = rest.and_then(|rest| rest.strip_prefix('_')?.strip_suffix(".vtu"));
    number.is_some_and(|n| n.len() >= 4 && n.bytes().all(|b| b.is_ascii_digit()))
}

/// One file for every second frame, the first and the last, and the file that gives their times.
fn collection(stem: &str, model: &Model, frames: &[&Frame], grid: fn(&Model, &Frame) -> String) -> Files {
    let last = frames.len().saturating_sub(1);
    let (mut files, mut sets) = (Vec::new(), String::new());
    for (_, frame) in frames.iter().enumerate().filter(|(i, _)| i % EVERY == 0 || *i == last) {
        let name = format!("{stem}_{:04}.vtu", files.len() + 1);
        let time = if model.travel > 0.0 { frame.travel } else { frame.time };
        let _ = writeln!(sets, "    <DataSet timestep=\"{time}\" part=\"0\" file=\"{name}\"/>");
        files.push((name, grid(model, frame).into_bytes()));
    }
    let text = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n{sets}  </Collection>\n\
         </VTKFile>\n"
    );
    files.push((format!("{stem}.pvd"), text.into_bytes()));
    files
}

fn section(model: &Model, frame: &Frame) -> String {
    let thinning = frame.elements.iter().map(|element| percent(model.blank.thickness, element.thickness)).collect();
    let others = [S0].into_iter().chain(tables::element_fields(model));
    let others = others.map(|field| field.column(model.extent(), &frame.elements));
    let fields = [Column::new("thinning", "Thinning", Unit::Percent, thinning)].into_iter().chain(others);
    let points = (0..frame.nodes.len()).flat_map(|i| [1.0, -1.0].map(|side| sections::surface(frame, i, side)));
    let cells: Vec<_> = (0..frame.elements.len()).map(|e| [2 * e, 2 * e + 1, 2 * e + 3, 2 * e + 2]).collect();
    grid(&points.collect::<Vec<_>>(), &cells, QUADRILATERAL, &fields.collect::<Vec<_>>())
}

/// Every tool as pieces of a line: not all readers know lines of many points.
fn tools(model: &Model, frame: &Frame) -> String {
    let (mut points, mut cells, mut roles) = (Vec::new(), Vec::new(), Vec::new());
    for (i, tool) in model.tools.iter().enumerate() {
        let sagitta = SAGITTA * model.blank.length;
        let mut line = sections::outline(&tool.profile, sections::tool_displacement(frame, i), sagitta);
        line.dedup();
        cells.extend((points.len() + 1..points.len() + line.len()).map(|n| [n - 1, n]));
        points.extend(line);
        roles.resize(cells.len(), tool.role as usize as f64);
    }
    grid(&points, &cells, LINE, &[Column::new("role", "Punch 0, die 1, holder 2", Unit::None, roles)])
}

/// Unstructured grid of cells of one type, with one entry of every field per cell.
fn grid<const CORNERS: usize>(
    points: &[(f64, f64)],
    cells: &[[usize; CORNERS]],
    cell_type: u8,
    fields: &[Column],
) -> String {
    let mut text = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">\n<UnstructuredGrid>\n\
         <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<Points>\n",
        points.len(),
        cells.len()
    );
    let points = points.iter().map(|(x, y)| format!("{x} {y} 0"));
    array(&mut text, "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", points);
    text.push_str("</Points>\n<Cells>\n");
    array(&mut text, "type=\"Int64\" Name=\"connectivity\"", cells.as_flattened());
    array(&mut text, "type=\"Int64\" Name=\"offsets\"", (1..=cells.len()).map(|i| i * CORNERS));
    array(&mut text, "type=\"UInt8\" Name=\"types\"", std::iter::repeat_n(cell_type, cells.len()));
    let _ = writeln!(text, "</Cells>\n<CellData Scalars=\"{}\">", fields.first().map_or_else(String::new, name));
    for field in fields {
        array(&mut text, &format!("type=\"Float64\" Name=\"{}\"", name(field)), &field.values);
    }
    text + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"
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

fn array(text: &mut String, attributes: &str, values: impl IntoIterator<Item = impl Display>) {
    let _ = write!(text, "<DataArray {attributes} format=\"ascii\">");
    values.into_iter().for_each(|value| _ = write!(text, "{value} "));
    text.push_str("</DataArray>\n");
}
