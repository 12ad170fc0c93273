//! The built-in materials, and the forming limits that cases can ask for.

use crate::common::prelude::*;

fn parsed(material: &str, more: &str) -> Result<Case, String> {
    let text = MINIMAL.replace(LAW, &format!("[material]\n{material}\n")) + more;
    case::parse(&text, "case.toml", &[]).map_err(|error| error.render(false))
}

/// Trust: over the whole list: each is a metal, cites its source, and its own text makes the same material in a case.
#[test]
fn every_material_loads_runs_and_cites_its_source() {
    let all = library::materials().unwrap_or_else(|e| panic!("{}", e.render(false)));
    assert!(all.len() >= 13);
    for entry in &all {
        let is_made = entry.about.is_made();
        let has_year = ["19", "20", "made from the band of"].iter().any(|part| entry.about.source().contains(part));
        assert!(has_year, "{}: no year", entry.name);
        let is_graded = ["A", "B", "C"].contains(&entry.about.grade.as_str());
        assert!(is_graded && !entry.about.licence.is_empty(), "{}", entry.name);
        let declared = entry.about.source().contains("declared") || is_made && entry.about.grade == "C";
        assert_eq!(entry.about.grade == "C", declared, "{}: an assumed law is called so", entry.name);
        let n = entry.n().expect("a load maximum");
        // Austenitic steel comes to 0.57.
        assert!((0.05..0.6).contains(&n), "{}: {n}", entry.name);
        let named = parsed(&format!("name = \"{}\"", entry.name), "").unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(named.model().material, entry.material);
        assert_eq!(named.sources.material.as_deref(), Some(entry.about.source()));
        let pasted = parsed(entry.text.trim_start_matches("[material]"), "");
        assert_eq!(pasted.unwrap_or_else(|e| panic!("{e}")).model().material, entry.material);
        let limit = parsed(&format!("name = \"{}\"", entry.name), "[forming_limit]\nmarciniak_kuczynski = {}");
        // Woo's law falls by 0.1 % where its branches meet: there a groove's equations have no solution, and say so.
        if entry.name == "woo-1968" {
            assert!(limit.expect_err("no curve").contains("have no solution beyond"));
        } else {
            let top =
                limit.unwrap_or_else(|e| panic!("{e}")).model().forming_limit.as_ref().expect("a curve").plane_strain();
            // Where the stress feels the rate, a neck grows on for a while.
            let range = 0.5 * n..if entry.material.rate.is_some() { 1.3 * n } else { n };
            assert!(range.contains(&top), "{}: a groove necks before the load maximum: {top} {n}", entry.name);
        }
    }
}

/// Trust: ferrite is bcc, aluminium and austenite fcc; benchmarks solved by von Mises, and a metal without a name, keep it.
#[test]
fn library_sheets_yield_and_neck_as_their_metal_does() {
    for (name, exponent, limit) in [
        ("drawing-steel", Some(6.0), "Keeler-Brazier"),
        ("if-steel", Some(6.0), "Keeler-Brazier"),
        ("radioss-steel", Some(6.0), "Keeler-Brazier"),
        ("trip690", Some(6.0), "Hill and Swift"),
        ("aisi304l-bar", Some(8.0), "Hill and Swift"),
        ("stainless-304", Some(8.0), "Hill and Swift"),
        ("stainless-430", Some(6.0), "Keeler-Brazier"),
        ("aa6016-t4", Some(8.0), "Hill and Swift"),
        ("aa6016a-surfalex", Some(8.0), "Points"),
        ("woo-1968", None, "Hill and Swift"),
    ] {
        let case = parsed(&format!("name = \"{name}\""), "").unwrap_or_else(|e| panic!("{e}"));
        let found = match case.model().material.yield_criterion {
            YieldCriterion::Hosford(hosford) => Some(hosford.exponent()),
            YieldCriterion::Hill48(_) => None,
        };
        assert_eq!(found, exponent, "{name}");
        assert_eq!(case.model().forming_limit.as_ref().expect("a curve").name, limit, "{name}");
        let without = parsed(&format!("name = \"{name}\""), "[forming_limit]\nnone = true");
        assert!(without.unwrap_or_else(|e| panic!("{e}")).model().forming_limit.is_none(), "{name}");
    }
    for name in ["superplastic_dome", "warm_cup", "woo_porous"] {
        let case = shipped_case(name, &[]);
        let says_so = case.derived.iter().any(|note| note.contains("no forming limit"));
        assert!(case.model().forming_limit.is_none() && says_so, "{name}");
    }
}

