//! `[[compare]]`.

use super::lines::Named;
use crate::case::file::{CaseFile, Compare, ComparedQuantity};
use crate::case::files::{self, FileError, Folder};
use crate::case::{CaseError, source::Source};
use crate::compare::{Against, BandQuantity, BandSpec, CurveSpec, Data, Quantity, SOURCES, Source as Provenance, Spec};
use crate::units::Dimensioned as _;
use std::path::{Path, PathBuf};

const EXAMPLE: &str = "write for example travel_mm,punch_force_kN in the first line and 12.5,30.1 below it";

pub(in crate::case) fn compare(file: &CaseFile, source: &Source, folder: Folder) -> Result<Vec<Spec>, CaseError> {
    let limited = file.forming_limit.is_some();
    file.compare.iter().enumerate().map(|(i, c)| Entry { source, i, c }.spec(folder, limited)).collect()
}

/// What `sources.toml` beside a reference file says of it.
fn provenance(path: &Path, key: &str, source: &Source, folder: Folder) -> Result<Option<Provenance>, CaseError> {
    let sources = path.with_file_name(SOURCES);
    let unreadable = |why: String| {
        let what = format!("cannot read {}: {why}", sources.display());
        source.error(key, what, "one table per reference file with citation, kind, grade and, if known, scatter")
    };
    let text = match folder.files.text(&sources, files::CSV) {
        Err(FileError::Missing) => return Ok(None),
        text => text.map_err(|error| unreadable(error.to_string()))?,
    };
    let name = path.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    Provenance::of(&name, &text).map_err(|error| unreadable(error.message().to_owned()))
}

/// One `[[compare]]` and where it stands.
struct Entry<'a> {
    source: &'a Source<'a>,
    i: usize,
    c: &'a Compare,
}

