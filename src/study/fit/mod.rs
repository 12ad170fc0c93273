//! Numbers from measurements: hardening laws from tension tests, keys of a case from measured curves.
//!
//! ```text
//! Tests       tension tests as a user names them, and the texts that say how they are reduced
//! Tension     a tension test as its file has it
//! FlowCurve   what follows: elastic line, yield stress, uniform elongation, stress over plastic strain
//! Kind        a hardening law and its parameters; LawFit: the law that fits, how sure, how far
//! LawFits     all laws beside each other, the one to use and why; rates and directions
//! Range       a key of a case: where to begin and between what
//! Target      a measured curve that a run is held against
//! CaseFit     the keys that fit, how sure, and what the curves cannot tell
//! Estimate    a fitted number: standard error and interval
//! ```

mod case;
mod case_spec;
mod case_words;
mod columns;
mod estimate;
mod flow_curve;
mod kind;
mod law_fit;
mod law_fits;
mod law_words;
mod material_text;
mod noise;
mod range;
mod runs;
pub mod specimens;
mod target;
mod tension;

pub use case::{CaseFit, Matched, fit_case};
pub use case_spec::{CaseFitSpec, load};
pub use estimate::{CONFIDENCE, Estimate, Estimates};
pub use flow_curve::{FlowCurve, FlowPoint, Reduction};
pub use kind::Kind;
pub use law_fit::{LawFit, RateKind};
pub use law_fits::{Direction, LawFits, fit_laws};
pub use material_text::{material_setting, material_text};
pub use range::Range;
pub use specimens::Tests;
pub use target::Target;
pub use tension::Tension;
