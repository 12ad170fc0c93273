//! Opening of a die: entry from the face to the throat, land, relief.

use super::{tools::Die, tools::ToolContext, *};
use crate::geometry::{Entry, Opening};

/// Relief behind a land \[rad\]; declared: 3°.
const RELIEF: f64 = 3.0 * std::f64::consts::PI / 180.0;

impl ToolContext<'_> {
    pub fn opening(&self, die: &Die, throat: f64, shoulder: f64) -> Result<Opening> {
        let (source, length) = (self.source, self.blank.length);
        source.one_of("tools.die", &["cone", "tractrix"], "keep one of them")?;
        let land = die.land.map(|land| [land.value(), die.relief.map_or(RELIEF, Dimensioned::value)]);
        let alone = if land.is_none() { &["relief"][..] } else { &[] };
        source.refuse("tools.die", alone, "stands behind a land, which is not given", "add land = \"6 mm\"")?;
        let has_entry = die.cone.is_some() || die.tractrix == Some(true);
        let alone = if has_entry { &[][..] } else { &["mouth", "mouth_diameter"] };
        let why = "is where a cone or a tractrix begins, and neither is given";
        source.refuse("tools.die", alone, why, "add cone = \"30 deg\" or tractrix = true")?;
        let lengths = [die.mouth, die.mouth_diameter, die.mouth];
        let keys = ["mouth", "mouth_diameter", "mouth"];
        let mouth = if lengths.iter().any(Option::is_some) { self.radius("tools.die", keys, lengths)? } else { length };
        let cone = die.cone.map(|angle| Entry::Cone { angle: angle.value(), mouth });
        let entry = if has_entry { cone.unwrap_or(Entry::Tractrix { mouth }) } else { Entry::Shoulder };
        let opening = Opening { throat, shoulder, entry, land };
        let is_held = self.written.holder.is_some() || self.standing.iter().any(|tool| tool.role == Role::Holder);
        let checked = opening.check(length, self.blank.thickness, is_held);
        checked.map_err(|error| source.error(&format!("tools.die.{}", error.key), error.what, error.help))?;
        Ok(opening)
    }
}
