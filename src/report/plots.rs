//! The plots of a stage by the files that hold them.

use super::document::Picture;
use crate::assess::tears_at;
use crate::results::{OUTPUTS, StageView};

/// The picture of the part, and what it shows of one that tears.
pub(super) const PART: &str = "part.png";
const TORN: &str = "the part coloured by thinning, its thinnest place and where it tears";

/// The plot of a stage that stands in this file of a result folder.
pub(super) fn plot(view: &StageView, file: &str) -> Option<Picture> {
    let output = OUTPUTS.iter().find(|output| output.file == file)?;
    let about = match tears_at(view.stage) {
        Some(_) if file == PART => TORN,
        _ => output.about,
    };
    let (name, caption) = (output.stem().to_owned(), String::from(about));
    Some(Picture { name, caption, chart: output.chart(view)? })
}
