//! A case file written around tools that were drawn: their profiles, and declared placeholders for the rest.

mod draft;
mod imported;
mod later;
mod refused;
mod sizes;

pub use draft::{Draft, Drawn};
pub use imported::{Import, ImportFailure, Imported};

use super::page::{Page, exact, size_key};
use super::templates::rules::strip_pressure;
use super::templates::{FRICTION, typical};
use crate::assess::design::Picked;
use crate::assess::estimate::{siebel, tensile_strength};
use crate::case::library;
use crate::material::hardening::Swift;
use crate::material::{Hardening, Material};
use crate::model::tool_sizes::mouth;
use crate::model::{Geometry, Role};
use crate::units::rounded;
use sizes::Sizes;

impl Draft<'_> {
    /// The case file's text: TOML with comments, every placeholder marked and declared in `notes`.
    pub fn toml(&self) -> String {
        let sizes = self.sizes();
        let mut page = self.head(&sizes);
        if let Some(name) = &self.name {
            page.table("stage", "");
            page.set("name", format!("\"{name}\""), "");
        }
        self.sheet(&sizes, &mut page);
        for (role, profile, made_of) in &self.tools {
            page.table(&format!("tools.{}", role.name()), made_of);
            page.profile(profile);
            page.set("friction", FRICTION, "placeholder: Coulomb's coefficient; change it");
            match (role, &sizes.travel) {
                (Role::Punch, Some(travel)) => page.set("travel", exact(travel.value), &change(travel)),
                (Role::Holder, _) => {
                    let (pressure, rule) = self.pressure(&sizes);
                    let why =
                        format!("placeholder: {rule}, on the area between holder and die; change it, or give a force");
                    page.set("pressure", format!("\"{pressure} MPa\""), &why);
                }
                _ => {}
            }
        }
        if !self.has(Role::Punch) {
            page.proposal(&[
                "No punch is drawn. Add one, for example:",
                "[tools.punch]",
                "flat = { radius = \"30 mm\", nose = \"6 mm\" }",
                &format!("friction = {FRICTION}"),
                "travel = \"10 mm\"",
            ]);
        }
        self.later_stages(&sizes, &mut page);
        page.text()
    }

    fn head(&self, sizes: &Sizes) -> Page {
        let written = "Written by `stampflow import`: the tools are as drawn, what is marked as placeholder is not in the drawing.";
        let about = std::iter::once(written.to_owned()).chain(self.notes.iter().map(|note| format!("- {note}")));
        let title: String = self.title.chars().filter(|c| !c.is_control()).take(150).collect();
        let mut open: Vec<&str> =
            self.material.is_none().then_some("material").into_iter().chain(["friction"]).collect();
        let picked =
            [("thickness", Some(&sizes.thickness)), ("blank", Some(&sizes.blank)), ("travel", sizes.travel.as_ref())];
        open.extend(picked.iter().filter(|(_, size)| size.is_some_and(|size| !size.is_given())).map(|(name, _)| name));
        open.extend(self.has(Role::Holder).then_some("holder pressure"));
        open.extend((!self.later.is_empty()).then_some("ways and holder forces of the later stages"));
        let notes = [
            "declared: the tools' sections are those of the drawing".to_owned(),
            format!("declared: placeholders, not in the drawing: {}", open.join(", ")),
        ];
        Page::new(about, &title, self.geometry, &notes)
    }

    fn sheet(&self, sizes: &Sizes, page: &mut Page) {
        let Sizes { thickness, blank, .. } = sizes;
        page.table("blank", "");
        page.set(size_key(self.geometry), exact(blank.value), &change(blank));
        page.set("thickness", exact(thickness.value), &change(thickness));
        match self.material {
            Some(name) => {
                page.table("material", "");
                page.set("name", format!("{name:?}"), "of the library: stampflow materials");
            }
            None => page.swift(
                typical(),
                "placeholder: typical of mild deep-drawing steel; change it, or name one of `stampflow materials`. \
                 σ = k (offset + ε)^n",
            ),
        }
        page.forming_limit(&self.law(), thickness.value, false);
    }

    /// The sheet's metal: that of the library, or the placeholder.
    fn law(&self) -> Material {
        let named = self.material.and_then(|name| library::material(name).ok()).map(|entry| entry.material);
        named.unwrap_or_else(|| {
            let [k, n, offset] = typical();
            Material::plain(Hardening::Swift(Swift::new(k, n, offset).expect("the law is one")))
        })
    }

    /// The holder's pressure \[MPa\], rounded up, and its rule: Siebel's for a blank that is drawn in round an axis.
    fn pressure(&self, sizes: &Sizes) -> (f64, &'static str) {
        let strength = tensile_strength(&self.law());
        let travel = sizes.travel.as_ref().map_or(0.0, |travel| travel.value);
        let punch = self.tool(Role::Punch).map(|punch| mouth(&punch, travel));
        let drawn = punch.filter(|punch| self.geometry == Geometry::Axisymmetric && sizes.blank.value > *punch);
        let (pressure, rule) = match drawn {
            Some(punch) => {
                (siebel(sizes.blank.value / punch, 2.0 * punch, sizes.thickness.value, strength), "Siebel's pressure")
            }
            None => (strip_pressure(strength).value, "1 % of the tensile strength"),
        };
        (rounded(0.01 * (100.0 * pressure).ceil()), rule)
    }

    fn has(&self, role: Role) -> bool {
        self.tools.iter().any(|(tool, ..)| *tool == role)
    }
}

/// What stands behind a size: nothing where it was given.
fn change(size: &Picked) -> String {
    if size.is_given() { String::new() } else { format!("placeholder: {}; change it", size.why) }
}
