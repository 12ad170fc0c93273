//! Comparisons of synthetic curves whose answer is known.

use crate::common::prelude::*;
use stampflow::case::comparison::{ComparedQuantity, Source, Spec};
use stampflow::results::comparison::{Comparison, Verdict, compare};

const PROVENANCE: &str = "[\"curve.csv\"]\ncitation = \"A. Uthor, A title, 1990.\"\nkind = \"experiment\"\ngrade = \"A\"\n\
                       scatter = \"5 %\"\n";

/// Force 2 t up to t = 10, then falling; edge diameter 90, draw-in 5 and thinnest 0.8 mm at the end; thickness 1 + s0/100 on elements of 2 mm.
fn history() -> Vec<StepRecord> {
    let falling = |from: f64, to: f64, i: usize| from + (to - from) * i as f64 / 16.0;
    let step = |i: usize| StepRecord {
        travel: i as f64,
        punch_force: if i <= 10 { 2000.0 * i as f64 } else { 40_000.0 - 2000.0 * i as f64 },
        draw_in: falling(0.0, 5.0, i),
        thinnest: falling(1.0, 0.8, i),
        ..StepRecord::default()
    };
    (1..=16).map(step).collect()
}

fn profile() -> Vec<ElementRecord> {
    let element = |s0: f64| ElementRecord { s0, r: 0.9 * s0, thickness: 1.0 + s0 / 100.0, ..ElementRecord::default() };
    (0..10).map(|i| element(1.0 + 2.0 * f64::from(i))).collect()
}

fn against(spec: &Spec, steps: &[StepRecord], complete: bool, paths: Option<(&Paths, &[ElementRecord])>) -> Comparison {
    let own = &profile()[..];
    let (length, elements) = (50.0, paths.map_or(own, |paths| paths.1));
    let paths = paths.map(|paths| paths.0);
    compare(spec, &Computed { extent: Extent::Ring, length, steps, elements, paths, complete, ring: None }).unwrap()
}

/// Of a blank of 50 mm.
fn against_drawn(spec: &Spec, complete: bool) -> Comparison {
    against(spec, &history(), complete, None)
}

fn spec(quantity: ComparedQuantity, columns: &[&str], csv: &str) -> Spec {
    Spec {
        reference: "nowhere/curve.csv".into(),
        data: Some(Csv::read(csv, "the file", "").unwrap()),
        source: Source::of("curve.csv", PROVENANCE).unwrap(),
        quantity,
        columns: columns.iter().map(|&column| column.to_owned()).collect(),
        tolerance: 0.05,
        ..Spec::default()
    }
}

#[test]
fn forces_at_equal_travel_are_interpolated_and_converted() {
    let csv = "# comment\ntravel_mm, punch_force_kN\n1.5, 3\n4, 8.16\n# between\n12,16\n";
    let c = against_drawn(&spec(ComparedQuantity::PunchForce, &["travel_mm", "punch_force_kN"], csv), true);
    let values: Vec<_> = c.points.iter().map(|p| (p.x, p.reference, p.computed.unwrap())).collect();
    assert_eq!(values, [(1.5, 3000.0, 3000.0), (4.0, 8160.0, 8000.0), (12.0, 16000.0, 16000.0)]);
    assert_eq!(c.verdict, Verdict::In);
    let worst = c.worst_point().unwrap();
    assert_eq!(worst.x, 4.0);
    assert!((worst.difference().unwrap() + 160.0 / 8160.0).abs() < 1e-12);
}

#[test]
fn travel_at_equal_force_is_taken_on_the_rise_to_the_peak() {
    let csv = "punch_force_N,other,travel_paper_cm\n5000,x,0.25\n19000,,0.95\n30000,,1.6\n";
    let spec = spec(ComparedQuantity::Travel, &["punch_force_N", "travel_paper_cm"], csv);
    let c = against_drawn(&spec, true);
    assert_eq!(c.points.iter().map(|p| p.computed).collect::<Vec<_>>(), [Some(2.5), Some(9.5), None]);
    assert_eq!(c.verdict, Verdict::NotReached);
    let c = against_drawn(&Spec { range: Some((0.0, 20_000.0)), ..spec }, true);
    assert_eq!((c.points.len(), c.points.iter().filter(|p| p.judged).count(), c.verdict), (3, 2, Verdict::In));
}

