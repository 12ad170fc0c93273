//! `[forming_limit]`: exactly one curve, computed once.

use super::material::{blame, not_one};
use crate::case::file;
use crate::case::{CaseError, source::Source};
use crate::forming_limit::{Curve, Hill, KeelerBrazier, Kind, Points, Sheet, Strain, Swift};
use crate::material::Material;
use crate::material::flow::ROOM_TEMPERATURE;
use crate::model::Heat;
use crate::units::{Amount, Dimensioned, Number, ZERO_CELSIUS};

const PATH: &str = "forming_limit";

pub(super) fn convert(
    file: &file::FormingLimit,
    material: &Material,
    thickness: f64,
    heat: Option<&Heat>,
    source: &Source,
) -> Result<Curve, CaseError> {
    let n = file.n.map(Dimensioned::value);
    let points = file.points.as_ref().map(|points| self::points(points, file.strain, source)).transpose()?;
    if let Some(groove) = &file.marciniak_kuczynski {
        groove.check().map_err(|error| blame(error, "forming_limit.marciniak_kuczynski", source))?;
    }
    // Points of the library stand among `points` by now.
    let what = "`measured` takes the points of a sheet of the library, and this case names none that has some";
    let help =
        "write points of the coil, or hill = true; `stampflow materials NAME` says which sheets have measured limits";
    source.require(file.measured != Some(true), "forming_limit.measured", what, help)?;
    let kinds = [
        points.map(|kind| ("points", Kind::Points(kind))),
        file.keeler_brazier.map(|kind| ("keeler_brazier", Kind::KeelerBrazier(KeelerBrazier { n, ..kind }))),
        file.hill.filter(|on| *on).map(|_| ("hill", Kind::Hill(Hill { n }))),
        file.swift.filter(|on| *on).map(|_| ("swift", Kind::Swift(Swift { n }))),
        file.marciniak_kuczynski.map(|kind| ("marciniak_kuczynski", Kind::MarciniakKuczynski(kind))),
    ];
    let names = "points, measured, keeler_brazier, hill, swift, marciniak_kuczynski";
    let mut given = kinds.into_iter().flatten();
    let (name, kind) = match (given.next(), given.next()) {
        (Some(only), None) => only,
        (first, _) => return Err(not_one(first.iter().count(), PATH, names, source)),
    };
    let is_points = matches!(kind, Kind::Points(_));
    let without_n = n.is_none() || !(is_points || matches!(kind, Kind::MarciniakKuczynski(_)));
    source.require(without_n, "forming_limit.n", format!("`n` has no part in `{name}`"), "drop it")?;
    source.require(n != Some(0.0), "forming_limit.n", "`n` must be above 0", "0.1 to 0.3 is usual")?;
    let what = format!("`strain` has no part in `{name}`, whose strains are logarithmic");
    source.require(file.strain.is_none() || is_points, "forming_limit.strain", what, "drop it")?;
    let temperature = heat.map_or(ROOM_TEMPERATURE, |heat| heat.initial.smallest());
    let sheet = Sheet { material, thickness, temperature };
    let curve = kind.curve(&sheet).map_err(|e| source.error(&format!("{PATH}.{name}"), e.message, e.help))?;
    curve.notes.iter().for_each(|note| source.note(note.clone()));
    if heat.is_some() && !is_points {
        let celsius = Amount::temperature(temperature - ZERO_CELSIUS);
        source.note(format!("forming limit: computed at {celsius}, the lowest initial temperature"));
    }
    Ok(curve)
}

/// Curve of a sheet's measured points.
pub(in crate::case) fn measured(file: &file::FormingLimit, sheet: &Sheet, source: &Source) -> Result<Curve, CaseError> {
    let points = points(file.points.as_deref().unwrap_or_default(), file.strain, source)?;
    Kind::Points(points).curve(sheet).map_err(|e| source.error("forming_limit.points", e.message, e.help))
}

fn points(points: &[(Number, Number)], strain: Option<Strain>, source: &Source) -> Result<Points, CaseError> {
    let Some(strain) = strain else {
        let help = "add strain = \"logarithmic\" (true strain) or strain = \"engineering\"";
        return Err(source.error("forming_limit.points", "`points` do not say which strains they are", help));
    };
    Ok(Points { points: points.iter().map(|(minor, major)| [minor.value(), major.value()]).collect(), strain })
}
