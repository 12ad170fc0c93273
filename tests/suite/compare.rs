//! Comparisons of synthetic curves whose answer is known.

use stampflow::case::comparison::{Against, BandSpec, ComparedQuantity, CurveSpec, Data, Source, Spec};
use stampflow::forming_limit::{Instant, Paths};
use stampflow::model::Extent;
use stampflow::results::comparison::{CompareError, Compared, Comparison, Computed, Verdict, compare};
use stampflow::solver::solution::{ElementRecord, StepRecord};
use stampflow::table::{Column, Csv};

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

/// Of a blank of 50 mm.
fn against_drawn(spec: &Spec, complete: bool) -> Result<Comparison, CompareError> {
    let (steps, elements) = (&history()[..], &profile()[..]);
    compare(spec, &Computed { extent: Extent::Ring, length: 50.0, steps, elements, paths: None, complete, ring: None })
}

/// A comparison with the text of a CSV file.
fn spec(csv: Option<&str>, against: Against) -> Spec {
    let data = csv.map(|csv| Data {
        csv: Csv::read(csv, "the file", "").unwrap(),
        source: Source::of("curve.csv", PROVENANCE).unwrap(),
    });
    let (reference, reason) = ("nowhere/curve.csv".into(), "for the test".to_owned());
    Spec { reference, data, against, reason, optional: false, demonstration: false }
}

fn curve(x: &str, y: &str, quantity: ComparedQuantity) -> CurveSpec {
    CurveSpec { quantity, x: x.to_owned(), y: y.to_owned(), range: None, tolerance: 0.05 }
}

fn compared(csv: &str, against: Against, complete: bool) -> Result<Comparison, CompareError> {
    against_drawn(&spec(Some(csv), against), complete)
}

fn along(csv: &str, spec: CurveSpec, complete: bool) -> Result<Comparison, CompareError> {
    compared(csv, Against::Curve(spec), complete)
}

#[test]
fn forces_at_equal_travel_are_interpolated_and_converted() {
    let csv = "# comment\ntravel_mm, punch_force_kN\n1.5, 3\n4, 8.16\n# between\n12,16\n";
    let c = along(csv, curve("travel_mm", "punch_force_kN", ComparedQuantity::PunchForce), true).unwrap();
    let values: Vec<_> = c.points().iter().map(|p| (p.x, p.reference, p.computed.unwrap())).collect();
    assert_eq!(values, [(1.5, 3000.0, 3000.0), (4.0, 8160.0, 8000.0), (12.0, 16000.0, 16000.0)]);
    assert_eq!(c.verdict, Verdict::In);
    let worst = c.worst_point().unwrap();
    assert_eq!(worst.x, 4.0);
    assert!((worst.difference().unwrap() + 160.0 / 8160.0).abs() < 1e-12);
    assert_eq!(c.sentence(), "punch_force against curve.csv: in, worst -2.0 % at punch travel = 4 mm (tolerance 5 %)");
    let source = c.source().unwrap();
    assert_eq!(source.to_string(), "A. Uthor, A title, 1990 (experiment, grade A, scatter 5 %)");
    let headers: Vec<_> = c.table().columns.iter().map(Column::header).collect();
    assert_eq!(headers, ["travel_mm", "reference_N", "computed_N", "difference_percent"]);
}

#[test]
fn travel_at_equal_force_is_taken_on_the_rise_to_the_peak() {
    let csv = "punch_force_N,other,travel_paper_cm\n5000,x,0.25\n19000,,0.95\n30000,,1.6\n";
    let of = || curve("punch_force_N", "travel_paper_cm", ComparedQuantity::Travel);
    let c = along(csv, of(), true).unwrap();
    assert_eq!(c.points().iter().map(|p| p.computed).collect::<Vec<_>>(), [Some(2.5), Some(9.5), None]);
    assert_eq!(c.verdict, Verdict::NotReached);
    let c = along(csv, CurveSpec { range: Some((0.0, 20_000.0)), ..of() }, true).unwrap();
    assert_eq!((c.points().len(), c.points().iter().filter(|p| p.judged).count(), c.verdict), (3, 2, Verdict::In));
}

