//! Folder of a study's results.

use crate::plot::Format;
use crate::results::{IsOurs, ResultFolder, WriteError};
use std::path::Path;

/// Opens the folder for the results of a study by its verb: those of an earlier one are replaced, other files stay.
pub fn study_folder(verb: &str, dir: &Path) -> Result<ResultFolder, WriteError> {
    let is_ours: IsOurs = match verb {
        "sweep" => |_, path| {
            let curves = "curves/load-0.csv curves/thickness-0.csv .study.csv.curves/load-0.csv .study.csv.curves/thickness-0.csv";
            is_one(path, "study.csv .study.csv.rows sensitivities.csv sweep.png") || is_one(path, curves)
        },
        "search" => |_, path| is_one(path, "search.csv .search.csv.rows search.png"),
        "scatter" => {
            |_, path| is_one(path, "scatter.csv .scatter.csv.rows scatter_lights.csv scatter_numbers.csv scatter.png")
        }
        "fit" => |_, path| is_one(path, "fit.csv laws.csv directions.csv fit.png fit_0.png fitted.toml material.toml"),
        _ => |_, path| is_one(path, "differences.csv compare_load.png compare_thickness.png compare_sections.png"),
    };
    ResultFolder::open(dir, is_ours)
}

/// Whether a path is one of some files: `.png` stands for any picture, 0 for any number.
fn is_one(path: &Path, files: &str) -> bool {
    let plain = |name: &str| {
        let digit = |c: char| if c.is_ascii_digit() { '0' } else { c };
        let mut plain: Vec<char> = Format::stem(name).unwrap_or(name).chars().map(digit).collect();
        plain.dedup_by(|a, b| a == b && *a == '0');
        (plain, Format::stem(name).is_some())
    };
    path.to_str().is_some_and(|name| files.split(' ').any(|file| plain(file) == plain(name)))
}
