//! How the pictures of the first page share what room the rest leaves.

use super::flow::WIDTH;
use crate::output::{DRAWN, Drawing};
use crate::plot::pdf::MM;
use crate::report::document::Picture;

/// Widths that pictures of the first page are laid out in \[px\]; the last is that of a narrow column.
const LAYOUTS: [f64; 4] = [DRAWN, 700.0, 600.0, 540.0];
/// No picture of the first page is narrower \[pt\], and what is between two side by side.
const NARROWEST: f64 = 75.0 * MM;
pub(super) const BETWEEN: f64 = 6.0 * MM;

/// How wide each of so many side by side is \[pt\].
pub(super) fn column(beside: usize) -> f64 {
    (WIDTH - (beside - 1) as f64 * BETWEEN) / beside as f64
}

/// How the pictures of the first page stand.
pub(super) struct Layout {
    /// So many in a row.
    pub beside: usize,
    pub drawings: Vec<Drawing>,
    /// Size on the page over that of the drawing \[pt/px\].
    pub scale: f64,
}

impl Layout {
    /// That with the largest letters, below each other or two and two, of those that fit into this height \[pt\] with captions of so high a line and are not
    /// too narrow. Narrower drawings have letters as large.
    pub fn best(pictures: &[&Picture], room: f64, line: f64) -> Option<Self> {
        let laid_out = |beside: usize, width: f64| {
            let drawings: Vec<_> = pictures.iter().map(|picture| Drawing::of(&picture.chart, width)).collect();
            let rows = drawings.chunks(beside);
            // A caption may take two lines of a narrow column.
            let room = room - rows.len() as f64 * (beside as f64 * line + 8.0);
            let high: f64 = rows.map(|row| row.iter().map(|drawing| drawing.height).fold(0.0, f64::max)).sum();
            let scale = (column(beside) / width).min(room / high);
            Self { beside, drawings, scale }
        };
        let all = [1, 2].into_iter().flat_map(|beside| LAYOUTS.map(|width| laid_out(beside, width)));
        let wide = |layout: &Self| layout.drawings.iter().all(|drawing| layout.scale * drawing.width >= NARROWEST);
        all.filter(wide).max_by(|a, b| a.scale.total_cmp(&b.scale))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plot::chart::{Chart, Look, Panel, Scale, Series};
    use crate::table::{Column, Unit};

    /// Trust: two pictures of 350 px and their axes are 160 mm high below each other at full width, and 75 mm side by side.
    #[test]
    fn no_picture_becomes_a_stamp() {
        let axis = Column::new("x", "X", Unit::Mm, vec![]).axis();
        let series = vec![Series::silent(vec![(0.0, 0.0), (1.0, 1.0)], Look::curve(0))];
        let panel = Panel { x: axis.clone(), y: axis, series, scale: Scale::Fit { height: 350.0, least: 0.0 } };
        let chart = Chart { title: "T".into(), legend: String::new(), panels: vec![panel], notes: vec![] };
        let picture = Picture { name: "p".into(), caption: "p".into(), chart };
        let beside = |room: f64| {
            let layout = Layout::best(&[&picture, &picture], room * MM, 10.0)?;
            assert!(layout.drawings.iter().all(|drawing| layout.scale * drawing.width >= NARROWEST), "{room}");
            let high: f64 = layout.drawings.chunks(layout.beside).map(|row| layout.scale * row[0].height).sum();
            assert!(high <= room * MM, "{room}");
            Some(layout.beside)
        };
        assert_eq!([220.0, 90.0, 30.0].map(beside), [Some(1), Some(2), None]);
    }
}
