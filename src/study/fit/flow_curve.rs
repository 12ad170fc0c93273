//! Reduction of a tension test: elastic line, yield stress, uniform elongation, flow curve.

use super::tension::{Tension, TensionRow};
use crate::study::StudyError;

/// How tests are reduced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reduction {
    /// Young's modulus; `None` to take the slope at the beginning \[MPa\].
    pub young: Option<f64>,
    /// Plastic strain at which the sheet is said to yield \[–\].
    pub offset: f64,
    /// Plastic strains that laws are fitted to; from the offset to uniform elongation where not given \[–\].
    pub from: Option<f64>,
    /// See `from` \[–\].
    pub to: Option<f64>,
}

/// A test as laws are fitted to it.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowCurve {
    /// Name of the file.
    pub name: String,
    /// To the rolling direction \[°\].
    pub direction: Option<f64>,
    /// Strain rate \[1/s\].
    pub rate: Option<f64>,
    /// Slope of the elastic line \[MPa\].
    pub young: Option<f64>,
    /// Whether that slope was fitted.
    pub is_fitted: bool,
    /// Engineering stress at the offset \[MPa\]; `None` where the test begins beyond.
    pub yield_stress: Option<f64>,
    /// Largest engineering stress \[MPa\].
    pub strength: f64,
    /// Plastic strain at the largest force, where the force falls thereafter \[–\].
    pub uniform: Option<f64>,
    /// Points that laws are fitted to.
    pub points: Vec<FlowPoint>,
    /// Points beyond or before, drawn only.
    pub others: Vec<FlowPoint>,
    /// r, width over thickness strain, and its standard error, where the width was measured \[–\].
    pub r: Option<(f64, f64)>,
}

/// A point of a flow curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlowPoint {
    /// True plastic strain \[–\].
    pub strain: f64,
    /// True stress \[MPa\].
    pub stress: f64,
    /// Its standard deviation, where known \[MPa\].
    pub scatter: Option<f64>,
}

/// Stress range of the elastic line over the stress at 1 % strain: between seating and yield \[–\].
const ELASTIC: [f64; 2] = [0.1, 0.4];
/// Fewest points of an elastic line.
const LINE: usize = 4;
/// Digits that files round strains to \[–\].
const ROUNDED: f64 = 1e-9;
/// Poisson's ratio of metals: of the elastic part of the width's strain, which is a hundredth of the whole \[–\].
const POISSON: f64 = 0.3;
/// The force has fallen when it is below its largest by this share \[–\].
const FALLEN: f64 = 0.002;

impl Default for Reduction {
    fn default() -> Self {
        Self { young: None, offset: 0.002, from: None, to: None }
    }
}

impl FlowCurve {
    /// Whether another file says the same of the same specimen.
    pub(super) fn is_again(&self, other: &Self) -> bool {
        let is_alike = self.direction == other.direction && self.rate == other.rate;
        is_alike && self.points == other.points && self.others == other.others
    }

