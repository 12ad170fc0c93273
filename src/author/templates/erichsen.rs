//! The cupping test of Erichsen: a sheet pushed by a greased ball through a standard die until it tears.

use super::inputs::{Choice, Inputs, Kind, Value};
use super::rules::Picked;
use super::sheet::Sheet;
use super::template::{Template, begin};
use super::tools::{elements, newtons, round_punch};
use crate::author::page::plain;
use crate::case::CaseError;
use crate::model::Geometry;
use crate::units::rounded;

pub(super) const TEMPLATE: Template =
    Template::new("erichsen", "the cupping test of Erichsen, all tools as in ISO 20482", OPTIONS, write);

const OPTIONS: &[Choice] = &[Choice::new(
    "clamp",
    Kind::Force,
    Value("10 kN"),
    "force of the holder on the sheet; the standard's when not given",
)];

/// Radii of ball, die bore, holder bore and the die's edge \[mm\].
const BALL: f64 = 10.0;
const DIE: f64 = 13.5;
const HOLDER: f64 = 16.5;
const EDGE: f64 = 0.75;
/// Half the least width of the specimen \[mm\].
const SPECIMEN: f64 = 45.0;
/// Thickest sheet of these tools \[mm\].
const THICKEST: f64 = 2.0;
/// No sheet is pushed so far before it tears \[mm\].
const TRAVEL: f64 = 25.0;
/// To which an index is given \[mm\].
const DIGIT: f64 = 0.1;

fn write(inputs: &Inputs) -> Result<String, CaseError> {
    let sheet = Sheet::read(inputs)?;
    if sheet.thickness > THICKEST {
        let what = format!(
            "the ball of {} and its die are for sheets up to {}, found {}",
            plain(2.0 * BALL),
            plain(THICKEST),
            plain(sheet.thickness)
        );
        return Err(CaseError::bare(
            what,
            "make --thickness smaller; for a thick sheet stampflow new stretch-dome".into(),
        ));
    }
    let notes = [
        "declared: ball Ø 20 mm, die bore Ø 27 mm, holder bore Ø 33 mm, edge radius 0.75 mm, clamp 10 kN: the sizes of \
         ISO 20482 from memory, the standard was not read"
            .to_owned(),
        "declared: a specimen 90 mm wide, round here, its rim still; the grease on the ball is in the friction".to_owned(),
    ];
    let mut page = begin(
        "The cupping test: the Erichsen index is the punch travel at the largest force, in mm; there the sheet tears.",
        &format!("Erichsen cupping test, {} thick", plain(sheet.thickness)),
        Geometry::Axisymmetric,
        &[&notes[..], &sheet.notes("a made-up specimen")[1..]].concat(),
    );
    let blank = Picked::by(SPECIMEN, "the least width of a specimen");
    sheet.blank(&mut page, Geometry::Axisymmetric, &blank);
    page.set("edge", "\"clamped\"", "of a free rim the draw-in is a few tenths of a millimetre");
    elements(&mut page, SPECIMEN, EDGE);
    sheet.material(&mut page, false);
    sheet.forming_limit(&mut page);
    let friction = rounded(sheet.friction);
    page.table("tools.punch", "");
    round_punch(&Picked::by(BALL, "the ball, Ø 20 mm")).write(&mut page);
    page.set("friction", friction, "greased, declared");
    page.length("travel", &Picked::by(TRAVEL, "beyond any index: the run ends where the sheet fails"));
    page.table("tools.die", "");
    page.length("throat", &Picked::given(DIE));
    page.length("shoulder", &Picked::by(EDGE, "the standard's: below what a shell follows of sheets above 0.15 mm"));
    page.set("friction", friction, "");
    page.table("tools.holder", "");
    page.length("inner_radius", &Picked::given(HOLDER));
    page.set("force", newtons(inputs.value("clamp")), "of the whole ring");
    page.table("stop", "The load maximum is the end of the test.");
    page.set("localised", false, "the force says when it tears");
    page.set("load_drop", "\"2 %\"", "");
    page.table("solver", "");
    page.set("max_step", rounded(DIGIT / TRAVEL), "of the travel: the index is given to a tenth of a millimetre");
    Ok(page.text())
}
