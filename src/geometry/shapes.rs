//! Standard tool shapes on a flat sheet of thickness t at z = 0: punch and holder at z = −t/2, the die at z = +t/2.

use super::{Piece, Point, Profile};
use crate::numerics::bisect;
use crate::units::rounded;
use std::f64::consts::FRAC_PI_2;

/// Angle of a tractrix to the axis at which it is left for an arc into the throat \[rad\]; declared: 20°.
const TAIL: f64 = 20.0 * std::f64::consts::PI / 180.0;
/// Arcs of a tractrix: with a throat of 30 mm and a mouth of 60 mm they are within 0.02 mm.
const ARCS: usize = 40;
/// Coordinates that are one \[mm\].
const SAME: f64 = 1e-6;

/// Opening of a die, sizes in mm and rad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Opening {
    /// Radius of the throat (plane strain: half-width).
    pub throat: f64,
    /// Radius of the shoulder; before a cone or a tractrix that of the mouth's edge, behind a cone also that into the throat.
    pub shoulder: f64,
    /// Surface from the face to the throat.
    pub entry: Entry,
    /// Length of the land and angle of the relief behind it to the axis; `None` for a land without end.
    pub land: Option<[f64; 2]>,
}

/// Surface that leads the sheet from a die's face into its throat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Entry {
    /// Shoulder alone.
    Shoulder,
    /// Cone at `angle` to the axis, from the end of the face at `mouth`, at least throat and shoulder.
    Cone {
        /// Angle to the axis \[rad\].
        angle: f64,
        /// End of the face \[mm\].
        mouth: f64,
    },
    /// Tractrix, with tangents equally long up to a wall, from `mouth`, in arcs; the last one ends at the wall.
    Tractrix {
        /// End of the face \[mm\].
        mouth: f64,
    },
}

/// Opening that no blank goes through: the key that is wrong, the mistake and its remedy.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{what}")]
pub struct OpeningError {
    /// Name of the size.
    pub key: &'static str,
    /// Mistake.
    pub what: String,
    /// Remedy.
    pub help: String,
}

/// Shortest land over the sheet's thickness \[–\]: a shorter one passes between two nodes.
const LEAST_LAND: f64 = 0.1;

impl Opening {
    /// Checks the sizes for a blank by its length and thickness \[mm\], which a holder may press on the die's face.
    pub fn check(&self, length: f64, thickness: f64, is_held: bool) -> Result<(), OpeningError> {
        let fail = |key, what: String, help: String| Err(OpeningError { key, what, help });
        let degrees = |angle: f64| angle.to_degrees() * (1.0 + 1e-12);
        let is_angle = |angle: f64, low: f64, high: f64| (low..=high).contains(&degrees(angle));
        let (mouth, least) = (self.mouth(), self.throat + self.shoulder);
        let mm = |length: f64| format!("{} mm", rounded(length));
        match (self.land, self.entry) {
            (Some([land, _]), _) if land < LEAST_LAND * thickness => {
                let what = format!("a land of {} is next to nothing for a sheet of {}", mm(land), mm(thickness));
                return fail("land", what, format!("at least {}", mm(LEAST_LAND * thickness)));
            }
            (Some([_, relief]), _) if !is_angle(relief, 0.5, 60.0) => {
                let what = format!("a relief of {:.1}° to the axis is out of range", degrees(relief));
                return fail("relief", what, "0.5° to 60°: write \"3 deg\"".into());
            }
            (_, Entry::Cone { angle, .. }) if !is_angle(angle, 5.0, 80.0) => {
                let what = format!("a cone of {:.1}° to the axis is out of range", degrees(angle));
                return fail("cone", what, "5° to 80°: write \"30 deg\"".into());
            }
            (_, Entry::Shoulder) => return Ok(()),
            _ => {}
        }
        let [at, edge] = [mouth, length].map(mm);
        if mouth < least {
            let what = format!("the entry's mouth at {at} lies inside throat and shoulder, {}", mm(least));
            fail("mouth", what, format!("at least {}, or a smaller shoulder", mm(least)))
        } else if mouth > length * (1.0 + 1e-9) {
            let what = format!("the entry's mouth at {at} lies beyond the blank's edge at {edge}");
            fail("mouth", what, format!("at most {edge}, where the blank lies on the die's face"))
        } else if is_held && mouth > length - thickness {
            let what = format!("from the entry's mouth at {at} to the blank's edge at {edge} there is nothing to hold");
            fail("mouth", what, format!("a mouth of {} or less, or no holder", mm(length - thickness)))
        } else {
            Ok(())
        }
    }

