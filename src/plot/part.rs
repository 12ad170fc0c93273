//! The part: its whole section, coloured by thinning, its thinnest place with its number and the place of tearing.

use super::StageView;
use super::chart::{BLACK, Chart, Color, Look, Series, WHITE};
use super::font;
use super::sections::{panel, surface, whole_tools};
use super::thinning::{Thinning, said, times};
use crate::assess::tears_at;
use crate::solver::solution::{ElementRecord, Frame};
use crate::units::{Amount, joined};

/// What is shown around the part, over its width.
const AROUND: f64 = 0.03;
/// Width of the section, and of that in a narrow column \[px\].
const WIDE: f64 = 680.0;
const NARROW: f64 = 430.0;
/// Size of the letters of what is said in it \[px\].
const LETTERS: f64 = 20.0;
/// Half the size of the cross \[px of a picture 800 wide\].
const CROSS: f64 = 9.0;
/// How much of the half that tears is left to the words of the thinnest place.
const SHARED: f64 = 0.25;
/// Places for words that are tried along each direction.
const STEPS: u32 = 24;

/// The last frame, mirrored to the full width.
pub(crate) fn plot(view: &StageView) -> Option<Chart> {
    let (model, frame) = (view.model(), view.stage.frames.last()?);
    let window = window(frame);
    let mm = 2.0 * window[0].1 / WIDE;
    // Words that cover no sheet in a narrow picture cover none in a wide one.
    let narrow = 2.0 * window[0].1 / NARROW;
    let (initial, thinning) = (model.blank.thickness, Thinning::of(model.blank.thickness, [frame].into_iter()));
    let times = times(initial, 1.0 / mm);
    // Tools that were taken away are not there.
    let tools = whole_tools(model, frame, window[0].1).filter(|_| model.release.is_none());
    let thinnest = frame.elements.iter().min_by(|a, b| a.thickness.total_cmp(&b.thickness))?;
    let number = number(initial, thinnest.thickness);
    let tears_at = tears_at(view.stage);
    // What lies beyond is that of the tear, whose words are shorter.
    let room = if tears_at.is_some() { -SHARED * window[0].1 } else { -window[0].1 };
    let mut marks = vec![callout(String::from(number), thinnest, (1.0, room), frame, window, narrow)];
    if let Some(s0) = tears_at {
        let away = |element: &&ElementRecord| (element.s0 - s0).abs();
        let torn = frame.elements.iter().min_by(|a, b| away(a).total_cmp(&away(b)))?;
        marks.push(callout(String::from("tears here"), torn, (-1.0, SHARED * window[0].1), frame, window, narrow));
        marks.extend(cross((-torn.r, torn.z), CROSS * mm));
    }
    let tools_at = model.release.is_none().then(|| "Grey: the tools at the end.".into());
    let drawn = joined(std::iter::once(said(times)).chain(tools_at), " ");
    let section = panel(model.geometry, tools.chain(thinning.whole(frame, times)).chain(marks), window);
    Some(Chart {
        title: view.titled("the part and its thinning"),
        legend: String::new(),
        panels: vec![section, thinning.scale()],
        notes: std::iter::once(String::from(drawn)).chain(view.notes()).collect(),
    })
}

/// The whole part and something around it.
fn window(frame: &Frame) -> [(f64, f64); 2] {
    let nodes = || frame.nodes.iter();
    let width = nodes().map(|node| node.r).fold(0.0, f64::max) * (1.0 + 2.0 * AROUND);
    let (top, bottom) =
        nodes().fold((f64::INFINITY, f64::NEG_INFINITY), |(top, bottom), n| (top.min(n.z), bottom.max(n.z)));
    let around = 2.0 * AROUND * width;
    [(-width, width), (top - 2.0 * around, bottom + around)]
}

/// `0.61 mm, 39 % thinner`, with the digits of the summary.
fn number(initial: f64, thickness: f64) -> String {
    let thinner = 1.0 - thickness / initial;
    let by = match thinner < 0.0 {
        false => format!("{thinning} thinner", thinning = Amount::share(thinner)),
        true => format!("{thickening} thicker", thickening = Amount::share(-thinner)),
    };
    joined([Amount::thickness(thickness).into(), by], ", ")
}

/// Words beside an element on one `side` of the middle (1 or −1), at the nearest place where they cover no sheet, from the
/// border at `left` on (negative: beyond the middle) \[mm\]; a px is so many `mm`.
fn callout(
    text: String,
    element: &ElementRecord,
    (side, left): (f64, f64),
    frame: &Frame,
    window: [(f64, f64); 2],
    mm: f64,
) -> Series {
    let [(_, right), (top, bottom)] = window;
    let at = (element.r, element.z);
    let (half, high) = ((0.5 * LETTERS * font::width(&text) + 6.0) * mm, 0.9 * LETTERS * mm);
    let surfaces: Vec<(f64, f64)> =
        (0..frame.nodes.len()).flat_map(|i| [1.0, -1.0].map(|face| surface(frame, i, face))).collect();
    let steps = |from: f64, to: f64| (0..=STEPS).map(move |i| from + (to - from) * f64::from(i) / f64::from(STEPS));
    let columns = steps(left + half, (right - half).max(left + half));
    let places = columns.flat_map(|x| steps(top + high, bottom - high).map(move |y| (x, y)));
    // Room for the leader, so that it is seen where it points.
    let covers = |p: &(f64, f64), q: &(f64, f64)| {
        (p.0 - q.0).abs().min((p.0 + q.0).abs()) < half + CROSS * mm && (p.1 - q.1).abs() < high + 1.5 * CROSS * mm
    };
    let free = places.filter(|place| !surfaces.iter().any(|surface| covers(place, surface)));
    let away = |p: &(f64, f64)| (p.0 - at.0).hypot(p.1 - at.1);
    let nearest =
        free.min_by(|a, b| away(a).total_cmp(&away(b))).unwrap_or(((right - half).max(left + half), top + high));
    Series::new(text, [at, nearest].map(|p| (side * p.0, p.1)).to_vec(), Look::Callout)
}

/// A black cross on white, so that it is seen on every colour.
fn cross(at: (f64, f64), half: f64) -> impl Iterator<Item = Series> {
    let line = move |up: f64, color: Color, width: f64| {
        let ends = vec![(at.0 - half, at.1 + up * half), (at.0 + half, at.1 - up * half)];
        Series::silent(ends, Look::Line { color, width, dash: &[] })
    };
    [(WHITE, 7.0), (BLACK, 3.5)]
        .into_iter()
        .flat_map(move |(color, width)| [1.0, -1.0].map(|up| line(up, color, width)))
}
