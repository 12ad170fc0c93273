//! The plots of a stage by the files that hold them.

use super::document::Picture;
use crate::output::{OUTPUTS, StageView};

/// The plot of a stage that stands in this file of a result folder.
pub(super) fn plot(view: &StageView, file: &str) -> Option<Picture> {
    let output = OUTPUTS.iter().find(|output| output.file == file)?;
    let (name, caption) = (output.stem().to_owned(), view.form.tell(output.about));
    Some(Picture { name, caption, chart: output.chart(view)? })
}
