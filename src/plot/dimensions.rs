//! Section at the start with its dimensions.

use super::{sections::flat, sections::panel, sections::tools, sections::whole_sheet, *};

/// Size of the section, and its place in the drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Dimension {
    /// Name in a table: `Punch diameter`.
    pub name: String,
    /// Text on a drawing: `Punch Ø 60 mm`.
    pub text: String,
    /// Value.
    pub amount: Amount,
    /// Point of the section that the text belongs to \[mm\].
    pub at: Point,
}

const AROUND: f64 = 0.05;

/// Sheet and tools before the first step of a stage with dimensions; `start` is the sheet that a later stage begins with.
pub fn dimensioned(title: String, model: &Model, start: Option<&Frame>, dimensions: &[Dimension]) -> Chart {
    let around = AROUND * model.blank.reach();
    let sheet = start.map_or_else(|| flat(model), |frame| whole_sheet(frame, 1.0));
    let points = || dimensions.iter().map(|own| (own.at.x, own.at.y)).chain(sheet.iter().copied());
    let width = bounds(points().map(|p| p.0)).1 + around;
    let (first, last) = bounds(sheet.iter().map(|p| p.1));
    let least = [-4.0, 4.0].map(|times| 0.5 * (first + last) + times * around);
    let (top, bottom) = bounds(points().map(|p| p.1).chain(least));
    let window = [(0.0, width), (top - around, bottom + around)];
    let flags: Vec<_> = dimensions.iter().map(|own| Annotation::flag(&own.text, (own.at.x, own.at.y))).collect();
    let note = match start {
        Some(_) => "Blue: the sheet that the stage begins with. Grey: the tools.",
        None => "Blue: the blank. Grey: the tools, where they touch it.",
    };
    let panel = panel(model.geometry, window).with(tools(model, start, width)).annotated(flags);
    Chart::new(title, vec![panel.with([Series::silent(sheet, Style::area(color(0)))])], vec![note.to_owned()])
}
