//! How zones and what the case does look in every picture of a study: colours that colour-blind readers tell apart, and lines
//! that are told apart in grey.

use crate::plot::chart::{BLACK, Color, GREY, Look, Series, color, pale};
use crate::study::Zone;
use crate::table::capitalised;

/// Of what is amber, all over.
pub(super) const AMBER: Look = Look::Area { fill: (253, 233, 190), edge: None };
/// Borders of zones.
pub(super) const BORDER: Look = Look::Line { color: BLACK, width: 2.0, dash: &[] };
/// Where the case stands.
pub(super) const OWN: Look = Look::Line { color: BLACK, width: 1.6, dash: &[5.0, 4.0] };

/// Colour of a zone, and how its lines rise \[degrees\].
fn pen(zone: Zone) -> (Color, f64) {
    match zone {
        Zone::Tears => (color(1), 45.0),
        Zone::Wrinkles => (color(0), 135.0),
        Zone::Press => (color(3), 0.0),
        Zone::Other => (color(4), 90.0),
        Zone::NoResult => (GREY, 70.0),
    }
}

/// A zone's ground.
pub(super) fn ground(zone: Zone) -> Look {
    Look::Area { fill: pale(pen(zone).0), edge: None }
}

/// A zone's lines, through which others are seen.
pub(super) fn lines(zone: Zone) -> Look {
    Look::Hatched { fill: None, line: pen(zone).0, rise: pen(zone).1 }
}

/// A zone in the legend.
pub(super) fn entry(zone: Zone) -> Series {
    let (line, rise) = pen(zone);
    let look = Look::Hatched { fill: Some(pale(line)), line, rise };
    Series::new(capitalised(&zone.label().to_string()), Vec::new(), look)
}
