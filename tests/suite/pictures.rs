//! Pictures: what they show, in which formats, how large on paper, and how much they say.

use crate::common::cli::{CUP, folder, stampflow, text};
use crate::common::drawn;
use crate::common::files::files;
use crate::common::pixels::pixels;
use stampflow::case::{Case, Press, parse};
use stampflow::forming_limit::{Instant, Paths};
use stampflow::model::{Bead, Geometry};
use stampflow::plot::chart::{Look, Scale, Series};
use stampflow::plot::dimensioned;
use stampflow::report::{Report, dimensions};
use stampflow::results::{Captions, Chart, Format, OUTPUTS, Pictures, StageView};
use stampflow::solver::solution::StageSolution;

/// The picture of this name.
fn chart(view: &StageView, name: &str) -> Chart {
    let output = OUTPUTS.iter().find(|output| output.stem() == name).expect("a picture of this name");
    output.chart(view).expect("there is something to draw")
}

fn drawn_chart(name: &str) -> Chart {
    let run = drawn::run(&drawn::blown(Geometry::Axisymmetric));
    chart(&drawn::view(&run), name)
}

fn labels(chart: &Chart, look: impl Fn(Look) -> bool) -> Vec<&str> {
    let series = chart.panels.iter().flat_map(|panel| &panel.series).filter(|series| look(series.look));
    series.filter_map(|series| series.label.as_deref()).collect()
}

/// Trust: the SVG is read by another maker's parser; a point is 25.4/72 mm.
#[test]
fn no_letter_is_smaller_than_six_points_on_paper() {
    let chart = drawn_chart("load_travel");
    for width in [50.0, 85.0, 170.0, 400.0] {
        let style = Pictures { formats: vec![Format::Svg], width: Some(width), ..Pictures::default() };
        let svg = String::from_utf8(style.files("a", &chart).remove(0).1).unwrap();
        let document = roxmltree::Document::parse(&svg).unwrap();
        let root = document.root_element();
        assert_eq!(root.attribute("width"), Some(format!("{width}mm").as_str()));
        let px: f64 = root.attribute("viewBox").unwrap().split(' ').nth(2).unwrap().parse().unwrap();
        let sizes = document.descendants().filter_map(|node| node.attribute("font-size")?.parse::<f64>().ok());
        let least = sizes.fold(f64::INFINITY, f64::min) * width / px * 72.0 / 25.4;
        assert!((5.999..99.0).contains(&least), "{width} mm: {least} pt");
    }
}

/// Trust: 85 mm are 1004 pixels of 300 to the inch, and 240.945 pt; the PNG is read by another maker's decoder.
#[test]
fn a_width_on_paper_is_that_of_every_format() {
    let style = Pictures { formats: Format::ALL.to_vec(), width: Some(85.0), ..Pictures::default() };
    let made = style.files("load_travel", &drawn_chart("load_travel"));
    let names: Vec<&str> = made.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["load_travel.svg", "load_travel.pdf", "load_travel.png"]);
    assert!(made[1].1.starts_with(b"%PDF-"));
    let pdf = String::from_utf8_lossy(&made[1].1).into_owned();
    assert!(pdf.contains("/MediaBox [0 0 240.94"), "{}", &pdf[..400]);
    assert_eq!(pixels(&made[2].1).width, 1004);
    let at = made[2].1.windows(4).position(|name| name == b"pHYs").expect("how many pixels to a metre") + 4;
    // 300 to the inch.
    assert_eq!(made[2].1[at..at + 9], [0, 0, 0x2e, 0x23, 0, 0, 0x2e, 0x23, 1]);
    let dense = Pictures { dpi: Some(600.0), ..style };
    assert_eq!(pixels(&dense.files("a", &drawn_chart("load_travel")).remove(2).1).width, 2008);
}

