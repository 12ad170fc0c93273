//! How much a case may hold: more is a slip, and would fill the memory or a plot before anyone sees it.

use super::memory::{Memory, least_steps, with_path};
use crate::case::file::{CaseFile, Compare, Section};
use crate::case::{CaseError, source::Source};
use crate::geometry::Piece;
use crate::model::{Model, Stage};
use std::f64::consts::FRAC_PI_2;

/// Characters of a title and of other texts, which every plot repeats.
const TITLE: usize = 200;
const TEXT: usize = 1000;
/// Characters of a file's or a column's name.
const NAME: usize = 200;
/// Rows of `profile.csv`: kept frames times elements.
const ROWS: usize = 500_000;
/// What a run keeps, all stages together \[bytes\]: ten stages with 1000 frames of 340 elements.
const MEMORY: usize = 500_000_000;
/// Chords that replace the arcs of one tool.
const CHORDS: f64 = 20_000.0;

/// Lists and texts of what was written.
pub(super) fn of_file(file: &CaseFile, source: &Source) -> Result<(), CaseError> {
    let tools = &file.tools;
    let steps = |section: Option<&Section>| match section {
        Some(Section::Steps(steps)) => Some(steps.len()),
        _ => None,
    };
    let lengths = [
        ("tools.beads", Some(tools.beads.len()), 20),
        ("notes", Some(file.notes.len()), 50),
        ("tools.punch.motion", tools.punch.as_ref().and_then(|t| t.motion.as_ref()).map(Vec::len), 1000),
        ("compare", Some(file.compare.len()), 50),
        ("forming_limit.points", file.forming_limit.as_ref().and_then(|f| f.points.as_ref()).map(Vec::len), 1000),
        ("output.frames", file.output.frames.as_ref().map(Vec::len), 1000),
        ("tools.punch.profile", steps(tools.punch.as_ref().and_then(|t| t.profile.as_ref())), 2000),
        ("tools.die.profile", steps(tools.die.as_ref().and_then(|t| t.profile.as_ref())), 2000),
        ("tools.holder.profile", steps(tools.holder.as_ref().and_then(|t| t.profile.as_ref())), 2000),
    ];
    let bands = |(i, c): (usize, &Compare)| (format!("compare.{i}.band"), c.band.as_ref().map(Vec::len), 20);
    let bands = file.compare.iter().enumerate().map(bands);
    for (path, length, most) in lengths.into_iter().map(|(path, n, most)| (path.to_owned(), n, most)).chain(bands) {
        if let Some(length) = length.filter(|length| *length > most) {
            let key = path.rsplit('.').next().unwrap_or(&path);
            let what = format!("`{key}` has {length} entries, more than {most}");
            return Err(source.error(&format!("{path}.{most}"), what, "leave out what is not needed"));
        }
    }
    let notes = file.notes.iter().enumerate().map(|(i, note)| (format!("notes.{i}"), note, TEXT));
    let reasons = file.compare.iter().enumerate().map(|(i, c)| (format!("compare.{i}.reason"), &c.reason, TEXT));
    let compared = file.compare.iter().enumerate().flat_map(|(i, c)| {
        let bands = c.band.iter().flatten().enumerate().map(|(k, name)| (format!("band.{k}"), name));
        let named =
            [("reference", Some(&c.reference)), ("x", c.x.as_ref()), ("y", c.y.as_ref()), ("error", c.error.as_ref())];
        let named = named.into_iter().filter_map(|(key, name)| Some((key.to_owned(), name?)));
        named.chain(bands).map(move |(key, name)| (format!("compare.{i}.{key}"), name, NAME))
    });
    let title = std::iter::once(("title".to_owned(), &file.title, TITLE));
    for (path, text, most) in title.chain(notes).chain(reasons).chain(compared) {
        let length = text.chars().count();
        if length > most {
            let what = format!("`{path}` has {length} characters, more than {most}");
            return Err(source.error(&path, what, "plots and messages repeat it: keep it short"));
        }
    }
    Ok(())
}

/// The key that says how many frames of a stage are kept, the first one being stage 0.
pub(super) fn frames_key(stage: usize, source: &Source) -> String {
    match stage {
        0 if source.has("output.frames") => "output.frames".into(),
        0 => "output.count".into(),
        later => format!("stages.{}.frames", later - 1),
    }
}

/// What a run keeps in memory, all stages together, is no more than [`MEMORY`].
pub(super) fn of_stages(stages: &[Stage], source: &Source) -> Result<(), CaseError> {
    let kept = || stages.iter().enumerate().flat_map(|(i, stage)| kept(stage, frames_key(i, source)));
    let total: usize = kept().map(|kept| kept.bytes).sum();
    // Of equal ones the first.
    let Some(largest) = kept().rev().max_by_key(|kept| kept.bytes).filter(|_| total > MEMORY) else { return Ok(()) };
    let gigabytes = |bytes: usize| bytes as f64 / 1e9;
    let (of, total, most) = (stages.len(), gigabytes(total), gigabytes(MEMORY));
    let what = format!("the run's stages ({of}) fill {total:.2} GB, more than {most:.2} GB: {}", largest.what);
    Err(source.error(&largest.key, what, largest.help))
}

/// A part of what a stage keeps until the run has ended.
struct Kept {
    bytes: usize,
    /// The key that it grows with.
    key: String,
    what: String,
    help: &'static str,
}

fn kept(Stage { name, model, .. }: &Stage, frames_key: String) -> [Kept; 3] {
    let (frames, elements, points) = (model.frames.len(), model.blank.elements, model.blank.layers);
    let memory = Memory::of(model);
    [
        Kept {
            bytes: memory.frames,
            key: frames_key,
            what: format!("stage `{name}` keeps {frames} frames of {elements} elements"),
            help: "keep fewer frames in every stage, or take fewer elements",
        },
        Kept {
            bytes: memory.points,
            key: "blank.layers".into(),
            what: format!("stage `{name}` keeps {points} points through the thickness of {elements} elements"),
            help: "take fewer points, or fewer elements",
        },
        Kept {
            bytes: memory.steps,
            key: "solver.max_step".into(),
            what: format!(
                "stage `{name}` keeps {} steps or more, and the strains of {} elements for the forming limit",
                least_steps(model),
                with_path(model)
            ),
            help: "take longer steps, or fewer elements",
        },
    ]
}

/// What follows from the numbers together.
pub(super) fn of_model(model: &Model, frames_key: &str, source: &Source) -> Result<(), CaseError> {
    let (frames, elements) = (model.frames.len(), model.blank.elements);
    if frames * elements > ROWS {
        let what = format!("{frames} frames of {elements} elements are {} rows, more than {ROWS}", frames * elements);
        return Err(source.error(frames_key, what, format!("keep at most {} frames", ROWS / elements)));
    }
    let Some(facets) = model.settings.facets else { return Ok(()) };
    for tool in &model.tools {
        let sweeps = tool.profile.pieces().iter().map(|piece| match piece {
            Piece::Arc(arc) => arc.sweep.abs(),
            Piece::Segment(_) => 0.0,
        });
        let quarters = sweeps.sum::<f64>() / FRAC_PI_2;
        if quarters * facets as f64 > CHORDS {
            let chords = quarters * facets as f64;
            let what = format!("the {}'s arcs make {chords:.0} chords, more than {CHORDS}", tool.role.name());
            return Err(source.error(
                "solver.facets",
                what,
                format!("at most facets = {:.0}", CHORDS / quarters - 0.5),
            ));
        }
    }
    Ok(())
}
