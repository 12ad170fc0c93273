//! Reduction of a tension test: elastic line, yield stress, uniform elongation, flow curve.

use super::tension::{Tension, TensionRow};
use crate::study::{StudyError, fail};
use crate::units::{Amount, significant};

/// Settings of the reduction of tests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reduction {
    /// Young's modulus; `None` for the slope at the beginning \[MPa\].
    pub young: Option<f64>,
    /// Plastic strain at yield \[–\].
    pub offset: f64,
    /// First plastic strain that laws are fitted to; the offset by default \[–\].
    pub from: Option<f64>,
    /// Last plastic strain that laws are fitted to; uniform elongation by default \[–\].
    pub to: Option<f64>,
}

/// Flow curve that laws are fitted to.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowCurve {
    /// Name of the file.
    pub name: String,
    /// Angle to the rolling direction \[°\].
    pub direction: Option<f64>,
    /// Strain rate \[1/s\].
    pub rate: Option<f64>,
    /// Slope of the elastic line \[MPa\].
    pub young: Option<f64>,
    /// Whether that slope was fitted.
    pub is_fitted: bool,
    /// Engineering stress at the offset; `None` if the test begins beyond \[MPa\].
    pub yield_stress: Option<f64>,
    /// Largest engineering stress \[MPa\].
    pub strength: f64,
    /// Plastic strain at the largest force; `None` if the force does not fall thereafter \[–\].
    pub uniform: Option<f64>,
    /// Points that laws are fitted to.
    pub points: Vec<FlowPoint>,
    /// Plastic points before and beyond them.
    pub others: Vec<FlowPoint>,
    /// r-value, width over thickness strain, and its standard error \[–\].
    pub r: Option<(f64, f64)>,
}

/// A point of a flow curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlowPoint {
    /// True plastic strain \[–\].
    pub strain: f64,
    /// True stress \[MPa\].
    pub stress: f64,
    /// Standard deviation of the stress \[MPa\].
    pub scatter: Option<f64>,
}

/// Stress range of the elastic line over the stress at 1 % strain: between seating and yield \[–\].
const ELASTIC: [f64; 2] = [0.1, 0.4];
/// Fewest points of an elastic line.
const LINE: usize = 4;
/// Resolution of strains in files \[–\].
const ROUNDED: f64 = 1e-9;
/// Poisson's ratio of metals, for the elastic part of the width's strain, a hundredth of the whole \[–\].
const POISSON: f64 = 0.3;
/// The force has fallen when it is below its largest by this share \[–\].
const FALLEN: f64 = 0.002;

impl Default for Reduction {
    fn default() -> Self {
        Self { young: None, offset: 0.002, from: None, to: None }
    }
}

impl FlowCurve {
    /// Reduces a test.
    pub fn of(test: &Tension, reduction: &Reduction) -> Result<Self, StudyError> {
        let line = match (reduction.young, test.is_plastic) {
            (young, true) => young.map(|young| (young, 0.0)),
            (young, false) => Some(elastic_line(test, young)?),
        };
        let (offset, toe) = (reduction.offset, line.map_or(0.0, |(_, toe)| toe));
        let elastic = |row: &TensionRow| line.map_or(0.0, |(young, _)| row.stress / young);
        let sum = |row: &TensionRow| if test.is_plastic { row.strain + elastic(row) } else { row.strain - toe };
        let rows = &test.rows;
        let plastic = |i: usize| if test.is_plastic { rows[i].strain } else { sum(&rows[i]) - elastic(&rows[i]) };
        let engineering = |i: usize| rows[i].stress * (-sum(&rows[i])).exp();
        let peak = (0..rows.len()).max_by(|a, b| engineering(*a).total_cmp(&engineering(*b))).unwrap_or(0);
        let strength = engineering(peak);
        let necks = (peak..rows.len()).any(|i| engineering(i) < (1.0 - FALLEN) * strength);
        let uniform = necks.then(|| plastic(peak));
        let from = reduction.from.unwrap_or(offset) - ROUNDED;
        let to = reduction.to.unwrap_or(f64::INFINITY).min(uniform.unwrap_or(f64::INFINITY)) + ROUNDED;
        let is_used = |i: &usize| (from..=to).contains(&plastic(*i)) && (*i <= peak || !necks);
        let (used, others): (Vec<usize>, Vec<usize>) = (0..rows.len()).partition(is_used);
        let Some(&last) = used.last() else {
            let range = format!("from {:.4} to {to:.4}", from + ROUNDED);
            let what = format!("{} has no points with a plastic strain {range}", test.name);
            return fail(what, "see whether --young, --offset, --from and --to go with it");
        };
        let yield_stress = match (1..=last).find(|&i| plastic(i - 1) < offset && plastic(i) >= offset) {
            Some(i) => {
                let share = (offset - plastic(i - 1)) / (plastic(i) - plastic(i - 1));
                Some(engineering(i - 1) + (engineering(i) - engineering(i - 1)) * share)
            }
            None => ((plastic(0) - offset).abs() <= ROUNDED).then(|| engineering(0)),
        };
        let across = |i: &usize| Some((plastic(*i), rows[*i].width? + POISSON * elastic(&rows[*i])));
        let r = r_value(used.iter().filter_map(across).collect());
        let point = |i: usize| FlowPoint { strain: plastic(i), stress: rows[i].stress, scatter: rows[i].scatter };
        Ok(Self {
            name: test.name.clone(),
            direction: None,
            rate: None,
            young: line.map(|(young, _)| young),
            is_fitted: reduction.young.is_none(),
            yield_stress,
            strength,
            uniform,
            points: used.into_iter().map(point).collect(),
            others: others.into_iter().map(point).filter(|point| point.strain > 0.0).collect(),
            r,
        })
    }

