//! Draw beads that are drawn in holder and die: the holder closes over the sheet before the punch comes, and the bead holds
//! the sheet back.

use crate::common::prelude::*;
use stampflow::solver::{closing_way, solve};

/// Radii of the bead's tip and of its foot, and its height \[mm\].
const TIP: f64 = 5.0;
const FOOT: f64 = 5.0;
const HEIGHT: f64 = 4.0;
/// Where it is, and where the sections end \[mm\].
const AT: f64 = 58.0;
const END: f64 = 125.0;

fn point(x: f64, z: f64) -> String {
    format!("[\"{x:.6} mm\", \"{z:.6} mm\"]")
}

fn arc(to: [f64; 2], center: [f64; 2], turn: &str) -> String {
    format!("{{ arc_to = {}, center = {}, turn = \"{turn}\" }}", point(to[0], to[1]), point(center[0], center[1]))
}

/// Holder and die with a bead between them, the die's groove `gap` off the holder's bead all round \[mm\].
fn sections(gap: f64) -> [String; 2] {
    let (below, centers) = (HEIGHT - TIP, TIP + FOOT);
    let across = (centers * centers - (FOOT - below).powi(2)).sqrt();
    // The points where foot and tip meet, of radii that the gap makes smaller and larger.
    let meets = |foot: f64| [across - across * foot / centers, FOOT + (below - FOOT) * foot / centers];
    let ([hx, hz], [dx, dz]) = (meets(FOOT), meets(FOOT - gap));
    let feet = |side: f64| [AT + side * across, FOOT];
    let to = |x: f64, z: f64| format!("{{ to = {} }}", point(x, z));
    let from = |x: f64, z: f64| format!("{{ from = {} }}", point(x, z));
    let holder = [
        from(36.0, -20.0),
        to(36.0, 0.0),
        to(AT - across, 0.0),
        arc([AT - hx, hz], feet(-1.0), "left"),
        arc([AT + hx, hz], [AT, below], "right"),
        arc([AT + across, 0.0], feet(1.0), "left"),
        to(END, 0.0),
    ];
    let die = [
        from(END, gap),
        to(AT + across, gap),
        arc([AT + dx, dz], feet(1.0), "right"),
        arc([AT - dx, dz], [AT, below], "left"),
        arc([AT - across, gap], feet(-1.0), "right"),
        to(39.4, gap),
        arc([31.4, gap + 8.0], [39.4, gap + 8.0], "right"),
        to(31.4, gap + 80.0),
    ];
    [&holder[..], &die].map(|steps| format!("profile = [{}]", steps.join(", ")))
}

/// A strip, or a cup, of mild steel without friction, drawn 25 mm under a holder of this force.
fn drawn(geometry: &str, force: &str, [holder, die]: &[String; 2], more: &str) -> (Vec<StageSolution>, Vec<Finding>) {
    let (length, half) = match geometry {
        "axisymmetric" => ("radius = \"80 mm\"", "radius"),
        _ => ("half_length = \"115 mm\"", "half_width"),
    };
    let text = format!(
        r#"
        title = "Bead"
        geometry = "{geometry}"
        [blank]
        {length}
        thickness = "1 mm"
        elements = 160
        [material.hardening.swift]
        k = "520 MPa"
        n = 0.22
        offset = 0.005
        [tools]
        punch = {{ flat = {{ {half} = "30 mm", nose = "8 mm" }}, friction = 0.0, travel = "25 mm" }}
        die = {{ friction = 0.0, {die} }}
        holder = {{ friction = 0.0, force = "{force}", {holder} }}
        {more}
        "#
    );
    let case = parsed(&text, &[]);
    let stages = solve(&case.stages, &mut ());
    let found = assess::after(&case, &stages);
    (stages, found)
}

/// Trust: the closed bead holds a strip without friction back with the work of bending over its radii; the estimate keeps the
/// thickness and takes each bend as whole, within a tenth of the solver's own bead.
#[test]
fn a_drawn_bead_closes_and_holds_the_strip_back_as_its_line_does() {
    let strip = |sections: &[String; 2], more: &str| {
        let (stages, found) = drawn("plane_strain", "2000 N/mm", sections, more);
        assert!(stages[0].stop.is_complete(), "{}", stages[0].stop);
        (stages, found)
    };
    let (modelled, found) = strip(&sections(1.05), "");
    let closing = modelled[0].closing.expect("the holder closes");
    assert!((closing.way - HEIGHT).abs() < 0.1 && closing.gap == 0.0, "{closing:?}");
    // The force is found to a thousandth of a step of 0.04 mm.
    assert!((closing.force / 2000.0 - 1.0).abs() < 0.05, "{closing:?}");
    assert!(found.iter().all(|finding| finding.key != "holder_open"));
    assert!(found.iter().any(|finding| finding.key == "holder" && finding.light == Light::Green));

    // By hand, Σ 2/√3 σ t²/(4ρ) over bending and unbending at the radii 3.95, 5 and 3.95 mm, Δε = 2/√3 t/(4ρ) by each.
    let line = "[[tools.beads]]\nat = \"58 mm\"\nrestraining = \"126.4 N/mm\"";
    let flat = ["inner_half_width = \"36 mm\"".to_owned(), "throat = \"31.4 mm\", shoulder = \"8 mm\"".to_owned()];
    let (free, _) = strip(&flat, "");
    let (as_line, _) = strip(&flat, line);
    assert!(free[0].closing.is_none());
    let [bead, line] = [&modelled, &as_line].map(|stages| peak(&stages[0]) - peak(&free[0]));
    assert!(bead > 5.0 * peak(&free[0]) && (bead / line - 1.0).abs() < 0.1, "{bead} {line}");
}

/// Trust: a holder too weak to bend the sheet round the bead stands open by what is left of its height, and what its lights
/// would say of a flange that it does not press means nothing.
#[test]
fn a_holder_that_stays_open_is_said_and_its_lights_are_grey() {
    let (stages, found) = drawn("axisymmetric", "15 kN", &sections(1.05), "");
    let closing = stages[0].closing.expect("the holder closes");
    assert!(closing.gap > 0.3 && (closing.force / 15e3 - 1.0).abs() < 1e-2, "{closing:?}");
    assert!(!stages[0].steps.is_empty(), "{}", stages[0].stop);
    let open = row(&found, "holder_open");
    assert!(open.kind == Kind::Warning && open.value() == Some(closing.gap), "{open:?}");
    assert!(open.sentence().to_string().contains("[[tools.beads]]"), "{open:?}");
    for key in ["holder", "wrinkling"] {
        let row = row(&found, key);
        assert!(row.light == Light::Grey && row.statement().contains("open by"), "{row:?}");
    }
}

/// Trust: none of the shipped cases has a bead or a slope between holder and die.
#[test]
fn holders_that_lie_flat_on_the_sheet_do_not_close_first() {
    for path in files("cases", "toml") {
        assert_eq!(closing_way(loaded(&path, &[]).model()), None, "{}", path.display());
    }
}