    /// Reduces a test.
    ///
    /// # Errors
    /// When there is no elastic line and none is given, or nothing lies between yield and uniform elongation.
    pub fn of(test: &Tension, reduction: &Reduction) -> Result<Self, StudyError> {
        let line = match (reduction.young, test.is_plastic) {
            (Some(young), true) => Some((young, 0.0)),
            (None, true) => None,
            (young, false) => Some(elastic_line(test, young)?),
        };
        let elastic = |stress: f64| line.map_or(0.0, |(young, _)| stress / young);
        let toe = line.map_or(0.0, |(_, toe)| toe);
        let plastic =
            |row: &TensionRow| if test.is_plastic { row.strain } else { row.strain - toe - elastic(row.stress) };
        let engineering = |row: &TensionRow| {
            let total = if test.is_plastic { row.strain + elastic(row.stress) } else { row.strain - toe };
            row.stress * (-total).exp()
        };
        let rows = &test.rows;
        let peak =
            (0..rows.len()).max_by(|a, b| engineering(&rows[*a]).total_cmp(&engineering(&rows[*b]))).unwrap_or(0);
        let strength = engineering(&rows[peak]);
        let necks = rows[peak..].iter().any(|row| engineering(row) < (1.0 - FALLEN) * strength);
        let uniform = necks.then(|| plastic(&rows[peak]));
        let from = reduction.from.unwrap_or(reduction.offset) - ROUNDED;
        let to = reduction.to.unwrap_or(f64::INFINITY).min(uniform.unwrap_or(f64::INFINITY)) + ROUNDED;
        let point = |row: &TensionRow| FlowPoint { strain: plastic(row), stress: row.stress, scatter: row.scatter };
        let is_used = |i: usize| (from..=to).contains(&plastic(&rows[i])) && (i <= peak || !necks);
        let used: Vec<usize> = (0..rows.len()).filter(|&i| is_used(i)).collect();
        let others = (0..rows.len()).filter(|&i| !is_used(i) && plastic(&rows[i]) > 0.0);
        let Some(&last) = used.last() else {
            let what =
                format!("{} has no points with a plastic strain from {:.4} to {:.4}", test.name, from + ROUNDED, to);
            return Err(StudyError::new(what, "see whether --young, --offset, --from and --to go with it"));
        };
        let crossing =
            (1..=last).find(|&i| plastic(&rows[i - 1]) < reduction.offset && plastic(&rows[i]) >= reduction.offset);
        let yield_stress = match crossing {
            Some(i) => {
                let (a, b) = (plastic(&rows[i - 1]), plastic(&rows[i]));
                let [low, high] = [i - 1, i].map(|i| engineering(&rows[i]));
                Some(low + (high - low) * (reduction.offset - a) / (b - a))
            }
            None => (plastic(&rows[0]) - reduction.offset).abs().le(&ROUNDED).then(|| engineering(&rows[0])),
        };
        Ok(Self {
            name: test.name.clone(),
            direction: None,
            rate: None,
            young: line.map(|(young, _)| young),
            is_fitted: reduction.young.is_none(),
            yield_stress,
            strength,
            uniform,
            points: used.iter().map(|&i| point(&rows[i])).collect(),
            others: others.map(|i| point(&rows[i])).collect(),
            r: r_value(
                used.iter()
                    .filter_map(|&i| Some((plastic(&rows[i]), rows[i].width? + POISSON * elastic(rows[i].stress))))
                    .collect(),
            ),
        })
    }

    /// Name of the file without its folders.
    pub fn short_name(&self) -> &str {
        self.name.rsplit(['/', '\\']).next().unwrap_or_default()
    }

    /// Largest plastic strain of what laws are fitted to \[–\].
    pub fn end(&self) -> f64 {
        self.points.iter().map(|point| point.strain).fold(0.0, f64::max)
    }
}

/// Slope \[MPa\] of the elastic line and the strain at which it begins: a given one goes through the middle of its points.
fn elastic_line(test: &Tension, young: Option<f64>) -> Result<(f64, f64), StudyError> {
    let help = "give --young \"210 GPa\"";
    let beyond = test.rows.iter().find(|row| row.strain >= 0.01).or(test.rows.last());
    let at = beyond.map_or(0.0, |row| row.stress);
    let range = ELASTIC[0] * at..=ELASTIC[1] * at;
    let before = test.rows.iter().take_while(|row| row.strain < 0.01);
    let points: Vec<(f64, f64)> =
        before.filter(|row| range.contains(&row.stress)).map(|row| (row.stress, row.strain)).collect();
    match (young, points.len()) {
        (Some(young), 0..LINE) => Ok((young, 0.0)),
        (None, count @ 0..LINE) => {
            let what = format!("{} has {count} points on its elastic line, too few for its slope", test.name);
            Err(StudyError::new(what, help))
        }
        (Some(young), _) => {
            let toe = points.iter().map(|(stress, strain)| strain - stress / young).sum::<f64>() / points.len() as f64;
            Ok((young, toe))
        }
        (None, _) => {
            let [toe, compliance, _] = straight(&points);
            if compliance <= 0.0 || compliance.is_nan() {
                return Err(StudyError::new(format!("{} begins without an elastic line", test.name), help));
            }
            Ok((1.0 / compliance, toe))
        }
    }
}

/// r from plastic strains along and across: −m/(1 + m) with their slope m.
fn r_value(points: Vec<(f64, f64)>) -> Option<(f64, f64)> {
    if points.len() < LINE {
        return None;
    }
    let [_, slope, error] = straight(&points);
    (-1.0 < slope && slope < 0.0).then(|| (-slope / (1.0 + slope), error / ((1.0 + slope) * (1.0 + slope))))
}

/// Intercept, slope and standard error of the slope of a straight line through points.
fn straight(points: &[(f64, f64)]) -> [f64; 3] {
    let n = points.len() as f64;
    let [x, y] = [points.iter().map(|p| p.0).sum::<f64>() / n, points.iter().map(|p| p.1).sum::<f64>() / n];
    let xx: f64 = points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum();
    let xy: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let slope = xy / xx;
    let rest: f64 = points.iter().map(|p| (p.1 - y - slope * (p.0 - x)).powi(2)).sum();
    [y - slope * x, slope, (rest / (n - 2.0).max(1.0) / xx).sqrt()]
}