#[test]
fn thickness_needs_the_whole_run_and_is_held_at_the_ends() {
    let of = || curve("s0_mm", "thickness_mm", ComparedQuantity::ThicknessAtS0);
    let csv = "s0_mm,thickness_mm\n0,1.01\n10,1.1\n20,1.19\n";
    assert_eq!(along(csv, of(), true).unwrap().verdict, Verdict::In);
    assert_eq!(along(csv, of(), false).unwrap().verdict, Verdict::NotReached);
    let of = curve("r_mm", "thickness_mm", ComparedQuantity::ThicknessAtRadius);
    let c = along("r_mm,thickness_mm\n9,1.2\n", of, true).unwrap();
    assert_eq!(c.verdict, Verdict::Out);
    assert!((c.points()[0].computed.unwrap() - 1.1).abs() < 1e-12);
}

fn band(quantity: ComparedQuantity, columns: &[&str]) -> Against {
    let columns = columns.iter().map(|&c| c.to_owned()).collect();
    Against::Band(BandSpec { quantity, columns, error: Some("error_mm".to_owned()) })
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
        let c = compared(&format!("a_mm,b_cm,error_mm\n{csv}\n"), band(quantity, &columns), true).unwrap();
        let Compared::Band(found) = c.compared else { panic!("{:?}", c.compared) };
        assert!((found.outside().unwrap() - outside).abs() < 1e-12, "{csv}: {found:?}");
        assert_eq!(c.verdict, verdict, "{csv}");
        assert_eq!(c.is_failure(), verdict == Verdict::Out);
    }
}

#[test]
fn a_peak_is_compared_wherever_it_is_and_a_band_needs_the_whole_run() {
    let band = |complete| {
        let against = BandSpec { quantity: ComparedQuantity::PeakForce, columns: vec!["f_kN".to_owned()], error: None };
        compared("f_kN\n21\n24\n", Against::Band(against), complete).unwrap()
    };
    assert_eq!(
        band(true).sentence(),
        "peak_force against curve.csv: OUT, 20000 N, 1000 N below (-4.8 %) of 21000 to 24000 N"
    );
    assert_eq!((band(false).verdict, band(false).worst()), (Verdict::NotReached, None));
    assert_eq!(band(false).sentence(), "peak_force against curve.csv: not reached");
}

/// Trust: the force of the history has its peak at 10 mm, and at half of it rises still.
#[test]
fn the_travel_at_the_peak_is_known_once_the_force_has_fallen() {
    let against =
        || BandSpec { quantity: ComparedQuantity::PeakTravel, columns: vec!["index_mm".to_owned()], error: None };
    let spec = spec(Some("index_mm\n9.5\n10.5\n"), Against::Band(against()));
    let of = |steps: &[StepRecord]| {
        let (length, elements) = (50.0, &profile()[..]);
        compare(
            &spec,
            &Computed { extent: Extent::Ring, length, steps, elements, paths: None, complete: false, ring: None },
        )
        .unwrap()
    };
    let fallen = of(&history());
    assert_eq!((fallen.verdict, fallen.farthest().map(|found| found.value)), (Verdict::In, Some(10.0)));
    assert_eq!(fallen.target().as_deref(), Some("9.50–10.5 mm"));
    assert_eq!(of(&history()[..8]).verdict, Verdict::NotReached);
}

/// Trust: by hand: the second element is the thinnest, its hoop strain is the minor one and half of the other; a name without a
/// unit is a plain number.
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
    let path = CurveSpec { range: Some((0.0, 0.4)), ..curve("major_true", "minor_true", ComparedQuantity::StrainPath) };
    let spec = spec(Some(csv), Against::Curve(path));
    let computed = Computed {
        extent: Extent::Ring,
        length: 4.0,
        steps: &history(),
        elements: &elements,
        paths: Some(&paths),
        complete: false,
        ring: None,
    };
    let c = compare(&spec, &computed).unwrap();
    let values: Vec<_> = c.points().iter().map(|p| p.computed.map(|y| (1e6 * y).round() / 1e6)).collect();
    assert_eq!((values, c.verdict), (vec![Some(0.1), Some(0.175), Some(0.2)], Verdict::In));
    let told = "strain_path against curve.csv: in, worst +2.9 % at major true strain = 0.35 (tolerance 5 %)";
    assert_eq!(c.sentence(), told);
}
