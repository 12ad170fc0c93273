//! Observed orders of convergence: p of an error that goes with the size of an element or of a step to the power p.

/// p from one refinement to the next, of errors that vanish in the limit.
pub fn orders(sizes: &[f64], errors: &[f64]) -> Vec<f64> {
    let log = |values: &[f64], i: usize| (values[i] / values[i + 1]).abs().ln();
    assert_eq!(sizes.len(), errors.len());
    (1..errors.len()).map(|i| log(errors, i - 1) / log(sizes, i - 1)).collect()
}

/// p where the limit is not known: from the changes of a value when the size is halved again and again.
pub fn orders_of_changes(values: &[f64]) -> Vec<f64> {
    let changes: Vec<f64> = values.windows(2).map(|w| w[1] - w[0]).collect();
    changes.windows(2).map(|w| (w[0] / w[1]).abs().log2()).collect()
}
