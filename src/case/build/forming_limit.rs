//! `[forming_limit]`: exactly one curve, computed once.

use crate::case::file::{self, StrainMeasure};
use crate::case::{CaseError, source::Source};
use crate::forming_limit::{Curve, Hill, KeelerBrazier, Kind, MarciniakKuczynski, Points, Sheet, Strain, Swift};
use crate::material::Material;
use crate::material::flow::ROOM_TEMPERATURE;
use crate::model::Heat;
use crate::units::{Number, Quantity, ZERO_CELSIUS, rounded};
use std::ops::RangeInclusive;

const PATH: &str = "forming_limit";

/// Grooves that make sense \[–\]: nearer to 1 a step cannot tell them from none.
const IMPERFECTION: RangeInclusive<f64> = 0.9..=0.9999;

pub(super) fn convert(
    file: &file::FormingLimit,
    material: &Material,
    thickness: f64,
    heat: Option<&Heat>,
    source: &Source,
    derived: &mut Vec<String>,
) -> Result<Curve, CaseError> {
    let n = file.n.map(Quantity::value);
    let points = file.points.as_ref().map(|points| self::points(points, file.strain, source)).transpose()?;
    let groove = file.marciniak_kuczynski.map(|groove| self::groove(groove, source)).transpose()?;
    let kinds = [
        points.map(|kind| ("points", Kind::Points(kind))),
        file.keeler_brazier.map(|_| ("keeler_brazier", Kind::KeelerBrazier(KeelerBrazier { n }))),
        file.hill.filter(|on| *on).map(|_| ("hill", Kind::Hill(Hill { n }))),
        file.swift.filter(|on| *on).map(|_| ("swift", Kind::Swift(Swift { n }))),
        groove.map(|kind| ("marciniak_kuczynski", Kind::MarciniakKuczynski(kind))),
    ];
    let names = "points, keeler_brazier, hill, swift, marciniak_kuczynski";
    let (name, kind) = super::only_one(kinds, PATH, names, source)?;
    if n.is_some() && matches!(kind, Kind::Points(_) | Kind::MarciniakKuczynski(_)) {
        let what = format!("`n` has no part in `{name}`");
        return Err(source.error("forming_limit.n", what, "drop it"));
    }
    if n == Some(0.0) {
        return Err(source.error("forming_limit.n", "`n` must be above 0", "0.1 to 0.3 is usual"));
    }
    if file.strain.is_some() && !matches!(kind, Kind::Points(_)) {
        let what = format!("`strain` has no part in `{name}`, whose strains are logarithmic");
        return Err(source.error("forming_limit.strain", what, "drop it"));
    }
    let temperature = heat.map_or(ROOM_TEMPERATURE, |heat| heat.initial.smallest());
    let counted = file.keeler_brazier.and_then(|k| k.thickness).map_or(thickness, Quantity::value);
    let sheet = Sheet { material, thickness: counted, temperature };
    let curve = kind.curve(&sheet).map_err(|e| source.error(&format!("{PATH}.{name}"), e.message, e.help))?;
    derived.extend(curve.notes.iter().cloned());
    if heat.is_some() && !matches!(kind, Kind::Points(_)) {
        let celsius = rounded(temperature - ZERO_CELSIUS);
        derived.push(format!("forming limit: computed at {celsius} °C, the lowest initial temperature"));
    }
    Ok(curve)
}

fn points(points: &[(Number, Number)], strain: Option<StrainMeasure>, source: &Source) -> Result<Points, CaseError> {
    let Some(strain) = strain else {
        let what = "`points` do not say which strains they are";
        let help = "add strain = \"logarithmic\" (true strain) or strain = \"engineering\"";
        return Err(source.error("forming_limit.points", what, help));
    };
    let strain = match strain {
        StrainMeasure::Logarithmic => Strain::True,
        StrainMeasure::Engineering => Strain::Engineering,
    };
    Ok(Points { points: points.iter().map(|(minor, major)| [minor.value(), major.value()]).collect(), strain })
}

fn groove(file: file::MarciniakKuczynski, source: &Source) -> Result<MarciniakKuczynski, CaseError> {
    let imperfection = file.imperfection.map_or(MarciniakKuczynski::IMPERFECTION, Quantity::value);
    if !IMPERFECTION.contains(&imperfection) {
        let what = format!(
            "`imperfection` must lie between {} and {}, found {imperfection}",
            IMPERFECTION.start(),
            IMPERFECTION.end()
        );
        let help = "it is the groove's thickness over the sheet's: 0.98 to 0.999 is usual";
        return Err(source.error("forming_limit.marciniak_kuczynski.imperfection", what, help));
    }
    let strain_rate = file.strain_rate.map_or(MarciniakKuczynski::STRAIN_RATE, Quantity::value);
    Ok(MarciniakKuczynski { imperfection, strain_rate })
}
