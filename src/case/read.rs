//! From the text of a case to the case.

use super::source::Source;
use super::{Case, CaseError, build, file, library, overrides, sources};
use crate::case::files::{self, Disk, FileError, Files, Folder, Noted};
use std::cell::RefCell;
use std::path::{Path, PathBuf};

/// Reads a case file from the disk and applies overrides such as `tools.punch.friction=0.1` or `blank.thickness=0.9 mm`.
///
/// # Errors
/// When the file cannot be read, or as [`parse`].
pub fn load(path: impl AsRef<Path>, overrides: &[String]) -> Result<Case, CaseError> {
    let path = path.as_ref();
    let files: &dyn Files = &Disk;
    let text = files.text(path, files::CASE).map_err(|error| CaseError::unreadable(path, &error))?;
    parse(&text, &path.to_string_lossy(), overrides)
}

/// Reads a case from text; `name` is the path that messages show and that reference curves, profiles and temperatures are
/// looked up from, on the disk.
///
/// An override is `KEY=VALUE`: a dotted path of keys (array entries by index, from 0) and a TOML value; what is not a
/// TOML value is taken as text. Optional tables such as `solver`, `output`, `press` and `forming_limit` are made when they are missing.
///
/// # Errors
/// When the text is not TOML, a key is unknown or missing, or a value makes no sense; the error points to its line.
pub fn parse(text: &str, name: &str, overrides: &[String]) -> Result<Case, CaseError> {
    parse_with(text, name, overrides, &Disk)
}

/// Reads a case from text as [`parse`], the files beside it from elsewhere. All that a case needs is read here.
///
/// ```
/// # use stampflow::{case, case::files::Memory};
/// let mut files = Memory::default();
/// files.insert("cases/field.csv", "s0_mm,temperature_C\n20,25\n40,150\n");
/// let text = format!("{}[heat]\ninitial = \"field.csv\"\n", stampflow::author::templates::find("cup").unwrap().fill(&[])?);
/// let case = case::parse_with(&text, "cases/cup.toml", &[], &files)?;
/// assert_eq!(case.model().heat.as_ref().unwrap().initial.at(40.0), 423.15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// Those of [`parse`].
pub fn parse_with(text: &str, name: &str, overrides: &[String], files: &dyn Files) -> Result<Case, CaseError> {
    let path = PathBuf::from(name);
    if text.len() > files::CASE {
        return Err(CaseError::unreadable(&path, &FileError::TooLarge { limit: files::CASE }));
    }
    let reads = Noted { files, paths: RefCell::new(vec![path.clone()]) };
    let text = overrides::apply(text, overrides)?;
    let shown = if overrides.is_empty() { name.to_owned() } else { format!("{name} (with overrides)") };
    let folder = Folder { files: &reads, path: path.parent().unwrap_or(Path::new("")) };
    let source = Source::parse(&shown, &text, folder)?;
    let mut file = source.read()?;
    sources::forget_replaced(&mut file, overrides);
    let taken = library::complete(&mut file, &source)?;
    sources::limit_of_another_sheet(&file, overrides).into_iter().for_each(|note| source.note(note));
    let stages = build::stages(&file, &source)?;
    let r_values = file.material.anisotropy.and_then(file::Anisotropy::directions);
    r_values.into_iter().for_each(|r| source.note(build::mean_of(r)));
    Ok(Case {
        name: path.file_stem().map_or_else(|| "case".into(), |stem| stem.to_string_lossy().into_owned()),
        compare: build::compare(&file, &source)?,
        press: build::press(&file, &source)?,
        springback: build::springback(&file, &source)?,
        sources: sources::sources(&file, taken, &source)?,
        text: text.clone(),
        overrides: overrides.to_vec(),
        stages,
        title_block: file.report,
        r_values,
        derived: source.take_notes(),
        inputs: reads.paths.take(),
        path,
    })
}
