//! The built-in font of every picture: no system font is looked for.

/// Name of the font in pictures.
pub const FAMILY: &str = "DejaVu Sans";

/// DejaVu Sans, Latin, Greek and mathematical signs only.
pub static DATA: &[u8] = include_bytes!("../../assets/DejaVuSans-subset.ttf");
