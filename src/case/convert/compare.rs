//! `[[compare]]`.

use crate::case::file::{CaseFile, ComparedQuantity};
use crate::case::{CaseError, source::Source};
use crate::compare::{Quantity, Spec};
use crate::quantity::Quantity as _;
use std::path::Path;

pub(in crate::case) fn compare(file: &CaseFile, source: &Source, case: &Path) -> Result<Vec<Spec>, CaseError> {
    let folder = case.parent().unwrap_or(Path::new(""));
    let convert = |(i, c): (usize, &crate::case::file::Compare)| {
        let candidates = [folder.join("../reference_data").join(&c.reference), folder.join(&c.reference)];
        let found = candidates.iter().find(|path| path.is_file());
        if found.is_none() && !c.optional {
            let what = format!("the reference file \"{}\" is not there", c.reference);
            let [first, second] = candidates.each_ref().map(|path| path.display());
            let help = format!("put it at {first} or {second}, or set optional = true");
            return Err(source.error(&format!("compare.{i}.reference"), what, help));
        }
        let range = c.range.map(|[from, to]| (from.value(), to.value()));
        if let Some((from, to)) = range.filter(|(from, to)| from >= to) {
            let what = format!("`range` must rise, found {from} to {to}");
            return Err(source.error(&format!("compare.{i}.range"), what, format!("write range = [{to}, {from}]")));
        }
        if c.reason.trim().is_empty() {
            let what = "a tolerance needs its reason";
            return Err(source.error(&format!("compare.{i}.reason"), what, "say what the difference may come from"));
        }
        Ok(Spec {
            reference: found.unwrap_or(&candidates[0]).clone(),
            x: c.x.clone(),
            y: c.y.clone(),
            quantity: match c.quantity {
                ComparedQuantity::PunchForce => Quantity::PunchForce,
                ComparedQuantity::Travel => Quantity::Travel,
                ComparedQuantity::ThicknessAtS0 => Quantity::ThicknessAtS0,
                ComparedQuantity::ThicknessAtRadius => Quantity::ThicknessAtRadius,
            },
            range,
            tolerance: c.tolerance.value(),
            reason: c.reason.clone(),
            optional: c.optional,
        })
    };
    file.compare.iter().enumerate().map(convert).collect()
}
