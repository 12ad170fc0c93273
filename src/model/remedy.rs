//! Settings that take the place of a model's where these find no equilibrium.

use super::{Norm, Settings};

/// Share of the settings' own largest and first step \[–\].
const SHORTER: f64 = 0.1;
/// Sliding speed of full friction over the punch speed \[–\].
const SMOOTHER: f64 = 1.0;

/// Change of one setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Remedy {
    /// Largest step a tenth as long.
    MaxStep,
    /// First step a tenth as long.
    FirstStep,
    /// Friction that sets in up to the punch speed.
    SlipSpeed,
    /// Steps accepted by the residual.
    ResidualNorm,
}

impl Remedy {
    /// Fixed order in which they are tried, those that move the answer least first.
    pub const ALL: [Self; 4] = [Self::MaxStep, Self::FirstStep, Self::SlipSpeed, Self::ResidualNorm];

    /// Settings with the change; `None` where they have it.
    pub fn applied(self, settings: &Settings) -> Option<Settings> {
        let mut changed = settings.clone();
        match self {
            Self::MaxStep => changed.max_step = (SHORTER * settings.max_step).max(settings.min_step),
            Self::FirstStep => changed.first_step = (SHORTER * settings.first_step).max(settings.min_step),
            Self::SlipSpeed => changed.slip_speed = settings.slip_speed.max(SMOOTHER),
            Self::ResidualNorm => changed.norm = Norm::Residual,
        }
        (changed != *settings).then_some(changed)
    }

    /// Changed key and value, as in a case file; `None` where the settings have it.
    pub fn setting(self, settings: &Settings) -> Option<String> {
        let changed = self.applied(settings)?;
        Some(match self {
            Self::MaxStep => format!("solver.max_step = {}", changed.max_step),
            Self::FirstStep => format!("solver.first_step = {}", changed.first_step),
            Self::SlipSpeed => format!("solver.slip_speed = {}", changed.slip_speed),
            Self::ResidualNorm => "solver.norm = \"residual\"".into(),
        })
    }
}
