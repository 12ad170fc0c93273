//! The rules that pick what is not given, and the refusal of what no single draw reaches.

use crate::author::page::plain;
use crate::case::CaseError;

pub use crate::assess::design::*;

/// Draw ratio of the blank that a part of this height takes, refused where no single draw reaches it.
///
/// # Errors
/// When the ratio is above [`LIMITING_RATIO`]; the message has the height that is not, and `or` what else may be done.
pub(super) fn draw_ratio(blank_for: impl Fn(f64) -> f64, height: f64, punch: f64, or: &str) -> Result<f64, CaseError> {
    let ratio = |height: f64| blank_for(height) / punch;
    if ratio(height) <= LIMITING_RATIO {
        return Ok(ratio(height));
    }
    let what = format!(
        "a blank of {} radius for a punch of {} is a draw ratio of {:.2}, above the limit of one draw, {LIMITING_RATIO}",
        plain(blank_for(height)),
        plain(punch),
        ratio(height)
    );
    let tenths = (1..=(10.0 * height) as u32).map(|tenths| 0.1 * f64::from(tenths));
    let most = tenths.take_while(|height| ratio(*height) <= LIMITING_RATIO).last();
    let help = most.map_or(or.to_owned(), |most| format!("--height of {} or less; or {or}", plain(most)));
    Err(CaseError::bare(what, help))
}
