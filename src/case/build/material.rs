//! `[material]`: elastic constants and exactly one hardening law.

use super::{softening, voids};
use crate::case::file::{self, Beyond};
use crate::case::{CaseError, explain::missing, source::Source};
use crate::material::hardening::{
    Branch, Extrapolation, Hollomon, Isotherms, LawError, Ludwik, PiecewisePower, Swift, Table, Voce,
};
use crate::material::rate::{CowperSymonds, JohnsonCook, PowerRate};
use crate::material::{BackStress, BackStresses, Elastic, Hardening, Hill48, Material, Rate};
use crate::model::Mode;
use crate::units::Quantity;
use std::ops::RangeInclusive;

/// Normal anisotropy of sheet metals, with room \[–\].
const RATIO: RangeInclusive<f64> = 0.1..=10.0;

const HARDENING: &str = "material.hardening";

/// Yield stress at 10 % strain, from hot superplastic alloys far below to piano wire far above \[MPa\].
const YIELD: RangeInclusive<f64> = 0.1..=1e5;

pub(in crate::case) fn convert(file: &file::Material, source: &Source) -> Result<Material, CaseError> {
    let elastic = match (file.young, file.poisson) {
        (None, None) => None,
        (Some(young), Some(poisson)) => Some(Elastic { young: young.value(), poisson: poisson.value() }),
        (Some(_), None) => return Err(missing(source, "material", "poisson")),
        (None, Some(_)) => return Err(missing(source, "material", "young")),
    };
    if let Some(Elastic { poisson, .. }) = elastic.filter(|e| e.poisson >= 0.5) {
        let what = format!("`poisson` must be below 0.5, found {poisson}");
        return Err(source.error("material.poisson", what, "0.3 for steel, 0.33 for aluminium"));
    }
    let hardening = hardening(&file.hardening, elastic, source)?;
    let stress = hardening.at(0.1).stress;
    if !YIELD.contains(&stress) {
        let what = format!("the law has a yield stress of {stress:.3e} MPa at a strain of 0.1: no metal has");
        let help = format!("between {} and {} MPa; check the units of the constants", YIELD.start(), YIELD.end());
        return Err(source.error(HARDENING, what, help));
    }
    let r = file.anisotropy.map_or(1.0, Quantity::value);
    if !RATIO.contains(&r) {
        let what = format!("`anisotropy` must lie between {} and {}, found {r}", RATIO.start(), RATIO.end());
        return Err(source.error("material.anisotropy", what, "0.6 to 0.8 for aluminium, 1 to 2 for steel"));
    }
    let rate = file.rate.map(|laws| rate(laws, source)).transpose()?;
    let softening = file.softening.map(|laws| softening::convert(laws, source)).transpose()?;
    let voids = file.voids.map(|law| voids::convert(law, source)).transpose()?;
    Ok(Material {
        hardening,
        elastic,
        rate,
        softening,
        anisotropy: Hill48::new(r),
        kinematic: kinematic(&file.kinematic, file.mode, source)?,
        voids,
    })
}

/// At most two back-stresses, of a sheet that is not left to the flow law alone.
fn kinematic(file: &[file::BackStress], mode: Option<Mode>, source: &Source) -> Result<BackStresses, CaseError> {
    let mut kinematic = BackStresses::default();
    if file.len() > kinematic.len() {
        let what = format!("{} back-stresses are given, more than {}", file.len(), kinematic.len());
        return Err(source.error("material.kinematic.2", what, "keep the two that matter"));
    }
    if !file.is_empty() && mode != Some(Mode::ElastoViscoplastic) {
        let help = "write mode = \"elasto_viscoplastic\", or drop it";
        return Err(source.error("material.kinematic.0", "the flow law has no back-stresses", help));
    }
    for (law, file) in kinematic.iter_mut().zip(file) {
        *law = BackStress { modulus: file.modulus.value(), dynamic_recovery: file.recall.map_or(0.0, Quantity::value) };
    }
    Ok(kinematic)
}

