//! Rules through the thickness: Gauss-Lobatto's, with points on both faces, where bending yields first, and equal parts.

/// A point of integration through the thickness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ThicknessPoint {
    /// Place over the half-thickness, −1 to 1.
    pub xi: f64,
    /// Weight: share of the thickness that it stands for; the weights sum to 1.
    pub weight: f64,
    /// Half the height of the part that it is the middle of, over the half-thickness; 0 where it stands for itself.
    pub half: f64,
}

/// The `n`-point rule, exact for polynomials of degree 2n − 3; one point is the mid-surface (membrane).
///
/// Source: M. Abramowitz, I. Stegun, Handbook of Mathematical Functions (1964), 25.4.32.
pub fn lobatto(n: usize) -> Vec<ThicknessPoint> {
    if n < 2 {
        return vec![ThicknessPoint { xi: 0.0, weight: 1.0, half: 0.0 }];
    }
    let degree = (n - 1) as f64;
    let point = |i: usize| {
        // The points are the ends and the extrema of P_{n-1}: Newton on (1 − x²) P'_{n-1}.
        let mut x = -(std::f64::consts::PI * i as f64 / degree).cos();
        for _ in 0..100 {
            let (p, below) = legendre(n - 1, x);
            let step = (x * p - below) / (n as f64 * p);
            x -= step;
            if step.abs() < 1e-16 {
                break;
            }
        }
        let (p, _) = legendre(n - 1, x);
        ThicknessPoint { xi: x, weight: 1.0 / (degree * n as f64 * p * p), half: 0.0 }
    };
    (0..n).map(point).collect()
}

/// Middles of `n` equal parts of the thickness, for laws that integrate over a part.
pub fn midpoint(n: usize) -> Vec<ThicknessPoint> {
    let weight = 1.0 / n as f64;
    (0..n).map(|i| ThicknessPoint { xi: (2 * i + 1) as f64 * weight - 1.0, weight, half: weight }).collect()
}

/// P_n(x) and P_{n−1}(x) of n ≥ 1 by the three-term recurrence.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut below, mut p) = (1.0, x);
    for k in 2..=n {
        let k = k as f64;
        (below, p) = (p, ((2.0 * k - 1.0) * x * p - (k - 1.0) * below) / k);
    }
    (p, below)
}
