//! Polygons clipped at a window, lines cut into dashes.

type Points = Vec<(f64, f64)>;

/// Polygon clipped at a window; separate parts stay joined along the border.
///
/// # References
/// I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, Comm. ACM 17 (1974) 32–42.
pub(super) fn clipped(polygon: &[(f64, f64)], x: (f64, f64), y: (f64, f64)) -> Points {
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
pub(super) fn dashed(line: &[(f64, f64)], pattern: &[f64]) -> Vec<Points> {
    if pattern.is_empty() || line.len() < 2 {
        return vec![line.to_vec()];
    }
    let mut dashes = Vec::new();
    let mut dash = vec![line[0]];
    let (mut part, mut left) = (0, pattern[0]);
    for pair in line.windows(2) {
        let (mut from, to) = (pair[0], pair[1]);
        loop {
            let length = (to.0 - from.0).hypot(to.1 - from.1);
            if length <= left {
                left -= length;
                dash.push(to);
                break;
            }
            let f = left / length;
            from = (from.0 + f * (to.0 - from.0), from.1 + f * (to.1 - from.1));
            dash.push(from);
            let done = std::mem::replace(&mut dash, vec![from]);
            dashes.extend((part % 2 == 0).then_some(done));
            part = (part + 1) % pattern.len();
            left = pattern[part];
        }
    }
    dashes.extend((part % 2 == 0 && dash.len() > 1).then_some(dash));
    dashes
}

#[cfg(test)]
#[test]
fn polygons_are_clipped_and_dashes_go_around_corners() {
    let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
    assert_eq!(clipped(&square, (1.0, 9.0), (-5.0, 2.0)), [(1.0, 2.0), (1.0, 0.0), (4.0, 0.0), (4.0, 2.0)]);
    assert!(clipped(&square, (5.0, 9.0), (0.0, 1.0)).is_empty());
    let dashes = dashed(&[(0.0, 0.0), (3.0, 0.0), (3.0, 7.0)], &[2.0, 2.0]);
    assert_eq!(dashes, [vec![(0.0, 0.0), (2.0, 0.0)], vec![(3.0, 1.0), (3.0, 3.0)], vec![(3.0, 5.0), (3.0, 7.0)]]);
}