    fn mouth(&self) -> f64 {
        match self.entry {
            Entry::Shoulder => self.throat + self.shoulder,
            Entry::Cone { mouth, .. } | Entry::Tractrix { mouth } => mouth,
        }
    }

    /// Arcs of the entry, each by its radius \[mm\] and its turn \[rad\], and the straight line behind the first \[mm\].
    fn bends(&self) -> (Vec<[f64; 2]>, f64) {
        let (radius, width) = (self.shoulder, self.mouth() - self.throat);
        match self.entry {
            Entry::Shoulder => (vec![[radius, FRAC_PI_2]], 0.0),
            Entry::Cone { angle, .. } => {
                (vec![[radius, FRAC_PI_2 - angle], [radius, angle]], ((width - radius) / angle.sin()).max(0.0))
            }
            Entry::Tractrix { .. } => (tractrix(radius, width), 0.0),
        }
    }
}

/// Arcs of a tractrix with a rounded edge that is `width` wide \[mm\].
///
/// With tangents of length a its radius is a tan φ where it has turned by φ from the face: it goes a (cos φ₁ − cos φ₂) inward
/// between two such places. An arc of the edge's radius stands where that is larger.
fn tractrix(edge: f64, width: f64) -> Vec<[f64; 2]> {
    let last = FRAC_PI_2 - TAIL;
    let tail = last.tan() * (1.0 - last.sin());
    let first = |a: f64| (edge / a).atan().min(last);
    let reach = |a: f64| edge.min(a * last.tan()) * first(a).sin() + a * (first(a).cos() - last.cos() + tail);
    let [a, _] = bisect(edge / last.tan(), (width + edge) / tail, 60, |a| reach(a) < width);
    // Equal ratios of the radii.
    let share = |i: usize| (first(a).tan().ln() * (ARCS - i) as f64 + last.tan().ln() * i as f64) / ARCS as f64;
    let place = |i: usize| share(i).exp().atan();
    let arcs = (0..ARCS).map(|i| {
        let [from, to] = [place(i), place(i + 1)];
        [a * (from.cos() - to.cos()) / (to.sin() - from.sin()), to - from]
    });
    let arcs = arcs.filter(|[radius, turn]| *turn > 1e-9 && radius.is_finite());
    [[edge, first(a)]].into_iter().chain(arcs).chain([[a * last.tan(), TAIL]]).collect()
}

/// Straight walls go on for this multiple of the tool's largest radius [–]: past any travel that makes sense.
const REACH: f64 = 20.0;
/// Shortest end that is taken for such a wall, over the distance of its corner from the axis [–]: no tool is drawn so long.
const ENDLESS: f64 = 10.0;

fn line(from: (f64, f64), to: (f64, f64)) -> Piece {
    Piece::line(Point::new(from.0, from.1), Point::new(to.0, to.1))
}

fn arc(center: (f64, f64), radius: f64, start: f64, sweep: f64) -> Piece {
    Piece::arc(Point::new(center.0, center.1), radius, start, sweep)
}

impl Profile {
    /// Punch with a spherical (plane strain: cylindrical) nose of `radius` \[mm\] and a straight wall.
    pub fn hemispherical_punch(radius: f64, sheet_thickness: f64) -> Self {
        Self::flat_punch(radius, radius, sheet_thickness)
    }

    /// Flat punch of `radius` (plane strain: half-width) with a corner of `nose` radius \[mm\].
    pub fn flat_punch(radius: f64, nose: f64, sheet_thickness: f64) -> Self {
        let top = -0.5 * sheet_thickness;
        let flat = radius - nose;
        let face = (flat > 1e-9 * radius).then(|| line((0.0, top), (flat, top)));
        let corner = arc((flat, top - nose), nose, FRAC_PI_2, -FRAC_PI_2);
        let wall = line((radius, top - nose), (radius, top - nose - REACH * radius));
        Self::connected(face.into_iter().chain([corner, wall]))
    }

    /// Crowned punch: a `face` radius, a corner `nose` and a wall at `radius` \[mm\] (plane strain: half-width).
    pub fn crowned_punch(radius: f64, face: f64, nose: f64, sheet_thickness: f64) -> Self {
        let top = -0.5 * sheet_thickness;
        // The corner circle touches the wall and, from inside, the face circle.
        let corner_r = radius - nose;
        let between = face - nose;
        let corner_z = top - face + (between * between - corner_r * corner_r).sqrt();
        let angle = (corner_r / between).asin(); // from the axis to the tangent point
        Self::connected([
            arc((0.0, top - face), face, FRAC_PI_2, -angle),
            arc((corner_r, corner_z), nose, FRAC_PI_2 - angle, angle - FRAC_PI_2),
            line((radius, corner_z), (radius, corner_z - REACH * radius)),
        ])
    }

