//! Fits: hardening laws from tension tests, keys of a case from measured curves.

mod case_fit;
mod estimate;
mod flow_curve;
mod hardening;
mod law_fit;
mod law_report;
mod material_text;
mod specimens;
mod tension;

pub use case_fit::{CaseFit, CaseFitRequest, fit_case};
pub use estimate::{Correlated, Estimate};
pub use flow_curve::{FlowCurve, FlowPoint, Reduction};
pub use hardening::{HardeningKind, RateKind};
pub use law_fit::{Direction, LawFit, LawFits, fit_laws};
pub use material_text::material_text;
pub use specimens::Tests;
pub use tension::Tension;