/// How the metal answers to strain, where it has what that takes.
pub(super) fn mode(mode: Mode, material: &Material, path: &str, source: &Source) -> Result<Mode, CaseError> {
    if mode != Mode::Flow && material.elastic.is_none() {
        let help = "add young = \"210 GPa\" and poisson = 0.3 to [material]";
        return Err(source.error(path, "an elastic sheet needs Young's modulus and Poisson's ratio", help));
    }
    if mode != Mode::Flow && material.voids.is_some() {
        let help = "drop [material.voids], or write mode = \"flow\"";
        return Err(source.error(path, "a sheet with voids has no elastic strains", help));
    }
    Ok(mode)
}

/// Exactly one rate law.
fn rate(file: file::Rate, source: &Source) -> Result<Rate, CaseError> {
    let power =
        file.power.map(|l| Rate::Power(PowerRate { exponent: l.exponent.value(), reference: l.reference.value() }));
    let cowper_symonds = file
        .cowper_symonds
        .map(|l| Rate::CowperSymonds(CowperSymonds { rate: l.rate.value(), exponent: l.exponent.value() }));
    let johnson_cook = file
        .johnson_cook
        .map(|l| Rate::JohnsonCook(JohnsonCook { coefficient: l.coefficient.value(), reference: l.reference.value() }));
    let names = "power, cowper_symonds, johnson_cook";
    super::only_one([power, cowper_symonds, johnson_cook], "material.rate", names, source)
}

fn hardening(file: &file::Hardening, elastic: Option<Elastic>, source: &Source) -> Result<Hardening, CaseError> {
    type Law<'a> = Box<dyn Fn() -> Result<Hardening, CaseError> + 'a>;
    let law = |name: &'static str| {
        move |error: LawError| {
            let key = match error.key.split_once('.') {
                // Points are pairs of strain and stress.
                Some(("strain", i)) if source.has(&format!("{HARDENING}.{name}.points")) => format!("points.{i}.0"),
                Some(("stress", i)) if source.has(&format!("{HARDENING}.{name}.points")) => format!("points.{i}.1"),
                _ => error.key.clone(),
            };
            source.error(
                format!("{HARDENING}.{name}.{key}").trim_end_matches('.'),
                format!("{name}: {error}"),
                "check the constants and their units",
            )
        }
    };
    let laws: [(&str, Option<Law>); 7] = [
        ("swift", file.swift.as_ref().map(|l| -> Law { Box::new(|| swift(l).map_err(law("swift"))) })),
        (
            "hollomon",
            file.hollomon
                .as_ref()
                .map(|l| -> Law { Box::new(|| hollomon(l, elastic, source)?.map_err(law("hollomon"))) }),
        ),
        ("ludwik", file.ludwik.as_ref().map(|l| -> Law { Box::new(|| ludwik(l).map_err(law("ludwik"))) })),
        ("voce", file.voce.as_ref().map(|l| -> Law { Box::new(|| voce(l).map_err(law("voce"))) })),
        ("table", file.table.as_ref().map(|l| -> Law { Box::new(|| table(l, source)?.map_err(law("table"))) })),
        (
            "piecewise_power",
            file.piecewise_power.as_ref().map(|l| -> Law { Box::new(|| branches(l).map_err(law("piecewise_power"))) }),
        ),
        ("isotherms", file.isotherms.as_ref().map(|l| -> Law { Box::new(|| isotherms(l).map_err(law("isotherms"))) })),
    ];
    let given: Vec<&(&str, Option<Law>)> = laws.iter().filter(|(_, law)| law.is_some()).collect();
    match given[..] {
        [(_, Some(law))] => law(),
        [] => {
            let all: Vec<&str> = laws.iter().map(|(name, _)| *name).collect();
            let help = format!("write one of [{HARDENING}.…]: {}", all.join(", "));
            Err(source.error(HARDENING, "the material has no hardening law", help))
        }
        [..] => {
            let names: Vec<String> = given.iter().map(|(name, _)| format!("`{name}`")).collect();
            let what = format!("the material has {} hardening laws: {}", given.len(), names.join(" and "));
            Err(source.error(&format!("{HARDENING}.{}", given[1].0), what, "keep one of them"))
        }
    }
}