/// Trust: EN 10130 as Tata Steel tabulates it (DC06), a mill's leaflet (1999) and a directory (n): yield stress, tensile strength
/// [MPa], r and n at least.
#[test]
fn a_grade_is_the_sheet_that_stands_for_it_and_keeps_its_limits() {
    for (word, name) in [
        ("DC04", "dc04"),
        ("dc 04", "dc04"),
        ("1.0338", "dc04"),
        ("St 14", "dc04"),
        ("DC01", "dc01"),
        ("aa6016", "aa6016-t4"),
        ("AA6016-T4", "aa6016-t4"),
        ("EN AW-6016", "en-aw-6016"),
        ("woo", "woo-1968"),
        ("DC06", "dc06"),
        ("1.4307", "aisi304l-bar"),
        ("1.4301", "1.4301"),
        ("AISI 430", "1.4016"),
        ("AA5754", "aa5754-o"),
        ("HCT690T", "trip690"),
    ] {
        let entry = library::material(word).unwrap_or_else(|e| panic!("{word}: {}", e.render(false)));
        assert_eq!(entry.name, name, "{word}");
        let case = parsed(&format!("name = {word:?}"), "").unwrap_or_else(|e| panic!("{e}"));
        assert_eq!(case.model().material, entry.material);
    }
    for (grade, yields, strength, r, n) in [
        ("DC04", 210.0, 270.0..=350.0, 1.6, 0.18),
        ("drawing-steel", 210.0, 270.0..=350.0, 1.6, 0.18),
        ("radioss-steel", 280.0, 270.0..=410.0, 0.0, 0.0),
        ("if-steel", 170.0, 270.0..=330.0, 2.1, 0.22),
    ] {
        let entry = library::material(grade).expect("a sheet");
        assert!(entry.proof_stress() <= yields, "{grade}: {}", entry.proof_stress());
        let found = entry.tensile_strength().expect("a maximum");
        assert!(strength.contains(&found), "{grade}: {found}");
        assert!(entry.material.yield_criterion.ratio() >= r && entry.n().expect("a maximum") > n - 1e-5, "{grade}");
    }
}

/// Trust: by hand for σ = k (ε₀ + ε)^n: Considère at ε = n − ε₀; the maximum is searched in steps and bisected.
#[test]
fn a_tension_test_is_computed_from_the_law() {
    let entry = library::material("drawing-steel").expect("a sheet");
    let (k, n, offset) = (549.03_f64, 0.22_f64, 0.007);
    assert!((entry.proof_stress() - k * (offset + 0.002_f64).powf(n)).abs() < 1e-9);
    let strength = k * n.powf(n) * (offset - n).exp();
    assert!((entry.tensile_strength().expect("a maximum") / strength - 1.0).abs() < 1e-6);
    assert!((entry.uniform_elongation().expect("a maximum") - (n - offset).exp_m1()).abs() < 1e-6);
}

/// Trust: over the whole list: a law written with the examples of its own schema is accepted and named by the summary's
/// formula, each parameter that is none is refused at its key, and its description names its source.
#[test]
fn every_law_is_read_as_its_schema_says_and_refuses_what_is_no_parameter() {
    let schema: serde_json::Value = serde_json::from_str(&case::schema()).expect("JSON");
    let mut tried = Vec::new();
    for (family, key) in
        [("Hardening", "hardening"), ("Rate", "rate"), ("ThermalLaw", "softening"), ("FrictionLaw", "friction")]
    {
        for (name, law) in schema["$defs"][family]["properties"].as_object().expect("laws") {
            let text = law.to_string();
            let referred = text.split("#/$defs/").nth(1).and_then(|rest| rest.split('"').next()).expect("a definition");
            let law = &schema["$defs"][referred];
            let description = law["description"].as_str().expect("a description");
            assert!(description.contains("Source: "), "{family} {name}: {description}");
            // Friction is none of the material's.
            if family == "FrictionLaw" {
                continue;
            }
            let parameters = law["properties"].as_object().expect("parameters");
            // Lists have no example.
            let Some(given) =
                parameters.iter().map(|(key, p)| Some((key, p["examples"].get(0)?))).collect::<Option<Vec<_>>>()
            else {
                continue;
            };
            let text = |wrong: Option<&str>| {
                let value = |key: &str, value: &serde_json::Value| match (wrong == Some(key), value.is_string()) {
                    (false, _) => value.to_string(),
                    (true, true) => "\"1 kg\"".to_owned(),
                    (true, false) => "-1".to_owned(),
                };
                let listed: Vec<_> = given.iter().map(|(key, v)| format!("{key} = {}", value(key, v))).collect();
                let hardening = "hardening.ludwik = { initial = \"150 MPa\", k = \"400 MPa\", n = 0.5 }";
                let hardening = if family == "Hardening" { "" } else { hardening };
                format!("{key}.{name} = {{ {} }}\n{hardening}", listed.join(", "))
            };
            parsed(&text(None), "").unwrap_or_else(|e| panic!("{name}: {e}"));
            for (parameter, _) in &given {
                let error = parsed(&text(Some(parameter)), "").expect_err(parameter);
                assert!(error.contains(&format!("material.{key}.{name}.{parameter}")), "{name}: {error}");
            }
            tried.push(name.clone());
        }
    }
    assert!(tried.len() >= 11 && tried.contains(&"swift".to_owned()), "{tried:?}");
}

/// Trust: thickness in inches is the same sheet; 0.21 for n and 1 mm give 37.43 %.
#[test]
fn every_kind_of_limit_makes_a_curve() {
    let at = |limit: &str| {
        let case = parsed("name = \"drawing-steel\"", &format!("[forming_limit]\n{limit}"));
        case.unwrap_or_else(|e| panic!("{e}")).model().forming_limit.as_ref().expect("a curve").plane_strain()
    };
    let inches = at("keeler_brazier = { thickness = \"0.0393700787 in\" }\nn = 0.21");
    assert!((inches - 1.3743_f64.ln()).abs() < 1e-9 && (inches - at("keeler_brazier = {}\nn = 0.21")).abs() < 1e-9);
    // n − ε₀ = 0.213 of the law in tension; in plane strain by r̄ = 1.6 with a smaller share of the offset.
    let (hill, swift) = (at("hill = true"), at("swift = true"));
    assert!((hill - swift).abs() < 1e-9 && (0.21..0.22).contains(&hill), "{hill} {swift}");
    let groove = at("marciniak_kuczynski = {}");
    assert!(groove < hill && groove > 0.6 * hill, "{groove} {hill}");
}
