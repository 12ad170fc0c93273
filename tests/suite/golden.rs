//! Curves, profiles and summaries of every shipped case against `tests/golden/digests.csv`.

use crate::common::prelude::*;

/// Number of values, their sum, the sum with the weights 1 … 7 in turn, and the sum of their magnitudes.
type Digest = [f64; 4];

/// Largest difference over the sum of magnitudes: of nine digits a value may fall on either side of a rounding.
const TOLERANCE: f64 = 1e-9;

/// Columns of the iteration, not of its answer: round-off moves them, and the imbalance of work is a small difference of large
/// numbers. `thickest_s0_mm` of `hat_springback` is one of two places of equal thickness.
const NUMERICAL: &str = "velocity_norm residual_norm iterations rejected steps_from_predictor steps_from_secant \
                         steps_from_softened imbalance_percent thickest_s0_mm";

fn digest(values: &[f64]) -> Digest {
    let weighted = values.iter().enumerate().map(|(i, v)| v * ((i % 7) + 1) as f64).sum();
    [values.len() as f64, values.iter().sum(), weighted, values.iter().map(|v| v.abs()).sum()]
}

fn columns(path: &Path) -> BTreeMap<String, Digest> {
    let text = fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    if path.extension().is_some_and(|e| e == "json") {
        let summary: serde_json::Map<String, serde_json::Value> = serde_json::from_str(&text).expect("an object");
        return summary.iter().filter_map(|(key, value)| Some((key.clone(), digest(&[value.as_f64()?])))).collect();
    }
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().expect("a header").clone();
    let records: Vec<csv::StringRecord> = reader.records().map(|r| r.expect("a record")).collect();
    let column = |i: usize| records.iter().map(|r| r[i].parse().ok()).collect::<Option<Vec<f64>>>();
    header.iter().enumerate().filter_map(|(i, name)| Some((name.to_owned(), digest(&column(i)?)))).collect()
}

/// Trust: the golden values were written by version 0.2.0, whose curves were compared with closed forms and measurements.
#[test]
fn every_shipped_case_has_its_golden_numbers() {
    let out = temp_dir::TempDir::new().expect("a folder");
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/digests.csv");
    let mut reader = csv::Reader::from_path(golden).expect("readable");
    let mut files: BTreeMap<String, Vec<(String, Digest)>> = BTreeMap::new();
    for row in reader.deserialize::<(String, String, f64, f64, f64, f64)>() {
        let (file, column, n, sum, weighted, magnitude) = row.expect("a row");
        files.entry(file).or_default().push((column, [n, sum, weighted, magnitude]));
    }
    let cases: BTreeSet<&str> = files.keys().filter_map(|f| f.split('/').next()).collect();
    assert_eq!(cases.len(), 22);
    for case in cases {
        solved(case).write(out.child(case)).expect("writable");
    }
    let mut wrong = Vec::new();
    for (file, expected) in &files {
        let computed = columns(&out.child(file));
        for (column, golden) in expected.iter().filter(|(column, _)| !NUMERICAL.split(' ').any(|one| one == column)) {
            let near = |new: &Digest| (0..4).all(|i| (new[i] - golden[i]).abs() <= TOLERANCE * golden[3] * 7.0);
            if !computed.get(column).is_some_and(near) {
                wrong.push(format!("{file} {column}: {golden:?} became {:?}", computed.get(column)));
            }
        }
    }
    assert!(wrong.is_empty(), "{} differ:\n{}", wrong.len(), wrong.join("\n"));
}
