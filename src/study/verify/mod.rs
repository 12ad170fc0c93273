//! Solution verification: how much of a number is mesh, step, points through the thickness and contact, and how much is the
//! model. What the model has wrong, laws, friction, tools, is validation, and no part of it.
//!
//! # Method
//! Each [`Direction`] is refined on its own, twice and four times, for errors of different origin cancel when they are
//! refined together. Of the numbers f₁, f₂, f₄ of one direction, f₁ that of the run as it is:
//! ```text
//!   p = log₂((f₁ − f₂)/(f₂ − f₄))        observed order
//!   e = 1.25 |f₁ − f₂|/(1 − 2⁻ᵖ)         where both differences have one sign and p lies within half and twice the
//!                                        formal order: Richardson's extrapolation, with a factor of safety
//!   e = 3 (max f − min f)                else, and where a direction has no formal order
//! ```
//! Contact makes most sequences jump a little: the second line is the usual case. The errors of all directions are put
//! together as [`combined`] says. A bar is never less than round-off and the solver's tolerance leave, nor, of a place or a
//! travel, than the element or the step that it is read off by.
//!
//! Whatever is no small error is told and not averaged: runs that end otherwise, numbers that jump, elements below what a
//! shell resolves.
//!
//! How often the truth lies inside is measured (`cargo bench --bench coverage`, docs/verification.md).
//!
//! # References
//! P. J. Roache, Perspective: a method for uniform reporting of grid refinement studies, J. Fluids Eng. 116 (1994) 405–413
//! (not read: the factor 1.25 and the term); ASME V&V 20, Standard for verification and validation in computational fluid
//! dynamics and heat transfer (2009) (not read); L. Eça, M. Hoekstra, A procedure for the estimation of the numerical
//! uncertainty of CFD calculations based on grid refinement studies, J. Comput. Phys. 262 (2014) 104–130 (not read: the
//! factor 3 on the spread of data that do not follow a power).

mod band;
mod bar;
mod direction;
mod estimate;
mod lights;
mod numbers;
mod outcome;
mod quick;
mod said;
mod telling;
mod verification;

#[cfg(test)]
mod tests;

pub use band::Band;
pub use bar::{Bar, Part, combined};
pub use direction::Direction;
pub use estimate::{Estimate, estimate};
pub use lights::{Moved, moved};
pub use numbers::{Number, Of, numbers};
pub use outcome::{End, Outcome};
pub use quick::quick;
pub use telling::{Told, ToldNumber, answered};
#[cfg(feature = "app")]
pub(crate) use verification::Watched;
pub use verification::{Verification, Watch, verify};
