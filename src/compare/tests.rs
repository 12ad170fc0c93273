//! Comparisons of synthetic curves whose answer is known.

use super::*;
use std::fs;
use std::path::Path;

const SOURCES: &str = "[\"curve.csv\"]\ncitation = \"A. Uthor, A title, 1990.\"\nkind = \"experiment\"\ngrade = \"A\"\n\
                       scatter = \"5 %\"\n";

/// Force 2 t up to t = 10, then falling; thickness 1 + s0/100 on elements of 2 mm.
fn history() -> Table {
    let travel: Vec<f64> = (1..=16).map(f64::from).collect();
    let force = travel.iter().map(|t| if *t <= 10.0 { 2000.0 * t } else { 40_000.0 - 2000.0 * t }).collect();
    Table::new(vec![
        Column::new("travel", "Punch travel", Unit::Mm, travel),
        Column::new("punch_force", "Punch force", Unit::N, force),
    ])
}

fn profile() -> Table {
    let s0: Vec<f64> = (0..10).map(|i| 1.0 + 2.0 * f64::from(i)).collect();
    Table::new(vec![
        Column::new("r", "Radius", Unit::Mm, s0.iter().map(|s| 0.9 * s).collect()),
        Column::new("thickness", "Thickness", Unit::Mm, s0.iter().map(|s| 1.0 + s / 100.0).collect()),
        Column::new("s0", "Initial radius", Unit::Mm, s0),
    ])
}

fn spec(dir: &Path, x: &str, y: &str, quantity: Quantity) -> Spec {
    Spec {
        reference: dir.join("curve.csv"),
        x: x.to_owned(),
        y: y.to_owned(),
        quantity,
        range: None,
        tolerance: 0.05,
        reason: "for the test".to_owned(),
        optional: false,
    }
}

fn compared(csv: &str, spec: impl Fn(&Path) -> Spec, complete: bool) -> Result<Comparison, CompareError> {
    let dir = tempfile::tempdir().unwrap();
    fs::write(dir.path().join("curve.csv"), csv).unwrap();
    fs::write(dir.path().join("sources.toml"), SOURCES).unwrap();
    compare(&spec(dir.path()), &Computed { history: &history(), profile: &profile(), complete })
}

#[test]
fn forces_at_equal_travel_are_interpolated_and_converted() {
    let csv = "# comment\ntravel_mm, punch_force_kN\n1.5, 3\n4, 8.16\n# between\n12,16\n";
    let c = compared(csv, |d| spec(d, "travel_mm", "punch_force_kN", Quantity::PunchForce), true).unwrap();
    let values: Vec<_> = c.points.iter().map(|p| (p.x, p.reference, p.computed.unwrap())).collect();
    assert_eq!(values, [(1.5, 3000.0, 3000.0), (4.0, 8160.0, 8000.0), (12.0, 16000.0, 16000.0)]);
    assert_eq!(c.verdict, Verdict::In);
    let worst = c.worst().unwrap();
    assert_eq!(worst.x, 4.0);
    assert!((worst.difference().unwrap() + 160.0 / 8160.0).abs() < 1e-12);
    let source = c.source.as_ref().unwrap();
    assert_eq!(source.to_string(), "A. Uthor, A title, 1990 (experiment, grade A, scatter 5 %)");
    let headers: Vec<_> = c.table().columns.iter().map(Column::header).collect();
    assert_eq!(headers, ["travel_mm", "reference_N", "computed_N", "difference_percent"]);
}

#[test]
fn travel_at_equal_force_is_taken_on_the_rise_to_the_peak() {
    let csv = "punch_force_N,other,travel_paper_cm\n5000,x,0.25\n19000,,0.95\n30000,,1.6\n";
    let of = |d: &Path| spec(d, "punch_force_N", "travel_paper_cm", Quantity::Travel);
    let c = compared(csv, of, true).unwrap();
    assert_eq!(c.points.iter().map(|p| p.computed).collect::<Vec<_>>(), [Some(2.5), Some(9.5), None]);
    assert_eq!(c.verdict, Verdict::NotReached);
    let c = compared(csv, |d| Spec { range: Some((0.0, 20_000.0)), ..of(d) }, true).unwrap();
    assert_eq!((c.points.len(), c.judged().count(), c.verdict), (3, 2, Verdict::In));
}

