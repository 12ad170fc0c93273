//! Colours of words and lines.

use crate::assess::Light;
use crate::plot::chart::Color;

/// Words of less weight.
pub(super) const GREY_TEXT: Color = (85, 85, 85);
/// Thin lines.
pub(super) const RULE: Color = (200, 200, 200);

/// The colour of a light's word.
pub(super) fn of_light(light: Light) -> Color {
    match light {
        Light::Grey => GREY_TEXT,
        Light::Green => (0, 102, 74),
        Light::Amber => (138, 90, 0),
        Light::Red => (176, 0, 32),
    }
}
