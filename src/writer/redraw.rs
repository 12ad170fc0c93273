//! Tools of a redraw: a die with a cone, and a sleeve inside the cup before.

use super::{mm, profile_text};
use crate::geometry::Point;
use std::f64::consts::PI;

/// Slope of the die and the sleeve \[°\], a declared rule of thumb: a flat beside the throat has no room.
const CONE: f64 = 40.0;
/// Least width between the cones over the thickness \[–\].
const LEAST_CLAMPED: f64 = 0.1;

/// Die of a redraw and its sleeve, which clamp the cup before between two cones, all \[mm\].
pub struct Ring {
    pub thickness: f64,
    /// Outside of the sleeve, and radius of its corner.
    pub outer: f64,
    pub nose: f64,
    /// Throat of the die, also the sleeve's bore, and radius of its shoulder.
    pub throat: f64,
    pub shoulder: f64,
    /// True of a ring that stands inside the cup before, which is turned over and drawn inside out.
    pub is_reverse: bool,
}

impl Ring {
    /// End of the sleeve's cone at its corner, which ends at z = 0.
    fn cone_end(&self) -> Point {
        let (sine, cosine) = CONE.to_radians().sin_cos();
        Point::new(self.outer - self.nose * (1.0 - sine), self.nose * cosine)
    }

    /// Begin of the die's cone at its shoulder, which ends at z = 0.
    fn cone_start(&self) -> Point {
        let (sine, cosine) = CONE.to_radians().sin_cos();
        Point::new(self.throat + self.shoulder * (1.0 - sine), -self.shoulder * cosine)
    }

    /// End of the round of a thickness at the sleeve's inner edge, and its centre.
    fn edge(&self) -> [Point; 2] {
        let (sine, cosine) = CONE.to_radians().sin_cos();
        let (round, end) = (self.thickness, self.cone_end());
        let center = self.throat + round;
        let height = end.y + ((end.x - center) * sine - round) / cosine;
        [Point::new(center + round * sine, height + round * cosine), Point::new(center, height)]
    }

    /// Whether the cones face each other over some width, so that a sleeve has something to hold.
    pub fn has_room(&self) -> bool {
        if self.is_reverse {
            return false;
        }
        let die = self.cone_start().x - self.thickness * CONE.to_radians().sin();
        self.cone_end().x - die.max(self.edge()[0].x) >= LEAST_CLAMPED * self.thickness
    }

    pub fn die(&self) -> String {
        let (start, far) = (self.cone_start(), 1.5 * self.outer);
        let center = Point::new(self.throat + self.shoulder, 0.0);
        let wall = [(Point::new(self.throat, 0.0), Some((center, false))), (Point::new(self.throat, 4.0 * far), None)];
        if self.is_reverse {
            let corner = self.nose.min(self.outer - self.throat - self.shoulder);
            let [rim, face] = [corner - self.shoulder, -self.shoulder];
            let corner_center = Point::new(self.outer - corner, rim);
            let lip = [
                (Point::new(self.outer, rim), None),
                (Point::new(self.outer - corner, face), Some((corner_center, false))),
                (Point::new(self.throat + self.shoulder, face), None),
            ];
            // Two arcs that meet leave no flat between them.
            let flat = usize::from(self.outer - corner - self.throat - self.shoulder > 1e-3);
            return profile_text(Point::new(self.outer, 4.0 * far), &[&lip[..2 + flat], &wall].concat(), mm);
        }
        let steps = [&[(start, None)], &wall[..]].concat();
        profile_text(Point::new(far, start.y - (far - start.x) * CONE.to_radians().tan()), &steps, mm)
    }

    /// Area on which the sleeve presses \[mm²\].
    pub fn area(&self) -> f64 {
        PI * (self.outer.powi(2) - self.throat.powi(2))
    }

    pub fn sleeve(&self, length: f64) -> String {
        let [edge, center] = self.edge();
        let steps = [
            (Point::new(self.throat, center.y), None),
            (edge, Some((center, false))),
            (self.cone_end(), None),
            (Point::new(self.outer, 0.0), Some((Point::new(self.outer - self.nose, 0.0), false))),
            (Point::new(self.outer, -length), None),
        ];
        profile_text(Point::new(self.throat, -length), &steps, mm)
    }
}
