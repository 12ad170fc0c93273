//! Pictures: labels, sizes on paper, captions, and what each kind shows.

use crate::common::cli::{CUP, folder, stampflow, text};
use crate::common::files::files;
use crate::common::pixels::pixels;
use crate::common::{drawn, shipped};
use stampflow::case::Press;
use stampflow::forming_limit::{Instant, Paths};
use stampflow::measure::bands;
use stampflow::model::{Bead, Geometry, Release};
use stampflow::plot::chart::{AnnotationKind, Scale, Style};
use stampflow::plot::{Captions, Chart, Format, Pictures, StageView, dimensioned, svg};
use stampflow::report::dimensions;
use stampflow::results::{Make, OUTPUTS};
use stampflow::solver::solution::{StageSolution, Stop};

fn chart(view: &StageView, name: &str) -> Chart {
    let output = OUTPUTS.iter().find(|output| output.stem() == name).expect("a picture of this name");
    output.chart(view).expect("there is something to draw").displayed()
}

fn texts(chart: &Chart, kind: impl Fn(AnnotationKind) -> bool) -> Vec<(&str, (f64, f64))> {
    let annotations = chart.panels.iter().flat_map(|panel| &panel.annotations).filter(|a| kind(a.kind));
    annotations.map(|a| (a.text.as_str(), a.at)).collect()
}

fn is_callout(kind: AnnotationKind) -> bool {
    matches!(kind, AnnotationKind::Callout(_))
}

/// Left, top, right and bottom of every horizontal text of an SVG, by a narrow estimate of its letters.
fn boxes(svg: &str) -> Vec<(String, [f64; 4])> {
    let document = roxmltree::Document::parse(svg).expect("well-formed XML");
    let nodes =
        document.descendants().filter(|node| node.has_tag_name("text") && node.attribute("transform").is_none());
    let boxed = nodes.map(|node| {
        let number = |name| node.attribute(name).and_then(|v: &str| v.parse::<f64>().ok()).expect("a number");
        let words = node.text().unwrap_or_default().trim().to_owned();
        let (size, x, y) = (number("font-size"), number("x"), number("y"));
        let width = 0.42 * size * words.chars().count() as f64;
        let left = match node.attribute("text-anchor") {
            Some("middle") => x - 0.5 * width,
            Some("end") => x - width,
            _ => x,
        };
        let down = if node.attribute("dy") == Some("0.76em") { 0.76 } else { 0.25 } * size;
        (words, [left, y + down - 0.7 * size, left + width, y + down])
    });
    boxed.collect()
}

/// Reference: the SVG as another maker's parser reads it.
#[test]
fn every_picture_has_its_labels_and_no_text_on_another() {
    for geometry in [Geometry::Axisymmetric, Geometry::PlaneStrain] {
        for model in [drawn::model(geometry), drawn::blown(geometry)] {
            let run = drawn::run(&model);
            let view = drawn::view(&run);
            let plots = OUTPUTS.iter().filter(|output| matches!(output.make, Make::Plot(_)));
            for (output, chart) in plots.filter_map(|output| Some((output.file, output.chart(&view)?))) {
                assert!(chart.title.starts_with(&run.model.title) && !chart.panels.is_empty(), "{output}");
                for axis in chart.panels.iter().flat_map(|panel| [&panel.x, &panel.y]) {
                    assert!(!axis.label.is_empty() && !axis.unit.is_empty(), "{output}: {axis:?}");
                }
                let boxes = boxes(&svg(&chart));
                for (i, (a, [left, top, right, bottom])) in boxes.iter().enumerate() {
                    for (b, other) in &boxes[..i] {
                        let apart = *right <= other[0] || other[2] <= *left || *bottom <= other[1] || other[3] <= *top;
                        assert!(apart, "{output}: “{a}” lies on “{b}”");
                    }
                }
            }
        }
    }
}

