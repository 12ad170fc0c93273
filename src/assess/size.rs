//! Whether the sizes of a case are those of a stamping.

use super::{Finding, Kind, sentences};
use crate::case::Case;
use crate::model::Model;
use crate::rules::size::{self, Doubt};

/// What is doubted of a case's sizes, as sentences: where one is wrong, nothing else is worth reading.
pub fn size_doubts(case: &Case) -> Vec<String> {
    let doubts = [width, thickness, slender, blank_diameter, throat_diameter].map(|ask| ask(case.model()));
    sentences(&doubts.into_iter().flatten().collect::<Vec<_>>(), Kind::Warning)
}

pub(super) fn width(model: &Model) -> Option<Finding> {
    size::width(model).map(|doubt| doubted("width", "Width", doubt))
}

pub(super) fn thickness(model: &Model) -> Option<Finding> {
    size::thickness(model).map(|doubt| doubted("thickness", "Thickness", doubt))
}

pub(super) fn slender(model: &Model) -> Option<Finding> {
    size::slender(model).map(|doubt| doubted("slenderness", "Width over thickness", doubt))
}

pub(super) fn blank_diameter(model: &Model) -> Option<Finding> {
    size::blank_diameter(model).map(|doubt| doubted("blank_diameter", "Blank", doubt))
}

pub(super) fn throat_diameter(model: &Model) -> Option<Finding> {
    size::throat_diameter(model).map(|doubt| doubted("throat_diameter", "Throat", doubt))
}

fn doubted(key: &'static str, label: &'static str, doubt: Doubt) -> Finding {
    let Doubt { value, unit, found, limit, advice } = doubt;
    Finding::warning(key, label, found).against(value, unit, limit).advice(advice)
}
