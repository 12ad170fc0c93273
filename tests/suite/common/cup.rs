//! The text of the smallest cup, and of its parts.

/// The case of the documentation of `stampflow::case`: no key of it can be left out.
pub const MINIMAL: &str = r#"title = "Cup"
geometry = "axisymmetric"
[blank]
radius = "55 mm"
thickness = "1 mm"
[material.hardening]
swift = { k = "520 MPa", n = 0.22, offset = 0.005 }
[tools]
punch = { flat = { radius = "30 mm", nose = "6 mm" }, friction = 0.08, travel = "25 mm" }
die = { throat = "31.25 mm", shoulder = "6 mm", friction = 0.08 }
holder = { inner_radius = "32 mm", force = "10 kN" }
"#;

/// Its law.
pub const LAW: &str = "[material.hardening]\nswift = { k = \"520 MPa\", n = 0.22, offset = 0.005 }\n";
