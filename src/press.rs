//! Drive of a mechanical press: the slide's way and speed over the crank angle, and the force that its torque permits.
//!
//! φ is the angle before the bottom dead centre and h the slide's height above it. Of a crank of radius R = stroke/2, with a
//! connecting rod of length L in line with it, by the geometry of the slider-crank:
//!
//! ```text
//! h(φ) = R (1 − cos φ) + L [1 − √(1 − λ² sin² φ)]              λ = R/L
//! a(φ) = dh/dφ = R sin φ [1 + λ cos φ/√(1 − λ² sin² φ)]        speed of the slide: a dφ/dt
//! sin²(φ/2) = h (2 − h/L)/(4 [R + λ (R − h)])                  its inverse, by the law of cosines
//! ```
//!
//! Without a rod λ is 0. A link drive has h(φ) by its data sheet, and a by the slope from point to point.
//!
//! By virtual work, M dφ = F dh, a torque M bears the force M/a. The press gives its nominal force F_N down from a height h_N,
//! so M = F_N a(φ_N), and the frame bears no more than F_N:
//!
//! ```text
//! F(φ) = F_N min[1, a(φ_N)/a(φ)]
//! ```
//!
//! Assumptions, declared: the torque is the same at every angle, the crank turns evenly, friction of the drive is in the nominal
//! values, and a punch that has gone its full travel is at the bottom dead centre.

use crate::numerics::PiecewiseLinear;
use std::f64::consts::PI;

/// Points of a schedule: the speed is that of the slide within 3 % of its largest.
const POINTS: usize = 60;

/// Mechanism between the crank and the slide.
#[derive(Clone, Debug, PartialEq)]
pub enum Linkage {
    /// Crank of a radius R and its ratio λ to the rod's length, 0 without one.
    Crank {
        /// R \[mm\].
        radius: f64,
        /// λ \[–\].
        ratio: f64,
    },
    /// Heights \[mm\] over the angle \[rad\], both rising from 0.
    Link(PiecewiseLinear),
}

impl Linkage {
    /// Height of the slide above the bottom dead centre \[mm\], at an angle before it \[rad\].
    pub fn height(&self, angle: f64) -> f64 {
        match self {
            Self::Link(heights) => heights.at(angle),
            Self::Crank { radius, ratio } => {
                let sine = angle.sin();
                let root = (1.0 - (ratio * sine).powi(2)).sqrt();
                radius * (2.0 * (0.5 * angle).sin().powi(2) + ratio * sine * sine / (1.0 + root))
            }
        }
    }

    /// Lever arm dh/dφ \[mm\] at an angle \[rad\].
    pub fn lever(&self, angle: f64) -> f64 {
        match self {
            Self::Link(heights) => heights.slope_before(angle),
            Self::Crank { radius, ratio } => {
                let (sine, cosine) = angle.sin_cos();
                radius * sine * (1.0 + ratio * cosine / (1.0 - (ratio * sine).powi(2)).sqrt())
            }
        }
    }

    /// Angle before the bottom dead centre \[rad\] at a height \[mm\].
    pub fn angle(&self, height: f64) -> f64 {
        match self {
            Self::Link(heights) => heights.reaches(height),
            Self::Crank { radius, ratio } => {
                let square = height * (2.0 - ratio * height / radius) / (4.0 * (radius + ratio * (radius - height)));
                2.0 * square.clamp(0.0, 1.0).sqrt().asin()
            }
        }
    }

    /// Largest height \[mm\].
    pub fn stroke(&self) -> f64 {
        match self {
            Self::Link(heights) => heights.largest(),
            Self::Crank { radius, .. } => 2.0 * radius,
        }
    }
}

/// Motion of the slide in time.
#[derive(Clone, Debug, PartialEq)]
pub enum Pace {
    /// Strokes per minute of a crank that turns evenly \[1/min\].
    Strokes(f64),
    /// Heights above the bottom dead centre \[mm\] of a servo press over the time left to it \[s\], both rising from 0.
    Servo(PiecewiseLinear),
}

/// Curve of heights; `None` unless it rises from (0, 0).
pub fn from_below(points: Vec<(f64, f64)>) -> Option<PiecewiseLinear> {
    let rises = points.len() > 1 && points[0] == (0.0, 0.0) && points.windows(2).all(|w| w[0].1 < w[1].1);
    PiecewiseLinear::new(points).filter(|_| rises)
}

/// Drive of a press.
#[derive(Clone, Debug, PartialEq)]
pub struct Drive {
    /// Mechanism.
    pub linkage: Linkage,
    /// Motion in time, if it is given.
    pub pace: Option<Pace>,
    /// Height above the bottom dead centre down from which the nominal force is permitted \[mm\].
    pub nominal_height: f64,
}

impl Drive {
    /// Crank angle before the bottom dead centre \[°\], with so much of the travel left \[mm\].
    pub fn degrees(&self, height: f64) -> f64 {
        self.linkage.angle(height).to_degrees()
    }

    /// Permitted force over the nominal one \[–\] at a height \[mm\].
    pub fn permitted(&self, height: f64) -> f64 {
        let lever = |height| self.linkage.lever(self.linkage.angle(height));
        (lever(self.nominal_height) / lever(height)).min(1.0)
    }

    /// Height from which the slide comes \[mm\].
    pub fn reach(&self) -> f64 {
        let stroke = self.linkage.stroke();
        if let Some(Pace::Servo(heights)) = &self.pace { stroke.min(heights.largest()) } else { stroke }
    }

    /// Punch travel \[mm\] over time \[s\] of a stroke that ends at the bottom dead centre; `None` without a motion in time.
    pub fn schedule(&self, travel: f64) -> Option<PiecewiseLinear> {
        let (start, height): (f64, Box<dyn Fn(f64) -> f64>) = match self.pace.as_ref()? {
            Pace::Servo(heights) => (heights.reaches(travel), Box::new(|left| heights.at(left))),
            Pace::Strokes(rate) => {
                let speed = rate / 60.0 * 2.0 * PI;
                (self.linkage.angle(travel) / speed, Box::new(move |left| self.linkage.height(speed * left)))
            }
        };
        let point = |i: usize| {
            let time = start * i as f64 / POINTS as f64;
            (time, if i == 0 { 0.0 } else { travel - height(start - time) })
        };
        PiecewiseLinear::new((0..=POINTS).map(point).collect())
    }
}
