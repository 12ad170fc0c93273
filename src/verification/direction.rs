//! Directions of refinement.

use crate::model::{Grading, Model, Stage};
use crate::units::Amount;

/// A direction in which a solution is refined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd)]
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
    /// All of them at once.
    Together,
}

/// Fewest elements and points of a coarser run.
const LEAST_ELEMENTS: usize = 8;
const LEAST_POINTS: usize = 3;

impl Direction {
    /// Directions that are refined each on its own.
    pub const ALL: [Self; 7] =
        [Self::Elements, Self::Points, Self::Steps, Self::Stiffness, Self::Smoothing, Self::Slip, Self::CutOff];

    /// Name in files and JSON.
    pub fn key(self) -> &'static str {
        match self {
            Self::Stiffness => "contact_stiffness",
            Self::Smoothing => "contact_smoothing",
            Self::Slip => "slip_speed",
            Self::CutOff => "cut_off",
            Self::Together => "together",
            plain => plain.label(),
        }
    }

    /// Name in tables.
    pub fn label(self) -> &'static str {
        match self {
            Self::Elements => "elements",
            Self::Points => "points",
            Self::Steps => "steps",
            Self::Stiffness => "contact stiffness",
            Self::Smoothing => "contact smoothing",
            Self::Slip => "slip speed",
            Self::CutOff => "cut-off",
            Self::Together => "all together",
        }
    }

    /// Refinement in words: `4 times the elements`.
    pub fn text(self, times: f64) -> String {
        let n = Amount::number(times);
        match self {
            Self::Points => format!("{n} times the points through the thickness"),
            Self::Steps => format!("steps of 1/{n} of the length"),
            Self::CutOff => format!("1/{n} of the cut-off strain"),
            Self::Together => format!("everything {n} times as fine"),
            Self::Elements | Self::Stiffness => format!("{n} times the {}", self.label()),
            Self::Smoothing | Self::Slip => format!("1/{n} of the {}", self.label()),
        }
    }

    /// Formal order of convergence \[–\]; `None` for points through the thickness, which may or may not meet the reversal of
    /// stress.
    pub fn order(self) -> Option<f64> {
        match self {
            Self::Elements => Some(2.0),
            Self::Points | Self::Together => None,
            Self::Steps | Self::Stiffness | Self::Smoothing | Self::Slip | Self::CutOff => Some(1.0),
        }
    }

    /// Cost of a refined run over that of the run as it is \[–\].
    pub fn cost(self, times: f64) -> f64 {
        match self {
            Self::Elements | Self::Points | Self::Steps => times,
            Self::Together => times.powi(3),
            _ => 1.0,
        }
    }

    /// Stages refined by a factor, coarser below 1; `None` if there is nothing to refine.
    pub fn refined(self, stages: &[Stage], times: f64) -> Option<Vec<Stage>> {
        let mut refined = stages.to_vec();
        for stage in &mut refined {
            match self {
                Self::Together => Self::ALL.iter().for_each(|each| each.refine(&mut stage.model, times)),
                _ => self.refine(&mut stage.model, times),
            }
        }
        let changed = refined.iter().zip(stages).any(|(refined, stage)| refined.model != stage.model);
        (changed && refined.iter().all(|stage| stage.model.check().is_ok())).then_some(refined)
    }

    fn refine(self, model: &mut Model, times: f64) {
        let Model { blank, settings, .. } = model;
        let contact = !model.tools.is_empty();
        match self {
            Self::Elements => {
                if blank.grading == Grading::Radii {
                    blank.grading = Grading::Divided { of: blank.elements };
                }
                blank.elements = scaled(blank.elements, times, LEAST_ELEMENTS);
            }
            Self::Points if blank.layers > 1 => blank.layers = scaled(blank.layers, times, LEAST_POINTS),
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

fn scaled(count: usize, times: f64, least: usize) -> usize {
    ((count as f64 * times).round() as usize).max(least.min(count))
}
