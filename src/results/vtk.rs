//! The moving section as VTK files for ParaView: open a `.pvd`, its time is the punch travel.
//!
//! `section.pvd` names the files `section_0001.vtu` …, each with one quadrilateral per element between the sheet's faces.
//! Cells carry the columns of `profile.csv`, named with their units: `thickness [mm]`, and `thinning [%]`, which viewers show
//! first. Coordinates \[mm\]: x from the axis or the symmetry plane, y along the punch travel.
//!
//! Source: VTK XML file formats: Kitware, VTK File Formats (<https://docs.vtk.org>).

use super::{Files, StageView, tables};
use crate::model::Model;
use crate::plot::{fields::element::S0, sections, thinning::percent};
use crate::solver::solution::Frame;
use crate::table::{Column, Unit};
use std::fmt::{Display, Write};

const QUADRILATERAL: u8 = 9;
const EVERY: usize = 2;
pub(super) const COLLECTION: &str = "section.pvd";

pub(super) fn is_ours(name: &str) -> bool {
    let number = name.strip_prefix("section_").and_then(|rest| rest.strip_suffix(".vtu"));
    name == COLLECTION || number.is_some_and(|n| n.len() >= 4 && n.bytes().all(|b| b.is_ascii_digit()))
}

pub(super) fn files(view: &StageView, frames: &[&Frame]) -> Files {
    let (last, model) = (frames.len().saturating_sub(1), view.model());
    let (mut files, mut sets) = (Vec::new(), String::new());
    for (_, frame) in frames.iter().enumerate().filter(|(i, _)| i % EVERY == 0 || *i == last) {
        let name = format!("section_{:04}.vtu", files.len() + 1);
        let time = if model.travel > 0.0 { frame.travel } else { frame.time };
        let _ = writeln!(sets, "    <DataSet timestep=\"{time}\" part=\"0\" file=\"{name}\"/>");
        files.push((name, grid(model, frame).into_bytes()));
    }
    let text = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\">\n  <Collection>\n{sets}  </Collection>\n\
         </VTKFile>\n"
    );
    files.push((COLLECTION.to_owned(), text.into_bytes()));
    files
}

fn grid(model: &Model, frame: &Frame) -> String {
    let thinning = frame.elements.iter().map(percent).collect();
    let others = [S0].into_iter().chain(tables::element_fields(model));
    let others = others.map(|field| field.column(model.extent(), &frame.elements));
    let (nodes, cells) = (frame.nodes.len(), frame.elements.len());
    let points = (0..nodes).flat_map(|i| [1.0, -1.0].map(|side| sections::surface(frame, i, side)));
    let corners = (0..cells).flat_map(|e| [2 * e, 2 * e + 1, 2 * e + 3, 2 * e + 2]);
    let mut text = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\">\n<UnstructuredGrid>\n\
         <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{cells}\">\n<Points>\n",
        2 * nodes
    );
    let points = points.map(|(x, y)| format!("{x} {y} 0"));
    array(&mut text, "type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", points);
    text.push_str("</Points>\n<Cells>\n");
    array(&mut text, "type=\"Int64\" Name=\"connectivity\"", corners);
    array(&mut text, "type=\"Int64\" Name=\"offsets\"", (1..=cells).map(|i| 4 * i));
    array(&mut text, "type=\"UInt8\" Name=\"types\"", std::iter::repeat_n(QUADRILATERAL, cells));
    text.push_str("</Cells>\n<CellData Scalars=\"thinning [%]\">\n");
    for field in [Column::new("thinning", "Thinning", Unit::Percent, thinning)].into_iter().chain(others) {
        let unit = match field.unit.spelled() {
            "" => "-",
            "percent" => "%",
            unit => unit,
        };
        array(&mut text, &format!("type=\"Float64\" Name=\"{} [{unit}]\"", field.key), &field.values);
    }
    text + "</CellData>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n"
}

fn array(text: &mut String, attributes: &str, values: impl IntoIterator<Item = impl Display>) {
    let _ = write!(text, "<DataArray {attributes} format=\"ascii\">");
    values.into_iter().for_each(|value| _ = write!(text, "{value} "));
    text.push_str("</DataArray>\n");
}
