//! Whether the sizes of a case are those of a stamping.

use super::Finding;
use crate::model::Model;
use crate::rules::size::{self, Doubt};

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
