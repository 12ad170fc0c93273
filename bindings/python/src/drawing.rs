//! Cases from drawings.

use super::case::Case;
use super::error;
use super::picture::{Picture, picture};
use super::words::plain;
use pyo3::prelude::*;
use stampflow::author::{Import, ImportFailure, Imported};
use stampflow::case::files::{Disk, Files};
use stampflow::import::{self, ImportError, Options};
use stampflow::output::sketch;
use stampflow::units::{Length, Positive, Quantity};
use std::path::PathBuf;

/// Unit, axis, join, tolerance, which way the punch moves, geometry.
type How = [Option<String>; 6];

/// Sheet, thickness, blank, travel.
type Sizes = [Option<String>; 4];

/// A case of a DXF drawing, how it was understood, and a picture of what was read.
#[pyfunction]
pub fn from_drawing<'py>(
    py: Python<'py>,
    path: PathBuf,
    layers: Vec<String>,
    how: How,
    sizes: Sizes,
) -> PyResult<(Case, Vec<String>, Picture<'py>)> {
    let shown = path.display().to_string();
    let wrong = |error: ImportError| error::of_drawing(py, &shown, &error);
    let refused = |what: String, help: &str| ImportError { what, help: help.to_owned(), line: None };
    let asked = asked(&layers, how, sizes).map_err(wrong)?;
    let bytes = Disk.read(&path, import::LARGEST);
    let bytes =
        bytes.map_err(|error| wrong(refused(format!("it cannot be read: {error}"), "give the path of a DXF file")))?;
    let imported = asked.read(&bytes, &path).map_err(|failure| match failure {
        ImportFailure::Drawing(error) => wrong(error),
        ImportFailure::Sheet(error) | ImportFailure::Case(error) => error::of_case(py, &error),
    })?;
    let Imported { sections, text, case, notes, .. } = imported;
    if case.is_none() {
        let what = "no punch is drawn, so that the case cannot be run".to_owned();
        return Err(wrong(refused(what, "name its layer: layers={\"NAME\": \"punch\"}")));
    }
    let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let drawn = picture(py, &sketch(&name, asked.geometry, &sections));
    let case = Case::parse(py, text, path.with_extension("toml").to_string_lossy().into_owned(), Vec::new())?;
    Ok((case, notes.iter().map(plain).collect(), drawn))
}

fn asked(layers: &[String], how: How, sizes: Sizes) -> Result<Import, ImportError> {
    let [unit, axis, join, tolerance, punch_moves, geometry] = how;
    let [material, thickness, blank, travel] = sizes;
    let size = |name: &str, text: Option<String>| read::<Positive<Length>>(name, text).map(|l| l.map(|l| l.value()));
    let default = Options::default();
    let layers = layers.iter().map(|text| import::layer(text).map_err(|help| wrong("layers", text, help)));
    Ok(Import {
        options: Options {
            layers: layers.collect::<Result<_, _>>()?,
            unit: read("units", unit)?,
            axis: read::<Length>("axis", axis)?.map(|axis| axis.value()),
            join: size("join", join)?.unwrap_or(default.join),
            tolerance: size("tolerance", tolerance)?.unwrap_or(default.tolerance),
            punch_moves: read("punch_moves", punch_moves)?,
        },
        geometry: read("geometry", geometry)?.unwrap_or(stampflow::model::Geometry::Axisymmetric),
        material,
        thickness: size("thickness", thickness)?,
        blank: size("blank_radius", blank)?,
        travel: size("travel", travel)?,
    })
}

/// A text of an option, where it is given.
fn read<T: std::str::FromStr<Err: ToString>>(name: &str, text: Option<String>) -> Result<Option<T>, ImportError> {
    text.map(|text| text.parse().map_err(|error: T::Err| wrong(name, &text, error.to_string()))).transpose()
}

fn wrong(name: &str, text: &str, help: String) -> ImportError {
    ImportError { what: format!("{name}: `{text}` is not understood"), help, line: None }
}
