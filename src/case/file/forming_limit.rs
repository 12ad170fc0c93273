//! `[forming_limit]`: exactly one curve, computed once.

use super::{Deserialize, JsonSchema, Result, Source, material::blame, material::not_one};
use crate::forming_limit::{Curve, Hill, KeelerBrazier, Kind, MarciniakKuczynski, Points, Sheet, Strain, Swift};
use crate::material::{Material, flow::ROOM_TEMPERATURE};
use crate::model::Heat;
use crate::units::{Amount, Dimensioned, Fraction, Number, ZERO_CELSIUS};

/// Forming limit curve, exactly one: `points`, `measured`, `keeler_brazier`, `hill`, `swift` or `marciniak_kuczynski`; or `none`.
///
/// Default: the measured points of the library's sheet; else, of a cold sheet without voids, Keeler and Brazier for steel of at
/// most 3.1 mm and 590 MPa of tensile strength (`crystal = "bcc"`, or without a crystal `young` of steel and n up to 0.3), and
/// Hill with Swift for other metals. Such a curve is computed, not measured, and the verdict says so.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(extend("dependentRequired" = { "points": ["strain"], "strain": ["points"] }))]
pub struct FormingLimit {
    /// Pairs of minor and major strain from left to right, plain numbers: `[[-0.2, 0.5], [0, 0.3], [0.3, 0.45]]`.
    ///
    /// Valid for the sheet and the thickness it was measured on, and for straight strain paths. Source: the case's own.
    pub points: Option<Vec<(Number, Number)>>,
    /// True for no forming limit at all, where the default would make one.
    pub none: Option<bool>,
    /// Measure of strain of `points`: needed with them.
    pub strain: Option<Strain>,
    /// Measured points of the library's sheet that `[material] name` names, if it has some.
    pub measured: Option<bool>,
    /// Empirical curve of steels; `{}` takes n from the hardening law.
    pub keeler_brazier: Option<KeelerBrazier>,
    /// Hill's localised necking on the left, Swift's diffuse necking on the right: from the hardening law and r̄.
    pub hill: Option<bool>,
    /// Swift's diffuse necking on both sides: from the hardening law and r̄.
    pub swift: Option<bool>,
    /// Hardening exponent of `keeler_brazier`, `hill` or `swift`. Default: for `keeler_brazier` the uniform strain at the load
    /// maximum of the hardening law, for the others the law itself.
    pub n: Option<Fraction>,
    /// Groove in the sheet: from the hardening law, the rate law and r̄.
    pub marciniak_kuczynski: Option<MarciniakKuczynski>,
}

impl FormingLimit {
    /// Curve of a case that gives none; a note says why there is none.
    pub fn usual(material: &Material, thickness: f64, heat: Option<&Heat>, source: &Source) -> Option<Curve> {
        let sheet = Sheet { material, thickness, temperature: ROOM_TEMPERATURE };
        let curve = match (heat, material.rate.is_some_and(|rate| rate.is_superplastic()), material.gtn) {
            (Some(_), ..) => Err("a hot sheet's hangs on its temperature and rate".to_owned()),
            (_, true, _) => Err("a superplastic sheet thins evenly far beyond any computed one".to_owned()),
            (.., Some(_)) => Err("the voids say when the sheet fails".to_owned()),
            _ => Kind::usual(&sheet).map_err(|error| error.message),
        };
        let curve = curve.inspect_err(|why| source.note(format!("no forming limit: {why}"))).ok();
        curve.inspect(|curve| curve.notes.iter().for_each(|note| source.note(note.clone())))
    }

    /// Curve that the case gives; `None` if it wants none.
    pub fn curve(&self, material: &Material, t: f64, heat: Option<&Heat>, source: &Source) -> Result<Option<Curve>> {
        let n = self.n.map(Dimensioned::value);
        let checked = self.marciniak_kuczynski.iter().try_for_each(MarciniakKuczynski::check);
        checked.map_err(|error| blame(error, "forming_limit.marciniak_kuczynski", source))?;
        // Points of the library stand among `points` by now.
        let what = "`measured` takes the points of a sheet of the library, and this case names none that has some";
        let help = "write points of the coil, or hill = true; `stampflow materials NAME` says which sheets have measured limits";
        source.require(self.measured != Some(true), "forming_limit.measured", what, help)?;
        let kinds = [
            self.points(source)?.map(|kind| ("points", Kind::Points(kind))),
            self.keeler_brazier.map(|kind| ("keeler_brazier", Kind::KeelerBrazier(KeelerBrazier { n, ..kind }))),
            self.hill.filter(|on| *on).map(|_| ("hill", Kind::Hill(Hill { n }))),
            self.swift.filter(|on| *on).map(|_| ("swift", Kind::Swift(Swift { n }))),
            self.marciniak_kuczynski.map(|kind| ("marciniak_kuczynski", Kind::MarciniakKuczynski(kind))),
        ];
        let names = "points, measured, keeler_brazier, hill, swift, marciniak_kuczynski, none";
        let mut given = kinds.into_iter().flatten();
        let (name, kind) = match (given.next(), given.next()) {
            (None, None) if self.none == Some(true) => return Ok(None),
            (Some(only), None) if self.none != Some(true) => only,
            (first, _) => return Err(not_one(first.iter().count(), "forming_limit", names, source)),
        };
        let is_points = matches!(kind, Kind::Points(_));
        let without_n = n.is_none() || !(is_points || matches!(kind, Kind::MarciniakKuczynski(_)));
        source.require(without_n, "forming_limit.n", format!("`n` has no part in `{name}`"), "drop it")?;
        source.require(n != Some(0.0), "forming_limit.n", "`n` must be above 0", "0.1 to 0.3 is usual")?;
        let what = format!("`strain` has no part in `{name}`, whose strains are logarithmic");
        source.require(self.strain.is_none() || is_points, "forming_limit.strain", what, "drop it")?;
        let temperature = heat.map_or(ROOM_TEMPERATURE, |heat| heat.initial.smallest());
        let sheet = Sheet { material, thickness: t, temperature };
        let curve =
            kind.curve(&sheet).map_err(|e| source.error(&format!("forming_limit.{name}"), e.message, e.help))?;
        curve.notes.iter().for_each(|note| source.note(note.clone()));
        if heat.is_some() && !is_points {
            let celsius = Amount::temperature(temperature - ZERO_CELSIUS);
            source.note(format!("forming limit: computed at {celsius}, the lowest initial temperature"));
        }
        Ok(Some(curve))
    }

    fn points(&self, source: &Source) -> Result<Option<Points>> {
        let Some(points) = &self.points else { return Ok(None) };
        let what = "`points` do not say which strains they are";
        let help = "add strain = \"logarithmic\" (true strain) or strain = \"engineering\"";
        let strain = self.strain.ok_or_else(|| source.error("forming_limit.points", what, help))?;
        let points = points.iter().map(|(minor, major)| [minor.value(), major.value()]).collect();
        Ok(Some(Points { points, strain }))
    }
}
