//! Which step is to be taken apart, and how.

use crate::model::Iteration;

/// What is to be taken apart.
#[derive(Clone, Debug, PartialEq)]
pub struct Asked {
    /// The stage, from 1.
    pub stage: usize,
    /// The step of it, from 1.
    pub step: usize,
    /// The matrices to iterate with, each from the same state; that of the case where none is named.
    pub matrices: Vec<Iteration>,
    /// What the norm is to come down to in this step alone \[–\]; that of the case where it is `None`.
    pub tolerance: Option<f64>,
}

impl Default for Asked {
    fn default() -> Self {
        Self { stage: 1, step: 1, matrices: Vec::new(), tolerance: None }
    }
}
