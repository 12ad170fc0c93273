//! The section as it moves as VTK files, to be looked at in ParaView: open a `.pvd`, its time is the punch travel. There
//! are about [`STATES`] states, spread as evenly as the steps allow, and the sheet before the first step.
//!
//! | collection | one file per state | cells |
//! |---|---|---|
//! | `section.pvd` | `section_0001.vtu` … | one quadrilateral per element between the sheet's faces |
//! | `revolved.pvd` | `revolved_0001.vtu` … | the same turned about the axis in [`SECTORS`] sectors; axisymmetric cases only |
//! | `tools.pvd` | `tools_0001.vtu` … | the lines of the tools, by `role [-]`: punch 0, die 1, holder 2 |
//!
//! Cells carry the columns of `profile.csv`, named with their units: `thickness [mm]`, `stress_hoop [MPa]`, and
//! `thinning [%]`, which viewers show first. Coordinates are in mm: x is the distance from the axis or the symmetry plane and y is z of the
//! section; the turned sheet's axis is z.
//!
//! # References
//! VTK XML file formats: Kitware, VTK File Formats (<https://docs.vtk.org>); S. Josefsson, RFC 4648 (2006).

mod base64;
mod grid;

use super::{Files, StageView, profile};
use crate::model::{Geometry, Model};
use crate::plot::thinning::percent;
use crate::plot::{animation, sections};
use crate::solver::solution::{ElementRecord, Frame};
use crate::table::fields::element::S0;
use crate::table::{Column, Field, Unit};
use grid::Grid;
use std::fmt::Write;

/// Sectors of a full turn, of 5° each: the volume of the turned sheet is 0.13 % below that of the round one.
pub const SECTORS: usize = 72;

/// Chords of tools leave their arcs by at most this share of the blank's length \[–\].
const SAGITTA: f64 = 1e-4;

/// Of the pictures of an animation one in so many is written: the files of the turned sheet take a megabyte or more each.
const EVERY: usize = 2;

/// How many states are wanted of a run after its start: half the pictures of its animation.
pub const STATES: usize = animation::PICTURES / EVERY;

/// `section.pvd` and its files: of these frames every second, the first and the last.
pub(super) fn section_files<'a>(view: &'a StageView, frames: &'a [&Frame]) -> Files<'a> {
    collection("section", view.model(), frames, |frame| section(view.model(), frame))
}

/// `revolved.pvd` and its files; none in plane strain.
pub(super) fn revolved_files<'a>(view: &'a StageView, frames: &'a [&Frame]) -> Files<'a> {
    match view.geometry() {
        Geometry::PlaneStrain => Box::new(std::iter::empty()),
        Geometry::Axisymmetric => {
            collection("revolved", view.model(), frames, |frame| section(view.model(), frame).turned(SECTORS))
        }
    }
}

/// `tools.pvd` and its files; none without a tool.
pub(super) fn tool_files<'a>(view: &'a StageView, frames: &'a [&Frame]) -> Files<'a> {
    match view.model().tools.is_empty() {
        true => Box::new(std::iter::empty()),
        false => collection("tools", view.model(), frames, |frame| tools(view.model(), frame)),
    }
}

/// Whether a file's name is one of the collection that a `.pvd` file names.
pub(super) fn is_of(collection: &str, name: &str) -> bool {
    let rest = collection.strip_suffix("pvd").and_then(|stem| name.strip_prefix(stem.trim_end_matches('.')));
    let number = rest.and_then(|rest| rest.strip_prefix('_')?.strip_suffix(".vtu"));
    number.is_some_and(|n| n.len() >= 4 && n.bytes().all(|b| b.is_ascii_digit()))
}

/// One file per frame, and as the last one, so that what it names is there, the file that says when each is.
fn collection<'a>(
    stem: &'static str,
    model: &'a Model,
    frames: &'a [&Frame],
    grid: impl Fn(&Frame) -> Grid + 'a,
) -> Files<'a> {
    let last = frames.len().saturating_sub(1);
    let frames: Vec<&Frame> = (0..frames.len()).filter(|i| i % EVERY == 0 || *i == last).map(|i| frames[i]).collect();
    let name = move |i: usize| format!("{stem}_{:04}.vtu", i + 1);
    let mut sets = String::new();
    for (i, frame) in frames.iter().enumerate() {
        let _ = writeln!(sets, "    <DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>", when(model, frame), name(i));
    }
    let text = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  \
         <Collection>\n{sets}  </Collection>\n</VTKFile>\n"
    );
    let states = frames.into_iter().enumerate().map(move |(i, frame)| (name(i), grid(frame).bytes()));
    Box::new(states.chain([(format!("{stem}.pvd"), text.into_bytes())]))
}

/// The travel \[mm\], or the time \[s\] where nothing travels.
fn when(model: &Model, frame: &Frame) -> f64 {
    if model.travel > 0.0 { frame.travel } else { frame.time }
}

/// A quadrilateral for every element, from face to face.
fn section(model: &Model, frame: &Frame) -> Grid {
    let faces = (0..frame.nodes.len()).flat_map(|i| [1.0, -1.0].map(|side| sections::surface(frame, i, side)));
    Grid::strip(faces.collect(), fields(model, frame))
}

/// How much thinner the sheet is, by which viewers colour it, and the columns of `profile.csv` that are no places of the
/// section and no times.
fn fields(model: &Model, frame: &Frame) -> Vec<Column> {
    let column = |field: Field<ElementRecord>| field.column(model.extent(), &frame.elements);
    let thinning = |element: &ElementRecord| percent(model.blank.thickness, element.thickness);
    let thinning = frame.elements.iter().map(thinning).collect();
    let thinning = Column::new("thinning", "Thinning", Unit::Percent, thinning);
    let others = std::iter::once(S0).chain(profile::fields(model)).map(column);
    std::iter::once(thinning).chain(others).collect()
}

/// A line for every tool, where it stands in the frame; its number is that of the role: punch 0, die 1, holder 2.
fn tools(model: &Model, frame: &Frame) -> Grid {
    let sagitta = SAGITTA * model.blank.length;
    let lines = model.tools.iter().enumerate();
    let lines = lines.map(|(i, tool)| sections::outline(&tool.profile, sections::place(frame, i), sagitta)).collect();
    let roles = model.tools.iter().map(|tool| tool.role as usize as f64).collect();
    Grid::lines(lines, vec![Column::new("role", "Punch 0, die 1, holder 2", Unit::None, roles)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_names_that_are_given_are_taken_for_ours() {
        for name in ["section_0001.vtu", "section_12345.vtu"] {
            assert!(is_of("section.pvd", name), "{name}");
        }
        for name in ["section_1.vtu", "section_mine.vtu", "section.vtu", "tools_0001.vtu", "section_0001.vtu.bak"] {
            assert!(!is_of("section.pvd", name), "{name}");
        }
    }
}
