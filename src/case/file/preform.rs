//! `[blank] earlier_run`: the sheet that another run has formed.

use super::{points::Named, *};
use crate::case::files;
use crate::model::Preform;
use crate::numerics::running_sums;
use crate::units::joined;

/// Gap to the axis, over the space of two elements, that is none \[–\].
const ON_AXIS: f64 = 0.1;
/// Relative difference of thicknesses that are one \[–\]: of rounded columns.
const SAME: f64 = 1e-3;
const KEY: &str = "blank.earlier_run";
const EXAMPLE: &str = "give the folder of its results, of one of several stages: out/cup or out/cup/1-draw";

/// Meridian of the sheet at the end of a run with results in `folder`, and its thickness and strains.
pub fn read(folder: &str, thickness: f64, geometry: Geometry, source: &Source) -> Result<(Profile, Preform)> {
    let (file, path) = (format!("{folder}/profile.csv"), source.folder.path.join(folder));
    let is_file = source.folder.files.text(&path, files::CSV).is_ok();
    source.require(!is_file, KEY, format!("\"{folder}\" is a file, not the folder of a run"), EXAMPLE)?;
    // Several stages have a folder each.
    let stages = source.folder.files.text(&path.join("stages.csv"), files::CSV).unwrap_or_default();
    let stages = stages.lines().skip(1).filter_map(|row| {
        let mut cells = row.split(',');
        Some(format!("\"{folder}/{}-{}\"", cells.next()?, cells.next()?))
    });
    let stages = joined(stages, ", ");
    let what = format!("the run in \"{folder}\" has stages");
    source.require(stages.is_empty(), KEY, what, format!("give the folder of one: {stages}"))?;
    let (text, csv) = Named { file: &file, what: "earlier run's", example: EXAMPLE, key: KEY }.open(source)?;
    let strains = ["strain_meridional", "strain_hoop", "strain_equivalent", "strain_thickness"];
    let names = [&["s0_mm", "r_mm", "z_mm", "thickness_mm"], &strains[..]].concat();
    let missing = |name: &str| format!("there is no column {name}; found {}", csv.names());
    let column = |name: &&str| csv.column(name).ok_or_else(|| text.error(csv.header.line, missing(name), EXAMPLE));
    let columns = names.iter().map(column).collect::<Result<Vec<_>>>()?;
    // Rows of each instant go outward from the axis: those of the last one remain.
    let mut rows: Vec<[f64; 8]> = Vec::new();
    for record in &csv.rows {
        let mut row = [0.0; 8];
        for (k, (value, &column)) in row.iter_mut().zip(&columns).enumerate() {
            let number = text.number(record, column)?.filter(|number| *number > 0.0 || ![1, 3].contains(&k));
            let what = || format!("{} is no number above 0", names[k]);
            *value = number.ok_or_else(|| text.error(record.line, what(), EXAMPLE))?;
        }
        let before = row[3] * (-row[7]).exp();
        let what = || format!("the sheet there was {before:.4} mm thick at first, not {} mm", rounded(thickness));
        if (before / thickness - 1.0).abs() > SAME {
            return Err(text.error(record.line, what(), "give its `thickness` before the earlier run"));
        }
        if rows.last().is_some_and(|last| row[0] <= last[0]) {
            rows.clear();
        }
        rows.push(row);
    }
    let is_strip = rows.iter().all(|row| row[5] == 0.0);
    let what = format!("the run in \"{folder}\" is not {}, as this case is", geometry.key());
    source.require(is_strip == (geometry == Geometry::PlaneStrain), KEY, what, "give a run of the same `geometry`")?;
    let middles: Vec<Point> = rows.iter().map(|row| Point::new(row[1], row[2])).collect();
    let ([first, second, ..], [.., before, last]) = (&middles[..], &middles[..]) else {
        return Err(text.error(csv.header.line, "a sheet has two elements at least", EXAMPLE));
    };
    let (mut start, end) = (first + 0.5 * (first - second), last + 0.5 * (last - before));
    if start.x < ON_AXIS * (second - first).norm() {
        start.x = 0.0;
    }
    let points: Vec<Point> = [start].into_iter().chain(middles.iter().copied()).chain([end]).collect();
    let chords = points.windows(2).map(|w| Piece::line(w[0], w[1])).collect();
    let profile = Profile::new(chords).map_err(|error| text.error(csv.header.line, error.to_string(), EXAMPLE))?;
    let (long, profile) = (profile.length(), profile.rounded());
    let along = running_sums(points.windows(2).map(|w| (w[1] - w[0]).norm() * profile.length() / long)).split_off(1);
    let curve = |k: usize| {
        let points = along.iter().zip(&rows).map(|(s, row)| (*s, row[k])).collect();
        PiecewiseLinear::new(points).ok_or_else(|| text.error(csv.header.line, "its rows repeat a place", EXAMPLE))
    };
    let summary = source.file(&path.join("summary.json"), files::CSV).unwrap_or_default();
    let summary: serde_json::Value = serde_json::from_str(&summary).unwrap_or_default();
    let written = |key: &str| summary[key].as_str().unwrap_or_default().to_owned();
    let rows = summary["verdict"]["findings"].as_array().into_iter().flatten();
    let red = joined(rows.filter(|row| row["light"] == "red").filter_map(|row| row["label"].as_str()), ", ");
    let doubt = match red.is_empty() {
        _ if summary["complete"] == false => written("stop").split(';').next().unwrap_or_default().to_owned(),
        true => String::new(),
        false => format!("red lines: {red}"),
    };
    let draws = summary["draws_mm"].as_array().into_iter().flatten().filter_map(serde_json::Value::as_f64).collect();
    let (thickness, strains) = (curve(3)?, [curve(4)?, curve(5)?, curve(6)?]);
    let run = Preform { folder: folder.to_owned(), material: written("hardening"), doubt, draws, thickness, strains };
    source.note(format!("the sheet is that of {folder} at its end, without its stresses, bending strains and damage"));
    Ok((profile, run))
}
