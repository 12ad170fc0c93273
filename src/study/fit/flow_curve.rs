//! Reduction of tension tests: elastic line, yield stress, uniform elongation, flow curve.

use super::tension::{EXAMPLE, FlowPoint, rows};
use crate::case::files::{self, Disk, Files};
use crate::numerics::statistics::block_means;
use crate::study::{Result, StudyError, Watch, ensure, fail, measured_curve::OF_FILE, measured_curve::csv_error};
use crate::table::Csv;
use crate::tester;
use crate::units::{Amount, joined, significant};
use std::path::PathBuf;

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
    /// Section of the specimen, for forces \[mm²\].
    pub section: Option<f64>,
    /// Gauge length, for elongations \[mm\].
    pub gauge: Option<f64>,
}

/// Flow curve that laws are fitted to.
#[derive(Clone, Debug, PartialEq)]
pub struct FlowCurve {
    /// Name of the file without its folders.
    pub name: String,
    /// Angle to the rolling direction \[°\].
    pub direction: Option<f64>,
    /// Strain rate \[1/s\].
    pub rate: Option<f64>,
    /// Slope of the elastic line \[MPa\].
    pub young: Option<f64>,
    /// Plastic strain at the largest force; `None` if the force does not fall thereafter \[–\].
    pub uniform: Option<f64>,
    /// Points that laws are fitted to.
    pub points: Vec<FlowPoint>,
    /// r-value, width over thickness strain, and its standard error \[–\].
    pub r: Option<(f64, f64)>,
    /// Results of the test.
    pub sentence: String,
}

/// Stress range of the elastic line over the stress at 1 % strain: between seating and yield \[–\].
const ELASTIC: [f64; 2] = [0.1, 0.4];
const LINE: usize = 4;
/// Most means in the search of the largest force, so that noise of single rows is no peak.
const FORCES: usize = 200;
/// Share of the offset on either side whose rows give the yield stress \[–\].
const AT_YIELD: f64 = 0.1;
/// Resolution of strains in files \[–\].
const ROUNDED: f64 = 1e-9;
/// Poisson's ratio of metals, for the elastic part of the width's strain, a hundredth of the whole \[–\].
const POISSON: f64 = 0.3;
/// The force has fallen when it is below its largest by this share \[–\].
const FALLEN: f64 = 0.002;

impl Default for Reduction {
    fn default() -> Self {
        Self { young: None, offset: 0.002, from: None, to: None, section: None, gauge: None }
    }
}

impl FlowCurve {
    /// Reads and reduces a test from a text.
    pub fn read(text: &str, name: &str, reduction: &Reduction) -> Result<Self> {
        Self::new(&tester::read(text, EXAMPLE).map_err(|error| csv_error(name, error))?, name, reduction)
    }

    fn new(csv: &Csv, name: &str, reduction: &Reduction) -> Result<Self> {
        let (rows, is_plastic) = rows(csv, name, reduction)?;
        let (offset, young) = (reduction.offset, reduction.young);
        let line = if is_plastic { young.map(|young| (young, 0.0)) } else { Some(elastic_line(&rows, name, young)?) };
        let elastic = |row: &FlowPoint| line.map_or(0.0, |(young, _)| row.stress / young);
        let toe = line.map_or(0.0, |(_, toe)| toe);
        // Plastic strain and engineering stress.
        let reduced = |row: &FlowPoint| {
            let plastic = if is_plastic { row.strain } else { row.strain - toe - elastic(row) };
            [plastic, row.stress * (-plastic - elastic(row)).exp()]
        };
        let all: Vec<[f64; 2]> = rows.iter().map(reduced).collect();
        let forces = block_means(&all, FORCES);
        let peak = (0..forces.len()).max_by(|a, b| forces[*a][1].total_cmp(&forces[*b][1])).unwrap_or(0);
        let [at_peak, strength] = forces[peak];
        let uniform = forces.last().filter(|last| last[1] < (1.0 - FALLEN) * strength).map(|_| at_peak);
        let from = reduction.from.unwrap_or(offset) - ROUNDED;
        let to = reduction.to.unwrap_or(f64::INFINITY).min(uniform.unwrap_or(f64::INFINITY)) + ROUNDED;
        let rows_each = all.len().div_ceil(FORCES);
        let end = all.len() - uniform.map_or(0, |_| (forces.len() - 1 - peak) * rows_each);
        let used: Vec<usize> = (0..end).filter(|i| (from..=to).contains(&all[*i][0])).collect();
        let what = format!("{name} has no points with a plastic strain from {:.4} to {to:.4}", from + ROUNDED);
        ensure(!used.is_empty(), what, "see whether --young, --offset, --from and --to go with it")?;
        let is_near = |at: &[f64; 2]| (at[0] - offset).abs() <= AT_YIELD * offset;
        let near: Vec<[f64; 2]> = all[..end].iter().copied().filter(is_near).collect();
        let crossing = all[..end].windows(2).find(|pair| pair[0][0] <= offset + ROUNDED && pair[1][0] >= offset);
        let yield_stress = crossing.map(|pair| {
            let [at_zero, slope, _] = straight_line(if near.len() < LINE { pair.to_vec() } else { near });
            at_zero + slope * offset
        });
        let across = |i: &usize| Some([all[*i][0], rows[*i].width? + POISSON * elastic(&rows[*i])]);
        let r = r_value(used.iter().filter_map(across).collect());
        let points: Vec<FlowPoint> = used.into_iter().map(|i| FlowPoint { strain: all[i][0], ..rows[i] }).collect();
        let source = if reduction.young.is_none() { "slope of the elastic line" } else { "E as given" };
        let young = line.map(|(young, _)| young);
        let cut = uniform.map_or("the force does not fall: no cut".to_owned(), |uniform| {
            let of = if rows_each > 1 { format!(", mean of {rows_each} rows,") } else { String::new() };
            format!("largest force{of} at a plastic strain of {uniform:.3}, {}: cut there", Amount::stress(strength))
        });
        let name = name.rsplit(['/', '\\']).next().unwrap_or_default().to_owned();
        let (count, first) = (points.len(), points[0].strain);
        let mut curve = Self { name, direction: None, rate: None, young, uniform, points, r, sentence: String::new() };
        let parts = [
            young.map(|young| format!("{source} {}", Amount::stress(significant(young, 3)))),
            yield_stress.map(|stress| format!("yield stress {}", Amount::stress(stress))),
            Some(format!("{cut}; {count} points from {first:.4} to {:.3}", curve.end())),
            r.map(|(r, error)| format!("r {r:.3} ± {error:.3}")),
        ];
        curve.sentence = format!("{}: {}.", curve.name, joined(parts.into_iter().flatten(), "; "));
        Ok(curve)
    }

