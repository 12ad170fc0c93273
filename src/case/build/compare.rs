//! `[[compare]]`.

use super::lines::Named;
use crate::case::comparison::{
    Against, BandSpec, ComparedQuantity, CurveSpec, Data, SOURCES, Source as Provenance, Spec,
};
use crate::case::file::{CaseFile, Compare};
use crate::case::files::{self, FileError};
use crate::case::{CaseError, source::Source};
use crate::units::Dimensioned as _;
use std::path::Path;

const EXAMPLE: &str = "write for example travel_mm,punch_force_kN in the first line and 12.5,30.1 below it";

pub(in crate::case) fn compare(file: &CaseFile, source: &Source) -> Result<Vec<Spec>, CaseError> {
    let limited = file.forming_limit.is_some();
    file.compare.iter().enumerate().map(|(i, c)| Entry { source, i, c }.spec(limited)).collect()
}

/// Entry of `sources.toml` beside a reference file.
fn provenance(path: &Path, key: &str, source: &Source) -> Result<Option<Provenance>, CaseError> {
    let sources = path.with_file_name(SOURCES);
    let unreadable = |why: &str| {
        let what = format!("cannot read {}: {why}", sources.display());
        source.error(key, what, "one table per reference file with citation, kind, grade and, if known, scatter")
    };
    let text = match source.folder.files.text(&sources, files::CSV) {
        Err(FileError::Missing) => return Ok(None),
        text => text.map_err(|error| unreadable(&error.to_string()))?,
    };
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    Provenance::of(&name, &text).map_err(|error| unreadable(error.message()))
}

/// One `[[compare]]` and its index.
struct Entry<'a> {
    source: &'a Source<'a>,
    i: usize,
    c: &'a Compare,
}

impl Entry<'_> {
    /// Requested comparison with its reference; `limited` if the case has a forming limit.
    fn spec(&self, limited: bool) -> Result<Spec, CaseError> {
        let Compare { reference, quantity, reason, optional, demonstration, .. } = self.c.clone();
        let (source, key) = (self.source, format!("compare.{}.reference", self.i));
        let folder = source.folder.path;
        let [first, second] = [folder.join("../reference_data").join(&reference), folder.join(&reference)];
        let named = Named { file: &reference, what: "reference", example: EXAMPLE, key: &key };
        let found = named.first(&[&first, &second], source)?;
        let what = format!("the reference file \"{reference}\" is not there");
        let help = format!("put it at {} or {}, or set optional = true", first.display(), second.display());
        source.require(found.is_some() || optional, &key, what, help)?;
        let help = "say what the difference may come from";
        self.require(!reason.trim().is_empty(), "reason", "a comparison needs its reason", help)?;
        let what = "strain paths are kept of a case with a forming limit, and this one has none";
        let known = limited || quantity != ComparedQuantity::StrainPath;
        self.require(known, "quantity", what, "add [forming_limit] with hill = true, or points")?;
        let against = if quantity.is_curve() { self.curve()? } else { self.band()? };
        let Some((path, lines, csv)) = found else {
            return Ok(Spec { reference: first, data: None, against, reason, optional, demonstration });
        };
        if let Some(row) = csv.rows.iter().find(|row| row.fields.len() != csv.header.fields.len()) {
            let what = format!("a row of {} under {} columns", row.fields.len(), csv.header.fields.len());
            return Err(lines.error(row.line, what, "write a comma for each field, empty ones too"));
        }
        let data = Some(Data { csv, source: provenance(path, &key, source)? });
        Ok(Spec { reference: path.to_owned(), data, against, reason, optional, demonstration })
    }

    fn require(&self, ok: bool, key: &str, what: impl Into<String>, help: &str) -> Result<(), CaseError> {
        self.source.require(ok, &format!("compare.{}.{key}", self.i), what, help)
    }

    /// Checks that the entry has the `needed` keys, and none of the `foreign` ones.
    fn keys(&self, foreign: &[&str], needed: &[&str], help: &str) -> Result<(), CaseError> {
        let table = format!("compare.{}", self.i);
        self.source.refuse(&table, foreign, "does not apply here", help)?;
        let written = self.source.written(&table, needed);
        let missing = needed.iter().find(|key| !written.contains(key));
        let what = format!("`{}` is missing in [[compare]] number {}", missing.unwrap_or(&""), self.i + 1);
        self.source.require(missing.is_none(), &table, what, help)
    }

    fn curve(&self) -> Result<Against, CaseError> {
        let Compare { quantity, x, y, range, tolerance, .. } = self.c.clone();
        let help = format!("`{}` is compared along a curve: give x, y and tolerance", quantity.name());
        self.keys(&["band", "error"], &["x", "y", "tolerance"], &help)?;
        let range = range.map(|[from, to]| (from.value(), to.value()));
        if let Some((from, to)) = range {
            let what = format!("`range` must rise, found {from} to {to}");
            self.require(from < to, "range", what, &format!("write range = [{to}, {from}]"))?;
        }
        let (x, y, tolerance) = (x.unwrap_or_default(), y.unwrap_or_default(), tolerance.map_or(0.0, |t| t.value()));
        Ok(Against::Curve(CurveSpec { quantity, x, y, range, tolerance }))
    }

    fn band(&self) -> Result<Against, CaseError> {
        let Compare { quantity, band, error, .. } = self.c.clone();
        let help = format!(
            "`{}` is compared with the band that values span: give `band` the columns that hold them, as in \
             band = [\"low_mm\", \"high_mm\"]",
            quantity.name()
        );
        self.keys(&["x", "y", "range", "tolerance"], &["band"], &help)?;
        let columns = band.unwrap_or_default();
        self.require(!columns.is_empty(), "band", "`band` names no column", &help)?;
        Ok(Against::Band(BandSpec { quantity, columns, error }))
    }
}
