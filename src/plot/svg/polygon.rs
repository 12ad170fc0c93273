//! Polygons clipped at a window.

/// Polygon clipped at a window; separate parts stay joined along the border.
///
/// # References
/// I. E. Sutherland, G. W. Hodgman, Reentrant polygon clipping, Comm. ACM 17 (1974) 32–42.
pub(super) fn clipped(polygon: &[(f64, f64)], x: (f64, f64), y: (f64, f64)) -> Vec<(f64, f64)> {
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

#[cfg(test)]
#[test]
fn polygons_are_clipped() {
    let square = [(0.0, 0.0), (4.0, 0.0), (4.0, 4.0), (0.0, 4.0)];
    assert_eq!(clipped(&square, (1.0, 9.0), (-5.0, 2.0)), [(1.0, 2.0), (1.0, 0.0), (4.0, 0.0), (4.0, 2.0)]);
    assert!(clipped(&square, (5.0, 9.0), (0.0, 1.0)).is_empty());
}
