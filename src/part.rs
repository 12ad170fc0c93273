//! Round part by its finished sizes: the blank of its area, and what a formed sheet lacks of them.

use crate::measure::part_height;
use crate::rules::{blank_of, cup_area, tool_radius};
use crate::solver::solution::Frame;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// Least radius of a recess's bends over the thickness \[–\], declared: that of the die's is smaller by the gap.
const RECESS_BEND: f64 = 8.0;

/// Finished round part; lengths in mm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Part {
    /// Sheet.
    pub thickness: f64,
    /// Inside radius, and that of the punch's corner.
    pub radius: f64,
    /// Corner between bottom and wall.
    pub nose: f64,
    /// Height from the outside of the bottom to the trimmed rim or the flange.
    pub height: f64,
    /// Width that is trimmed off the rim or the flange.
    pub trim: f64,
    /// Radius of the trimmed flange.
    pub flange: Option<f64>,
    /// Inside radius and height of a narrower part at the bottom.
    pub step: Option<[f64; 2]>,
    /// Radius of a domed bottom.
    pub dome: Option<f64>,
    /// Radius at half its depth, and depth, of a recess in the bottom.
    pub recess: Option<[f64; 2]>,
}

impl Part {
    /// Inside radius next to the bottom.
    pub fn bottom_radius(&self) -> f64 {
        self.step.map_or(self.radius, |[narrow, _]| narrow)
    }

    /// Radius of the two bends of a slope that deep, and its width: at most 45° steep.
    pub fn slope(&self, depth: f64) -> [f64; 2] {
        let bend = (0.5 * depth / (1.0 - FRAC_PI_4.cos())).max(RECESS_BEND * self.thickness);
        let cosine = 1.0 - 0.5 * depth / bend;
        [bend, 2.0 * bend * (1.0 - cosine * cosine).sqrt()]
    }

    /// Radius of the blank with the area of the mid-surface of a part of this height and what is trimmed off it (Guldin).
    pub fn blank(&self, height: f64) -> f64 {
        let half = 0.5 * self.thickness;
        let middle = self.radius + half;
        let trim = if self.flange.is_some() { 0.0 } else { self.trim };
        let mut area = cup_area(middle, self.nose + half, height + trim - half);
        if let Some([narrow, low]) = self.step {
            area -= 2.0 * PI * (self.radius - narrow) * low;
        }
        if let Some(dome) = self.dome {
            let radius = self.bottom_radius();
            let rise = dome - (dome * dome - radius * radius).sqrt();
            area += PI * rise * rise - 2.0 * PI * radius * rise;
        }
        if let Some([radius, depth]) = self.recess {
            area += 2.0 * PI * radius * depth;
        }
        if let Some(flange) = self.flange {
            let bend = (2.0 - FRAC_PI_2) * (tool_radius(self.thickness).value + half);
            area += PI * ((flange + self.trim).powi(2) - middle * middle) - 2.0 * PI * middle * bend;
        }
        blank_of(area)
    }

    /// Height of a plain cup of a blank's area at an even thickness.
    pub fn cup_height(&self, blank: f64, radius: f64, nose: f64) -> f64 {
        let half = 0.5 * self.thickness;
        let (middle, nose) = (radius + half, nose + half);
        nose + (PI * blank * blank - cup_area(middle, nose, nose)) / (2.0 * PI * middle) + half
    }

    /// Area that the blank lacks \[mm²\], and height that a flanged part or the one below a step lacks \[mm\].
    pub fn missing(&self, frame: &Frame) -> Option<[f64; 2]> {
        let Part { thickness, radius, height, trim, flange, step, .. } = *self;
        let (edge, short) = (frame.nodes.last()?.r, height - part_height(frame)?);
        if let Some(flange) = flange {
            return Some([PI * ((flange + trim).powi(2) - edge * edge), short]);
        }
        let area = 2.0 * PI * (radius + 0.5 * thickness) * (trim + short);
        let Some([narrow, low]) = step else { return Some([area, 0.0]) };
        let middle = 0.5 * (radius + narrow + thickness);
        let (a, b) = frame.nodes.iter().zip(&frame.nodes[1..]).find(|(_, b)| b.r > middle)?;
        let z = a.z + (middle - a.r) / (b.r - a.r) * (b.z - a.z);
        Some([area, low - (frame.nodes[0].z + 0.5 * frame.nodes[0].thickness - z)])
    }
}