#[test]
fn captions_say_nothing_little_or_all() {
    let run = drawn::run(&drawn::blown(Geometry::Axisymmetric));
    let with = |captions| {
        let mut view = drawn::view(&run);
        view.pictures = Pictures { formats: vec![Format::Svg], captions, ..Pictures::default() };
        String::from_utf8(view.pictures.files("a", &chart(&view, "forming_limit")).remove(0).1).unwrap()
    };
    let [none, short, full] = [Captions::None, Captions::Short, Captions::Full].map(with);
    let of = |text: &str| [none.contains(text), short.contains(text), full.contains(text)];
    assert_eq!(of("drawn for tests"), [false, true, true], "the title");
    assert_eq!(of("The limit is"), [false, true, true], "what the picture shows");
    assert_eq!(of("The geometry is declared"), [false, false, true], "an assumption");
    assert_eq!(of("Marginal"), [true; 3], "the legend");
}

/// Trust: the drawn run's forces are some 95 kN; the peak is the largest of its records.
#[test]
fn the_load_curve_is_in_kn_with_its_peak_and_the_press() {
    let run = drawn::run(&drawn::model(Geometry::Axisymmetric));
    let mut view = drawn::view(&run);
    let peak = run.steps.iter().max_by(|a, b| a.punch_force.total_cmp(&b.punch_force)).unwrap();
    let plain = chart(&view, "load_travel");
    assert_eq!(plain.panels[0].y.text(), "Force [kN]");
    let flag = |chart: &Chart| {
        let flags = chart.panels[0].series.iter().filter(|series| series.look == Look::Flag);
        let peak = flags.filter(|series| series.label.as_deref().is_some_and(|label| label.starts_with("peak")));
        peak.cloned().collect::<Vec<Series>>()
    };
    assert_eq!(flag(&plain).len(), 1);
    assert_eq!(flag(&plain)[0].points, [(peak.travel, 1e-3 * peak.punch_force)]);
    let rated = |force: f64, view: &mut StageView| {
        view.press = Press { force: Some(force), energy: None };
        let chart = chart(view, "load_travel");
        let line = |series: &Series| series.label.as_deref().is_some_and(|label| label.starts_with("Press rating"));
        (chart.panels[0].series.iter().find(|series| line(series)).cloned(), chart.notes.concat())
    };
    let (line, _) = rated(120e3, &mut view);
    assert!(line.expect("a line").points.iter().all(|point| point.1 == 120.0));
    let (line, notes) = rated(4e6, &mut view);
    assert!(line.is_none() && notes.contains("Press rating"), "far above, the curve would be flat: {notes}");
    let mut weak = run.clone();
    weak.steps.iter_mut().for_each(|step| (step.punch_force, step.holder_force) = (1e-3 * step.punch_force, 0.0));
    assert_eq!(chart(&drawn::view(&weak), "load_travel").panels[0].y.text(), "Punch force [N]");
}

/// The drawn cup with these strains at its end: minor and major.
fn strained(geometry: Geometry, strains: [[f64; 2]; 4]) -> StageSolution {
    let mut run = drawn::run(&drawn::blown(geometry));
    let mut paths = Paths::starting(vec![10.0, 30.0, 60.0, 90.0]);
    for share in [0.0, 0.5, 1.0] {
        let strains = strains.iter().map(|[minor, major]| [share * major, share * minor]).collect();
        paths.push(Instant { time: share, travel: 50.0 * share, strains });
    }
    run.paths = paths;
    run
}

