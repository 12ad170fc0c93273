//! Built-in materials: one file of `library/` each, every number with its source.

use super::file::{self, CaseFile};
use super::files::{Disk, Folder};
use super::sources::{Sheets, Sources, Thickness};
use super::{CaseError, Result, source::Source};
use crate::forming_limit::{Curve, Sheet, uniform_strain};
use crate::grade::{self, Band, Coil, PROOF, SheetText};
use crate::material::{BackStress, Material, flow::ROOM_TEMPERATURE, hardening::HardeningTable};
use crate::model::Mode;
use crate::units::{Dimensioned, Positive, did_you_mean};
use serde::{Deserialize, de::IgnoredAny};
use std::path::Path;

fn source(text: SheetText) -> Result<Source<'static>> {
    Source::parse(text.path, text.text, Folder { files: &Disk, path: Path::new("") })
}

/// Takes the shop's own sheets from a folder instead of that of `STAMPFLOW_SHEETS`; before the first look-up.
pub fn use_folder(folder: &Path) -> Result<()> {
    grade::use_folder(folder).map_err(|[what, help]| CaseError::bare(what, help))
}

fn texts() -> Result<impl Iterator<Item = SheetText>> {
    grade::texts().map_err(|[what, help]| CaseError::bare(what, help))
}

/// Description of a sheet, its source and its numbers: a file of the library.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Description {
    /// Description in one line.
    pub title: String,
    /// Grade of `reference_data/sources.toml`: A, read in the named source; B, quoted; C, the hardening is assumed.
    pub grade: String,
    /// Terms of use of the numbers.
    pub licence: String,
    /// Thickness of the sheet that the numbers are of.
    pub thickness: Option<String>,
    /// Grades that it stands for.
    pub stands_for: Option<StandsFor>,
    /// Limits of its grade.
    pub band: Option<Band>,
    /// Remarks on the numbers.
    pub notes: Vec<String>,
    /// Points of the fits, for the tests.
    #[serde(default, rename = "measured")]
    _measured: IgnoredAny,
    /// Keys of its `[material]` that its band makes.
    #[serde(skip)]
    made: Option<String>,
    elastoplastic: Option<Shifting>,
    material: file::Material,
    forming_limit: Option<file::FormingLimit>,
}

/// Back-stresses, and the hardening law that they leave of the yield stress.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Shifting {
    kinematic: Vec<BackStress>,
    hardening: HardeningTable,
}

impl Description {
    /// True if the law is made from the band of a grade, false if it was fitted.
    pub fn is_made(&self) -> bool {
        self.made.is_some()
    }

    /// Author, year and place of the numbers.
    pub fn source(&self) -> &str {
        self.material.source.as_deref().unwrap_or_default()
    }

    fn elastoplastic(&self) -> Option<file::Material> {
        let Shifting { kinematic, hardening } = self.elastoplastic.clone()?;
        let mode = Some(Mode::ElastoViscoplastic);
        Some(file::Material { kinematic, hardening: Some(hardening), mode, ..self.material.clone() })
    }
}

/// Grades of standards that a sheet may be taken for.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct StandsFor {
    /// Names of standards and mills, the usual one first.
    pub grades: Vec<String>,
    /// Reason: a source, or a declaration.
    pub because: String,
}

fn read(text: SheetText, coil: Option<Coil>) -> Result<Description> {
    let source = source(text)?;
    let mut sheet: Description = source.deserialised()?;
    if sheet.material.hardening.is_none() {
        let help = "give rp02, rm and one of ag, n and a, or write a law such as [material.hardening.swift]";
        let missing = || source.error("band", "the sheet has no law, and no band that makes one", help);
        let band = sheet.band.as_ref().ok_or_else(missing)?;
        let (law, r) = (band.law(coil).ok_or_else(missing)?, band.r_value().unwrap_or(1.0));
        let made = format!("source = {:?}\nanisotropy = {r}\n{law}", band.origin(coil));
        let file::Material { source, anisotropy, fitted_up_to, hardening, .. } =
            toml::from_str(&made).map_err(|_| missing())?;
        sheet.material = file::Material { source, anisotropy, fitted_up_to, hardening, ..sheet.material };
        sheet.made = Some(made);
    }
    Ok(sheet)
}

