//! Limits of what a part may ask of a sheet and of thin-shell theory.
//!
//! # References
//! 4ming, Forming handbook, "Clearance according to Oehler/Kaiser", table of draw ratios (4ming.de/en/forming-handbook);
//! the books that it quotes were not read.

/// Radius over thickness below which shells are no longer thin \[–\]: a declared rule of thumb.
pub const THIN: f64 = 5.0;
/// Blank over punch that one draw of good steel reaches \[–\]: a declared rule of thumb, above 4ming's table.
pub const LIMITING_RATIO: f64 = 2.2;
/// Blank over punch that is close to the limit \[–\]: that of DC04 for a punch of 100 mm (4ming).
pub const CAREFUL_RATIO: f64 = 2.0;
/// First cup over redrawn cup \[–\], of DC04 in the second draw (4ming).
pub const REDRAW_RATIO: f64 = 1.3;
