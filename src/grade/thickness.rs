use serde::Deserialize;
use std::collections::BTreeMap;

/// Classes of one standard.
#[derive(Deserialize)]
struct Standard {
    /// Upper end of each class of thickness and the tolerance \[mm\].
    classes: Vec<[f64; 2]>,
}

/// Tolerance of a thickness by a standard and class of `thickness_tolerances.toml`, plus or minus \[mm\]; `None` outside of the
/// classes that were read.
pub fn tolerance(standard: &str, thickness: f64) -> Option<f64> {
    let mut all: BTreeMap<String, Standard> = toml::from_str(include_str!("thickness_tolerances.toml")).ok()?;
    let classes = all.remove(standard)?.classes;
    classes.into_iter().find(|[end, _]| thickness <= end + 1e-9).map(|[_, tolerance]| tolerance)
}
