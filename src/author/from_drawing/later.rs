//! Operations after the first one as `[[stages]]`.

use super::draft::{Draft, Drawn};
use super::sizes::Sizes;
use super::{change, exact};
use crate::author::page::Page;
use crate::author::templates::FRICTION;
use crate::model::tool_sizes::{extent, mouth, throat};
use crate::model::{Geometry, Role};
use std::f64::consts::PI;

impl Draft<'_> {
    /// Each later operation's tools, new ones that are brought up to the sheet as it is; the die stays where none is drawn.
    pub(super) fn later_stages(&self, sizes: &Sizes, page: &mut Page) {
        let mut before = self.operation(&self.tools, sizes, sizes.travel.as_ref().map(|travel| travel.value));
        for (name, tools) in &self.later {
            let has = |role: Role| tools.iter().any(|(tool, ..)| *tool == role);
            // What stays: the die under a new punch, and with it the holder.
            let stay = before.tools.iter().filter(|(role, ..)| match role {
                Role::Punch => false,
                Role::Die => !has(Role::Die),
                Role::Holder => !has(Role::Holder) && !has(Role::Die),
            });
            let there: Vec<Drawn> = tools.iter().chain(stay).copied().collect();
            let now = self.operation(&there, sizes, None);
            page.table(
                "[stages]",
                &format!("{name}: new tools, brought up to where they touch the sheet as it then is."),
            );
            page.set("name", format!("\"{name}\""), "");
            if before.has(Role::Holder) && !now.has(Role::Holder) {
                page.set("remove", "[\"holder\"]", "no holder is drawn for the new die");
            }
            for (role, profile, made_of) in tools {
                page.table(&format!("stages.{}", role.name()), made_of);
                page.profile(profile);
                page.set("friction", FRICTION, "placeholder: Coulomb's coefficient; change it");
                match (role, now.sizes().travel) {
                    (Role::Punch, Some(travel)) => page.set("move", exact(travel.value), &change(&travel)),
                    (Role::Holder, _) => {
                        let (force, why) = self.force(sizes, &before, &now);
                        page.set("force", force, &why);
                    }
                    _ => {}
                }
            }
            before = now;
        }
    }

    /// One operation alone, on the sheet of the first.
    fn operation<'t>(&'t self, tools: &[Drawn<'t>], sizes: &Sizes, travel: Option<f64>) -> Draft<'t> {
        Draft {
            tools: tools.to_vec(),
            thickness: Some(sizes.thickness.value),
            blank: Some(sizes.blank.value),
            travel,
            name: None,
            later: Vec::new(),
            ..*self
        }
    }

    /// The holder's force and its rule: the first operation's pressure on the ring, or strip, between the die's throat and the
    /// smaller of the holder and the part as it comes.
    fn force(&self, sizes: &Sizes, before: &Draft, now: &Draft) -> (String, String) {
        let (pressure, _) = self.pressure(sizes);
        let comes = before
            .tool(Role::Punch)
            .map_or(f64::INFINITY, |punch| mouth(&punch, before.sizes().travel.map_or(0.0, |travel| travel.value)));
        let holder = now.tool(Role::Holder).map_or((0.0, 0.0), |holder| extent(&holder));
        let inner = now.tool(Role::Die).and_then(|die| throat(&die)).unwrap_or(0.0).max(holder.0);
        let outer = holder.1.min(comes).max(inner);
        let (area, unit) = match self.geometry {
            Geometry::Axisymmetric => (PI * (outer * outer - inner * inner), "N"),
            Geometry::PlaneStrain => (outer - inner, "N/mm"),
        };
        let why = format!(
            "placeholder: the first operation's pressure between {inner:.1} and {outer:.1} mm from the axis; change it"
        );
        (format!("\"{:.0} {unit}\"", (pressure * area).ceil().max(1.0)), why)
    }
}
