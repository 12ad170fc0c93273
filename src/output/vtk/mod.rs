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
//! `thinning [%]`. Coordinates are in mm: x is the distance from the axis or the symmetry plane and y is z of the
//! section; the turned sheet's axis is z.
//!
//! # References
//! VTK XML file formats: Kitware, VTK File Formats (<https://docs.vtk.org>); S. Josefsson, RFC 4648 (2006).

mod base64;
mod grid;

use super::file::{WriteError, write as write_file};
use super::{Subject, film, profile, shapes};
use crate::model::{Geometry, Model};
use crate::solution::Frame;
use crate::table::{Column, Unit};
use grid::Grid;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Sectors of a full turn, of 5° each: the volume of the turned sheet is 0.13 % below that of the round one.
pub const SECTORS: usize = 72;

/// The collections' names.
const SECTION: &str = "section";
const REVOLVED: &str = "revolved";
const TOOLS: &str = "tools";

/// The files to open.
pub(super) const COLLECTIONS: [&str; 3] = ["section.pvd", "revolved.pvd", "tools.pvd"];

/// Chords of tools leave their arcs by at most this share of the blank's length \[–\].
const SAGITTA: f64 = 1e-4;

/// Of the pictures of a film one in so many is written: the files of the turned sheet take a megabyte or more each.
const EVERY: usize = 2;

/// How many states are wanted of a run after its start: half the pictures of its film.
pub const STATES: usize = film::PICTURES / EVERY;

/// Writes the collections and their files into `dir`: of these frames, rising in time and about [`film::PICTURES`], every
/// second, the first and the last; nothing of a run that never started.
///
/// # Errors
/// When a file cannot be written.
pub fn write(subject: &Subject, frames: &[Frame], dir: &Path) -> Result<Vec<PathBuf>, WriteError> {
    let model = subject.model;
    if frames.len() < 2 {
        return Ok(Vec::new());
    }
    let last = frames.len() - 1;
    let frames: Vec<&Frame> = (0..=last).filter(|i| i % EVERY == 0 || *i == last).map(|i| &frames[i]).collect();
    let mut written = collection(SECTION, dir, model, &frames, |frame| section(model, frame))?;
    if model.geometry == Geometry::Axisymmetric {
        written.extend(collection(REVOLVED, dir, model, &frames, |frame| section(model, frame).turned(SECTORS))?);
    }
    if !model.tools.is_empty() {
        written.extend(collection(TOOLS, dir, model, &frames, |frame| tools(model, frame))?);
    }
    Ok(written)
}

/// Whether a file's name is one that [`write`] gives.
pub(super) fn is_ours(name: &str) -> bool {
    [SECTION, REVOLVED, TOOLS].iter().filter_map(|stem| name.strip_prefix(stem)).any(|rest| {
        let number = rest.strip_prefix('_').and_then(|rest| rest.strip_suffix(".vtu"));
        rest == ".pvd" || number.is_some_and(|n| n.len() >= 4 && n.bytes().all(|b| b.is_ascii_digit()))
    })
}

/// One file per frame, and the file that says when each is.
fn collection(
    stem: &str,
    dir: &Path,
    model: &Model,
    frames: &[&Frame],
    grid: impl Fn(&Frame) -> Grid,
) -> Result<Vec<PathBuf>, WriteError> {
    let mut written = Vec::new();
    let mut sets = String::new();
    for (i, frame) in frames.iter().enumerate() {
        let name = format!("{stem}_{:04}.vtu", i + 1);
        write_file(&dir.join(&name), &grid(frame).bytes())?;
        let _ = writeln!(sets, "    <DataSet timestep=\"{}\" part=\"0\" file=\"{name}\"/>", when(model, frame));
        written.push(dir.join(name));
    }
    let path = dir.join(format!("{stem}.pvd"));
    let text = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n  \
         <Collection>\n{sets}  </Collection>\n</VTKFile>\n"
    );
    // The last one: what it names is there.
    write_file(&path, text.as_bytes())?;
    written.push(path);
    Ok(written)
}

/// The travel \[mm\], or the time \[s\] where nothing travels.
fn when(model: &Model, frame: &Frame) -> f64 {
    if model.travel > 0.0 { frame.travel } else { frame.time }
}

/// A quadrilateral for every element, from face to face.
fn section(model: &Model, frame: &Frame) -> Grid {
    let faces = (0..frame.nodes.len()).flat_map(|i| [1.0, -1.0].map(|side| shapes::surface(frame, i, side)));
    Grid::strip(faces.collect(), fields(model, frame))
}

/// The columns of `profile.csv` that are no places and no times, and how much thinner the sheet is.
fn fields(model: &Model, frame: &Frame) -> Vec<Column> {
    let table = profile::table(model, std::slice::from_ref(frame));
    let thinning = |t: &f64| 100.0 * (1.0 - t / model.blank.thickness);
    let thinning = table.column("thickness").values.iter().map(thinning).collect();
    let mut fields = table.columns;
    fields.retain(|column| !["travel", "r", "z"].contains(&column.key));
    fields.push(Column::new("thinning", "Thinning", Unit::Percent, thinning));
    fields
}

/// A line for every tool, where it stands in the frame; its number is that of the role: punch 0, die 1, holder 2.
fn tools(model: &Model, frame: &Frame) -> Grid {
    let sagitta = SAGITTA * model.blank.length;
    let lines = model.tools.iter().enumerate();
    let lines = lines.map(|(i, tool)| shapes::outline(&tool.profile, shapes::place(frame, i), sagitta)).collect();
    let roles = model.tools.iter().map(|tool| tool.role as usize as f64).collect();
    Grid::lines(lines, vec![Column::new("role", "Punch 0, die 1, holder 2", Unit::None, roles)])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_names_that_are_given_are_taken_for_ours() {
        for name in ["section.pvd", "revolved_0001.vtu", "tools_12345.vtu"] {
            assert!(is_ours(name), "{name}");
        }
        for name in ["section_1.vtu", "section_mine.vtu", "section.vtu", "my_section.pvd", "tools.pvd.bak"] {
            assert!(!is_ours(name), "{name}");
        }
    }
}
