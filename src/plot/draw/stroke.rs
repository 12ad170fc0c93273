//! The outline of a line that has a width.

use super::mark::Point;
use std::f64::consts::TAU;

/// Chords of round joins span at most this angle \[rad\].
const CHORD: f64 = 0.4;

/// The outline of a line through these points, `half` of its width to either side; none where it has no length.
pub(super) fn outline(points: &[Point], half: f64) -> Vec<Point> {
    let mut line = points.to_vec();
    line.dedup();
    let mut outline = Vec::with_capacity(4 * line.len());
    if line.len() > 1 {
        side(&line, half, &mut outline);
        line.reverse();
        side(&line, half, &mut outline);
    }
    outline
}

/// What lies to one side of the line, from its start to its end.
fn side(line: &[Point], half: f64, outline: &mut Vec<Point>) {
    let aside = |pair: &[Point]| {
        let (x, y) = (pair[1].0 - pair[0].0, pair[1].1 - pair[0].1);
        let scale = half / x.hypot(y);
        (y * scale, -x * scale)
    };
    let beside = |at: Point, by: Point| (at.0 + by.0, at.1 + by.1);
    let mut before: Option<Point> = None;
    for pair in line.windows(2) {
        let by = aside(pair);
        if let Some(from) = before {
            let turn = (from.0 * by.1 - from.1 * by.0).atan2(from.0 * by.0 + from.1 * by.1);
            if turn > 0.0 {
                // Outside of the bend: along a circle.
                let chords = (turn / CHORD).ceil();
                outline.extend((1..chords as usize).map(|i| {
                    let (sin, cos) = (turn * i as f64 / chords).sin_cos();
                    beside(pair[0], (from.0 * cos - from.1 * sin, from.0 * sin + from.1 * cos))
                }));
            } else {
                outline.push(pair[0]);
            }
        }
        outline.extend([beside(pair[0], by), beside(pair[1], by)]);
        before = Some(by);
    }
}

/// A circle in chords.
pub(super) fn circle(at: Point, radius: f64) -> Vec<Point> {
    const CHORDS: usize = 40;
    let point = |i: usize| {
        let (sin, cos) = (TAU * i as f64 / CHORDS as f64).sin_cos();
        (at.0 + radius * cos, at.1 + radius * sin)
    };
    (0..CHORDS).map(point).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: areas by hand: a straight line is a rectangle; a right angle adds a quarter of a circle outside, of three
    /// chords and more, and covers a square twice inside.
    #[test]
    fn a_line_becomes_a_band_with_round_joins() {
        let area = |outline: &[Point]| {
            let next = outline.iter().cycle().skip(1);
            0.5 * outline.iter().zip(next).map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum::<f64>().abs()
        };
        assert_eq!(area(&outline(&[(0.0, 0.0), (5.0, 0.0), (10.0, 0.0)], 1.0)), 20.0);
        for corner in [2.0, -2.0] {
            let bent = area(&outline(&[(0.0, 0.0), (10.0, 0.0), (10.0, 5.0 * corner)], 1.0));
            assert!((bent - (40.0 + 0.125 * TAU)).abs() < 0.03, "{bent}");
        }
        assert!(outline(&[(1.0, 1.0), (1.0, 1.0)], 1.0).is_empty());
    }
}
