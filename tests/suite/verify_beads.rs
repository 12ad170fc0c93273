//! Draw beads: those drawn in holder and die, over which the holder closes before the punch comes, and those given by their
//! section, whose forces come from a strip that is pulled through.

use crate::common::prelude::*;
use stampflow::{bead, bead::Drawn, model::Round, solver::closing_way, solver::solve};

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
fn drawn(geometry: &str, hold: &str, [holder, die]: &[String; 2], more: &str) -> (Vec<StageSolution>, Vec<Finding>) {
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
        holder = {{ friction = 0.0, {hold}, {holder} }}
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
        let (stages, found) = drawn("plane_strain", "force = \"2000 N/mm\"", sections, more);
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
    let line = "[[tools.beads]]\nat = \"58 mm\"\nrestraining = \"126.4 N/mm\"\nclosing = \"500 N/mm\"";
    let flat = ["inner_half_width = \"36 mm\"".to_owned(), "throat = \"31.4 mm\", shoulder = \"8 mm\"".to_owned()];
    let (free, _) = strip(&flat, "");
    let (as_line, found) = strip(&flat, line);
    assert_relative_eq!(row(&found, "press_force").value().unwrap(), 2000.0 + peak(&as_line[0]), max_relative = 1e-6);
    assert!(free[0].closing.is_none());
    let [bead, line] = [&modelled, &as_line].map(|stages| peak(&stages[0]) - peak(&free[0]));
    assert!(bead > 5.0 * peak(&free[0]) && (bead / line - 1.0).abs() < 0.1, "{bead} {line}");
}

