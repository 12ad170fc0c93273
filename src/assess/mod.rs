//! What a user should know of a case, before it is solved and after.

pub mod check;
pub mod verdict;