impl Entry<'_> {
    /// The comparison that is asked for, its reference read; `limited` says whether the case has a forming limit.
    fn spec(&self, folder: Folder, limited: bool) -> Result<Spec, CaseError> {
        let c = self.c;
        let candidates = [folder.path.join("../reference_data").join(&c.reference), folder.path.join(&c.reference)];
        let found = self.found(&candidates, folder)?;
        if found.is_none() && !c.optional {
            let what = format!("the reference file \"{}\" is not there", c.reference);
            let [first, second] = candidates.each_ref().map(|path| path.display());
            let help = format!("put it at {first} or {second}, or set optional = true");
            return Err(self.error("reference", what, help));
        }
        if c.reason.trim().is_empty() {
            let what = "a comparison needs its reason";
            return Err(self.error("reason", what, "say what the difference may come from"));
        }
        let (reference, data) = match found {
            Some((path, data)) => (path, Some(data)),
            None => (candidates[0].clone(), None),
        };
        Ok(Spec {
            reference,
            data,
            against: match c.quantity {
                ComparedQuantity::PunchForce => self.curve(Quantity::PunchForce)?,
                ComparedQuantity::Travel => self.curve(Quantity::Travel)?,
                ComparedQuantity::ThicknessAtS0 => self.curve(Quantity::ThicknessAtS0)?,
                ComparedQuantity::ThicknessAtRadius => self.curve(Quantity::ThicknessAtRadius)?,
                ComparedQuantity::StrainPath => self.strain_path(limited)?,
                ComparedQuantity::DrawInAtTravel => self.curve(Quantity::DrawInAtTravel)?,
                ComparedQuantity::EdgeDiameter => self.band(BandQuantity::EdgeDiameter)?,
                ComparedQuantity::DrawIn => self.band(BandQuantity::DrawIn)?,
                ComparedQuantity::Thinnest => self.band(BandQuantity::Thinnest)?,
                ComparedQuantity::Thickness => self.band(BandQuantity::Thickness)?,
                ComparedQuantity::PeakForce => self.band(BandQuantity::PeakForce)?,
                ComparedQuantity::PeakTravel => self.band(BandQuantity::PeakTravel)?,
                ComparedQuantity::RingOpening => self.band(BandQuantity::RingOpening)?,
            },
            reason: c.reason.clone(),
            optional: c.optional,
            demonstration: c.demonstration,
        })
    }

    /// The first of some files that is there, and what stands in it.
    fn found(&self, candidates: &[PathBuf], folder: Folder) -> Result<Option<(PathBuf, Data)>, CaseError> {
        let (source, key) = (self.source, &format!("{}.reference", self.path()));
        let named = Named { file: &self.c.reference, what: "reference", example: EXAMPLE, key };
        for path in candidates {
            let text = match folder.files.text(path, files::CSV) {
                Err(FileError::Missing | FileError::Folder) => continue,
                text => text.map_err(|error| named.unreadable(&error, source))?,
            };
            let (lines, csv) = named.table(&text, path, source)?;
            if let Some(row) = csv.rows.iter().find(|row| row.fields.len() != csv.header.fields.len()) {
                let what = format!("a row of {} under {} columns", row.fields.len(), csv.header.fields.len());
                return Err(lines.error(row.line, what, "write a comma for each field, empty ones too"));
            }
            return Ok(Some((path.clone(), Data { csv, source: provenance(path, key, source, folder)? })));
        }
        Ok(None)
    }

    /// Key path of the table.
    fn path(&self) -> String {
        format!("compare.{}", self.i)
    }

    fn error(&self, key: &str, what: impl Into<String>, help: impl Into<String>) -> CaseError {
        self.source.error(&format!("{}.{key}", self.path()), what, help)
    }

    fn curve(&self, quantity: Quantity) -> Result<Against, CaseError> {
        let c = self.c;
        let help = format!("`{}` is compared along a curve: give x, y and tolerance", quantity.name());
        self.refused("band", c.band.is_some(), &help)?;
        self.refused("error", c.error.is_some(), &help)?;
        let (Some(x), Some(y), Some(tolerance)) = (&c.x, &c.y, c.tolerance) else {
            let missing = [("x", c.x.is_none()), ("y", c.y.is_none()), ("tolerance", c.tolerance.is_none())];
            let missing: Vec<_> = missing.iter().filter(|m| m.1).map(|m| format!("`{}`", m.0)).collect();
            let what = format!("{} missing in [[compare]] number {}", missing.join(" and "), self.i + 1);
            return Err(self.source.error(&self.path(), what, help));
        };
        let range = c.range.map(|[from, to]| (from.value(), to.value()));
        if let Some((from, to)) = range.filter(|(from, to)| from >= to) {
            let what = format!("`range` must rise, found {from} to {to}");
            return Err(self.error("range", what, format!("write range = [{to}, {from}]")));
        }
        let (x, y, tolerance) = (x.clone(), y.clone(), tolerance.value());
        Ok(Against::Curve(CurveSpec { quantity, x, y, range, tolerance }))
    }

    /// Strain paths are kept for the forming limit that they are held against.
    fn strain_path(&self, limited: bool) -> Result<Against, CaseError> {
        if !limited {
            let what = "strain paths are kept of a case with a forming limit, and this one has none";
            return Err(self.error("quantity", what, "add [forming_limit] with hill = true, or points"));
        }
        self.curve(Quantity::StrainPath)
    }

    fn band(&self, quantity: BandQuantity) -> Result<Against, CaseError> {
        let c = self.c;
        let help = format!(
            "`{}` is compared with the band that values span: give `band` the columns that hold them, as in band = [\"low_mm\", \"high_mm\"]",
            quantity.name()
        );
        self.refused("x", c.x.is_some(), &help)?;
        self.refused("y", c.y.is_some(), &help)?;
        self.refused("range", c.range.is_some(), &help)?;
        self.refused("tolerance", c.tolerance.is_some(), &help)?;
        match &c.band {
            Some(columns) if !columns.is_empty() => {
                Ok(Against::Band(BandSpec { quantity, columns: columns.clone(), error: c.error.clone() }))
            }
            Some(_) => Err(self.error("band", "`band` names no column", help)),
            None => {
                let what = format!("`band` is missing in [[compare]] number {}", self.i + 1);
                Err(self.source.error(&self.path(), what, help))
            }
        }
    }

    /// A key that the quantity has no use for.
    fn refused(&self, key: &str, given: bool, help: &str) -> Result<(), CaseError> {
        if !given {
            return Ok(());
        }
        Err(self.error(key, format!("`{key}` does not apply here"), help))
    }
}
