//! Laws beside each other: which to use and why, and what directions of the sheet differ by.

use super::flow_curve::FlowCurve;
use super::kind::Kind;
use super::law_fit::{LawFit, RateKind};
use crate::material::hardening::Hardening;
use crate::study::StudyError;

/// Laws that were fitted to tests.
#[derive(Clone, Debug, PartialEq)]
pub struct LawFits {
    /// All tests.
    pub tests: Vec<FlowCurve>,
    /// Each law.
    pub fits: Vec<LawFit>,
    /// The one to use.
    pub best: usize,
    /// What each direction differs by; empty where none is given.
    pub directions: Vec<Direction>,
}

/// A direction of the sheet: means of its tests.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Direction {
    /// To the rolling direction \[°\].
    pub angle: f64,
    /// Tests in it.
    pub tests: usize,
    /// Stress over that of the law, which is of the first direction, mean over the points \[–\].
    pub ratio: f64,
    /// r \[–\].
    pub r: Option<f64>,
    /// Standard error of r \[–\].
    pub r_error: Option<f64>,
}

/// A law with fewer numbers is taken where its criterion is larger by no more.
pub(super) const AS_GOOD: f64 = 2.0;

/// Fits laws to tests: all, or the one that is wanted. Tests in the first direction, 0° where there is one, are fitted to;
/// the others are held against them.
///
/// # Errors
/// When there is no test, or no law can be fitted.
pub fn fit_laws(tests: Vec<FlowCurve>, wanted: Option<Kind>, rate_kind: RateKind) -> Result<LawFits, StudyError> {
    let kinds = match wanted {
        None => Kind::ALL.to_vec(),
        // What it is mixed of stands with it.
        Some(Kind::Mixed(_)) => vec![Kind::Swift, Kind::Voce, Kind::Mixed(None)],
        Some(kind) => vec![kind],
    };
    let angles: Vec<f64> = tests.iter().filter_map(|test| test.direction).collect();
    let first = angles.iter().copied().find(|angle| *angle == 0.0).or(angles.first().copied());
    let fitted: Vec<&FlowCurve> = tests.iter().filter(|test| test.direction == first).collect();
    let of = |kind: Kind| match kind {
        Kind::Mixed(_) => {
            let [swift, voce] = [Kind::Swift, Kind::Voce].map(|kind| LawFit::of(kind, &fitted, rate_kind));
            match (swift?.hardening, voce?.hardening) {
                (Hardening::Swift(swift), Hardening::Voce(voce)) => {
                    LawFit::of(Kind::Mixed(Some((swift, voce))), &fitted, rate_kind)
                }
                _ => Err(StudyError::new("no mixed law", "try another --law")),
            }
        }
        kind => LawFit::of(kind, &fitted, rate_kind),
    };
    let mut fits = Vec::new();
    let mut wrong = None;
    for kind in kinds {
        match of(kind) {
            Ok(fit) => fits.push(fit),
            Err(error) => wrong = wrong.or(Some(error)),
        }
    }
    if fits.is_empty() {
        return Err(wrong.unwrap_or_else(|| StudyError::new("no law is asked for", "name one by --law")));
    }
    let best = if wanted.is_some() { fits.len() - 1 } else { best(&fits) };
    let mut order: Vec<f64> = angles;
    order.sort_by(f64::total_cmp);
    order.dedup();
    let directions = order.into_iter().map(|angle| direction(angle, &tests, &fits[best])).collect();
    Ok(LawFits { tests, fits, best, directions })
}

/// The least criterion of laws whose numbers lie within their ranges, or the fewest numbers among those that are as good.
fn best(fits: &[LawFit]) -> usize {
    let sound: Vec<usize> = (0..fits.len()).filter(|&i| !fits[i].is_pushed()).collect();
    let sound = if sound.is_empty() { (0..fits.len()).collect() } else { sound };
    let least = sound.iter().map(|&i| fits[i].aic).fold(f64::INFINITY, f64::min);
    let good = sound.into_iter().filter(|&i| fits[i].aic <= least + AS_GOOD);
    good.min_by(|&a, &b| (fits[a].kind.count()).cmp(&fits[b].kind.count()).then(fits[a].aic.total_cmp(&fits[b].aic)))
        .unwrap_or(0)
}

fn direction(angle: f64, tests: &[FlowCurve], law: &LawFit) -> Direction {
    let own: Vec<&FlowCurve> = tests.iter().filter(|test| test.direction == Some(angle)).collect();
    let ratios: Vec<f64> = own
        .iter()
        .flat_map(|test| test.points.iter().map(|point| point.stress / law.band(point.strain, test.rate).0))
        .collect();
    let r: Vec<(f64, f64)> = own.iter().filter_map(|test| test.r).collect();
    let count = r.len() as f64;
    Direction {
        angle,
        tests: own.len(),
        ratio: ratios.iter().sum::<f64>() / ratios.len() as f64,
        r: (!r.is_empty()).then(|| r.iter().map(|r| r.0).sum::<f64>() / count),
        r_error: (!r.is_empty()).then(|| r.iter().map(|r| r.1 * r.1).sum::<f64>().sqrt() / count),
    }
}

impl LawFits {
    /// The law to use.
    pub fn best(&self) -> &LawFit {
        &self.fits[self.best]
    }

    /// The tests that laws are fitted to.
    pub fn fitted(&self) -> impl Iterator<Item = &FlowCurve> {
        let first = self.directions.iter().find(|d| d.angle == 0.0).map(|d| d.angle);
        let first = first.or(self.tests.iter().find_map(|test| test.direction));
        self.tests.iter().filter(move |test| test.direction == first)
    }

    /// Largest plastic strain that laws are fitted to \[–\].
    pub fn end(&self) -> f64 {
        self.fitted().map(FlowCurve::end).fold(0.0, f64::max)
    }

    /// r at 0°, 45° and 90°, where all three were measured.
    pub fn r_values(&self) -> Option<[f64; 3]> {
        let at = |angle: f64| self.directions.iter().find(|d| d.angle == angle)?.r;
        Some([at(0.0)?, at(45.0)?, at(90.0)?])
    }
}
