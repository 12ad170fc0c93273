//! The built-in font of every picture: no system font is looked for.

use plotters::style::{FontStyle, register_font};
use std::sync::Once;

/// Name of the font in pictures.
pub const FAMILY: &str = "DejaVu Sans";

/// DejaVu Sans, Latin, Greek and mathematical signs only.
pub static DATA: &[u8] = include_bytes!("../../assets/DejaVuSans-subset.ttf");

/// Makes the font known to plotters; once is enough, more does no harm.
pub fn register() {
    static DONE: Once = Once::new();
    DONE.call_once(|| {
        if register_font(FAMILY, FontStyle::Normal, DATA).is_err() {
            unreachable!("the built-in font is a font");
        }
    });
}
