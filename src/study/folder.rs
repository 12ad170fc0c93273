//! Folder of a study's results.

use crate::plot::Format;
use crate::results::{IsOurs, ResultFolder, WriteError};
use std::path::Path;

/// Opens the folder for the results of a study by the name of its table: those of an earlier one are replaced, other files stay.
pub fn study_folder(name: &str, dir: &Path) -> Result<ResultFolder, WriteError> {
    let is_ours: IsOurs = match name {
        "study" => |_, path| {
            let curves = "curves/load-#.csv curves/thickness-#.csv .study.csv.curves/load-#.csv .study.csv.curves/thickness-#.csv";
            is_one(path, "study.csv .study.csv.rows sensitivities.csv sweep.png") || is_one(path, curves)
        },
        "search" => |_, path| is_one(path, "search.csv .search.csv.rows search.png"),
        "scatter" => {
            |_, path| is_one(path, "scatter.csv .scatter.csv.rows scatter_lights.csv scatter_numbers.csv scatter.png")
        }
        "fit" => |_, path| is_one(path, "fit.csv laws.csv directions.csv fit.png fit_#.png fitted.toml material.toml"),
        _ => |_, path| is_one(path, "differences.csv compare_load.png compare_thickness.png compare_sections.png"),
    };
    ResultFolder::open(dir, is_ours)
}

fn is_one(path: &Path, files: &str) -> bool {
    let name = path.to_string_lossy();
    let name = Format::stem(&name).map_or_else(|| name.to_string(), |stem| format!("{stem}.png"));
    let number = |(before, after): (&str, &str)| name.strip_prefix(before)?.strip_suffix(after)?.parse::<u64>().ok();
    files.split(' ').any(|file| file == name || file.split_once('#').and_then(number).is_some())
}