/// Trust: no place's minor strain is the larger one, so nothing of the limit lies right of the line on which both are
/// alike; engineering strains are e^ε − 1.
#[test]
fn the_limit_is_drawn_where_places_can_be_and_in_either_strain() {
    let run = strained(Geometry::Axisymmetric, [[0.05, 0.06], [-0.02, 0.1], [-0.1, 0.12], [-0.2, 0.15]]);
    let mut view = drawn::view(&run);
    let logarithmic = chart(&view, "forming_limit");
    let series = &logarithmic.panels[0].series;
    assert!(series.iter().flat_map(|s| &s.points).all(|p| p.0 <= p.1 + 1e-12), "nothing beyond equal strains");
    let zones = labels(&logarithmic, |look| matches!(look, Look::Area { .. }));
    assert_eq!(zones, ["Failed", "Marginal, above 90\u{a0}% of the limit", "Safe"]);
    view.pictures.engineering_strain = true;
    let engineering = chart(&view, "forming_limit");
    assert_eq!(engineering.panels[0].y.text(), "Major engineering strain, mid-surface [–]");
    for (a, b) in series.iter().zip(&engineering.panels[0].series) {
        for (a, b) in a.points.iter().zip(&b.points) {
            assert!((a.0.exp_m1() - b.0).abs() < 1e-12 && (a.1.exp_m1() - b.1).abs() < 1e-12);
        }
    }
}

/// Trust: in plane strain the minor strain is none, so that a diagram would be one upright line.
#[test]
fn a_strip_has_its_major_strain_over_the_part() {
    let run = strained(Geometry::PlaneStrain, [[0.0, 0.06], [0.0, 0.1], [0.0, 0.12], [0.0, 0.02]]);
    let view = drawn::view(&run);
    let strip = chart(&view, "forming_limit");
    let panel = &strip.panels[0];
    assert_eq!(panel.x.text(), "Initial distance from the symmetry plane [mm]");
    let limit = view.model().forming_limit.as_ref().unwrap().plane_strain();
    let line = panel.series.iter().find(|s| s.label.as_deref().is_some_and(|l| l.starts_with("Limit"))).unwrap();
    assert!(line.points.iter().all(|p| (p.1 - limit).abs() < 1e-12));
    let major = panel.series.iter().find(|s| s.label.as_deref() == Some("Major strain")).unwrap();
    assert_eq!(major.points[1..5], [(10.0, 0.06), (30.0, 0.1), (60.0, 0.12), (90.0, 0.02)]);
    assert!(matches!(panel.scale, Scale::Window { x: (0.0, 100.0), .. }));
}