/// Trust: a holder too weak to bend the sheet round the bead stands open by what is left of its height, and what its lights
/// would say of a flange that it does not press means nothing.
#[test]
fn a_holder_that_stays_open_is_said_and_its_lights_are_grey() {
    let (stages, found) = drawn("axisymmetric", "force = \"15 kN\"", &sections(1.05), "");
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

/// Bead and shoulders of 5 mm, so high that the sheet of 1 mm wraps a half of the one and a quarter of each other.
const ROLLERS: Round = Round { radius: 5.0, height: 12.0, shoulder: 5.0, clearance: Some(1.2) };

/// A strip of 1 mm, rigid-perfectly plastic at 300 MPa, over the rollers with so many times the elements.
fn pulled_through(friction: f64, finer: usize) -> Drawn {
    let material = Material::plain(Hardening::Ludwik(Ludwik::new(300.0, 0.0, 1.0).expect("valid")));
    let case = Model { material, ..simple::pulled(Geometry::PlaneStrain, Theory::Bending, 1.0) };
    let mut stages = bead::stages(&case, &ROLLERS, 50.0, ROLLERS.height);
    for model in stages.iter_mut().map(|stage| &mut stage.model) {
        model.blank.elements *= finer;
        model.tools.iter_mut().for_each(|tool| tool.friction = friction.into());
    }
    bead::drawn(&ROLLERS, 50.0, &solve(&stages, &mut ())).expect("it comes through")
}

/// Restraint of the rollers, and the thickness left, by hand. With S = 2/√3 σ_y, the moment of a strip of thickness t under the
/// tension T is M = S (t²/4 − e²), its neutral line e = T/(2 S) off its middle. Bending to the curvature κ stretches the middle
/// by e κ, so that t falls by its share and the work per length is M κ + T e κ; T does T e κ of it, and grows by M κ. Unbending
/// does the same. Over a wrap of θ friction multiplies T by exp(μ θ).
fn by_hand(friction: f64) -> [f64; 2] {
    let (s, mut tension, mut t) = (2.0 / 3f64.sqrt() * 300.0, 0.0, 1.0);
    for wrap in [FRAC_PI_2, PI, FRAC_PI_2] {
        for then in [wrap, 0.0] {
            let curvature = 1.0 / (5.0 + 0.5 * t);
            let rise = |tension: f64| s * curvature * (0.25 * t * t - (tension / (2.0 * s)).powi(2));
            let mean: f64 = tension + 0.5 * rise(tension);
            tension = (tension + rise(mean)) * (friction * then).exp();
            t *= 1.0 - curvature * mean / (2.0 * s);
        }
    }
    [tension, t]
}

/// Trust: the work of bending and unbending of a rigid-perfectly plastic strip, in closed form.
#[test]
fn a_strip_is_pulled_over_rollers_by_the_work_of_bending() {
    let [tension, t] = by_hand(0.0);
    let strips = [1, 2].map(|finer| pulled_through(0.0, finer));
    let misses = strips.map(|strip| strip.restraining / tension - 1.0);
    assert!(misses.iter().all(|miss| miss.abs() < 0.03) && (misses[1] - misses[0]).abs() < 0.01, "{misses:?}");
    assert!((1.0 - strips[0].thinning - t).abs() < 0.01, "{strips:?} {t}");
    let rubbed = pulled_through(0.1, 1);
    let [with_friction, _] = by_hand(0.1);
    let miss = rubbed.restraining / with_friction - 1.0;
    // All of the tension over the whole wrap is more than there can be.
    assert!(miss.abs() < 0.03 && rubbed.restraining < tension * (0.1 * 2.0 * PI).exp(), "{rubbed:?} {with_friction}");
    let [by_elements, with_friction] = [percent(&misses, 1), percent(&[miss], 1)];
    let figure =
        format!("{by_elements} with 1 and 2 times the elements; with friction 0.1 over each wrap {with_friction}");
    agreement("strip over three frictionless rollers, its bending and unbending in closed form", &[figure]);
}

/// The bead of `round` at [`AT`] drawn in holder and die, their faces `gap` apart \[mm\].
fn drawn_round([radius, height, shoulder, clearance]: [f64; 4], gap: f64) -> [String; 2] {
    let half = (radius * radius - (radius - height).powi(2)).sqrt();
    let (wall, edge) = (half + clearance, half + clearance + shoulder);
    let (start, top) = (gap + shoulder, gap + shoulder + height + 1.0);
    let from = |x: f64, z: f64| format!("{{ from = {} }}", point(x, z));
    let to = |points: &[[f64; 2]]| {
        points.iter().map(|[x, z]| format!("{{ to = {} }}", point(*x, *z))).collect::<Vec<_>>().join(", ")
    };
    let tip = arc([AT + half, 0.0], [AT, height - radius], "right");
    let holder = [from(36.0, -20.0), to(&[[36.0, 0.0], [AT - half, 0.0]]), tip, to(&[[END, 0.0]])];
    let die = [
        from(END, gap),
        to(&[[AT + edge, gap]]),
        arc([AT + wall, start], [AT + edge, start], "right"),
        to(&[[AT + wall, top], [AT - wall, top], [AT - wall, start]]),
        arc([AT - edge, gap], [AT - edge, start], "right"),
        to(&[[39.4, gap]]),
        arc([31.4, gap + 8.0], [39.4, gap + 8.0], "right"),
        to(&[[31.4, gap + 80.0]]),
    ];
    [&holder[..], &die].map(|steps| format!("profile = [{}]", steps.join(", ")))
}

/// Trust: the bead that is given by its section and the same bead drawn in holder and die, both by the flow law and with one
/// gap, hold a strip back alike; the drawn one has half as many points through the thickness.
#[test]
fn a_bead_by_its_section_holds_the_strip_back_as_a_drawn_one() {
    let strip = |sections: &[String; 2], more: &str| {
        let (stages, _) = drawn("plane_strain", "gap = \"1.02 mm\"", sections, more);
        assert!(stages[0].stop.is_complete(), "{}", stages[0].stop);
        peak(&stages[0])
    };
    let flat = ["inner_half_width = \"36 mm\"".to_owned(), "throat = \"31.4 mm\", shoulder = \"8 mm\"".to_owned()];
    let round = "{ radius = \"5 mm\", height = \"4 mm\", shoulder = \"5 mm\", clearance = \"1.2 mm\" }";
    let free = strip(&flat, "");
    let line = strip(&flat, &format!("[[tools.beads]]\nat = \"58 mm\"\nround = {round}")) - free;
    let bead = strip(&drawn_round([5.0, 4.0, 5.0, 1.2], 1.02), "") - free;
    assert!(bead > 3.0 * free && (bead / line - 1.0).abs() < 0.1, "{bead} {line}");
    let miss = percent(&[line / bead - 1.0], 0);
    agreement(
        "punch force that a bead by its section adds, over that of the same bead drawn in holder and die",
        &[miss],
    );
}

/// Trust: forces and thinning grow with the penetration; a bead that tears its strip names itself, and is a run that stopped.
#[test]
fn a_bead_has_its_table_and_tears_a_strip_that_is_bent_too_much() {
    let base = fs::read_to_string("cases/quickstart.toml").expect("a case").replace("10 kN", "200 kN");
    let beads = |round: &str| format!("tools.beads=[{{ at = \"48 mm\", round = {round} }}]");
    let with = |round: &str| case::parse(&base, "cup.toml", &[beads(round)]);
    let case = with("{ radius = \"3 mm\", height = \"1.5 mm\", shoulder = \"2 mm\" }").expect("a sound bead");
    let table = bead::table(case.model()).expect("a table");
    for key in ["penetration", "restraining", "thinning"] {
        assert!(table.column(key).values.is_sorted() && table.rows() == 4, "{key} {table:?}");
    }
    let [line] = &case.model().beads[..] else { panic!("one bead") };
    assert!((line.restraining.largest() / table.column("restraining").values[3] - 1.0).abs() < 5e-3, "{line:?}");
    let torn = with("{ radius = \"1 mm\", height = \"9 mm\", shoulder = \"1 mm\" }").expect_err("torn");
    assert!(torn.is_stopped_run && torn.key() == "tools.beads.0.round", "{torn:?}");
}
