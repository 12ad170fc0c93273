//! What is promised of whatever is not refused.

use crate::common::prelude::*;

/// Of every model that is accepted, and of what can be said without solving it.
pub fn of_model(case: &Case) {
    let model = case.model();
    let blank = &model.blank;
    for (what, value) in [
        ("length", blank.length),
        ("thickness", blank.thickness),
        ("duration", model.duration),
        ("speed", model.speed),
        ("tolerance", model.settings.tolerance),
        ("max_step", model.settings.max_step),
        ("min_step", model.settings.min_step),
        ("contact_stiffness", model.settings.contact_stiffness),
    ] {
        assert!(value.is_finite() && value > 0.0, "{what} = {value}");
    }
    assert!((2..=2000).contains(&blank.elements) && (1..=101).contains(&blank.layers));
    assert!(model.frames.len() <= 1001 && model.frames.last() == Some(&model.duration));
    assert!(model.frames.is_sorted_by(|a, b| a < b), "{:?}", model.frames);
    for tool in &model.tools {
        assert!((0.0..=64.0).contains(&tool.friction.largest_coefficient()), "{}", tool.friction);
        assert!(tool.profile.polyline(0.1).iter().all(|p| p.x.is_finite() && p.y.is_finite()));
    }
    let stresses = [0.0, 1e-4, 0.01, 0.1, 1.0].map(|strain| model.material.hardening.at(strain).stress);
    assert!(stresses.is_sorted() && stresses[0] >= 0.0 && stresses[4].is_finite() && stresses[4] > 0.0, "{stresses:?}");
    let nodes = mesh::nodes(model);
    assert_eq!(nodes.len(), blank.elements + 1);
    assert!(nodes.is_sorted_by(|a, b| a < b), "nodes do not rise");

    let report = stampflow::assess::check::report(case);
    for line in &report.lines {
        assert!(line.number.is_none_or(f64::is_finite), "{line:?}");
    }
    assert!(report.to_string().len() < 1_000_000);
}

/// Of every picture: XML of a sensible height, with numbers where numbers belong.
pub fn of_picture(svg: &str, file: &str) {
    let tree = Document::parse(svg).expect("XML");
    let height: f64 = tree.root_element().attribute("height").expect("a height").parse().expect("a number");
    assert!(height < 5_000.0, "{file}: {height} px high");
    for attribute in tree.descendants().flat_map(|node| node.attributes()) {
        let value = attribute.value();
        assert!(!value.contains("NaN") && !value.contains("inf"), "{file}: {value}");
    }
}

/// Of every summary: an object without an unknown value.
pub fn of_json(text: &str) {
    let json: serde_json::Value = serde_json::from_str(text).expect("JSON");
    assert_eq!(json.as_object().expect("an object").iter().filter(|(_, v)| v.is_null()).count(), 0, "{json}");
}
