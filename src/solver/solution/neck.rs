//! Detection of a neck: one place thins alone.

use crate::solver::{state::nonlocal_average::NonlocalAverage, *};

/// Least thickness strain of a neck over the mean of its surroundings \[–\].
const NECK: f64 = 1.6;
/// Largest thinning rate of the surroundings over the neck's once the neck has taken over \[–\].
const STOPPED: f64 = 0.1;
/// Largest thickness of a neck over the initial one \[–\].
const THINNED: f64 = 0.8;
/// Distances of the surroundings from a neck, over the thickness \[–\].
const SURROUNDINGS: [f64; 2] = [3.0, 8.0];
/// Largest distance over the radius of a ball, along which a sound sheet thins unevenly, and the smallest over that \[–\].
const ON_BALL: [f64; 2] = [0.5, 0.5];

/// Thinnest place of the sheet and the thinning around it.
#[derive(Clone, Copy, Debug)]
pub struct Neck {
    /// Initial distance from the axis \[mm\].
    pub s0: f64,
    /// Thickness without ironing over the initial one \[–\].
    pub share: f64,
    /// Thinning rate over the last step, in process time \[1/s\].
    pub rate: f64,
    /// True if it is as much thinner than its surroundings as a neck is: on a ball a sound dome may be so too.
    pub stands_out: bool,
    /// True if it is a neck: besides, its surroundings have stopped thinning.
    pub took_over: bool,
}

/// Smallest and largest distance of the surroundings from a neck \[mm\].
fn surroundings(model: &Model) -> [f64; 2] {
    let t = model.blank.thickness;
    let [near, away] = SURROUNDINGS.map(|times| times * t);
    let corners = model.tool(Role::Punch).into_iter().flat_map(|punch| punch.profile.corners());
    let balls = corners.filter(|arc| arc.at(0.0).x.min(arc.at(1.0).x) < t).map(|arc| ON_BALL[0] * arc.radius);
    let away = balls.fold(away, f64::min);
    [near.min(ON_BALL[1] * away), away]
}

/// Finds the thinnest place by nonlocal section thickness, apart from ironing; `before` is the state one step ago.
pub fn neck(model: &Model, state: &State, before: Option<&State>) -> Neck {
    let share = |state: &State, e: usize| state.thickness[e] / model.blank.unformed_thickness(state.middle(e));
    let section = |state: &State| NonlocalAverage::new(model, state).means(|e| share(state, e));
    let thickness = section(state);
    // What two tools take off a wall is no neck.
    let strains = thickness.iter().zip(&state.ironed).map(|(share, [_, ironed])| share.ln() + ironed);
    let strains: Vec<f64> = strains.collect();
    let n = thickness.len();
    // What gets shorter along the meridian is no groove around it: the edge of a hole thins as it is widened.
    let shortens = |e: usize| state.membrane[e][0] < 0.0;
    let order = |a: &usize, b: &usize| shortens(*a).cmp(&shortens(*b)).then(strains[*a].total_cmp(&strains[*b]));
    let e = (0..n).min_by(order).expect("a blank has elements");
    let mut neck =
        Neck { s0: state.middle(e), share: strains[e].exp(), rate: 0.0, stands_out: false, took_over: false };
    if neck.share > THINNED || shortens(e) {
        return neck;
    }
    let former = before.map(section);
    let rate = |e: usize| {
        before.zip(former.as_ref()).map_or(0.0, |(before, former)| {
            (former[e] / thickness[e]).ln() - (state.ironed[e][1] - before.ironed[e][1])
        })
    };
    let step = before.map_or(f64::INFINITY, |before| model.process_time(before.time, state.time - before.time));
    neck.rate = rate(e) / step;
    // A sheet that does not form, while tools go back, thins by less than the cut-off.
    let rigid = model.settings.cutoff_strain / (Settings::CUTOFF_STEP * model.duration);
    let [least, most] = surroundings(model);
    let (mut sum, mut rates, mut count) = (0.0, 0.0, 0.0);
    for other in 0..n {
        let away = (state.middle(other) - neck.s0).abs();
        // On a coarse mesh the next but one stands for the surroundings.
        if (least..most).contains(&away) || (other.abs_diff(e) == 2 && away >= most) {
            sum += strains[other];
            rates += rate(other).abs();
            count += 1.0;
        }
    }
    neck.stands_out = count > 0.0 && strains[e] < NECK * (sum / count).min(0.0);
    neck.took_over = neck.stands_out && before.is_some() && neck.rate > rigid && rates / count < STOPPED * rate(e);
    neck
}
