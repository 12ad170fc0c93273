//! Limits on the size of a case: more is a slip, and would fill the memory or a plot.

use crate::case::{CaseError, source::Source};
use crate::forming_limit::Paths;
use crate::geometry::Piece;
use crate::model::{Model, Stage};
use crate::solver::solution::{ElementRecord, NodeRecord, PointRecord, StepRecord};
use crate::solver::state::MaterialPoint;
use std::f64::consts::FRAC_PI_2;

/// Most rows of `profile.csv`: kept frames times elements.
const ROWS: usize = 500_000;
/// Memory of a run, all stages together \[bytes\]: ten stages with 1000 frames of 340 elements.
const MEMORY: usize = 500_000_000;
/// Most chords that replace the arcs of one tool.
const CHORDS: f64 = 20_000.0;

/// Key that gives the number of kept frames of a stage, the first one being stage 0.
pub fn frames_key(stage: usize, source: &Source) -> String {
    match stage {
        0 if source.has("output.frames") => "output.frames".into(),
        0 => "output.count".into(),
        later => format!("stages.{}.frames", later - 1),
    }
}

pub fn of_stages(stages: &[Stage], source: &Source) -> Result<(), CaseError> {
    let mut records = Vec::new();
    for (i, Stage { name, model, .. }) in stages.iter().enumerate() {
        let (frames, elements, points) = (model.frames.len(), model.blank.elements, model.blank.layers);
        // Every frame is landed on, and no step is longer than the longest.
        let steps = frames.max((1.0 / model.settings.max_step).round() as usize);
        let with_path = if model.forming_limit.is_some() { elements } else { 0 };
        let of_frames = frames * elements * (size_of::<ElementRecord>() + size_of::<NodeRecord>());
        let of_points = elements * points * (2 * size_of::<PointRecord>() + size_of::<MaterialPoint>());
        let of_steps = steps * size_of::<StepRecord>() + steps.min(Paths::MOST) * with_path * size_of::<[f64; 2]>();
        let through = format!("{points} points through the thickness of {elements} elements");
        let kept = [
            (of_frames, frames_key(i, source), format!("{frames} frames of {elements} elements"), "keep fewer frames"),
            (of_points, "blank.layers".into(), through, "take fewer points"),
            (of_steps, "solver.max_step".into(), format!("{steps} steps or more"), "take longer steps"),
        ];
        records.extend(kept.map(|(bytes, key, what, help)| (bytes, key, format!("stage `{name}` keeps {what}"), help)));
    }
    let total: usize = records.iter().map(|record| record.0).sum();
    let [gigabytes, most] = [total, MEMORY].map(|bytes| bytes as f64 / 1e9);
    let (_, key, largest, help) = records.into_iter().rev().max_by_key(|record| record.0).expect("a case has a stage");
    let what = format!("the stages ({}) fill {gigabytes:.2} GB, more than {most:.2} GB: {largest}", stages.len());
    source.require(total <= MEMORY, &key, what, format!("{help}, or fewer elements"))
}

pub fn of_model(model: &Model, frames_key: &str, source: &Source) -> Result<(), CaseError> {
    let (frames, elements) = (model.frames.len(), model.blank.elements);
    let rows = frames * elements;
    let what = format!("{frames} frames of {elements} elements are {rows} rows, more than {ROWS}");
    source.require(rows <= ROWS, frames_key, what, format!("keep at most {} frames", ROWS / elements))?;
    let Some(facets) = model.settings.facets else { return Ok(()) };
    for tool in &model.tools {
        let sweep = |piece: &Piece| if let Piece::Arc(arc) = piece { arc.sweep.abs() } else { 0.0 };
        let quarters = tool.profile.pieces().iter().map(sweep).sum::<f64>() / FRAC_PI_2;
        let chords = quarters * facets as f64;
        let what = format!("the {}'s arcs make {chords:.0} chords, more than {CHORDS}", tool.role.name());
        let help = format!("at most facets = {:.0}", CHORDS / quarters - 0.5);
        source.require(chords <= CHORDS, "solver.facets", what, help)?;
    }
    Ok(())
}