#[test]
fn thickness_needs_the_whole_run_and_is_held_at_the_ends() {
    let csv = "s0_mm,thickness_mm\n0,1.01\n10,1.1\n20,1.19\n";
    let own = spec(ComparedQuantity::ThicknessAtS0, &["s0_mm", "thickness_mm"], csv);
    assert_eq!(against_drawn(&own, true).verdict, Verdict::In);
    assert_eq!(against_drawn(&own, false).verdict, Verdict::NotReached);
    let own = spec(ComparedQuantity::ThicknessAtRadius, &["r_mm", "thickness_mm"], "r_mm,thickness_mm\n9,1.2\n");
    let c = against_drawn(&own, true);
    assert_eq!(c.verdict, Verdict::Out);
    assert!((c.points[0].computed.unwrap() - 1.1).abs() < 1e-12);
}

/// Trust: ends chosen by hand around thickness 1.01 to 1.19, edge 90, draw-in 5, thinnest 0.8.
#[test]
fn a_band_spans_all_values_with_their_errors_and_says_by_how_much_it_is_left() {
    let columns = ["a_mm", "b_cm"];
    for (quantity, csv, outside, verdict) in [
        (ComparedQuantity::Thickness, "1.02,,0.02\n,0.118,0.01", 0.0, Verdict::In),
        (ComparedQuantity::Thickness, "1.05,,0.02\n,0.118,0.02", -0.02, Verdict::Out),
        (ComparedQuantity::Thickness, "1.02,,0.02\n,0.11,0.01", 0.08, Verdict::Out),
        (ComparedQuantity::Thickness, "1.05,,\n,0.11,", 0.09, Verdict::Out),
        (ComparedQuantity::EdgeDiameter, "89,9.05,0", 0.0, Verdict::In),
        (ComparedQuantity::EdgeDiameter, "91,9.2,0.5", -0.5, Verdict::Out),
        (ComparedQuantity::DrawIn, "4,0.45,0.25", 0.25, Verdict::Out),
        (ComparedQuantity::Thinnest, "0.79,0.081,0", 0.0, Verdict::In),
    ] {
        let own = spec(quantity, &columns, &format!("a_mm,b_cm,error_mm\n{csv}\n"));
        let c = against_drawn(&Spec { error: Some("error_mm".to_owned()), ..own }, true);
        let found = c.band.unwrap();
        assert!((found.outside().unwrap() - outside).abs() < 1e-12, "{csv}: {found:?}");
        assert_eq!(c.verdict, verdict, "{csv}");
        assert_eq!(c.is_failure(), verdict == Verdict::Out);
    }
}

#[test]
fn a_peak_is_compared_wherever_it_is_and_a_band_needs_the_whole_run() {
    let spec = spec(ComparedQuantity::PeakForce, &["f_kN"], "f_kN\n21\n24\n");
    let [whole, part] = [true, false].map(|complete| against_drawn(&spec, complete));
    assert_eq!((whole.verdict, whole.farthest().map(|found| found.value)), (Verdict::Out, Some(20_000.0)));
    assert_eq!((part.verdict, part.worst()), (Verdict::NotReached, None));
}

/// Trust: the force of the history has its peak at 10 mm, and at half of it rises still.
#[test]
fn the_travel_at_the_peak_is_known_once_the_force_has_fallen() {
    let spec = spec(ComparedQuantity::PeakTravel, &["index_mm"], "index_mm\n9.5\n10.5\n");
    let of = |steps: &[StepRecord]| against(&spec, steps, false, None);
    let fallen = of(&history());
    assert_eq!((fallen.verdict, fallen.farthest().map(|found| found.value)), (Verdict::In, Some(10.0)));
    assert_eq!(of(&history()[..8]).verdict, Verdict::NotReached);
}

/// Trust: by hand: the second element is the thinnest, its hoop strain the minor one; without a unit a plain number.
#[test]
fn a_strain_path_is_that_of_the_thinnest_place() {
    let mut paths = Paths::starting(vec![1.0, 3.0]);
    for i in 0..=4 {
        let major = 0.1 * f64::from(i);
        let strains = vec![[major, major], [major, 0.5 * major]];
        paths.record(Instant { time: f64::from(i), travel: f64::from(i), strains });
    }
    let elements = [0.9, 0.8].map(|thickness| ElementRecord { thickness, ..ElementRecord::default() });
    let csv = "major_true,minor_true\n0.2,0.1\n0.35,0.170\n0.45,0.2\n";
    let spec = spec(ComparedQuantity::StrainPath, &["major_true", "minor_true"], csv);
    let c = against(&Spec { range: Some((0.0, 0.4)), ..spec }, &history(), false, Some((&paths, &elements)));
    let values: Vec<_> = c.points.iter().map(|p| p.computed.map(|y| (1e6 * y).round() / 1e6)).collect();
    assert_eq!((values, c.verdict), (vec![Some(0.1), Some(0.175), Some(0.2)], Verdict::In));
}
