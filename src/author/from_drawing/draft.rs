//! What was drawn, and what is to be made of it.

use crate::geometry::Profile;
use crate::model::{Geometry, Role};

/// A tool, its section, and a line that says where it comes from.
pub type Drawn<'a> = (Role, &'a Profile, &'a str);

/// What a case file is written from.
#[derive(Clone, Debug, PartialEq)]
pub struct Draft<'a> {
    /// The case's title.
    pub title: &'a str,
    /// What a section of the drawing stands for.
    pub geometry: Geometry,
    /// Name of the first operation, where there are several.
    pub name: Option<String>,
    /// Sections in the order punch, die, holder, each with a line that says where it comes from.
    pub tools: Vec<Drawn<'a>>,
    /// Names of later operations and their sections likewise, each with a punch.
    pub later: Vec<(String, Vec<Drawn<'a>>)>,
    /// A sheet of the library, by its name or a grade that it stands for; a placeholder where `None`.
    pub material: Option<&'a str>,
    /// Of the sheet \[mm\]; a placeholder where `None`.
    pub thickness: Option<f64>,
    /// Radius or half-length \[mm\]; a placeholder where `None`.
    pub blank: Option<f64>,
    /// Of the punch \[mm\]; a placeholder where `None`.
    pub travel: Option<f64>,
    /// How the drawing was understood, for comments at the top.
    pub notes: &'a [String],
}
