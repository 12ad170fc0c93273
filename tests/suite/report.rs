//! Reports: whole, self-contained, and with no number that the JSON has not.

use crate::common::prelude::*;
use roxmltree::Node;

const PARTS: [&str; 8] = ["Case", "Verdict", "Section", "Inputs", "Assumptions", "Warnings", "Solver", "Results"];

const RELEASE: &str = include_str!("../../cases/hat_springback.toml");
const LIMIT: &str = include_str!("../../cases/stretch_limit.toml");

/// The HTML and the JSON of a case.
fn report(case: &str) -> (String, Value) {
    let dir = folder(case);
    let done = stampflow(dir.path(), &["report", "cases/cup.toml", "--json"]);
    assert!(matches!(done.status.code(), Some(0 | 3)), "{}", text(&done.stderr));
    let html = fs::read_to_string(dir.path().join("out/cup/report.html")).unwrap();
    (html, serde_json::from_slice(&done.stdout).unwrap())
}

/// The page as XML, with its elements that have no content closed: more than HTML asks of well-formedness.
fn as_xml(html: &str) -> String {
    let mut xml = String::new();
    let mut rest = html.strip_prefix("<!DOCTYPE html>").expect("a document type");
    while let Some(start) = ["<meta", "<br", "<hr", "<img", "<col>"].iter().filter_map(|tag| rest.find(tag)).min() {
        let end = start + rest[start..].find('>').expect("a whole tag");
        xml = xml + &rest[..end] + "/";
        rest = &rest[end..];
    }
    xml + rest
}

fn elements<'a>(page: &'a Document, name: &str) -> impl Iterator<Item = Node<'a, 'a>> {
    page.descendants().filter(move |node| node.has_tag_name(name))
}

fn text_of(node: Node) -> String {
    node.descendants().filter(Node::is_text).filter_map(|text| text.text()).collect()
}

/// Numbers written in a text, as they are written.
fn numbers(text: &str) -> Vec<String> {
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | '-' | 'e');
    let words = text.split(|c| !is_part(c)).map(|t| t.trim_matches(['.', 'e']));
    words.filter(|t| t.parse::<f64>().is_ok()).map(str::to_owned).collect()
}

fn collect(value: &Value, found: &mut Vec<f64>) {
    match value {
        Value::Number(n) => found.extend(n.as_f64()),
        Value::String(s) => found.extend(numbers(s).iter().filter_map(|n| n.parse::<f64>().ok())),
        Value::Array(a) => a.iter().for_each(|v| collect(v, found)),
        Value::Object(o) => o.values().for_each(|v| collect(v, found)),
        _ => {}
    }
}

/// Half of the last digit that is written: what rounding may take.
fn rounding(written: &str) -> f64 {
    let (mantissa, exponent) = written.split_once('e').unwrap_or((written, "0"));
    let decimals = mantissa.split_once('.').map_or(0, |(_, d)| d.len() as i32);
    0.5001 * 10f64.powi(exponent.parse::<i32>().unwrap() - decimals)
}

#[test]
fn a_report_is_whole_self_contained_and_agrees_with_its_json() {
    let staged = format!("{CUP}{STAGES}");
    let hat = RELEASE.replace("elements = 200", "elements = 60").replace("travel = \"70 mm\"", "travel = \"20 mm\"");
    for (case, extra) in [(CUP, ""), (&staged, "Stage 2-retract"), (&hat, "Spring-back"), (LIMIT, "Forming limit")] {
        let (html, json) = report(case);
        let xml = as_xml(&html);
        let page = Document::parse(&xml).unwrap_or_else(|e| panic!("{e}"));
        for outside in ["http:", "https:", "src=", "url(", "@import", "<script", "<link", "xlink"] {
            assert!(!html.contains(outside), "{outside}");
        }
        let headings: Vec<String> = ["h2", "h3"].into_iter().flat_map(|h| elements(&page, h).map(text_of)).collect();
        for part in PARTS {
            assert!(headings.iter().any(|h| h.ends_with(part)), "{part} in {headings:?}");
        }
        let (pictures, pages) = (elements(&page, "svg").count(), html.matches("class=\"page").count());
        assert!(pictures >= 5 && html.contains(extra) && pages == 3, "{pictures} {extra} {pages}");
        let mut known = Vec::new();
        collect(&json, &mut known);
        // The first column has names: SHA-256.
        for cell in elements(&page, "td").filter(|cell| cell.prev_sibling_element().is_some()).map(text_of) {
            for written in numbers(&cell) {
                let value: f64 = written.parse().unwrap();
                // Forces and works that are large are told in thousands: kN, kJ.
                let is = |k: f64| (k - value).abs() <= rounding(&written) || k == value;
                let near = known.iter().any(|k| is(*k) || is(1e-3 * k));
                assert!(near, "{written} of {cell:?} is not in the JSON");
            }
        }
    }
}