/// The sheet of a name; else the one that stands for a grade, first one made from its band; else the only one whose name or
/// grade begins so. With the reason of the choice, if the word is not its name.
fn find(word: &str, coil: Option<Coil>) -> Result<(Entry, Option<String>)> {
    if let Some(text) = texts()?.find(|text| text.name == word) {
        return Ok((entry(text, coil)?, None));
    }
    // `EN AW-6016` is `enaw6016`.
    let plain = |word: &str| -> String {
        word.chars().filter(|c| c.is_alphanumeric() || *c == '.').flat_map(char::to_lowercase).collect()
    };
    let wanted = plain(word);
    let (mut exact, mut begins) = (Vec::new(), Vec::new());
    for text in texts()? {
        let entry = entry(text, coil)?;
        let grades = entry.about.stands_for.iter().flat_map(|stands| &stands.grades);
        let known: Vec<String> = grades.map(|grade| plain(grade)).chain([plain(entry.name)]).collect();
        if known.contains(&wanted) {
            exact.push(entry);
        } else if !wanted.is_empty() && known.iter().any(|known| known.starts_with(&wanted)) {
            begins.push(entry);
        }
    }
    if exact.iter().any(|entry| entry.about.is_made()) {
        exact.retain(|entry| entry.about.is_made());
    }
    let mut candidates = if exact.is_empty() { begins } else { exact };
    let names: Vec<&str> = candidates.iter().map(|entry| entry.name).collect();
    match names[..] {
        [name] => {
            let entry = candidates.remove(0);
            let note = match plain(name).starts_with(&wanted) || entry.about.stands_for.is_none() {
                false => format!("material {word}: {name} stands for it, as `stampflow materials {name}` explains"),
                true => format!("material {word} read as {name}"),
            };
            Ok((entry, Some(note)))
        }
        [] => {
            let names: Vec<&str> = self::names().collect();
            let (near, names) = (did_you_mean(word, names.iter().copied()), names.join(", "));
            let help = format!("{near}known materials: {names}; `stampflow materials` says which grades they are for");
            Err(CaseError::bare(format!("the library has no material \"{word}\""), help))
        }
        _ => Err(CaseError::bare(format!("\"{word}\" may be {}", names.join(" or ")), "write the whole name".into())),
    }
}

/// Material of the library.
#[derive(Clone, Debug)]
pub struct Entry {
    /// Name in a case.
    pub name: &'static str,
    /// Its file.
    pub about: Description,
    /// Material of a case.
    pub material: Material,
    /// Material of the elasto-viscoplastic mode, if it has back-stresses there.
    pub elastoplastic: Option<Material>,
    /// Measured forming limit.
    pub measured_limit: Option<Curve>,
    /// `[material]` table, to paste into a case.
    pub text: String,
}

impl Entry {
    /// Uniform strain of the hardening law, n of a power law; `None` if the law has no load maximum \[–\].
    pub fn n(&self) -> Option<f64> {
        uniform_strain(&Sheet { material: &self.material, thickness: 1.0, temperature: ROOM_TEMPERATURE }).ok()
    }

    /// Proof stress: the law's stress at 0.2 % of plastic strain \[MPa\].
    pub fn proof_stress(&self) -> f64 {
        self.material.hardening.at(PROOF).stress
    }

    /// Tensile strength: force over the initial section at Considère's load maximum \[MPa\]; `None` if the law has none.
    pub fn tensile_strength(&self) -> Option<f64> {
        let strain = self.n()?;
        Some(self.material.hardening.at(strain).stress * (-strain).exp())
    }

    /// Uniform elongation, engineering strain at Considère's load maximum \[–\]; `None` if the law has none.
    pub fn uniform_elongation(&self) -> Option<f64> {
        Some(self.n()?.exp_m1())
    }
}

/// Returns every material: the fitted ones, those made from a band, then the shop's own. Fails at a faulty sheet in the shop's folder.
pub fn materials() -> Result<Vec<Entry>> {
    texts()?.map(|text| entry(text, None)).collect()
}

/// Returns the names of all materials.
pub fn names() -> impl Iterator<Item = &'static str> {
    texts().into_iter().flatten().map(|text| text.name)
}

/// Material of a name, a grade or a unique prefix. Fails when there is none or several; the error proposes the nearest.
pub fn material(name: &str) -> Result<Entry> {
    Ok(find(name, None)?.0)
}

