//! The plots of a stage by the files that hold them.

use super::document::Picture;
use crate::output::{Make, OUTPUTS, StageView};

/// The plot of a stage that stands in this file of a result folder.
pub(super) fn plot(view: &StageView, file: &str) -> Option<Picture> {
    let output = OUTPUTS.iter().find(|output| output.file == file)?;
    let Make::Plot(make) = output.make else { return None };
    let name = output.stem().to_owned();
    Some(Picture { name, caption: output.about.to_owned(), chart: make(view)? })
}
