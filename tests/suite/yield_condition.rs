//! Yield conditions: lights where Hill's is known to be wrong, and the order of metals on a dome.

use crate::common::prelude::*;
use stampflow::forming_limit;

/// A hemispherical cup of AA6016-T4, its dome stretched both ways.
fn cup(overrides: &[&str]) -> Case {
    made("hemispherical-cup", &[("material", "aa6016-t4")], overrides)
}

fn solved(overrides: &[&str]) -> (Solution, Vec<Finding>) {
    let solution = cup(overrides).solve(&mut ());
    let found = findings(&solution);
    (solution, found)
}

const HILL: &str = "material.yield_condition=hill48";
const HOSFORD: &str = "material.yield_condition={ hosford = { crystal = \"fcc\" } }";

/// Trust: the advised line, written into the case, takes the doubt away; a limit that ends, by any of the computed curves,
/// neither turns green nor lets the rule of thumb off.
#[test]
fn a_low_r_by_hill_is_doubted() {
    let (_, with_hosford) = solved(&[HOSFORD]);
    let groove = ["forming_limit.marciniak_kuczynski={}", "forming_limit.hill=false"];
    for limit in [&["forming_limit.hill=true"][..], &groove] {
        let (solution, found) = solved(&[&[HILL], limit].concat());
        let doubted = row(&found, "yield_condition");
        assert_eq!(doubted.light, Light::Amber, "{doubted:?}");
        let line = "yield_condition = { hosford = { crystal = \"fcc\" } }";
        assert!(doubted.advice.to_string().contains(line), "{doubted:?}");
        let held = row(&found, "forming_limit");
        assert!(held.light == Light::Amber && held.statement().starts_with("not judged"), "{held:?}");
        assert_eq!(row(&found, "thinning").light, Light::Red, "the rule of thumb stays");
        assert!(Answer::of(&solution.case, &solution.stages, &found).light == Light::Red);
    }
    let trusted = row(&with_hosford, "yield_condition");
    assert!(trusted.light == Light::Green && trusted.advice.is_empty(), "{trusted:?}");
    assert!(row(&with_hosford, "forming_limit").light != Light::Grey);
}

/// Trust: limiting draw ratios of 2.5 to 2.7 by Hill's condition at r̄ 1.6 to 2, where steel draws 2.0 to 2.4.
#[test]
fn a_high_r_by_hill_is_doubted() {
    for (overrides, light) in [(&[][..], Light::Green), (&[HILL], Light::Amber)] {
        let found = findings(&made("cup", &[("material", "drawing-steel")], overrides).solve(&mut ()));
        assert_eq!(row(&found, "yield_condition").light, light, "{:?}", row(&found, "yield_condition"));
    }
}

/// Travels at which the forming limit is first reached and at which the load is largest \[mm\].
fn travels(template: &str, material: &str, sizes: &[(&str, &str)], overrides: &[&str]) -> [f64; 2] {
    let sizes: Vec<_> = sizes.iter().copied().chain([("material", material)]).collect();
    let model = made(template, &sizes, overrides).model().clone();
    let run = solver::run(&model, &mut ());
    let reached = forming_limit::assess(model.forming_limit.as_ref().expect("one"), &run.paths).expect("paths").reached;
    let peak = run.steps.iter().max_by(|a, b| a.punch_force.total_cmp(&b.punch_force)).expect("steps");
    [reached.expect("it necks").travel, peak.travel]
}

/// Trust: DC04 of 1 mm has an Erichsen index of 10 to 11.5 mm, and more than AA6016 on any dome.
#[test]
fn dc04_is_stretched_further_than_aluminium() {
    let index = travels("erichsen", "drawing-steel", &[], &[]);
    assert!(index.iter().all(|travel| (10.0..11.5).contains(travel)), "{index:?}");
    let dome = |material: &str| {
        let set = ["tools.punch.travel=35 mm", "stop.localised=false", "stop.load_drop=2 %"];
        travels("stretch-dome", material, &[("punch-radius", "25 mm"), ("height", "25 mm")], &set)
    };
    let [steel, aluminium] = ["drawing-steel", "AA6016"].map(dome);
    assert!(steel[0] > aluminium[0] && steel[1] > aluminium[1], "{steel:?} {aluminium:?}");
}

/// Trust: a producer's index of AISI 304 rises by 2.5 mm from 0.5 to 2 mm (reference_data/erichsen_304.csv); that of steel by
/// Keeler and Brazier's curve by about as much.
#[test]
fn a_thicker_sheet_is_cupped_further() {
    let at = |thickness: &str| travels("erichsen", "drawing-steel", &[("thickness", thickness)], &[]);
    let [thin, thick] = ["0.5 mm", "2 mm"].map(at);
    assert!((1.5..3.5).contains(&(thick[0] - thin[0])) && thick[1] > thin[1] + 1.0, "{thin:?} {thick:?}");
}

/// Trust: by hand, (0.525 + 2 × 0.248 + 0.429)/4; the same model as with the mean, and ears about it that add up to little:
/// two thirds of each other's sign.
#[test]
fn r_by_direction_is_its_mean_and_tells_the_ears() {
    let of = |given: &str| cup(&[given]);
    let directions = of("material.anisotropy={ r0 = 0.525, r45 = 0.248, r90 = 0.429 }");
    assert_eq!(directions.stages, of("material.anisotropy=0.3625").stages);
    let mean = "(r0 + 2 r45 + r90)/4 of 0.525, 0.248 and 0.429";
    assert!(directions.derived.iter().any(|note| note.to_string().contains(mean)), "{:?}", directions.derived);
    let ears = |case: Case| findings(&case.solve(&mut ())).into_iter().find(|finding| finding.key == "ears");
    let found = ears(directions).expect("ears");
    let is_likely = found.value().is_some_and(|height| (0.2..3.0).contains(&height));
    assert!(found.light == Light::Green && is_likely, "{found:?}");
    assert!(ears(of("material.anisotropy=0.3625")).is_none(), "nothing is known of directions");
}
