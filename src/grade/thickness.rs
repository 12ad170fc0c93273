use serde::Deserialize;
use std::collections::BTreeMap;

#[derive(Deserialize)]
struct Standard {
    source: String,
    width: String,
    /// Upper end of each class of thickness and the tolerance \[mm\].
    classes: Vec<[f64; 2]>,
}

/// Tolerance of a thickness by a standard and class, plus or minus \[mm\], and its source; `None` where none was read.
pub fn tolerance(standard: &str, thickness: f64) -> Option<(f64, String)> {
    let mut all: BTreeMap<String, Standard> = toml::from_str(include_str!("thickness_tolerances.toml")).ok()?;
    let Standard { source, width, classes } = all.remove(standard)?;
    let [_, tolerance] = classes.into_iter().find(|[end, _]| thickness <= end + 1e-9)?;
    Some((tolerance, format!("{standard}, width {width} ({source})")))
}
