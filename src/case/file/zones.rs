//! `[[blank.zones]]`: parts of a tailored blank.

use super::{material::only, *};
use crate::material::{Hardening, Material, hardening::HardeningTable, law::Family};

/// Part of a flat blank that is thinner or hardens otherwise, as of a tailored one; its middle lies where that of the blank does.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Zone {
    /// Distance of its begin from the axis or symmetry plane; the blank's own when not given.
    from: Option<NonNegative<Length>>,
    /// Distance of its end; the blank's edge when not given.
    to: Option<Positive<Length>>,
    /// Thickness, at most that of the blank, which it has when not given.
    thickness: Option<Positive<Length>>,
    /// Hardening, one law as in `[material.hardening]`; the rest of the material, and the forming limit, are the blank's.
    hardening: Option<HardeningTable>,
}

impl Zone {
    /// Zones of a blank of this material.
    pub fn all(all: &[Self], blank: &model::Blank, material: &Material, source: &Source) -> Result<Vec<model::Zone>> {
        let mut zones: Vec<model::Zone> = Vec::new();
        for (k, zone) in all.iter().enumerate() {
            let path = format!("blank.zones.{k}");
            let [start, edge] = blank.ends();
            let within = [zone.from.map_or(start, Dimensioned::value), zone.to.map_or(edge, Dimensioned::value)];
            source.require(blank.meridian.is_none(), &path, "zones are of a flat blank", "drop them, or the shape")?;
            let [from, to] = within.map(rounded);
            let free = zones.last().map_or(start, |before| before.within[1]);
            let what = format!("a zone from {from} to {to} mm does not fit");
            let help = format!("it lies between {} and {} mm, zones go outward", rounded(free), rounded(edge));
            source.require(free <= within[0] && within[0] < within[1] && within[1] <= edge, &path, what, help)?;
            let thickness = zone.thickness.map_or(blank.thickness, Dimensioned::value);
            let [thick, most] = [thickness, blank.thickness].map(rounded);
            let what = format!("a zone of {thick} mm does not go with the blank of {most} mm");
            let help = "give `blank.thickness` of the thickest part, on which the tools lie; a tenth at least";
            source.require((0.1 * most..=most).contains(&thick), &format!("{path}.thickness"), what, help)?;
            let law = |table: &HardeningTable| {
                let young = material.elastic.map(|elastic| elastic.young);
                let hardening = only(Hardening::named(table.clone()), young, &format!("{path}.hardening"), source)?;
                Ok::<_, CaseError>(Material { hardening, ..material.clone() })
            };
            zones.push(model::Zone { within, thickness, material: zone.hardening.as_ref().map(law).transpose()? });
        }
        Ok(zones)
    }
}
