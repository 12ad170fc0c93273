//! The distance blocks that a holder comes to rest on where it has lost the sheet.

use crate::geometry::{Point, Profile};
use crate::model::{Model, Role};

/// Distance over the sheet thickness at which the blocks keep holder and die apart \[–\].
const APART: f64 = 0.5;
/// Rises of the search, and the one that ends it, over the distance that is looked for \[–\].
const RISES: usize = 200;
const LAST_RISE: f64 = 1e-6;

/// As [`height`], of a model's holder; `None` without one.
pub(super) fn of_holder(model: &Model) -> Option<f64> {
    let (holder, thickness) = (model.tool(Role::Holder)?, model.blank.thickness);
    let flat = (1.0 - APART) * thickness;
    Some(model.tool(Role::Die).map_or(flat, |die| height(&holder.profile, &die.profile, thickness)))
}

/// Move of a holder, from where it touches the flat sheet and relative to the die, at which it stands on its blocks \[mm\]:
/// where the two, at their closest place, are half a thickness apart.
///
/// A holder whose face lies under the die's flat stands there with its face half a thickness off the die's. One that faces
/// the die on a cone or at its shoulder alone comes further, and one that fits into the throat up to the die's other end.
pub(super) fn height(holder: &Profile, die: &Profile, thickness: f64) -> f64 {
    rise(holder, die, APART * thickness)
}

/// Move of a holder, from where it touches the flat sheet and relative to the die, at which the two are this far apart at
/// their closest place \[mm\].
pub(super) fn rise(holder: &Profile, die: &Profile, apart: f64) -> f64 {
    let heights = |profile: &Profile| {
        let points = profile.polyline(0.01);
        let low = points.iter().map(|p| p.y).fold(f64::INFINITY, f64::min);
        (low, points.iter().map(|p| p.y).fold(f64::NEG_INFINITY, f64::max))
    };
    let ((_, top), (face, end)) = (heights(holder), heights(die));
    // It may rise by what the two are too far apart: no place of them comes closer than by the rise.
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
    use crate::geometry::{Arc, Piece, Segment};
    use approx::assert_relative_eq;

    const T: f64 = 1.0;

    fn line(from: [f64; 2], to: [f64; 2]) -> Piece {
        Piece::Segment(Segment::new(from.into(), to.into()))
    }

    /// Trust: plain subtraction where flat lies under flat.
    #[test]
    fn a_flat_holder_stands_half_a_thickness_off_the_face() {
        let die = Profile::die(31.0, 6.0, T);
        for inner in [31.5, 34.0, 40.0] {
            assert_relative_eq!(height(&Profile::holder(inner, T), &die, T), 0.5 * T, epsilon = 1e-9);
        }
    }

    /// Trust: the centres of two rounds half a thickness apart are their radii and that half apart, here 5.8 of it across.
    #[test]
    fn a_sleeve_that_meets_the_shoulder_alone_comes_further() {
        let (nose, shoulder, across) = (6.0, 6.8, 5.8);
        let (throat, flat) = (31.5, 31.5 + shoulder - across);
        let top = -0.5 * T;
        let center = Point::new(flat, top - nose);
        let sleeve = Profile::new(vec![
            line([throat, -100.0], [throat, top]),
            line([throat, top], [flat, top]),
            Piece::Arc(Arc::between(center + Point::new(0.0, nose), center + Point::new(nose, 0.0), center, false).0),
            line([flat + nose, top - nose], [flat + nose, -100.0]),
        ]);
        let rise = height(&sleeve.expect("a chain"), &Profile::die(throat, shoulder, T), T);
        let apart = nose + shoulder + 0.5 * T;
        let centers = apart.powi(2) - across * across;
        // The sleeve's own centre lies by nose + shoulder + t below the die's when it touches the sheet. Measured at points
        // 0.02 rad apart: within 6 × 0.02²/8 mm.
        assert_relative_eq!(rise, nose + shoulder + T - centers.sqrt(), epsilon = 1e-3);
        assert!(rise > T, "{rise}");
    }

    /// Trust: by construction; nothing of it comes near the die's wall.
    #[test]
    fn a_sleeve_within_the_throat_goes_through() {
        let sleeve = Profile::new(vec![
            line([15.0, -100.0], [15.0, -0.5]),
            line([15.0, -0.5], [20.0, -0.5]),
            line([20.0, -0.5], [20.0, -100.0]),
        ]);
        assert!(height(&sleeve.expect("a chain"), &Profile::die(31.0, 6.0, T), T) > 100.0);
    }
}