    /// Die with a throat of `throat` radius (plane strain: half-width) and a `shoulder` radius \[mm\], its land without end.
    pub fn die(throat: f64, shoulder: f64, sheet_thickness: f64) -> Self {
        Self::die_with(&Opening { throat, shoulder, entry: Entry::Shoulder, land: None }, sheet_thickness)
    }

    /// Die with an opening; the mouth of a cone or a tractrix lies at least throat and shoulder from the axis.
    pub fn die_with(opening: &Opening, sheet_thickness: f64) -> Self {
        let (throat, end, face) = (opening.throat, opening.mouth(), 0.5 * sheet_thickness);
        let (bends, straight) = opening.bends();
        let mut pieces = vec![line((end + REACH * end, face), (end, face))];
        let (mut at, mut turned, count) = ((end, face), 0.0_f64, bends.len());
        for (i, [radius, turn]) in bends.into_iter().enumerate() {
            let center = (at.0 + radius * turned.sin(), at.1 + radius * turned.cos());
            pieces.push(arc(center, radius, -FRAC_PI_2 - turned, -turn));
            turned += turn;
            at = (center.0 - radius * turned.sin(), center.1 - radius * turned.cos());
            if i == 0 && straight > SAME {
                let next = (at.0 - straight * turned.cos(), at.1 + straight * turned.sin());
                pieces.push(line(at, next));
                at = next;
            }
            if i + 1 == count {
                at = (throat, center.1);
            }
        }
        let up = |from: (f64, f64), by: f64, angle: f64| (from.0 + by * angle.sin(), from.1 + by * angle.cos());
        let [land, relief] = opening.land.unwrap_or([REACH * end, 0.0]);
        let exit = up(at, land, 0.0);
        pieces.push(line(at, exit));
        pieces.extend(opening.land.map(|_| line(exit, up(exit, REACH * end, relief))));
        Self::connected(pieces)
    }

    /// Length of a die's land \[mm\] and angle of the relief behind it to the axis \[rad\]; `None` where its wall has no end.
    pub fn land(&self) -> Option<[f64; 2]> {
        let [.., Piece::Segment(land), Piece::Segment(relief)] = self.pieces() else { return None };
        let [land, relief] = [land, relief].map(|line| line.to - line.from);
        (land.x.abs() < SAME && relief.y > SAME && relief.x > SAME).then(|| [land.y, relief.x.atan2(relief.y)])
    }

    /// Angle of the cone between a die's face and its throat to the axis \[rad\].
    pub fn cone(&self) -> Option<f64> {
        let inner = &self.pieces()[1..self.pieces().len().saturating_sub(2).max(1)];
        let line = |piece: &Piece| if let Piece::Segment(line) = piece { Some(line.to - line.from) } else { None };
        let slanted = inner.iter().filter_map(line).find(|line| line.x < -SAME && line.y > SAME);
        slanted.map(|line| (-line.x).atan2(line.y))
    }

    /// Flat blank holder from `inner` radius \[mm\] outward.
    pub fn holder(inner: f64, sheet_thickness: f64) -> Self {
        let face = -0.5 * sheet_thickness;
        let (low, edge, end) = ((inner, face - REACH * inner), (inner, face), (inner + REACH * inner, face));
        Self::connected([line(low, edge), line(edge, end)])
    }

    /// Profile whose endless walls are cut `margin` beyond a box, by its lower and upper corner \[mm\].
    pub fn cut_to(&self, around: [Point; 2], margin: f64) -> Self {
        let mut pieces = self.pieces().to_vec();
        let last = pieces.len() - 1;
        pieces[last] = cut_wall(&pieces[last], around, margin);
        pieces[0] = cut_wall(&pieces[0].reversed(), around, margin).reversed();
        Self::connected(pieces)
    }
}

/// Wall from its corner outward, cut beyond a box if it goes on without end.
fn cut_wall(piece: &Piece, [low, high]: [Point; 2], margin: f64) -> Piece {
    let (corner, direction) = (piece.first(), piece.tangent(true));
    let corners = [low, high, Point::new(low.x, high.y), Point::new(high.x, low.y)];
    let reach = corners.map(|p| (p - corner).dot(&direction)).into_iter().fold(0.0, f64::max) + margin;
    let is_endless = matches!(piece, Piece::Segment(_)) && piece.length() > ENDLESS * corner.x.max(margin);
    if is_endless && reach < piece.length() { Piece::line(corner, corner + reach * direction) } else { *piece }
}
