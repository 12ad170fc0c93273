//! What a number is moved by when each key is changed by itself: the bars of a tornado.

use super::results::Results;

/// How far a number goes over the values of one axis, all else as it stands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Swing {
    /// Place of the axis in [`Results::axes`].
    pub axis: usize,
    /// Where the number is least.
    pub low: End,
    /// Where it is largest.
    pub high: End,
    /// Where every value moves the number to one side: the furthest on the other side of where the case stands than the value
    /// at the end.
    pub other: Option<End>,
}

/// One end of a swing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// The number, in its unit.
    pub number: f64,
    /// The row that has it; 0, the case as it stands, where no value goes further.
    pub row: usize,
    /// The axis's value there, in its unit; `None` of the case as it stands.
    pub value: Option<f64>,
}

impl Swing {
    /// From end to end, in the number's unit.
    pub fn width(&self) -> f64 {
        self.high.number - self.low.number
    }
}

/// The swings of a number of a study of one key at a time, the largest first; none where the case as it stands has no such
/// number.
pub fn swings(results: &Results, place: usize) -> Vec<Swing> {
    let own = results.rows[0].numbers[place];
    let stands = End { number: own, row: 0, value: None };
    if !own.is_finite() {
        return Vec::new();
    }
    let mut all: Vec<Swing> =
        (0..results.axes.len()).map(|axis| Swing { axis, low: stands, high: stands, other: None }).collect();
    for (row, found) in results.rows.iter().enumerate().skip(1) {
        let number = found.numbers[place];
        let places = results.plan.place(row as u64);
        let Some((axis, at)) = places.iter().enumerate().find_map(|(axis, at)| Some((axis, (*at)?))) else { continue };
        if !number.is_finite() || !found.is_known() {
            continue;
        }
        let end = End { number, row, value: Some(results.axes[axis].values[at]) };
        let swing = &mut all[axis];
        if number < swing.low.number {
            swing.low = end;
        }
        if number > swing.high.number {
            swing.high = end;
        }
    }
    all.iter_mut().for_each(|swing| swing.other = beside(results, place, swing));
    all.sort_by(|a, b| b.width().total_cmp(&a.width()));
    all
}

/// [`Swing::other`]; `None` of names, which have no sides.
fn beside(results: &Results, place: usize, swing: &Swing) -> Option<End> {
    let axis = &results.axes[swing.axis];
    let (one, stands) = match (swing.low.value, swing.high.value) {
        (None, Some(value)) | (Some(value), None) => (value, axis.own.filter(|_| !axis.has_names())?),
        _ => return None,
    };
    let own = results.rows[0].numbers[place];
    let ends = results.rows.iter().enumerate().skip(1).filter_map(|(row, found)| {
        let value = axis.values[results.plan.place(row as u64)[swing.axis]?];
        let number = found.numbers[place];
        let is_beside = (value - stands) * (one - stands) < 0.0 && number.is_finite() && found.is_known();
        is_beside.then_some(End { number, row, value: Some(value) })
    });
    ends.max_by(|a, b| (a.number - own).abs().total_cmp(&(b.number - own).abs()))
}
