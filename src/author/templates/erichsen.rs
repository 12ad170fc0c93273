//! Erichsen's cupping test: a greased ball pushes the sheet through a standard die until it tears.

use super::sizes::newtons;
use super::*;

pub(super) const TEMPLATE: Template = Template {
    name: "erichsen",
    about: "the cupping test of Erichsen, all tools as in ISO 20482",
    own: &[Choice::new("clamp", Kind::FORCE, "10 kN", "force of the holder on the sheet")],
    text: include_str!("erichsen.toml"),
    sizes,
};

/// Radius of the specimen and of the die's edge \[mm\].
const SPECIMEN: f64 = 45.0;
const EDGE: f64 = 0.75;
/// Thickest sheet of these tools \[mm\].
const THICKEST: f64 = 2.0;

fn sizes(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let thickness = plain(sheet.thickness);
    let what = || format!("the ball of 20 mm and its die are for sheets up to {}, found {thickness}", plain(THICKEST));
    let help = "make --thickness smaller; for a thick sheet stampflow new stretch-dome";
    ensure(sheet.thickness <= THICKEST, what, help)?;
    let mut sizes = sheet.values(false);
    sizes.elements(SPECIMEN, EDGE, 1);
    sizes.set("size", &thickness, "");
    sizes.set("clamp", newtons(inputs.value("clamp")), "");
    Ok(sizes)
}
