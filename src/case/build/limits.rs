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
    let limit = file.forming_limit.as_ref().and_then(|limit| limit.points.as_ref());
    let (punch, die, holder) = (tools.punch.as_ref(), tools.die.as_ref(), tools.holder.as_ref());
    for (path, length, most) in [
        ("tools.beads", tools.beads.len(), 20),
        ("notes", file.notes.len(), 50),
        ("compare", file.compare.len(), 50),
        ("output.frames", file.output.frames.as_ref().map_or(0, Vec::len), 1000),
        ("forming_limit.points", limit.map_or(0, Vec::len), 1000),
        ("tools.punch.motion", punch.and_then(|t| t.motion.as_ref()).map_or(0, Vec::len), 1000),
        ("tools.punch.profile", steps(punch.and_then(|t| t.profile.as_ref())), 2000),
        ("tools.die.profile", steps(die.and_then(|t| t.profile.as_ref())), 2000),
        ("tools.holder.profile", steps(holder.and_then(|t| t.profile.as_ref())), 2000),
    ] {
        list(path, length, most)?;
    }
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
        for (key, name) in
            [("reference", Some(&c.reference)), ("x", c.x.as_ref()), ("y", c.y.as_ref()), ("error", c.error.as_ref())]
        {
            text(&path(key), name.map_or("", String::as_str), NAME)?;
        }
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
    let (mut total, mut largest) = (0, (0, String::new(), String::new(), ""));
    for (i, Stage { name, model, .. }) in stages.iter().enumerate() {
        let (frames, elements, points) = (model.frames.len(), model.blank.elements, model.blank.layers);
        // Every frame is landed on, and no step is longer than the longest.
        let steps = frames.max((1.0 / model.settings.max_step).round() as usize);
        let with_path = if model.forming_limit.is_some() { elements } else { 0 };
        let of_frames = frames * elements * (size_of::<ElementRecord>() + size_of::<NodeRecord>());
        let of_points = elements * points * (2 * size_of::<PointRecord>() + size_of::<MaterialPoint>());
        let of_paths = steps.min(Paths::MOST) * with_path * size_of::<[f64; 2]>();
        let of_steps = steps * size_of::<StepRecord>() + of_paths;
        let through = format!("{points} points through the thickness of {elements} elements");
        let records = [
            (of_frames, frames_key(i, source), format!("{frames} frames of {elements} elements"), "keep fewer frames"),
            (of_points, "blank.layers".into(), through, "take fewer points"),
            (of_steps, "solver.max_step".into(), format!("{steps} steps or more"), "take longer steps"),
        ];
        for (bytes, key, what, help) in records {
            total += bytes;
            if bytes > largest.0 {
                largest = (bytes, key, format!("stage `{name}` keeps {what}"), help);
            }
        }
    }
    let [gigabytes, most] = [total, MEMORY].map(|bytes| bytes as f64 / 1e9);
    let (_, key, records, help) = largest;
    let what = format!("the stages ({}) fill {gigabytes:.2} GB, more than {most:.2} GB: {records}", stages.len());
    source.require(total <= MEMORY, &key, what, format!("{help}, or fewer elements"))
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
