//! Split-ring test: a ring cut from the wall of a drawn cup springs open when it is slit.
//!
//! # Opening
//! The wall keeps a hoop moment M per mm of height. The slit ring loses the curvature M/(E′I), I = t³/12, and parts by
//!
//! ```text
//!   δ = 2π r² M/(E′ I)         > 0 opens, to the first order in δ/2πr; measured along the ring
//! ```
//!
//! # E′ and M of a ring of some height
//! A low ring is a bar, E′ = E, a high one a plate, E′ = E/(1 − ν²). Between them the shell equation of a ring of height h
//! holds, D w⁗ + E t w/r² = 0 with free edges, whose mean over the height is Lamb's (1891) for a bent plate:
//!
//! ```text
//!   F = 2 (cosh x − cos x) / (x (sinh x + sin x)),   x = h ⁴√(3 (1 − ν²)) / √(r t)        1 of a low ring, 0 of a high one
//!   E′ = E (1 − ν² F)/(1 − ν²),   M = M_hoop − ν F M_meridional
//! ```
//!
//! # References
//! M. Y. Demeri, M. Lou, M. J. Saran, SAE 2000-01-2657 (not read); H. Lamb, Proc. London Math. Soc. 21 (1891) 70–91 (not read:
//! derived here); shell equation: S. Timoshenko, S. Woinowsky-Krieger, Theory of Plates and Shells, §114.

use super::{moment::moment, part_height};
use crate::material::Elastic;
use crate::model::Geometry;
use crate::solver::solution::{Frame, PointRecord, StageSolution};
use crate::units::{As, Length, NonNegative, Positive};
use std::f64::consts::TAU;

/// Cosine of the largest angle between wall and axis \[–\]: 30°.
const UPRIGHT: f64 = 0.866;
/// Round-off of a ring's height \[–\].
const ROUND_OFF: f64 = 1e-9;
const PLACES: u32 = 100;

/// Ring of the wall of a cup that stands on its bottom.
#[derive(Clone, Copy, Debug, PartialEq, serde::Deserialize, schemars::JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Ring {
    /// Height of its lower edge over the outside of the bottom \[mm\].
    #[serde(with = "As::<NonNegative<Length>>")]
    pub from: f64,
    /// Its height, from edge to edge \[mm\].
    #[serde(with = "As::<Positive<Length>>")]
    pub height: f64,
}

/// Cut ring before slitting: means over its height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CutRing {
    /// Radius of the mid-surface \[mm\].
    pub radius: f64,
    /// Thickness \[mm\].
    pub thickness: f64,
    /// Height \[mm\].
    pub height: f64,
    /// Hoop moment per mm of height, positive with tension outside \[N\].
    pub moment_hoop: f64,
    /// Meridional moment per mm of circumference, positive with tension outside \[N\].
    pub moment_meridional: f64,
}

impl CutRing {
    /// F: share of a bar's curling \[–\], 1 for a low ring, 0 for a high one.
    pub fn curling(&self, poisson: f64) -> f64 {
        let x = self.height * (3.0 * (1.0 - poisson * poisson)).powf(0.25) / (self.radius * self.thickness).sqrt();
        match x {
            // series 1 − x⁴/180; the difference of cosines would be round-off
            x if x < 1e-2 => 1.0,
            // the hyperbolic functions are equal to round-off, and may overflow
            x if x > 40.0 => 2.0 / x,
            x => 2.0 * (x.cosh() - x.cos()) / (x * (x.sinh() + x.sin())),
        }
    }

    /// Opening of the slit ring along its circumference \[mm\]; negative when it closes.
    pub fn opening(&self, elastic: Elastic) -> f64 {
        let Elastic { young, poisson } = elastic;
        let curling = self.curling(poisson);
        let modulus = young * (1.0 - poisson * poisson * curling) / (1.0 - poisson * poisson);
        let moment = self.moment_hoop - poisson * curling * self.moment_meridional;
        TAU * self.radius * self.radius * moment / (modulus * self.thickness.powi(3) / 12.0)
    }
}

impl Ring {
    /// Cuts the ring; `None` where the wall is too low or leans by more than 30°, and without thickness points.
    pub fn cut(self, frame: &Frame) -> Option<CutRing> {
        let (middle, rim) = (frame.nodes.first()?, frame.nodes.last()?);
        // Over the outside of the bottom.
        let over = |z: f64| (middle.z - rim.z).signum() * (middle.z - z) + 0.5 * middle.thickness;
        let layers = &frame.through.layers;
        let mut sums = [0.0; 5];
        let sections = frame.elements.iter().zip(frame.through.elements()).zip(frame.nodes.windows(2));
        for ((element, points), ends) in sections {
            let heights = [over(ends[0].z), over(ends[1].z)];
            let (low, high) = (heights[0].min(heights[1]), heights[0].max(heights[1]));
            let share = (high.min(self.from + self.height) - low.max(self.from)).max(0.0);
            if share == 0.0 {
                continue;
            }
            let (along, across) = (ends[1].z - ends[0].z, ends[1].r - ends[0].r);
            if along.abs() < UPRIGHT * along.hypot(across) {
                return None;
            }
            // layers run towards the punch's face, inside of a wall that goes away from its bottom
            let outward = along.signum();
            let moment = |stress: fn(&PointRecord) -> f64| outward * moment(element.thickness, layers, points, stress);
            let (hoop, meridional) = (moment(|point| point.stress_hoop), moment(|point| point.stress_meridional));
            let values = [1.0, element.r, element.thickness, hoop, meridional];
            sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += share * value);
        }
        let [height, sums @ ..] = sums;
        if layers.is_empty() || (height - self.height).abs() > ROUND_OFF * self.height {
            return None;
        }
        let [radius, thickness, moment_hoop, moment_meridional] = sums.map(|sum| sum / height);
        Some(CutRing { radius, thickness, height, moment_hoop, moment_meridional })
    }

    /// Opening of the ring after a release as the last stage \[mm\]; `None` without release or wall.
    pub fn opening(self, stages: &[StageSolution]) -> Option<f64> {
        let (frame, elastic) = released(stages)?;
        Some(self.cut(frame)?.opening(elastic))
    }

    /// Opening of this ring, and lower edges and openings of this and others all along the wall \[mm\].
    pub fn openings(self, stages: &[StageSolution]) -> Option<(f64, Vec<(f64, f64)>)> {
        let own = self.opening(stages)?;
        let height = part_height(released(stages)?.0)?;
        let others = (0..=PLACES).map(|i| height * f64::from(i) / f64::from(PLACES));
        let along = others.filter_map(|from| Some((from, Self { from, ..self }.opening(stages)?)));
        let mut openings: Vec<(f64, f64)> = along.chain([(self.from, own)]).collect();
        openings.sort_by(|a, b| a.0.total_cmp(&b.0));
        Some((own, openings))
    }
}

fn released(stages: &[StageSolution]) -> Option<(&Frame, Elastic)> {
    let last = stages.last().filter(|stage| stage.model.geometry == Geometry::Axisymmetric)?;
    let [_, frame] = last.released()?;
    Some((frame, last.model.material.elastic?))
}
