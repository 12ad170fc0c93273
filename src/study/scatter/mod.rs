//! Scatter: how sure a verdict is when coil, friction, thickness and press are not the same for every part.
//!
//! ```text
//! Distribution, Written  how a number scatters, and as it is typed
//! Factor                 a key of the case that scatters; the strength of its sheet
//! Correlation, Copula    what goes together
//! Sampling               scrambled Sobol points by their index, in independent scramblings
//! Scatter                the designs of a sample
//! Estimate               a number with its interval of 95 %, from the scramblings
//! Index                  what of a number's variance a factor decides
//! Base                   the case as it stands: the columns of the table, and the limits
//! Grids                  curves of all runs at the same places
//! Sample                 the table of a sample, read back
//! Found                  what it says: quantiles, probabilities, influence, bands; telling has its sentences
//! ```
//!
//! # References
//! B. Burley, Practical hash-based Owen scrambling, J. Comput. Graph. Tech. 9 (2020) (not read; the crate `sobol_burley` does
//! it); A. B. Owen, Scrambled net variance for integrals of smooth functions, Ann. Statist. 25 (1997) 1541–1562 (not read).

mod base;
mod copula;
mod curves;
mod deciding;
mod declared;
pub mod distribution;
mod estimate;
mod factor;
pub mod file;
mod found;
mod indices;
mod plan;
mod sample;
mod sampling;
mod telling;

pub use base::{Base, Known};
pub use copula::Correlation;
pub use curves::Grids;
pub use deciding::deciding;
pub use distribution::Distribution;
pub use estimate::{CONFIDENCE, Estimate, Tries, jackknife, probability};
pub use factor::{Factor, STRENGTH};
pub use found::{Band, Event, Found, Influence, QUANTILES, Spread, What};
pub use indices::{Index, indices, rank_correlation};
pub use plan::{Asked, POINTS, SEED, Scatter};
pub use sample::Sample;
pub use sampling::{COORDINATES, MOST, Part, Place, REPLICATES, Sampling};
pub use telling::called;

use super::StudyError;
