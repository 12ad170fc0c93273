//! The measured forming limit of a sheet of the library, and the table that is made of it.

use crate::common::page::{plain, told};
use crate::common::surfalex::{fitted, measured, table};
use stampflow::assess::{self, Light};
use stampflow::author::templates;
use stampflow::case::{self, library};

const DOCUMENT: &str = include_str!("../../docs/surfalex_limit.md");

/// Trust: the points of the library are the means of what was measured, to the digits that they are written with.
#[test]
fn the_points_of_the_library_are_the_means_of_the_data() {
    let sheet = library::material("aa6016a-surfalex").expect("a sheet");
    let curve = sheet.measured_limit.expect("a measured limit");
    let widths = measured();
    assert_eq!((widths.len(), curve.points().len()), (6, 6));
    for (point, width) in curve.points().iter().zip(&widths) {
        let mean = width.mean(0);
        assert!((point[0] - mean.minor[0]).abs() < 6e-5 && (point[1] - mean.major[0]).abs() < 6e-5, "{}", width.name);
    }
}

/// Trust: the document has what the program prints, and the program's words of what came out hold: the misses of the fitted
/// widths cancel to the precision of the fit, and both conditions agree up to plane strain within the scatter of the means.
#[test]
fn the_document_has_the_table_that_the_program_makes() {
    let widths = measured();
    let fitted = fitted(&widths);
    let lines = table(&widths, &fitted);
    for line in &lines {
        assert!(DOCUMENT.contains(line.as_str()), "not in the document:\n{}", lines.join("\n"));
    }
    for one in &fitted {
        let [a, b] = [2, 3].map(|i| one.miss(&widths[i]).expect("a limit"));
        // The limit itself settles to 0.2 %.
        assert!((a + b).abs() < 4e-3, "{a} {b}");
    }
    let [hill, hosford] = [0, 1].map(|i| fitted[i].miss(&widths[5]).expect("a limit"));
    let most =
        (0..widths.len()).filter_map(|i| fitted[1].miss(&widths[i])).fold(0.0_f64, |most, miss| most.max(miss.abs()));
    assert!(hosford.abs() < 0.5 * hill, "{hill} {hosford}");
    told(
        "docs/agreement.md",
        "fitted at two of six widths: within {} by Hosford's condition, {} too high at the full circle by Hill's",
        &plain(&[most, hill], 3),
    );
}

/// Trust: a hemispherical cup is held against what was measured, and nothing of it is computed.
#[test]
fn a_cup_of_the_sheet_is_held_against_its_measured_limit() {
    let given = [("material", "aa6016a-surfalex"), ("thickness", "1.5 mm")];
    let text = templates::find("hemispherical-cup").and_then(|template| template.fill(&given)).expect("a case");
    assert!(text.contains("measured = true") && !text.contains("hill = true"), "{text}");
    let case = case::parse(&text, "made.toml", &[]).expect("valid");
    let curve = case.model().forming_limit.clone().expect("a limit");
    assert_eq!(
        Some(&curve),
        library::material("aa6016a-surfalex").expect("a sheet").measured_limit.as_ref().map(|_| &curve)
    );
    assert!(curve.is_measured() && (curve.major_at(0.0915) - 0.2616).abs() < 1e-12);
    assert!(case.derived.iter().any(|note| note.to_string().contains("measured points of aa6016a-surfalex")));
    let solution = case.solve(&mut ());
    let found = assess::after(&solution.case, &solution.stages);
    let limit = found.iter().find(|finding| finding.key == "forming_limit").expect("a row");
    assert!(limit.light != Light::Grey && limit.limit.to_string().starts_with("Points"), "{limit:?}");
    // Of a sheet without measured points, and of none, the case says what is missing.
    for (from, to) in [
        ("aa6016a-surfalex", "drawing-steel"),
        ("name = \"aa6016a-surfalex\"", "hardening.swift = { k = \"500 MPa\", n = 0.2, offset = 0.01 }"),
    ] {
        let error = case::parse(&text.replace(from, to), "made.toml", &[]).expect_err("no points");
        assert!(error.to_string().contains("names none that has some"), "{error}");
    }
}
