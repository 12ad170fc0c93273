//! Fits: hardening laws from tension tests, keys of a case from measured curves.

mod case_fit;
mod estimate;
mod flow_curve;
mod law;
mod law_fit;
mod law_report;
mod tension;

pub use case_fit::{CaseFit, CaseFitRequest, fit_case};
pub use estimate::Estimate;
pub use flow_curve::{FlowCurve, Reduction, Tests};
pub use law::HardeningKind;
pub use law_fit::{Direction, LawFit, LawFits, fit_laws};
pub use law_report::material_text;
pub use tension::{FlowPoint, Tension};
