//! Limits on the size of a case: more is a slip, and would fill the memory or a plot.

use crate::case::file::{CaseFile, Section};
use crate::case::{CaseError, source::Source};
use crate::forming_limit::Paths;
use crate::geometry::Piece;
use crate::model::{Model, Stage};
use crate::solver::solution::{ElementRecord, NodeRecord, PointRecord, StepRecord};
use crate::solver::state::MaterialPoint;
use std::f64::consts::FRAC_PI_2;

/// Longest title and longest other text, which every plot repeats \[characters\].
const TITLE: usize = 200;
const TEXT: usize = 1000;
/// Longest name of a file or a column \[characters\].
const NAME: usize = 200;
/// Most rows of `profile.csv`: kept frames times elements.
const ROWS: usize = 500_000;
/// Memory of a run, all stages together \[bytes\]: ten stages with 1000 frames of 340 elements.
const MEMORY: usize = 500_000_000;
/// Most chords that replace the arcs of one tool.
const CHORDS: f64 = 20_000.0;

/// Checks the lengths of lists and texts.
pub(super) fn of_file(file: &CaseFile, source: &Source) -> Result<(), CaseError> {
    let tools = &file.tools;
    let steps = |section: Option<&Section>| match section {
        Some(Section::Steps(steps)) => steps.len(),
        _ => 0,
    };
    let list = |path: &str, length: usize, most: usize| {
        let key = path.rsplit('.').next().unwrap_or(path);
        let what = format!("`{key}` has {length} entries, more than {most}");
        source.require(length <= most, &format!("{path}.{most}"), what, "leave out what is not needed")
    };
    list("tools.beads", tools.beads.len(), 20)?;
    list("notes", file.notes.len(), 50)?;
    list("compare", file.compare.len(), 50)?;
    list("output.frames", file.output.frames.as_ref().map_or(0, Vec::len), 1000)?;
    let limit = file.forming_limit.as_ref().and_then(|limit| limit.points.as_ref());
    list("forming_limit.points", limit.map_or(0, Vec::len), 1000)?;
    let motion = tools.punch.as_ref().and_then(|punch| punch.motion.as_ref());
    list("tools.punch.motion", motion.map_or(0, Vec::len), 1000)?;
    list("tools.punch.profile", steps(tools.punch.as_ref().and_then(|t| t.profile.as_ref())), 2000)?;
    list("tools.die.profile", steps(tools.die.as_ref().and_then(|t| t.profile.as_ref())), 2000)?;
    list("tools.holder.profile", steps(tools.holder.as_ref().and_then(|t| t.profile.as_ref())), 2000)?;
    let text = |path: &str, text: &str, most: usize| {
        let length = text.chars().count();
        let what = format!("`{path}` has {length} characters, more than {most}");
        source.require(length <= most, path, what, "plots and messages repeat it: keep it short")
    };
    text("title", &file.title, TITLE)?;
    for (i, note) in file.notes.iter().enumerate() {
        text(&format!("notes.{i}"), note, TEXT)?;
    }
    for (i, c) in file.compare.iter().enumerate() {
        let path = |key: &str| format!("compare.{i}.{key}");
        list(&path("band"), c.band.as_ref().map_or(0, Vec::len), 20)?;
        text(&path("reason"), &c.reason, TEXT)?;
        for (key, name) in [("reference", Some(&c.reference)), ("x", c.x.as_ref()), ("y", c.y.as_ref())] {
            text(&path(key), name.map_or("", String::as_str), NAME)?;
        }
        text(&path("error"), c.error.as_deref().unwrap_or(""), NAME)?;
        for (k, name) in c.band.iter().flatten().enumerate() {
            text(&path(&format!("band.{k}")), name, NAME)?;
        }
    }
    Ok(())
}

/// Key that gives the number of kept frames of a stage, the first one being stage 0.
pub(super) fn frames_key(stage: usize, source: &Source) -> String {
    match stage {
        0 if source.has("output.frames") => "output.frames".into(),
        0 => "output.count".into(),
        later => format!("stages.{}.frames", later - 1),
    }
}

/// Checks the memory of a run, all stages together.
pub(super) fn of_stages(stages: &[Stage], source: &Source) -> Result<(), CaseError> {
    let kept: Vec<Kept> = stages.iter().enumerate().flat_map(|(i, stage)| kept(stage, frames_key(i, source))).collect();
    let total: usize = kept.iter().map(|kept| kept.bytes).sum();
    // The first of equal ones.
    let Some(largest) = kept.iter().rev().max_by_key(|kept| kept.bytes) else { return Ok(()) };
    let [gigabytes, most] = [total, MEMORY].map(|bytes| bytes as f64 / 1e9);
    let n = stages.len();
    let what = format!("the run's stages ({n}) fill {gigabytes:.2} GB, more than {most:.2} GB: {}", largest.what);
    source.require(total <= MEMORY, &largest.key, what, largest.help)
}

/// Part of the records that a stage keeps until the run has ended.
struct Kept {
    bytes: usize,
    /// Key that it grows with.
    key: String,
    what: String,
    help: &'static str,
}

fn kept(Stage { name, model, .. }: &Stage, frames_key: String) -> [Kept; 3] {
    let (frames, elements, points) = (model.frames.len(), model.blank.elements, model.blank.layers);
    // Every frame is landed on, and no step is longer than the longest.
    let steps = frames.max((1.0 / model.settings.max_step).round() as usize);
    let with_path = if model.forming_limit.is_some() { elements } else { 0 };
    [
        Kept {
            bytes: frames * elements * (size_of::<ElementRecord>() + size_of::<NodeRecord>()),
            key: frames_key,
            what: format!("stage `{name}` keeps {frames} frames of {elements} elements"),
            help: "keep fewer frames in every stage, or take fewer elements",
        },
        Kept {
            bytes: elements * points * (2 * size_of::<PointRecord>() + size_of::<MaterialPoint>()),
            key: "blank.layers".into(),
            what: format!("stage `{name}` keeps {points} points through the thickness of {elements} elements"),
            help: "take fewer points, or fewer elements",
        },
        Kept {
            bytes: steps * size_of::<StepRecord>() + steps.min(Paths::MOST) * with_path * size_of::<[f64; 2]>(),
            key: "solver.max_step".into(),
            what: format!("stage `{name}` keeps {steps} steps or more, and the strains of {with_path} elements"),
            help: "take longer steps, or fewer elements",
        },
    ]
}

/// Checks the rows and chords that follow from a model.
pub(super) fn of_model(model: &Model, frames_key: &str, source: &Source) -> Result<(), CaseError> {
    let (frames, elements) = (model.frames.len(), model.blank.elements);
    let rows = frames * elements;
    let what = format!("{frames} frames of {elements} elements are {rows} rows, more than {ROWS}");
    source.require(rows <= ROWS, frames_key, what, format!("keep at most {} frames", ROWS / elements))?;
    let Some(facets) = model.settings.facets else { return Ok(()) };
    for tool in &model.tools {
        let sweeps = tool.profile.pieces().iter().map(|piece| match piece {
            Piece::Arc(arc) => arc.sweep.abs(),
            Piece::Segment(_) => 0.0,
        });
        let quarters = sweeps.sum::<f64>() / FRAC_PI_2;
        let chords = quarters * facets as f64;
        let what = format!("the {}'s arcs make {chords:.0} chords, more than {CHORDS}", tool.role.name());
        let help = format!("at most facets = {:.0}", CHORDS / quarters - 0.5);
        source.require(chords <= CHORDS, "solver.facets", what, help)?;
    }
    Ok(())
}