    /// Largest plastic strain that laws are fitted to \[–\].
    pub fn end(&self) -> f64 {
        self.points.iter().map(|point| point.strain).fold(0.0, f64::max)
    }
}

/// Slope \[MPa\] of the elastic line and the strain at which it begins: a given one goes through the middle of its points.
fn elastic_line(rows: &[FlowPoint], name: &str, young: Option<f64>) -> Result<(f64, f64)> {
    let help = "give --young \"210 GPa\"";
    let at = rows.iter().find(|row| row.strain >= 0.01).or(rows.last()).map_or(0.0, |row| row.stress);
    let is_elastic = |row: &&FlowPoint| (ELASTIC[0] * at..=ELASTIC[1] * at).contains(&row.stress);
    let before = rows.iter().take_while(|row| row.strain < 0.01).filter(is_elastic);
    let points: Vec<[f64; 2]> = before.map(|row| [row.stress, row.strain]).collect();
    let count = points.len();
    if let Some(young) = young {
        let toe = points.iter().map(|[stress, strain]| strain - stress / young).sum::<f64>() / count as f64;
        return Ok((young, if count < LINE { 0.0 } else { toe }));
    }
    ensure(count >= LINE, format!("{name} has {count} points on its elastic line, too few for its slope"), help)?;
    match straight_line(points) {
        [toe, compliance, _] if compliance > 0.0 => Ok((1.0 / compliance, toe)),
        _ => fail(format!("{name} begins without an elastic line"), help),
    }
}

/// r from plastic strains along and across: −m/(1 + m) with their slope m.
fn r_value(points: Vec<[f64; 2]>) -> Option<(f64, f64)> {
    let [_, slope, error] = Some(points).filter(|points| points.len() >= LINE).map(straight_line)?;
    (-1.0 < slope && slope < 0.0).then(|| (-slope / (1.0 + slope), error / (1.0 + slope).powi(2)))
}

/// Reads and reduces tests, maybe with a strain rate \[1/s\] and an angle to the rolling direction \[°\] of each.
pub fn flow_curves(
    tests: &[PathBuf], reduction: &Reduction, rates: &[f64], directions: &[f64], watch: &dyn Watch,
) -> Result<Vec<FlowCurve>> {
    for (option, own) in [("--rate", rates.len()), ("--direction", directions.len())] {
        let what = format!("{option} has {own} values for {} tests", tests.len());
        ensure(own == 0 || own == tests.len(), what, "give one each")?;
    }
    for rate in rates {
        ensure(*rate > 0.0 && rate.is_finite(), format!("a strain rate of {rate} /s"), "it must be above 0")?;
    }
    let mut curves: Vec<FlowCurve> = Vec::new();
    for (i, path) in tests.iter().enumerate() {
        ensure(!watch.wants_to_stop(), "interrupted", "begin again")?;
        let name = path.display().to_string();
        let bytes = Disk.read(path, files::CSV).map_err(|error| StudyError::unreadable(path, &error, OF_FILE))?;
        let csv = tester::read(&tester::text(bytes), EXAMPLE).map_err(|error| csv_error(&name, error))?;
        let (rate, direction) = (rates.get(i).copied(), directions.get(i).copied());
        let curve = FlowCurve { rate, direction, ..FlowCurve::new(&csv, &path.to_string_lossy(), reduction)? };
        // Equal numbers are no second measurement, and would make every interval narrower.
        let same = |other: &FlowCurve| (rate, direction, &curve.points) == (other.rate, other.direction, &other.points);
        if let Some(twin) = curves.iter().position(same) {
            let what = format!("{} and {} are one test", tests[twin].display(), path.display());
            return fail(what, "give every test once");
        }
        curves.push(curve);
    }
    Ok(curves)
}

pub(super) fn straight_line(points: Vec<[f64; 2]>) -> [f64; 3] {
    let n = points.len() as f64;
    let [x, y] = [points.iter().map(|p| p[0]).sum::<f64>() / n, points.iter().map(|p| p[1]).sum::<f64>() / n];
    let xx: f64 = points.iter().map(|p| (p[0] - x).powi(2)).sum();
    let xy: f64 = points.iter().map(|p| (p[0] - x) * (p[1] - y)).sum();
    let slope = if xx > 0.0 { xy / xx } else { 0.0 };
    let rest: f64 = points.iter().map(|p| (p[1] - y - slope * (p[0] - x)).powi(2)).sum();
    [y - slope * x, slope, (rest / (n - 2.0).max(1.0) / xx).sqrt()]
}