fn swift(l: &file::Swift) -> Result<Hardening, LawError> {
    Swift::new(l.k.value(), l.n.value(), l.offset.value()).map(Hardening::Swift)
}

fn hollomon(
    l: &file::Hollomon,
    elastic: Option<Elastic>,
    source: &Source,
) -> Result<Result<Hardening, LawError>, CaseError> {
    let (k, n) = (l.k.value(), l.n.value());
    let law = match (l.offset, elastic) {
        (Some(offset), _) => Hollomon::with_offset(k, n, offset.value()),
        (None, Some(elastic)) => Hollomon::from_elastic_line(k, n, elastic.young),
        (None, None) => {
            let what = "hollomon: k ε^n has no stress at ε = 0; it needs an `offset`, or `young` to start from";
            let help = "add offset = 0.001 to the law, or young = \"210 GPa\" and poisson = 0.3 to [material]";
            return Err(source.error("material.hardening.hollomon", what, help));
        }
    };
    Ok(law.map(Hardening::Hollomon))
}

fn ludwik(l: &file::Ludwik) -> Result<Hardening, LawError> {
    Ludwik::new(l.initial.value(), l.k.value(), l.n.value()).map(Hardening::Ludwik)
}

fn voce(l: &file::Voce) -> Result<Hardening, LawError> {
    let exponent = l.exponent.map_or(1.0, Quantity::value);
    Voce::new(l.initial.value(), l.saturation.value(), l.rate.value(), exponent).map(Hardening::Voce)
}

fn table(l: &file::Table, source: &Source) -> Result<Result<Hardening, LawError>, CaseError> {
    let (strain, stress) = match (&l.points, &l.strain, &l.stress) {
        (Some(points), None, None) => points.iter().map(|(strain, stress)| (strain.value(), stress.value())).unzip(),
        (None, Some(strain), Some(stress)) => {
            (strain.iter().map(|s| s.value()).collect(), stress.iter().map(|s| s.value()).collect())
        }
        _ => {
            let help = "write points = [[0, \"150 MPa\"], [0.1, \"290 MPa\"]], or both strain = [..] and stress = [..]";
            return Err(source.error(
                "material.hardening.table",
                "table: needs `points`, or `strain` and `stress`",
                help,
            ));
        }
    };
    Ok(Table::new(strain, stress, beyond(l.extrapolation)).map(Hardening::Table))
}

fn beyond(file: Beyond) -> Extrapolation {
    match file {
        Beyond::Hold => Extrapolation::Hold,
        Beyond::Slope => Extrapolation::Slope,
    }
}

fn isotherms(l: &file::Isotherms) -> Result<Hardening, LawError> {
    let curve = |(i, curve): (usize, &file::Isotherm)| {
        let (strain, stress) = curve.points.iter().map(|(strain, stress)| (strain.value(), stress.value())).unzip();
        Table::new(strain, stress, beyond(l.extrapolation)).map_err(|error| {
            // Points are pairs of strain and stress.
            let key = match error.key.split_once('.') {
                Some(("strain", point)) => format!("curves.{i}.points.{point}.0"),
                Some((_, point)) => format!("curves.{i}.points.{point}.1"),
                None => format!("curves.{i}.points"),
            };
            LawError { message: format!("curve {}: {}", i + 1, error.message), key }
        })
    };
    let curves = l.curves.iter().enumerate().map(curve).collect::<Result<_, _>>()?;
    let temperatures = l.curves.iter().map(|curve| curve.temperature.value()).collect();
    Isotherms::new(temperatures, curves).map(Hardening::Isotherms)
}

fn branches(l: &file::PiecewisePower) -> Result<Hardening, LawError> {
    let branch = |b: &file::Branch| Branch {
        up_to: b.up_to.map_or(f64::INFINITY, Quantity::value),
        initial: b.initial.value(),
        k: b.k.value(),
        n: b.n.value(),
    };
    PiecewisePower::new(l.branches.iter().map(branch).collect()).map(Hardening::PiecewisePower)
}
