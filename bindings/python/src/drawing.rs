//! Cases from drawings.

use super::error;
use super::table::{Picture, picture};
use pyo3::prelude::*;
use serde::Deserialize;
use stampflow::author::Import;
use stampflow::case::files::{Disk, Files};
use stampflow::import::{self, ImportError, Options};
use stampflow::units::{Dimensioned, Fraction, Length, Positive};
use std::{collections::BTreeMap, path::PathBuf, str::FromStr};

/// Options of an import, as texts with units.
#[derive(Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct Request {
    layers: BTreeMap<String, String>,
    units: Option<String>,
    axis: Option<String>,
    join: Option<String>,
    tolerance: Option<String>,
    punch_moves: Option<String>,
    geometry: Option<String>,
    material: Option<String>,
    thickness: Option<String>,
    blank_radius: Option<String>,
    travel: Option<String>,
    friction: Option<f64>,
    set: Vec<String>,
}

/// Text and name of the case of a DXF drawing, how it was understood, and a picture of what was read.
#[pyfunction]
pub fn from_drawing(py: Python<'_>, path: PathBuf, options: &str) -> PyResult<(String, String, Vec<String>, Picture)> {
    let file = path.display().to_string();
    let failed = |error: ImportError| error::drawing(py, &file, &error);
    let request: Request =
        serde_json::from_str(options).map_err(|e| failed(wrong("options", options, e.to_string())))?;
    let import = request.import().map_err(failed)?;
    let bytes = Disk.read(&path, import::LARGEST).map_err(|error| {
        failed(ImportError { what: error.to_string(), help: "give the path of a DXF file".into(), line: None })
    })?;
    let imported = import.read(&bytes, &path).map_err(failed)?;
    let (notes, drawn) = (imported.notes.clone(), picture(&imported.picture(&path))?);
    Ok((imported.text, path.with_extension("toml").to_string_lossy().into_owned(), notes, drawn))
}

impl Request {
    fn import(self) -> Result<Import, ImportError> {
        let size = |name: &str, text: Option<String>| {
            read::<Positive<Length>>(name, text).map(|length| length.map(|length| length.value()))
        };
        let default = Options::default();
        let layers = self.layers.iter().map(|(layer, tool)| {
            let text = format!("{layer}={tool}");
            import::layer(&text).map_err(|help| wrong("layers", &text, help))
        });
        Ok(Import {
            options: Options {
                layers: layers.collect::<Result<_, _>>()?,
                unit: read("units", self.units)?,
                axis: read::<Length>("axis", self.axis)?.map(|axis| axis.value()),
                join: size("join", self.join)?.unwrap_or(default.join),
                tolerance: size("tolerance", self.tolerance)?.unwrap_or(default.tolerance),
                punch_moves: read("punch_moves", self.punch_moves)?,
            },
            geometry: read("geometry", self.geometry)?,
            material: self.material,
            thickness: size("thickness", self.thickness)?,
            blank: size("blank_radius", self.blank_radius)?,
            travel: size("travel", self.travel)?,
            friction: read::<Fraction>("friction", self.friction.map(|f| f.to_string()))?.map(Fraction::value),
            overrides: self.set,
        })
    }
}

fn read<T: FromStr<Err: ToString>>(name: &str, text: Option<String>) -> Result<Option<T>, ImportError> {
    text.map(|text| text.parse().map_err(|error: T::Err| wrong(name, &text, error.to_string()))).transpose()
}

fn wrong(name: &str, text: &str, help: String) -> ImportError {
    ImportError { what: format!("{name}: `{text}` is not understood"), help, line: None }
}
