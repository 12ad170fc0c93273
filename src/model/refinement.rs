//! Directions in which the discretisation of a model is refined.

use super::{Grading, Model, Stage};
use crate::units::Amount;

/// A direction in which a solution is refined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// Elements along the meridian.
    Elements,
    /// Points through the thickness.
    Points,
    /// Steps: the longest, the first, and the strain of one.
    Steps,
    /// Stiffness of the contact.
    Stiffness,
    /// Gap over which contact sets in: the foot of its law.
    Smoothing,
    /// Sliding speed at which friction sets in.
    Slip,
    /// Strain below which the sheet is rigid.
    CutOff,
}

/// Name, and refinement in words with its factor as `{}`.
const TABLE: [(&str, &str); 7] = [
    ("elements", "{} times the elements"),
    ("points", "{} times the points through the thickness"),
    ("steps", "steps of 1/{} of the length"),
    ("contact stiffness", "{} times the contact stiffness"),
    ("contact smoothing", "1/{} of the contact smoothing"),
    ("slip speed", "1/{} of the slip speed"),
    ("cut-off", "1/{} of the cut-off strain"),
];

impl Direction {
    /// Directions that are refined each on its own.
    pub const ALL: [Self; 7] =
        [Self::Elements, Self::Points, Self::Steps, Self::Stiffness, Self::Smoothing, Self::Slip, Self::CutOff];

    /// Name in files and JSON.
    pub fn key(self) -> String {
        self.label().replace([' ', '-'], "_")
    }

    /// Name in tables.
    pub fn label(self) -> &'static str {
        TABLE[self as usize].0
    }

    /// Refinement in words: `4 times the elements`.
    pub fn text(self, times: f64) -> String {
        TABLE[self as usize].1.replace("{}", &Amount::number(times).to_string())
    }

    /// Stages refined by a factor; `None` if there is nothing to refine.
    pub fn refined(self, stages: &[Stage], times: f64) -> Option<Vec<Stage>> {
        let mut refined = stages.to_vec();
        refined.iter_mut().for_each(|stage| self.refine(&mut stage.model, times));
        let changed = refined.iter().zip(stages).any(|(refined, stage)| refined.model != stage.model);
        (changed && refined.iter().all(|stage| stage.model.check().is_ok())).then_some(refined)
    }

    fn refine(self, model: &mut Model, times: f64) {
        let Model { blank, settings, .. } = model;
        let contact = !model.tools.is_empty();
        let scaled = |count: usize| (count as f64 * times).round() as usize;
        match self {
            Self::Elements => {
                if blank.grading == Grading::Radii {
                    blank.grading = Grading::Divided { of: blank.elements };
                }
                blank.elements = scaled(blank.elements);
            }
            Self::Points if blank.layers > 1 => blank.layers = scaled(blank.layers),
            Self::Steps => {
                settings.max_step = (settings.max_step / times).min(1.0);
                settings.first_step = (settings.first_step / times).min(settings.max_step);
                settings.strain_step /= times;
            }
            Self::Stiffness if contact => settings.contact_stiffness *= times,
            Self::Smoothing if contact => settings.contact_smoothing /= times,
            Self::Slip if contact => settings.slip_speed /= times,
            Self::CutOff => settings.cutoff_strain /= times,
            _ => {}
        }
    }
}
