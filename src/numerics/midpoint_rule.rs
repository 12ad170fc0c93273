//! The thickness in equal parts: each point stands in the middle of one, for laws that integrate over it.

use super::lobatto::ThicknessPoint;

/// The middles of `n` equal parts.
pub fn rule(n: usize) -> Vec<ThicknessPoint> {
    let weight = 1.0 / n as f64;
    (0..n).map(|i| ThicknessPoint { xi: (2 * i + 1) as f64 * weight - 1.0, weight, half: weight }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Trust: parts from the one face to the other, whose mean squares about the mid-surface are that of the thickness, 1/3.
    #[test]
    fn parts_fill_the_thickness() {
        for n in [1, 3, 6, 51] {
            let points = rule(n);
            let mut face = -1.0;
            for p in &points {
                assert!((p.xi - p.half - face).abs() < 1e-14 && p.weight == p.half);
                face = p.xi + p.half;
            }
            assert!((face - 1.0).abs() < 1e-14);
            let square: f64 = points.iter().map(|p| p.weight * (p.xi * p.xi + p.half * p.half / 3.0)).sum();
            assert!((square - 1.0 / 3.0).abs() < 1e-14, "{n}: {square}");
        }
    }
}
