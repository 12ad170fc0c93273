//! Polygons clipped at a window or hatched, lines cut into dashes.

type Points = Vec<(f64, f64)>;

/// Polygon clipped at a window; separate parts stay joined along the border.
///
/// # References
/// I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, Comm. ACM 17 (1974) 32–42.
pub fn clipped(polygon: &[(f64, f64)], x: (f64, f64), y: (f64, f64)) -> Points {
    type Inside = fn((f64, f64), f64) -> f64;
    let sides: [(Inside, f64); 4] =
        [(|p, b| p.0 - b, x.0), (|p, b| b - p.0, x.1), (|p, b| p.1 - b, y.0), (|p, b| b - p.1, y.1)];
    let mut points = polygon.to_vec();
    for (inside, border) in sides {
        let mut kept = Vec::with_capacity(points.len() + 4);
        for (i, &to) in points.iter().enumerate() {
            let from = points[(i + points.len() - 1) % points.len()];
            let (a, b) = (inside(from, border), inside(to, border));
            if (a >= 0.0) != (b >= 0.0) {
                let f = a / (a - b);
                kept.push((from.0 + f * (to.0 - from.0), from.1 + f * (to.1 - from.1)));
            }
            if b >= 0.0 {
                kept.push(to);
            }
        }
        points = kept;
    }
    points
}

/// Pieces of a line cut by a pattern of drawn and left-out lengths; an empty pattern keeps it whole.
pub fn dashed(line: &[(f64, f64)], pattern: &[f64]) -> Vec<Points> {
    if pattern.is_empty() || line.len() < 2 {
        return vec![line.to_vec()];
    }
    let mut dashes = Vec::new();
    let (mut part, mut left) = (0, pattern[0]);
    let mut dash = vec![line[0]];
    for pair in line.windows(2) {
        let (from, to) = (pair[0], pair[1]);
        let length = (to.0 - from.0).hypot(to.1 - from.1);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let f = done / length;
            let at = (from.0 + f * (to.0 - from.0), from.1 + f * (to.1 - from.1));
            if part % 2 == 0 {
                dash.push(at);
                dashes.push(std::mem::take(&mut dash));
            } else {
                dash = vec![at];
            }
            part = (part + 1) % pattern.len();
            left = pattern[part];
        }
        left -= length - done;
        if part % 2 == 0 {
            dash.push(to);
        }
    }
    if dash.len() > 1 {
        dashes.push(dash);
    }
    dashes
}

/// Parallel lines inside a polygon, `rise` degrees counter-clockwise with y pointing down, `apart` from each other and at
/// even distances from the origin, so that they continue in neighbours.
pub fn hatched(polygon: &[(f64, f64)], rise: f64, apart: f64) -> Vec<[(f64, f64); 2]> {
    let (sin, cos) = (-rise.to_radians()).sin_cos();
    // Along the lines, and across them.
    let turned: Points = polygon.iter().map(|(x, y)| (x * cos + y * sin, y * cos - x * sin)).collect();
    let (low, high) = turned.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), p| (a.min(p.1), b.max(p.1)));
    let mut lines = Vec::new();
    // Half a step off: borders along the lines do not meet them.
    for step in ((low / apart).floor() as i64)..((high / apart).ceil() as i64) {
        let level = apart * (step as f64 + 0.5);
        let next = turned.iter().cycle().skip(1);
        let mut ends: Vec<f64> = turned
            .iter()
            .zip(next)
            .filter(|(a, b)| (a.1 <= level) != (b.1 <= level))
            .map(|(a, b)| a.0 + (b.0 - a.0) * (level - a.1) / (b.1 - a.1))
            .collect();
        ends.sort_by(f64::total_cmp);
        let back = |along: f64| (along * cos - level * sin, along * sin + level * cos);
        lines.extend(ends.chunks_exact(2).filter(|pair| pair[0] < pair[1]).map(|pair| [back(pair[0]), back(pair[1])]));
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    fn area(polygon: &[(f64, f64)]) -> f64 {
        let next = polygon.iter().cycle().skip(1);
        0.5 * polygon.iter().zip(next).map(|(a, b)| a.0 * b.1 - b.0 * a.1).sum::<f64>()
    }

    #[test]
    fn clipping_keeps_the_area_inside_the_window() {
        let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
        assert_eq!(area(&clipped(&square, (1.0, 9.0), (-5.0, 2.0))), 6.0);
        assert_eq!(area(&clipped(&square, (-1.0, 9.0), (-5.0, 9.0))), 16.0);
        assert!(clipped(&square, (5.0, 9.0), (0.0, 1.0)).is_empty());
    }

    #[test]
    fn dashes_have_the_lengths_of_the_pattern_around_corners() {
        let dashes = dashed(&[(0.0, 0.0), (3.0, 0.0), (3.0, 7.0)], &[2.0, 2.0]);
        assert_eq!(dashes, [vec![(0.0, 0.0), (2.0, 0.0)], vec![(3.0, 1.0), (3.0, 3.0)], vec![(3.0, 5.0), (3.0, 7.0)],]);
        assert_eq!(dashed(&[(0.0, 0.0), (3.0, 0.0)], &[]).len(), 1);
    }

    /// Reference: the lines of a square lie inside of it and are, times their distance, its area; a hole that is joined by a
    /// bridge has none.
    #[test]
    fn a_hatch_fills_its_area_and_no_hole() {
        let square = [(0.0, 0.0), (40.0, 0.0), (40.0, 40.0), (0.0, 40.0)];
        let hole = [(0.0, 0.0), (10.0, 10.0), (10.0, 30.0), (30.0, 30.0), (30.0, 10.0), (10.0, 10.0)];
        let holed: Points = square.iter().chain(&hole).copied().collect();
        let length = |lines: &[[(f64, f64); 2]]| lines.iter().map(|[a, b]| (a.0 - b.0).hypot(a.1 - b.1)).sum::<f64>();
        for rise in [0.0, 45.0, 135.0, 90.0] {
            let lines = hatched(&square, rise, 0.5);
            assert!((0.5 * length(&lines) - 1600.0).abs() < 10.0, "{rise}: {}", 0.5 * length(&lines));
            assert!((0.5 * length(&hatched(&holed, rise, 0.5)) - 1200.0).abs() < 10.0, "{rise}");
        }
        let rising = hatched(&square, 45.0, 10.0)[0];
        assert!(
            (rising[1].0 - rising[0].0) * (rising[1].1 - rising[0].1) < 0.0,
            "up the page to the right: {rising:?}"
        );
    }
}
