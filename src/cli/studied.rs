//! What a study of the case found: its pictures written, its answer told and as JSON.

use super::many::{Many, write_all};
use serde_json::Value;
use stampflow::output::study::{json, kept_loads, loads, pictures};
use stampflow::study::{Designs, Results, Said};
use stampflow::units::rounded;
use std::path::{Path, PathBuf};

/// What a study found, and the pictures of it that are written.
pub struct Studied {
    said: Said,
    files: Vec<PathBuf>,
}

impl Studied {
    /// Draws a study that is complete into its folder; load curves too, where it `has_curves` kept there.
    ///
    /// # Errors
    /// When a picture cannot be written.
    pub fn of(results: &Results, many: &Many, dir: &Path, has_curves: bool) -> anyhow::Result<Self> {
        let style = many.pictures.pictures();
        let case = results.plan.subject().case(&[])?;
        let mut drawn = pictures(results, &case.model().title);
        if has_curves {
            let curves = kept_loads(dir, results.plan.count());
            drawn.extend(loads(results, &curves).map(|chart| ("loads", chart)));
        }
        let files = write_all(dir, drawn.iter().flat_map(|(stem, chart)| style.files(stem, chart)))?;
        Ok(Self { said: Said::of(results), files })
    }

    /// A few lines, and where the pictures are.
    pub fn told(&self, results: &Results) -> String {
        let sentences = self.said.sentences(results);
        let mut lines = sentences.iter().map(|sentence| sentence.to_string());
        let first = lines.next().unwrap_or_default();
        let others: String = lines.map(|line| format!("\n- {line}")).collect();
        let files: String = self.files.iter().map(|file| format!("\n{}", file.display())).collect();
        first + &others + &files
    }

    /// The same for programs; numbers in SI.
    pub fn json(&self, results: &Results, table: &Path, (kept, seconds): (usize, f64)) -> Value {
        let mut value = json::sweep(results, &self.said);
        value["file"] = table.display().to_string().into();
        value["pictures"] = self.files.iter().map(|file| file.display().to_string()).collect();
        value["kept"] = kept.into();
        value["wall_s"] = rounded(seconds).into();
        value
    }
}