/// Reference: a point is 25.4/72 mm; 85 mm are 1004 pixels of 300 to the inch.
#[test]
fn a_width_on_paper_is_that_of_every_format() {
    let run = drawn::run(&drawn::blown(Geometry::Axisymmetric));
    let chart = chart(&drawn::view(&run), "load_travel");
    for width in [50.0, 85.0, 170.0, 400.0] {
        let style = Pictures { formats: vec![Format::Svg], width: Some(width), ..Pictures::default() };
        let svg = String::from_utf8(style.files("a", &chart).remove(0).1).unwrap();
        let document = roxmltree::Document::parse(&svg).unwrap();
        let root = document.root_element();
        assert_eq!(root.attribute("width"), Some(format!("{width}mm").as_str()));
        let px: f64 = root.attribute("viewBox").unwrap().split(' ').nth(2).unwrap().parse().unwrap();
        let sizes = document.descendants().filter_map(|node| node.attribute("font-size")?.parse::<f64>().ok());
        let least = sizes.fold(f64::INFINITY, f64::min) * width / px * 72.0 / 25.4;
        assert!((5.99..99.0).contains(&least), "{width} mm: {least} pt");
    }
    for (dpi, pixel_width) in [(None, 1004), (Some(600.0), 2008)] {
        let style = Pictures { width: Some(85.0), dpi, ..Pictures::default() };
        let (name, png) = style.files("load_travel", &chart).remove(0);
        assert_eq!((name.as_str(), pixels(&png).width), ("load_travel.png", pixel_width));
        assert!(png.windows(4).any(|chunk| chunk == b"pHYs"), "its pixels per metre");
    }
}

#[test]
fn captions_hold_nothing_little_or_all() {
    let run = drawn::run(&drawn::blown(Geometry::Axisymmetric));
    let with = |captions| {
        let mut view = drawn::view(&run);
        view.pictures = Pictures { formats: vec![Format::Svg], captions, ..Pictures::default() };
        String::from_utf8(view.pictures.files("a", &chart(&view, "forming_limit")).remove(0).1).unwrap()
    };
    let [none, short, full] = [Captions::None, Captions::Short, Captions::Full].map(with);
    for (text, expected) in [
        ("drawn for tests", [false, true, true]),
        ("The limit is", [false, true, true]),
        ("The geometry is declared", [false, false, true]),
        ("Marginal", [true; 3]),
    ] {
        assert_eq!([&none, &short, &full].map(|svg| svg.contains(text)), expected, "{text}");
    }
}

/// Reference: the drawn run's forces are some 95 kN; the peak is the largest of its records.
#[test]
fn the_load_curve_has_its_peak_and_the_press() {
    let run = drawn::run(&drawn::model(Geometry::Axisymmetric));
    let mut view = drawn::view(&run);
    let peak = run.steps.iter().max_by(|a, b| a.punch_force.total_cmp(&b.punch_force)).unwrap();
    let plain = chart(&view, "load_travel");
    assert_eq!(plain.panels[0].y.text(), "Force [kN]");
    let flags = texts(&plain, |kind| kind == AnnotationKind::Flag);
    let peaks: Vec<_> = flags.into_iter().filter(|(text, _)| text.starts_with("peak")).collect();
    assert!(peaks.len() == 1 && peaks[0].1 == (peak.travel, 1e-3 * peak.punch_force), "{peaks:?}");
    for (rating, is_drawn) in [(120e3, true), (4e6, false)] {
        view.press = Press { force: Some(rating), energy: None };
        let chart = chart(&view, "load_travel");
        let is_line = |label: &Option<String>| label.as_deref().is_some_and(|label| label.starts_with("Press rating"));
        let line = chart.panels[0].series.iter().find(|series| is_line(&series.label));
        assert_eq!(line.is_some_and(|line| line.points.iter().all(|p| p.1 == 1e-3 * rating)), is_drawn);
        assert_eq!(chart.notes.concat().contains("Press rating"), !is_drawn);
    }
}

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

