//! Detection of a neck: one place thins alone.

use crate::model::{Model, Settings};
use crate::solver::state::State;
use crate::solver::state::nonlocal_average::NonlocalAverage;

/// Least thickness strain of a neck over the mean of its surroundings \[–\].
const NECK: f64 = 1.6;
/// Largest thinning rate of the surroundings over the neck's once the neck has taken over \[–\].
const STOPPED: f64 = 0.1;
/// Largest thickness of a neck over the initial one \[–\].
const THINNED: f64 = 0.8;
/// Distances of the surroundings from a neck, over the thickness \[–\].
pub(crate) const NEAR: f64 = 3.0;
pub(crate) const AWAY: f64 = 8.0;

/// Thinnest place of the sheet and the thinning around it.
#[derive(Clone, Copy, Debug)]
pub struct Neck {
    /// Initial distance from the axis \[mm\].
    pub s0: f64,
    /// Thickness without ironing over the initial one \[–\].
    pub share: f64,
    /// True if it is a neck.
    pub stands_out: bool,
    /// True if its surroundings have stopped thinning.
    pub took_over: bool,
}

/// Finds the thinnest place by nonlocal section thickness, apart from ironing; `before` is the state one step ago.
pub fn neck(model: &Model, state: &State, before: Option<&State>) -> Neck {
    let t0 = model.blank.thickness;
    let section = |state: &State| NonlocalAverage::new(model, state).section_thickness(&state.thickness);
    let thickness = section(state);
    // What two tools take off a wall is no neck.
    let strains = thickness.iter().zip(&state.ironed).map(|(thickness, ironed)| (thickness / t0).ln() + ironed);
    let strains: Vec<f64> = strains.collect();
    let n = thickness.len();
    let thinnest = (0..n).min_by(|&a, &b| strains[a].total_cmp(&strains[b]));
    let e = thinnest.expect("a blank has elements");
    let mut neck = Neck { s0: state.middle(e), share: strains[e].exp(), stands_out: false, took_over: false };
    if neck.share > THINNED {
        return neck;
    }
    let former = before.map(section);
    let rate = |e: usize| {
        let then = before.zip(former.as_ref());
        then.map_or(0.0, |(before, former)| (former[e] / thickness[e]).ln() - (state.ironed[e] - before.ironed[e]))
    };
    // A sheet that does not form, while tools go back, thins by less than the cut-off.
    let rigid = before.map_or(0.0, |before| {
        let step = model.process_time(before.time, state.time - before.time);
        model.settings.cutoff_strain * step / (Settings::CUTOFF_STEP * model.duration)
    });
    let (mut sum, mut rates, mut count) = (0.0, 0.0, 0.0);
    for other in 0..n {
        let away = (state.middle(other) - neck.s0).abs();
        // On a coarse mesh the next but one stands for the surroundings.
        let near = (NEAR * t0..AWAY * t0).contains(&away) || (other.abs_diff(e) == 2 && away >= AWAY * t0);
        if near {
            sum += strains[other];
            rates += rate(other).abs();
            count += 1.0;
        }
    }
    neck.stands_out = count > 0.0 && strains[e] < NECK * (sum / count).min(0.0);
    neck.took_over = neck.stands_out && before.is_some() && rate(e) > rigid && rates / count < STOPPED * rate(e);
    neck
}