    /// Name of the file without its folders.
    pub fn short_name(&self) -> &str {
        self.name.rsplit(['/', '\\']).next().unwrap_or_default()
    }

    /// Largest plastic strain that laws are fitted to \[–\].
    pub fn end(&self) -> f64 {
        self.points.iter().map(|point| point.strain).fold(0.0, f64::max)
    }

    pub(super) fn is_again(&self, other: &Self) -> bool {
        let is_alike = self.direction == other.direction && self.rate == other.rate;
        is_alike && self.points == other.points && self.others == other.others
    }

    /// Results of the test in one sentence.
    pub fn sentence(&self) -> String {
        let source = if self.is_fitted { "slope of the elastic line" } else { "E as given" };
        let mut parts = Vec::new();
        parts.extend(self.young.map(|young| format!("{source} {}", Amount::stress(significant(young, 3)))));
        parts.extend(self.yield_stress.map(|stress| format!("yield stress {}", Amount::stress(stress))));
        let strength = Amount::stress(self.strength);
        parts.push(self.uniform.map_or("the force does not fall: no cut".to_owned(), |uniform| {
            format!("largest force at a plastic strain of {uniform:.3}, {strength}: cut there")
        }));
        let first = self.points.first().map_or(0.0, |p| p.strain);
        parts.push(format!("{} points from {first:.4} to {:.3}", self.points.len(), self.end()));
        parts.extend(self.r.map(|(r, error)| format!("r {r:.3} ± {error:.3}")));
        format!("{}: {}.", self.short_name(), parts.join("; "))
    }
}

/// Slope \[MPa\] of the elastic line and the strain at which it begins: a given one goes through the middle of its points.
fn elastic_line(test: &Tension, young: Option<f64>) -> Result<(f64, f64), StudyError> {
    let help = "give --young \"210 GPa\"";
    let at = test.rows.iter().find(|row| row.strain >= 0.01).or(test.rows.last()).map_or(0.0, |row| row.stress);
    let is_elastic = |row: &&TensionRow| (ELASTIC[0] * at..=ELASTIC[1] * at).contains(&row.stress);
    let before = test.rows.iter().take_while(|row| row.strain < 0.01).filter(is_elastic);
    let points: Vec<(f64, f64)> = before.map(|row| (row.stress, row.strain)).collect();
    let count = points.len();
    match young {
        Some(young) if count < LINE => Ok((young, 0.0)),
        Some(young) => Ok((young, points.iter().map(|(s, e)| e - s / young).sum::<f64>() / count as f64)),
        None if count < LINE => {
            fail(format!("{} has {count} points on its elastic line, too few for its slope", test.name), help)
        }
        None => match straight_line(points) {
            [toe, compliance, _] if compliance > 0.0 => Ok((1.0 / compliance, toe)),
            _ => fail(format!("{} begins without an elastic line", test.name), help),
        },
    }
}

/// r from plastic strains along and across: −m/(1 + m) with their slope m.
fn r_value(points: Vec<(f64, f64)>) -> Option<(f64, f64)> {
    if points.len() < LINE {
        return None;
    }
    let [_, slope, error] = straight_line(points);
    (-1.0 < slope && slope < 0.0).then(|| (-slope / (1.0 + slope), error / (1.0 + slope).powi(2)))
}

/// Intercept, slope and standard error of the slope of the regression through points.
pub(super) fn straight_line(points: Vec<(f64, f64)>) -> [f64; 3] {
    let n = points.len() as f64;
    let [x, y] = [points.iter().map(|p| p.0).sum::<f64>() / n, points.iter().map(|p| p.1).sum::<f64>() / n];
    let xx: f64 = points.iter().map(|p| (p.0 - x).powi(2)).sum();
    let xy: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let slope = if xx > 0.0 { xy / xx } else { 0.0 };
    let rest: f64 = points.iter().map(|p| (p.1 - y - slope * (p.0 - x)).powi(2)).sum();
    [y - slope * x, slope, (rest / (n - 2.0).max(1.0) / xx).sqrt()]
}
