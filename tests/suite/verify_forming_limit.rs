//! A whole run held against a forming limit, and what it leaves behind.

use crate::common::prelude::*;
use stampflow::forming_limit::{Assessment, SHORTEST, assess};

fn solved(overrides: &[&str]) -> (Case, StageSolution, Assessment) {
    let case = shipped_case("stretch_limit", overrides);
    let run = solver::run(case.model(), &mut ());
    let curve = case.model().forming_limit.as_ref().expect("a curve");
    let assessment = assess(curve, &run.paths).expect("paths");
    (case, run, assessment)
}

/// Trust: the paths end where the last frame is; the thinnest place, which necks in the end, is where the limit is reached
/// first, and the sheet has thinned there; the clamped sheet's pole is stretched alike in both directions.
#[test]
fn a_stretched_sheet_reaches_its_limit_where_it_thins() {
    let (case, run, found) = solved(&[]);
    assert_eq!(run.paths.instants.len(), run.steps.len() + 1, "the start, and every step");
    let last = run.frames.last().expect("a frame");
    for (judged, element) in found.elements.iter().zip(&last.elements) {
        assert_eq!(judged.s0, element.s0);
        assert_eq!(judged.major, element.strain_meridional.max(element.strain_hoop));
        assert_eq!(judged.minor, element.strain_meridional.min(element.strain_hoop));
    }
    let reached = found.reached.expect("the travel goes beyond the limit");
    assert!(reached.travel > 0.0 && reached.travel < case.model().travel, "{reached:?}");
    let thinnest = run.steps.last().expect("steps").thinnest_s0;
    // Within a tenth of the blank: the neck may settle a few elements from where the limit was met.
    assert!((found.worst().s0 - thinnest).abs() < 0.1 * case.model().blank.length, "{:?} {thinnest}", found.worst());
    let pole = found.elements[0];
    assert!(pole.major > SHORTEST && (pole.major - pole.minor).abs() < 0.05 * pole.major, "{pole:?}");
}

#[test]
fn another_curve_moves_the_margin_and_not_the_sheet() {
    let points = |top: f64| format!("forming_limit.points=[[-0.5, {}], [0, {top}], [0.2, {top}]]", top + 0.5);
    let of = |top: f64| solved(&["forming_limit.hill=false", &points(top), "forming_limit.strain=logarithmic"]);
    let ((_, run, low), (_, other, high)) = (of(0.25), of(0.9));
    assert_eq!(run.steps.len(), other.steps.len());
    for (low, high) in low.elements.iter().zip(&high.elements) {
        assert!((high.margin() - low.margin() - 0.65).abs() < 1e-12);
    }
    assert!(low.reached.is_some() && high.reached.is_none());
}