#[test]
fn thickness_needs_the_whole_run_and_is_held_at_the_ends() {
    let of = |d: &Path| spec(d, "s0_mm", "thickness_mm", Quantity::ThicknessAtS0);
    let csv = "s0_mm,thickness_mm\n0,1.01\n10,1.1\n20,1.19\n";
    assert_eq!(compared(csv, of, true).unwrap().verdict, Verdict::In);
    assert_eq!(compared(csv, of, false).unwrap().verdict, Verdict::NotReached);
    let of = |d: &Path| spec(d, "r_mm", "thickness_mm", Quantity::ThicknessAtRadius);
    let c = compared("r_mm,thickness_mm\n9,1.2\n", of, true).unwrap();
    assert_eq!(c.verdict, Verdict::Out);
    assert!((c.points[0].computed.unwrap() - 1.1).abs() < 1e-12);
}

#[test]
fn a_missing_file_is_an_error_unless_it_is_optional() {
    let dir = Path::new("/nowhere");
    let strict = spec(dir, "travel_mm", "punch_force_N", Quantity::PunchForce);
    let computed = Computed { history: &history(), profile: &profile(), complete: true };
    assert!(compare(&strict, &computed).unwrap_err().to_string().contains("/nowhere/curve.csv"));
    let c = compare(&Spec { optional: true, ..strict }, &computed).unwrap();
    assert_eq!((c.verdict, c.points.len(), c.worst()), (Verdict::NoData, 0, None));
    assert!(!c.verdict.is_failure());
}

#[test]
fn mistakes_in_the_file_are_named() {
    let force = |d: &Path| spec(d, "travel_mm", "punch_force_N", Quantity::PunchForce);
    for (csv, says) in [
        ("travel_mm,force_N\n1,2\n", "no column `punch_force_N`; it has travel_mm, force_N"),
        ("travel_mm,punch_force_N\n1,2\n\n2,two\n", "data row 2: `two`"),
        ("travel_mm,punch_force_N\n1,0\n", "is 0 at 1"),
        ("travel_mm,punch_force_N\n", "no rows"),
        ("travel_mm;punch_force_N\n1,5;2\n", "separates its columns by ';': write commas"),
        ("travel_mm\tpunch_force_N\n1\t2\n", "separates its columns by '\\t'"),
    ] {
        let message = compared(csv, force, true).unwrap_err().to_string();
        assert!(message.contains(says), "{message}");
    }
    let endless = format!("travel_mm,punch_force_N\n{}", "1,2\n".repeat(2_600_000));
    let error = std::error::Error::source(&compared(&endless, force, true).unwrap_err()).unwrap().to_string();
    assert_eq!(error, "it is larger than 10 MB");
    let kp = compared("travel_mm,force_kp\n1,2\n", |d| spec(d, "travel_mm", "force_kp", Quantity::PunchForce), true);
    assert!(kp.unwrap_err().to_string().contains("known units"));
    let mm = compared("travel_mm,force_mm\n1,2\n", |d| spec(d, "travel_mm", "force_mm", Quantity::PunchForce), true);
    assert!(mm.unwrap_err().to_string().contains("Punch force [N]"));
}

/// Trust: the curve itself is the reference, so every difference is rounding.
#[test]
fn a_curve_agrees_with_itself() {
    let (x, y) = (history().column("travel").values.clone(), history().column("punch_force").values.clone());
    let rows: String = x.iter().zip(&y).map(|(x, y)| format!("{x},{y}\n")).collect();
    let c = compared(
        &format!("travel_mm,punch_force_N\n{rows}"),
        |d| spec(d, "travel_mm", "punch_force_N", Quantity::PunchForce),
        true,
    );
    assert!(c.unwrap().points.iter().all(|p| p.difference().unwrap().abs() < 1e-14));
}