/// Reference: the minor strain is never the larger one; engineering strains are e^ε − 1.
#[test]
fn the_limit_ends_at_equal_strains_in_either_measure() {
    let run = strained(Geometry::Axisymmetric, [[0.05, 0.06], [-0.02, 0.1], [-0.1, 0.12], [-0.2, 0.15]]);
    let mut view = drawn::view(&run);
    let logarithmic = chart(&view, "forming_limit");
    let series = &logarithmic.panels[0].series;
    assert!(series.iter().flat_map(|s| &s.points).all(|p| p.0 <= p.1 + 1e-12), "points beyond equal strains");
    let zones = series.iter().filter(|s| matches!(s.style, Style::Area { .. })).filter_map(|s| s.label.as_deref());
    assert_eq!(zones.collect::<Vec<_>>(), ["Failed", "Marginal, above 90 % of the limit", "Safe"]);
    view.pictures.engineering_strain = true;
    let engineering = chart(&view, "forming_limit");
    assert_eq!(engineering.panels[0].y.text(), "Major engineering strain, mid-surface [–]");
    for (a, b) in series.iter().zip(&engineering.panels[0].series) {
        for (a, b) in a.points.iter().zip(&b.points) {
            assert!((a.0.exp_m1() - b.0).abs() < 1e-12 && (a.1.exp_m1() - b.1).abs() < 1e-12);
        }
    }
    let run = strained(Geometry::PlaneStrain, [[0.0, 0.06], [0.0, 0.1], [0.0, 0.12], [0.0, 0.02]]);
    let view = drawn::view(&run);
    let panel = &chart(&view, "forming_limit").panels[0];
    assert_eq!(panel.x.text(), "Initial distance from the symmetry plane [mm]");
    let limit = view.model().forming_limit.as_ref().unwrap().plane_strain();
    let labelled = |start: &str| {
        let is_it = |label: &Option<String>| label.as_deref().is_some_and(|label| label.starts_with(start));
        &panel.series.iter().find(|s| is_it(&s.label)).unwrap().points
    };
    assert!(labelled("Limit").iter().all(|p| (p.1 - limit).abs() < 1e-12));
    assert_eq!(labelled("Major strain")[1..5], [(10.0, 0.06), (30.0, 0.1), (60.0, 0.12), (90.0, 0.02)]);
}

/// Reference: the drawn cup's thinnest element and its numbers by hand; every outline has a mirror image.
#[test]
fn the_part_is_whole_and_its_thinnest_place_is_named() {
    for geometry in [Geometry::Axisymmetric, Geometry::PlaneStrain] {
        let mut run = drawn::run(&drawn::model(geometry));
        let last = run.frames.last().unwrap().clone();
        let thinnest = last.elements.iter().min_by(|a, b| a.thickness.total_cmp(&b.thickness)).unwrap();
        let part = chart(&drawn::view(&run), "part");
        let share = stampflow::units::Amount::share(1.0 - thinnest.thickness);
        let text = format!("{:.2} mm, {share} thinner", thinnest.thickness);
        assert_eq!(texts(&part, is_callout), [(text.as_str(), (thinnest.r, thinnest.z))]);
        let areas = || part.panels[0].series.iter().filter(|series| matches!(series.style, Style::Area { .. }));
        let extent = |points: &[(f64, f64)]| {
            let x = || points.iter().map(|p| p.0);
            (x().fold(f64::INFINITY, f64::min), x().fold(f64::NEG_INFINITY, f64::max))
        };
        for area in areas() {
            let (low, high) = extent(&area.points);
            assert!(areas().any(|other| extent(&other.points) == (-high, -low)), "{low} to {high} mm has no image");
        }

        let torn = last.elements[30];
        run.stop = Stop::Localised { travel: 50.0, s0: torn.s0, share: 0.5, why: Default::default() };
        let part = chart(&drawn::view(&run), "part");
        assert_eq!(texts(&part, is_callout)[1], ("tears here", (-torn.r, torn.z)));

        run.model.release = Some(Release::default());
        let part = chart(&drawn::view(&run), "part");
        let tools = part.panels[0].series.iter().filter(|s| matches!(s.style, Style::Area { edge: Some(_), .. }));
        assert_eq!(tools.count(), 0, "tools after their release");
    }
}

/// Reference: the drawn cup's punch stands at its travel in every frame, half a thickness above the sheet's middle.
#[test]
fn every_state_has_the_tools_of_its_time() {
    let run = drawn::run(&drawn::model(Geometry::Axisymmetric));
    let chart = chart(&drawn::view(&run), "shapes");
    let small: Vec<_> = chart.panels.iter().filter(|panel| panel.is_small).collect();
    assert_eq!(small.len(), run.frames.len());
    for (panel, frame) in small.iter().zip(&run.frames) {
        assert_eq!(panel.caption, format!("Punch travel {} mm", frame.travel));
        let punch = panel.series[0].points.iter().map(|p| p.1).fold(f64::NEG_INFINITY, f64::max);
        assert!((punch - (frame.travel - 0.5)).abs() < 1e-9, "{punch} at {}", frame.travel);
    }
    assert_eq!(chart.panels.last().unwrap().scale, Scale::Bar);
}