fn case(name: &str, sets: &[&str]) -> Case {
    let sets: Vec<String> = sets.iter().map(|set| (*set).to_owned()).collect();
    let path = format!("{}/cases/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    stampflow::case::load(&path, &sets).unwrap_or_else(|error| panic!("{}", error.render(false)))
}

/// Two lines meet inside of both.
fn cross(a: &[(f64, f64)], b: &[(f64, f64)]) -> bool {
    let side =
        |l: &[(f64, f64)], p: (f64, f64)| (l[1].0 - l[0].0) * (p.1 - l[0].1) - (l[1].1 - l[0].1) * (p.0 - l[0].0);
    side(a, b[0]) * side(a, b[1]) < 0.0 && side(b, a[0]) * side(b, a[1]) < 0.0
}

/// Trust: the sizes are those of the case files, diameters twice their radii; leaders are the thin lines that end left of a
/// label at the section's side.
#[test]
fn a_dimensioned_section_has_diameters_and_leaders_that_do_not_cross() {
    for name in ["quickstart", "stages_cup", "hat_springback", "brite_cylindrical", "osu_stretch", "bulge"] {
        let mut model = case(name, &[]).model().clone();
        model.beads = vec![Bead { at: 0.8 * model.blank.length, restraining: 50.0, closing: 10.0 }];
        let mut solution = stampflow::case::Solution { case: case(name, &[]), stages: Vec::new(), wall: None };
        solution.case.stages[0].model = model;
        let model = solution.case.model();
        let chart = dimensioned("Section".to_owned(), model, None, &dimensions(model, None));
        let series = &chart.panels[0].series;
        let thin = |s: &&Series| s.points.len() == 2 && matches!(s.look, Look::Line { width: 1.0, .. });
        let lines: Vec<_> = series.iter().filter(thin).map(|s| s.points.as_slice()).collect();
        let right = lines.iter().map(|line| line[1].0).fold(0.0, f64::max);
        let leaders: Vec<_> = lines.into_iter().filter(|line| line[1].0 == right).collect();
        for (i, a) in leaders.iter().enumerate() {
            assert!(leaders[..i].iter().all(|b| !cross(a, b)), "{name}: leaders cross");
        }
        // Half of the width is drawn: its line begins beyond the axis, where a dash-dotted line stands.
        let texts = labels(&chart, |look| look == Look::Text);
        let whole = series.iter().filter(thin).filter(|s| s.points[0].0 < 0.0 && s.points[0].1 == s.points[1].1);
        let sizes = texts.iter().filter(|text| text.contains(" Ø ") || text.contains(" width "));
        assert_eq!(whole.count(), sizes.filter(|text| !text.starts_with("Draw bead")).count(), "{name}: {texts:?}");
        let is_axis = |s: &&Series| {
            s.points.iter().all(|p| p.0 == 0.0) && matches!(s.look, Look::Line { dash: [_, _, _, _], .. })
        };
        assert_eq!(series.iter().filter(is_axis).count(), 1, "{name}");
        assert!(texts.iter().any(|text| text.starts_with("Draw bead")), "{name}: {texts:?}");
        if name == "quickstart" {
            for text in
                ["Blank Ø 110\u{a0}mm", "Punch Ø 60\u{a0}mm", "Punch nose R 6\u{a0}mm", "Die shoulder R 6\u{a0}mm"]
            {
                assert!(texts.contains(&text), "{text} is not in {texts:?}");
            }
        }
    }
}

/// Trust: the redraw's punch is another one than the draw's; taking the first one back brings nothing new.
#[test]
fn every_stage_with_tools_of_its_own_has_a_section() {
    let template = stampflow::author::templates::find("redraw").unwrap().fill(&[]).unwrap();
    let redraw = parse(&template, "redraw.toml", &[]).unwrap();
    let cup = parse(&format!("{CUP}{}", crate::common::cli::STAGES), "cup.toml", &[]).unwrap();
    for (case, later) in [(redraw, true), (cup, false)] {
        let solution = case.solve(&mut ());
        let page = Report::of(&solution).html();
        let sections = page.matches("<figcaption>the section at the start").count();
        assert_eq!(sections > 1, later, "{sections}");
    }
}

#[test]
fn letters_that_cannot_be_drawn_are_named() {
    let dir = folder(&CUP.replace("title = \"Cup\"", "title = \"Cup 深絞り r̄ = 1.5\""));
    let run = stampflow(dir.path(), &["run", "cases/cup.toml"]);
    let summary = std::fs::read_to_string(dir.path().join("out/cup/summary.json")).unwrap();
    for letter in ["深 (U+6DF1)", "絞 (U+7D5E)", "り (U+308A)"] {
        assert!(summary.contains(letter), "{summary}");
    }
    assert!(!summary.contains("U+0304"), "the bar of r̄ is drawn: {}", text(&run.stdout));
}

#[test]
fn formats_and_width_are_options_and_an_earlier_format_goes() {
    let dir = folder(CUP);
    let run = |options: &[&str]| stampflow(dir.path(), &[&["run", "cases/cup.toml", "--quiet"], options].concat());
    assert!(run(&["--format", "svg,pdf", "--width", "85 mm", "--captions", "none"]).status.success());
    let written = files(dir.path().join("out/cup"), "");
    let names: Vec<_> = written.iter().map(|path| path.file_name().unwrap().to_str().unwrap()).collect();
    assert!(names.contains(&"load_travel.svg") && names.contains(&"load_travel.pdf"), "{names:?}");
    assert!(!names.iter().any(|name| name.ends_with(".png")), "{names:?}");
    assert!(run(&[]).status.success());
    let left = files(dir.path().join("out/cup"), "");
    assert!(!left.iter().any(|path| path.extension().is_some_and(|end| end == "svg" || end == "pdf")), "{left:?}");
    let narrow = run(&["--width", "5 mm"]);
    assert_eq!(narrow.status.code(), Some(2));
    assert!(text(&narrow.stderr).contains("50 to 400 mm"), "{}", text(&narrow.stderr));
}
