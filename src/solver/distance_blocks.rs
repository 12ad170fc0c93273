//! Distance blocks between holder and die.

use crate::geometry::{Point, Profile};
use crate::model::{Model, Role};

/// Least distance of holder and die over the sheet thickness \[–\].
const APART: f64 = 0.5;
/// Most rises of the search, and the last one over the wanted distance \[–\].
const RISES: usize = 200;
const LAST_RISE: f64 = 1e-6;

/// Move of a model's holder at which it stands on its blocks, from where it touches the flat sheet and relative to the die
/// \[mm\]; `None` without a holder.
pub(super) fn block_height(model: &Model) -> Option<f64> {
    let (holder, apart) = (model.tool(Role::Holder)?, APART * model.blank.thickness);
    let on_die = model.tool(Role::Die).map(|die| travel_until(&holder.profile, &die.profile, apart));
    Some(on_die.unwrap_or(model.blank.thickness - apart))
}

/// Move of a holder at which its closest place is so far from the die \[mm\].
pub(super) fn travel_until(holder: &Profile, die: &Profile, apart: f64) -> f64 {
    let heights = |profile: &Profile| {
        let points = profile.polyline(0.01);
        let low = points.iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
        (low, points.iter().map(|p| p.y).fold(f64::NEG_INFINITY, f64::max))
    };
    let ((_, top), (face, end)) = (heights(holder), heights(die));
    // Distances change no faster than the holder moves.
    let mut moved = face - top - apart;
    for _ in 0..RISES {
        let spare = holder.distance_to(die, Point::new(0.0, moved)).0 - apart;
        if spare < LAST_RISE * apart || moved > end - top {
            break;
        }
        moved += spare;
    }
    moved
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Arc, Piece};
    use approx::assert_relative_eq;

    /// Trust: the centres of two rounds half a thickness apart are their radii and that half apart, here 5.8 of it across.
    /// Measured at points 0.02 rad apart: within 6 × 0.02²/8 mm.
    #[test]
    fn a_sleeve_that_meets_the_shoulder_alone_comes_further() {
        let (nose, shoulder, across, throat, top) = (6.0, 6.8, 5.8, 31.5, -0.5);
        let line = |from: [f64; 2], to: [f64; 2]| Piece::line(from.into(), to.into());
        let flat = throat + shoulder - across;
        let center = Point::new(flat, top - nose);
        let sleeve = vec![
            line([throat, -100.0], [throat, top]),
            line([throat, top], [flat, top]),
            Piece::Arc(Arc::between(center + Point::new(0.0, nose), center + Point::new(nose, 0.0), center, false).0),
            line([flat + nose, top - nose], [flat + nose, -100.0]),
        ];
        let centers = (nose + shoulder + 0.5_f64).powi(2) - across * across;
        let sleeve = Profile::new(sleeve).expect("a chain");
        let rise = travel_until(&sleeve, &Profile::die(throat, shoulder, 1.0), 0.5);
        assert_relative_eq!(rise, nose + shoulder + 1.0 - centers.sqrt(), epsilon = 1e-3);
    }
}
