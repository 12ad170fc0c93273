//! Comparisons that a case requests.

use super::band::BandSpec;
use super::computed::Computed;
use super::curve::CurveSpec;
use super::error::CompareError;
use super::reference::Reference;
use super::source::Source;
use crate::table::{Column, Csv};
use std::fmt;
use std::path::PathBuf;

/// A comparison that a case asks for.
#[derive(Clone, Debug, PartialEq)]
pub struct Spec {
    /// CSV file of the reference, units at the end of its headers.
    pub reference: PathBuf,
    /// Its contents; `None` if it is optional and missing.
    pub data: Option<Data>,
    /// Quantity and tolerance.
    pub against: Against,
    /// Why the tolerance or the band is what it is, or what a difference comes from.
    pub reason: String,
    /// Whether the reference file may be missing.
    pub optional: bool,
    /// Whether the difference is shown without being held against the program: the input is not that of the reference.
    pub demonstration: bool,
}

/// Contents of a reference file.
#[derive(Clone, Debug, PartialEq)]
pub struct Data {
    /// Its rows.
    pub csv: Csv,
    /// Source, if its folder names one.
    pub source: Option<Source>,
}

/// The kind of reference.
#[derive(Clone, Debug, PartialEq)]
pub enum Against {
    /// Points, each compared at its place.
    Curve(CurveSpec),
    /// An interval that values without places span.
    Band(BandSpec),
}

impl Spec {
    /// Contents of the reference file; `None` if it is optional and missing.
    ///
    /// # Errors
    /// When it is not there and not optional.
    pub(super) fn reference(&self) -> Result<Option<Reference<'_>>, CompareError> {
        match &self.data {
            Some(data) => Ok(Some(Reference { path: &self.reference, csv: &data.csv })),
            None if self.optional => Ok(None),
            None => Err(CompareError::Missing { path: self.reference.clone() }),
        }
    }
}

impl Against {
    /// The word for the compared quantity in case files, tables and file names.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Curve(curve) => curve.quantity.name(),
            Self::Band(band) => band.quantity.name(),
        }
    }

    /// The quantity as a table of many comparisons has it, short.
    pub fn label(&self) -> &'static str {
        match self {
            Self::Curve(curve) => curve.quantity.label(),
            Self::Band(band) => band.quantity.label(),
        }
    }

    /// Headers of the reference file that are read.
    pub fn headers(&self) -> Vec<&str> {
        match self {
            Self::Curve(curve) => vec![&curve.x, &curve.y],
            Self::Band(band) => band.columns.iter().chain(&band.error).map(String::as_str).collect(),
        }
    }

    /// The computed columns that are compared: abscissa and ordinate.
    pub(super) fn columns(&self, computed: &Computed) -> (Column, Column) {
        match self {
            Self::Curve(curve) => curve.quantity.columns(computed),
            Self::Band(band) => band.quantity.columns(computed),
        }
    }
}

impl fmt::Display for Against {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Curve(curve) => write!(f, "{} within {} %", self.name(), 100.0 * curve.tolerance),
            Self::Band(_) => write!(f, "{} within the band of the values", self.name()),
        }
    }
}