/// Reference: the bands that `measure` finds, each named once, with a border between each two.
#[test]
fn thickness_along_the_part_names_its_bands() {
    let stage = shipped::solve(&shipped::shipped("quickstart", &[]));
    let chart = chart(&drawn::view(&stage), "thickness");
    let bands = bands(&stage);
    let names: Vec<&str> = texts(&chart, |kind| kind == AnnotationKind::Middle).iter().map(|name| name.0).collect();
    assert_eq!(names, bands.iter().map(|stretch| stretch.band.name()).collect::<Vec<_>>());
    let [_, over_part] = &chart.panels[..] else { panic!("two panels") };
    let borders = over_part.series.iter().filter(|series| series.points.len() == 2).map(|series| series.points[0].0);
    assert_eq!(borders.collect::<Vec<_>>(), bands[1..].iter().map(|band| band.along[0]).collect::<Vec<_>>());
}

fn cross(a: &[(f64, f64)], b: &[(f64, f64)]) -> bool {
    let side =
        |l: &[(f64, f64)], p: (f64, f64)| (l[1].0 - l[0].0) * (p.1 - l[0].1) - (l[1].1 - l[0].1) * (p.0 - l[0].0);
    side(a, b[0]) * side(a, b[1]) < 0.0 && side(b, a[0]) * side(b, a[1]) < 0.0
}

/// Reference: the sizes are those of the case files; leaders are the thin lines that end left of a text at the side.
#[test]
fn a_dimensioned_section_has_leaders_that_do_not_cross() {
    for name in ["quickstart", "stages_cup", "hat_springback", "brite_cylindrical", "osu_stretch", "bulge"] {
        let mut model = shipped::shipped(name, &[]);
        model.beads = vec![Bead { at: 0.8 * model.blank.length, restraining: 50.0, closing: 10.0 }];
        let chart = dimensioned(name.to_owned(), &model, None, &dimensions(&model, None));
        let series = &chart.panels[0].series;
        let thin = series.iter().filter(|s| s.points.len() == 2 && matches!(s.style, Style::Line { width: 1.0, .. }));
        let lines: Vec<_> = thin.map(|s| s.points.as_slice()).collect();
        let right = lines.iter().map(|line| line[1].0).fold(0.0, f64::max);
        let leaders: Vec<_> = lines.into_iter().filter(|line| line[1].0 == right).collect();
        for (i, a) in leaders.iter().enumerate() {
            assert!(leaders[..i].iter().all(|b| !cross(a, b)), "{name}: leaders cross");
        }
        let texts: Vec<&str> = texts(&chart, |_| true).iter().map(|text| text.0).collect();
        assert!(texts.iter().any(|text| text.starts_with("Draw bead")), "{name}: {texts:?}");
        if name == "quickstart" {
            for text in ["Blank Ø 110 mm", "Punch Ø 60 mm", "Punch nose R 6 mm", "Die shoulder R 6 mm"] {
                assert!(texts.contains(&text), "{text} is not in {texts:?}");
            }
        }
    }
}

#[test]
fn formats_and_width_are_options_and_an_earlier_format_goes() {
    let dir = folder(&CUP.replace("title = \"Cup\"", "title = \"Cup 深絞り r̄ = 1.5\""));
    let run = |options: &[&str]| stampflow(dir.path(), &[&["run", "cases/cup.toml", "--quiet"], options].concat());
    let endings = || {
        let written = files(dir.path().join("out/cup"), "");
        ["svg", "png"].map(|end| written.iter().any(|path| path.extension().is_some_and(|e| e == end)))
    };
    assert!(run(&["--format", "svg", "--width", "85 mm", "--captions", "none"]).status.success());
    assert_eq!(endings(), [true, false]);
    assert!(run(&[]).status.success());
    assert_eq!(endings(), [false, true]);
    let narrow = run(&["--width", "5 mm"]);
    assert_eq!(narrow.status.code(), Some(2));
    assert!(text(&narrow.stderr).contains("50 to 400 mm"), "{}", text(&narrow.stderr));
    let summary = std::fs::read_to_string(dir.path().join("out/cup/summary.json")).unwrap();
    let missing = ["深 (U+6DF1)", "絞 (U+7D5E)", "り (U+308A)", "U+0304"].map(|letter| summary.contains(letter));
    assert_eq!(missing, [true, true, true, false], "the bar of r̄ is in the font");
}