pub(super) fn complete(file: &mut CaseFile, source: &Source) -> Result<Sources> {
    let Some(written) = file.material.name.clone() else {
        let help = "write name = \"dc04\", or strength = 1.08 in its place";
        source.require(file.material.coil.is_none(), "material.coil", "`coil` is of a sheet of the library", help)?;
        return Ok(Sources::default());
    };
    let here = |error: CaseError| match error.file() {
        Some(_) => error,
        None => source.error("material.name", error.to_string(), error.remedy().unwrap_or_default()),
    };
    let (entry, note) = find(&written, file.material.coil).map_err(here)?;
    let name = entry.name;
    let Description { material: sheet, thickness, forming_limit, .. } = entry.about.clone();
    let elastoplastic = entry.about.elastoplastic();
    let mut origin = entry.about.source().to_owned();
    if let Some((coil, false)) = file.material.coil.map(|coil| (coil, entry.about.is_made())) {
        let end = entry.about.band.as_ref().and_then(|band| band.strength(Some(coil))).zip(entry.tensile_strength());
        let what = format!("the library has no band of strength of {name}");
        let help = "write strength = 1.08, the factor of its flow stress";
        let (end, own) = end.ok_or_else(|| source.error("material.coil", what, help))?;
        let factor = file.material.strength.map_or(1.0, Dimensioned::value) * end / own;
        file.material.strength = Positive::checked(factor, "strength").ok();
        origin += &format!("; {coil} coil {:+.0} %", 100.0 * (end / own - 1.0));
    }
    note.into_iter().chain([format!("material {name}: {origin}")]).for_each(|note| source.note(note));
    let keys = ["young", "poisson", "anisotropy", "yield_condition", "rate", "softening", "hardening"];
    let replaced = source.written("material", &keys);
    let own_hardening = replaced.contains(&"hardening");
    let own = file.forming_limit.as_ref().map(|own| own.measured == Some(true) && own.points.is_none());
    if let Some(measured) = forming_limit.filter(|_| own.unwrap_or(!own_hardening)) {
        let own = file.forming_limit.take().unwrap_or_else(|| measured.clone());
        let strain = own.strain.or(measured.strain);
        file.forming_limit = Some(file::FormingLimit { points: measured.points, strain, measured: None, ..own });
        source.note(format!("forming limit: the measured points of {name}"));
    }
    let own = &mut file.material;
    let sheets = Sheets::new(name, own_hardening, own, &sheet);
    if own.young.is_none() && own.poisson.is_none() {
        (own.young, own.poisson) = (sheet.young, sheet.poisson);
    }
    own.anisotropy = own.anisotropy.or(sheet.anisotropy);
    // The model of voids is made for Hill's condition.
    own.yield_condition = own.yield_condition.or(sheet.yield_condition.filter(|_| own.voids.is_none()));
    own.rate = own.rate.or(sheet.rate);
    own.softening = own.softening.or(sheet.softening);
    if own.fracture.is_none() {
        (own.fracture, own.fracture_source) = (sheet.fracture, sheet.fracture_source.clone());
    }
    if !own_hardening {
        let shifts = own.mode == Some(Mode::ElastoViscoplastic) && own.kinematic.is_empty();
        let law = if let Some(shifting) = elastoplastic.filter(|_| shifts) {
            source.note(format!("material {name}: with its back-stresses, and the hardening without them"));
            shifting
        } else {
            file::Material { kinematic: own.kinematic.clone(), ..sheet }
        };
        (own.kinematic, own.hardening) = (law.kinematic, law.hardening);
        own.fitted_up_to = own.fitted_up_to.or(law.fitted_up_to);
        own.source.get_or_insert(origin);
    }
    if !replaced.is_empty() {
        source.note(format!("material {name}: {} as this case has it, not as its source", replaced.join(", ")));
    }
    // The sheet's thickness belongs to its own law only.
    let thickness = thickness.filter(|_| !own_hardening).and_then(|range| Thickness::parse(name, &range));
    Ok(Sources { sheets, thickness, ..Sources::default() })
}

fn entry(text: SheetText, coil: Option<Coil>) -> Result<Entry> {
    let mut about = read(text, coil)?;
    let source = source(text)?;
    let SheetText { name, text, .. } = text;
    let material = about.material.model(&source)?;
    let elastoplastic = about.elastoplastic().map(|shifting| shifting.model(&source)).transpose()?;
    let limit = about.forming_limit.as_ref().map(|limit| limit.curve(&material, 1.0, None, &source));
    about.material.r_values(&source);
    about.notes.extend(source.notes.take());
    let table = text.find("[material").map_or("", |at| &text[at..]);
    let made = about.made.iter().map(|made| format!("[material]\n{made}"));
    let text = made.fold(table.to_owned(), |table, made| table.replacen("[material]\n", &made, 1));
    Ok(Entry { name, about, material, elastoplastic, measured_limit: limit.transpose()?.flatten(), text })
}
