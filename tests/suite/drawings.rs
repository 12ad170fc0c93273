//! Drawings by other programs: each gives the profile that was drawn, a faulty one says what is wrong and where.

use crate::common::files::files;
use proptest::prelude::*;
use stampflow::case;
use stampflow::geometry::{Arc, Piece, Point, Profile, Segment};
use stampflow::import::{DrawingUnit, Options, Sections, read};
use stampflow::model::Role;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

pub(crate) fn sections(drawing: &str, options: &Options) -> Sections {
    let bytes = fs::read(Path::new("tests/drawings").join(drawing)).unwrap();
    read(&bytes, options).unwrap_or_else(|error| panic!("{drawing}: {error}"))
}

pub(crate) fn line(from: [f64; 2], to: [f64; 2]) -> Piece {
    Piece::Segment(Segment::new(from.into(), to.into()))
}

/// A quarter of a circle about `center` that turns to the right as one goes along it: a convex corner.
fn corner(center: [f64; 2], radius: f64, start_degrees: f64) -> Piece {
    Piece::Arc(Arc::new(center.into(), radius, start_degrees.to_radians(), -std::f64::consts::FRAC_PI_2))
}

/// A flat punch: half-width of its flat, nose, level of its face and of its end, z downward along the travel.
pub(crate) fn punch(flat: f64, nose: f64, face: f64, end: f64) -> Vec<Piece> {
    let wall = flat + nose;
    vec![
        line([0.0, face], [flat, face]),
        corner([flat, face - nose], nose, 90.0),
        line([wall, face - nose], [wall, end]),
    ]
}

/// A die from outside inward: reach of its face, throat, shoulder, level of its face and of its end.
pub(crate) fn die(reach: f64, throat: f64, shoulder: f64, face: f64, end: f64) -> Vec<Piece> {
    vec![
        line([reach, face], [throat + shoulder, face]),
        corner([throat + shoulder, face + shoulder], shoulder, -90.0),
        line([throat, face + shoulder], [throat, end]),
    ]
}

pub(crate) fn holder(inner: f64, face: f64, end: f64) -> Vec<Piece> {
    vec![line([inner, end], [inner, face]), line([inner, face], [90.0, face])]
}

/// Every piece with both ends, and an arc with centre, radius and sense, is the one expected (1e-6 mm: drawings are written
/// with 16 digits, and joints of round-off are closed).
pub(crate) fn assert_is(sections: &Sections, role: Role, expected: &[Piece], drawing: &str) {
    let found = &sections.tool(role).unwrap_or_else(|| panic!("{drawing}: no {}", role.name())).profile;
    assert_eq!(found.pieces().len(), expected.len(), "{drawing}: {found:?}");
    for (a, b) in found.pieces().iter().zip(expected) {
        let off = (a.first() - b.first()).norm().max((a.last() - b.last()).norm());
        assert!(off < 1e-6, "{drawing}: {a:?} {b:?}");
        match (a, b) {
            (Piece::Segment(_), Piece::Segment(_)) => {}
            (Piece::Arc(a), Piece::Arc(b)) => {
                assert!((a.center - b.center).norm() < 1e-6 && (a.radius - b.radius).abs() < 1e-6, "{drawing}");
                assert!((a.sweep - b.sweep).abs() < 1e-6, "{drawing}: {a:?} {b:?}");
            }
            _ => panic!("{drawing}: {a:?} instead of {b:?}"),
        }
    }
}

/// Trust: the programs were told these shapes (write.py, write.mjs), which are stated here anew as a tool maker would.
#[test]
fn drawings_give_the_profiles_that_were_drawn() {
    let mm = Options { unit: Some(DrawingUnit::Mm), ..Options::default() };
    let header = Options::default();
    let quickstart = (punch(24.0, 6.0, -20.0, -200.0), die(90.0, 31.25, 6.0, 0.5, 120.0), holder(32.0, -10.0, -40.0));
    let at_zero = |end: f64| (punch(24.0, 6.0, 0.0, -end), die(90.0, 31.25, 6.0, 1.0, end));
    let (halves, bulges) = ((punch(24.0, 6.0, 0.0, -80.0), die(90.0, 31.25, 6.0, 1.0, 90.0)), at_zero(100.0));
    let inches = (punch(25.4, 6.35, 0.0, -101.6), die(88.9, 33.02, 6.35, 1.016, 101.6));
    let (closed, below) = (holder(32.0, 0.0, -30.0), holder(32.0, 0.0, -20.0));
    for (drawing, options, punch, die, holder) in [
        ("ezdxf_lines_and_arcs.dxf", &header, &quickstart.0, &quickstart.1, Some(&quickstart.2)),
        ("ezdxf_inches.dxf", &header, &quickstart.0, &quickstart.1, Some(&quickstart.2)),
        ("ezdxf_both_halves.dxf", &header, &halves.0, &halves.1, Some(&closed)),
        ("ezdxf_r12_mirrored.dxf", &mm, &bulges.0, &bulges.1, None),
        ("tarikjabiri_bulges.dxf", &header, &bulges.0, &bulges.1, None),
        ("makerjs_inches_both_halves.dxf", &header, &inches.0, &inches.1, None),
        ("dxfwriter_polylines_punch_below.dxf", &header, &bulges.0, &bulges.1, Some(&below)),
    ] {
        let found = sections(drawing, options);
        assert_is(&found, Role::Punch, punch, drawing);
        assert_is(&found, Role::Die, die, drawing);
        match holder {
            Some(holder) => assert_is(&found, Role::Holder, holder, drawing),
            None => assert!(found.tool(Role::Holder).is_none(), "{drawing}"),
        }
    }
}

/// Points along the lines and arcs of a profile.
fn along(pieces: &[Piece]) -> impl Iterator<Item = Point> {
    pieces.iter().flat_map(|piece| piece.sample(40))
}

/// Sum of control points times Bernstein polynomials, drawn with y up: z = −y.
fn bezier(control: &[[f64; 2]; 4], u: f64) -> Point {
    let share = [(1.0 - u).powi(3), 3.0 * u * (1.0 - u).powi(2), 3.0 * u * u * (1.0 - u), u.powi(3)];
    control.iter().zip(share).map(|(p, share)| share * Point::new(p[0], -p[1])).sum()
}

/// N of degree p by the definition of B-splines (Cox, de Boor).
fn basis(knots: &[f64], i: usize, p: usize, u: f64) -> f64 {
    if p == 0 {
        return f64::from(u8::from(knots[i] <= u && u < knots[i + 1]));
    }
    let part = |from: f64, to: f64, up: bool| match to - from {
        0.0 => 0.0,
        width if up => (u - from) / width,
        width => (to - u) / width,
    };
    part(knots[i], knots[i + p], true) * basis(knots, i, p - 1, u)
        + part(knots[i + 1], knots[i + p + 1], false) * basis(knots, i + 1, p - 1, u)
}

/// Trust: closed forms (circle, parabola, Bernstein and B-spline bases); the tolerance that was asked for, and 1e-9 of
/// round-off. Both ways: no point of the arcs is away from the curve, none of the curve from the arcs.
#[test]
fn splines_are_followed_within_their_tolerance() {
    for tolerance in [1e-3, 1e-5] {
        let options = Options { tolerance, ..Options::default() };
        let near = tolerance + 1e-9;
        let found = sections("ezdxf_splines.dxf", &options);
        let pieces = found.tool(Role::Punch).unwrap().profile.pieces();
        let (circle, free): (Vec<Piece>, Vec<Piece>) = pieces.iter().partition(|piece| piece.last().y > -25.0 - 1e-9);
        // A quarter of a circle as a rational spline, centre 25 mm behind its lowest point.
        assert!(along(&circle).all(|p| ((p - Point::new(0.0, -25.0)).norm() - 25.0).abs() < near));
        assert!((circle[0].first() - Point::zeros()).norm() < 1e-6);
        let free = Profile::new(free).unwrap();
        let control = [[25.0, 25.0], [25.0, 40.0], [27.0, 50.0], [27.0, 70.0]];
        for i in 0..=500 {
            assert!(free.closest(bezier(&control, f64::from(i) / 500.0)).distance.abs() < near);
        }
        let turns = free.vertices().map(|v| v.turn.abs()).fold(0.0, f64::max);
        assert!(turns < 1e-6, "the arcs go on from each other: {turns}");

        let die = &found.tool(Role::Die).unwrap().profile;
        let control = [[80.0, -1.0], [60.0, -1.0], [40.0, -1.0], [30.0, -6.0], [29.0, -16.0], [29.0, -60.0]];
        let knots = [0.0, 0.0, 0.0, 0.0, 1.0, 2.0, 3.0, 3.0, 3.0, 3.0];
        for j in 0..600 {
            let u = f64::from(j) * 0.005;
            let p: Point =
                control.iter().enumerate().map(|(i, c)| basis(&knots, i, 3, u) * Point::new(c[0], -c[1])).sum();
            let away = die.closest(p).distance.abs();
            assert!(away < near, "{away} mm at u = {u}, tolerance {tolerance}");
        }

        // y = x²/10 in cm up to x = 2, and a wall. Vertical distances are up to 8 % longer on its slope of 0.4.
        let parabola = sections("tarikjabiri_spline_cm.dxf", &options);
        let pieces = parabola.tool(Role::Punch).unwrap().profile.pieces();
        let (wall, curve) = pieces.split_last().unwrap();
        assert!(along(curve).all(|p| (p.y + p.x * p.x / 100.0).abs() < 1.08 * near));
        assert!((wall.first() - Point::new(20.0, -4.0)).norm() < 1e-6);
        assert!((wall.last() - Point::new(20.0, -80.0)).norm() < 1e-6);
    }
}

/// Trust: by hand. What is repeated or lies on the axis goes, the left half is mirrored, the wall gives way to the nose.
#[test]
fn untidy_drawings_are_put_in_order_and_that_is_said() {
    let found = sections("ezdxf_untidy.dxf", &Options { axis: Some(200.0), ..Options::default() });
    assert_is(&found, Role::Punch, &punch(24.0, 6.0, 0.0, -100.0), "ezdxf_untidy.dxf");
    assert_is(&found, Role::Die, &die(90.0, 31.25, 6.0, 1.0, 100.0), "ezdxf_untidy.dxf");
    let notes = found.notes.join("\n");
    for says in [
        "runs along the axis",
        "it repeats LINE",
        "from x = 230 mm, y = 100 mm to x = 230 mm, y = 6.004 mm",
        "up to 4.00e-3 mm apart are joined",
        "the die is drawn on the left of the axis only",
        "the axis is at x = 200 mm",
    ] {
        assert!(notes.contains(says), "{says} is not in\n{notes}");
    }
}

pub(crate) fn stampflow(dir: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_stampflow")).args(args).current_dir(dir).output().unwrap()
}

pub(crate) fn text(bytes: &[u8]) -> &str {
    std::str::from_utf8(bytes).unwrap()
}

/// A folder with one drawing.
pub(crate) fn folder(drawing: &Path) -> temp_dir::TempDir {
    let dir = temp_dir::TempDir::new().unwrap();
    fs::copy(drawing, dir.path().join(drawing.file_name().unwrap())).unwrap();
    dir
}

/// Every `tests/drawings/faulty/NAME.dxf` has the message it must give in `NAME.txt`; `UPDATE=1` writes them anew. Exit code
/// 2, and nothing is left behind.
#[test]
fn faulty_drawings_give_the_expected_messages() {
    let faulty = files("tests/drawings/faulty", "dxf");
    assert!(faulty.len() >= 20, "only {} faulty drawings", faulty.len());
    let update = std::env::var_os("UPDATE").is_some();
    let mut wrong = Vec::new();
    for path in &faulty {
        let dir = folder(path);
        let name = path.file_name().unwrap().to_str().unwrap();
        let done = stampflow(dir.path(), &["import", name]);
        let found = text(&done.stderr);
        assert_eq!(done.status.code(), Some(2), "{name}: {found}");
        assert!(done.stdout.is_empty() && files(dir.path(), "").len() == 1, "{name} left something behind");
        let expectation = path.with_extension("txt");
        if update {
            fs::write(&expectation, found).unwrap();
        }
        let expected = fs::read_to_string(&expectation).unwrap_or_else(|_| "(no expectation)\n".into());
        if found != expected {
            wrong.push(format!("{name}\nfound:\n{found}expected:\n{expected}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert_eq!(files("tests/drawings/faulty", "txt").len(), faulty.len(), "an expectation without its drawing");
}

/// Trust: numbers of a file, not of an error: what is listed stays a few lines.
#[test]
fn names_in_messages_about_drawings_are_short_and_few() {
    let line = |layer: &str| format!("0\nLINE\n8\n{layer}\n10\n1\n20\n0\n11\n2\n21\n0\n");
    let many: String = (0..10_000).map(|i| line(&format!("L{i}"))).collect();
    for entities in [line(&"W".repeat(100_000)), many, line(&"punch".repeat(1_000)), line(&"punch die".repeat(1_000))] {
        let text = format!("0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n");
        let error = read(text.as_bytes(), &Options { unit: Some(DrawingUnit::Mm), ..Options::default() }).map(|_| ());
        let length = error.map_or_else(|error| error.to_string().len() + error.help.len(), |()| 0);
        assert!(length < 1_500, "a message of {length} bytes");
    }
}

/// Trust: the whole way. The case that is written has the profiles of the drawing, placed; it can be checked and run.
#[test]
fn an_imported_case_can_be_checked_and_run() {
    for (drawing, more) in [
        ("ezdxf_lines_and_arcs", &[][..]),
        ("tarikjabiri_bulges", &["--thickness", "0.9 mm", "--travel", "5 mm", "--geometry", "plane_strain"]),
        ("ezdxf_splines", &["--tolerance", "0.01 mm"]),
    ] {
        let dir = folder(&Path::new("tests/drawings").join(drawing).with_extension("dxf"));
        let file = format!("{drawing}.dxf");
        let imported = stampflow(dir.path(), &[&["import", &file, "-o", "cases/die.toml"], more].concat());
        assert_eq!(imported.status.code(), Some(0), "{drawing}: {}", text(&imported.stderr));
        assert!(text(&imported.stdout).contains("cases/die.toml"), "{}", text(&imported.stdout));
        assert!(fs::metadata(dir.path().join("cases/die.png")).unwrap().len() > 10_000);
        let checked = stampflow(dir.path(), &["check", "cases/die.toml"]);
        assert_eq!(checked.status.code(), Some(0), "{drawing}: {}", text(&checked.stderr));
        assert!(text(&checked.stdout).contains("declared: placeholders, not in the drawing"));
        let done = stampflow(dir.path(), &["run", "cases/die.toml", "--quiet"]);
        assert_eq!(done.status.code(), Some(0), "{drawing}: {}{}", text(&done.stderr), text(&done.stdout));
    }
}

/// Trust: by hand: punch 30 mm, throat 31.25 mm, holder and die drawn to 90 mm; Siebel's rule as `check` advises it, rounded up.
#[test]
fn an_import_says_its_size_and_picks_as_new_does() {
    let dir = folder(Path::new("tests/drawings/ezdxf_lines_and_arcs.dxf"));
    let import = |unit: &str| {
        let out = format!("{unit}.toml");
        let done = stampflow(dir.path(), &["import", "ezdxf_lines_and_arcs.dxf", "--unit", unit, "-o", &out]);
        assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
        (text(&done.stdout).to_owned(), case::load(dir.path().join(out), &[]).unwrap())
    };
    let (said, right) = import("mm");
    assert!(said.contains("punch radius 30 mm, die throat radius 31.25 mm, 180 mm wide in all"), "{said}");
    assert!(!said.contains("check --unit"), "{said}");
    let (said, _) = import("cm");
    assert!(said.contains("punch radius 300 mm, die throat radius 312.5 mm, 1800 mm wide in all"), "{said}");
    assert!(
        said.contains("leaves 12.5 mm between punch and die, 12.5 times the sheet's thickness of 1 mm, a placeholder")
    );

    let cup = stampflow::author::templates::find("cup").unwrap().fill(&[]).unwrap();
    let cup = case::parse(&cup, "cup.toml", &[]).unwrap();
    assert_eq!(right.model().material, cup.model().material);
    for (tool, picked) in right.model().tools.iter().zip(&cup.model().tools) {
        assert_eq!(tool.friction, picked.friction);
    }
    let report = stampflow::assess::check::report(&right);
    let pressure = |label: &str| report.lines.iter().find(|line| line.label == label).unwrap().number().unwrap();
    let more = pressure("holder pressure") - pressure("advised pressure");
    assert!((0.0..=0.01).contains(&more), "{more} MPa more than advised");
}

/// Trust: by hand, tan α = 0.36: where the cone meets the level of its face it is 0.95 + 0.25 tan(45° − α/2) in, and 25 mm
/// behind it 9 mm more. Its top is 46.9 mm, the throat 44.45 mm.
#[test]
fn a_cone_wider_than_its_die_is_drawn_as_far_as_it_fits() {
    let dir = folder(Path::new("tests/drawings/ezdxf_cone_inches.dxf"));
    let import = |more: &[&str]| {
        let done =
            stampflow(dir.path(), &[&["import", "ezdxf_cone_inches.dxf", "--force", "-o", "cone.toml"], more].concat());
        (done.status.code(), text(&done.stdout).to_owned() + text(&done.stderr))
    };
    let value = |label: &str| {
        let report = stampflow::assess::check::report(&case::load(dir.path().join("cone.toml"), &[]).unwrap());
        report.lines.iter().find(|line| line.label == label).unwrap_or_else(|| panic!("no {label}")).number().unwrap()
    };
    let (code, said) = import(&["--travel", "25 mm", "--blank-radius", "91 mm"]);
    assert_eq!(code, Some(0), "{said}");
    let slope = 0.36_f64.atan();
    let mouth = 25.4 * (0.95 + 0.25 * (std::f64::consts::FRAC_PI_4 - 0.5 * slope).tan()) + 0.36 * 25.0;
    assert!((mouth - 37.59).abs() < 0.01, "{mouth}");
    // Sizes are written to a micrometre.
    assert!((value("draw ratio") - 91.0 / mouth).abs() < 6e-4, "{}", value("draw ratio"));
    // The cone and the shoulder, a circle of 0.25 in: the distance of its centre from the cone, less the radius, by hand.
    let (r, z) = (50.8, 0.5 + 6.35);
    let away = (r - mouth + 0.36 * (z + 0.5)) * slope.cos() - 6.35;
    assert!((value("clearance") - away).abs() < 6e-4, "{} {away}", value("clearance"));

    // By itself it picks a travel that fits.
    let (code, said) = import(&[]);
    assert_eq!(code, Some(0), "{said}");
    assert!(value("clearance") >= 1.0 && value("draw ratio") < 2.0);
    // Too far: what it says has no file that is not there.
    let file = fs::read(dir.path().join("cone.toml")).unwrap();
    for (travel, says) in [("50.5 mm", "the punch is in the die"), ("49 mm", "the sheet does not fit")] {
        let (code, said) = import(&["--travel", travel]);
        let said = said.replace("\n  │ ", " ");
        assert_eq!(code, Some(2), "{said}");
        for says in [says, "the case made from ezdxf_cone_inches.dxf is refused", "--travel"] {
            assert!(said.contains(says), "{says} is not in\n{said}");
        }
        assert!(!said.contains("toml:") && !said.contains("╭"), "{said}");
    }
    assert_eq!(fs::read(dir.path().join("cone.toml")).unwrap(), file);
}

/// Inches read as mm: the punch is 1.18 mm and the gap 0.05 mm.
#[test]
fn a_wrong_unit_is_doubted() {
    let dir = folder(Path::new("tests/drawings/ezdxf_inches.dxf"));
    for (unit, doubts) in [
        ("mm", &["7.087 mm wide in all", "room for a sheet of 0.03 mm"][..]),
        ("m", &["7086.614 mm wide in all, which is odd", "times the sheet's thickness of 1 mm, a placeholder"]),
        ("in", &[]),
    ] {
        let done = stampflow(dir.path(), &["import", "ezdxf_inches.dxf", "--force", "--unit", unit]);
        let said = text(&done.stdout).to_owned() + text(&done.stderr);
        assert!(doubts.iter().all(|doubt| said.contains(doubt)), "{unit}: {said}");
        assert_eq!(said.contains("check --unit"), !doubts.is_empty(), "{unit}: {said}");
    }
    // Where there is no case for it, too: the blank is as long as two thicknesses.
    let dir = folder(Path::new("tests/drawings/ezdxf_cone_inches.dxf"));
    let done = stampflow(dir.path(), &["import", "ezdxf_cone_inches.dxf", "--unit", "mm"]);
    assert_eq!(done.status.code(), Some(2));
    assert!(text(&done.stderr).contains("7.2 mm wide"), "{}", text(&done.stderr));
}

/// Trust: the case's profile against the section that was read, moved along z only (1e-9 mm: digits of the file).
#[test]
fn the_written_case_holds_the_sections_exactly() {
    let dir = folder(Path::new("tests/drawings/ezdxf_lines_and_arcs.dxf"));
    let imported = stampflow(dir.path(), &["import", "ezdxf_lines_and_arcs.dxf", "--thickness", "1 mm"]);
    assert_eq!(imported.status.code(), Some(0), "{}", text(&imported.stderr));
    let case = case::load(dir.path().join("ezdxf_lines_and_arcs.toml"), &[]).unwrap();
    // By hand: the punch's face is drawn at y = 20 and goes to z = -0.5; the die's at y = -0.5 and is there already.
    for (role, expected, moved) in [
        (Role::Punch, punch(24.0, 6.0, -20.0, -200.0), 19.5),
        (Role::Die, die(90.0, 31.25, 6.0, 0.5, 120.0), 0.0),
        (Role::Holder, holder(32.0, -10.0, -40.0), 9.5),
    ] {
        let placed = Profile::new(expected).unwrap().shifted(moved);
        let found = &case.model().tool(role).unwrap().profile;
        for (a, b) in found.pieces().iter().zip(placed.pieces()) {
            assert!((a.first() - b.first()).norm() < 1e-9 && (a.last() - b.last()).norm() < 1e-9, "{a:?} {b:?}");
        }
    }

    // What is there stays, unless it is asked to go.
    let again = stampflow(dir.path(), &["import", "ezdxf_lines_and_arcs.dxf"]);
    assert_eq!(again.status.code(), Some(2));
    assert!(text(&again.stderr).contains("--force"), "{}", text(&again.stderr));
    let forced = stampflow(dir.path(), &["import", "ezdxf_lines_and_arcs.dxf", "--force"]);
    assert_eq!(forced.status.code(), Some(0), "{}", text(&forced.stderr));
}

#[test]
fn options_say_what_a_drawing_does_not() {
    let faulty = |name: &str, more: &[&str]| {
        let dir = folder(&Path::new("tests/drawings/faulty").join(name));
        let done = stampflow(dir.path(), &[&["import", name], more].concat());
        (done.status.code(), text(&done.stdout).to_owned() + text(&done.stderr))
    };
    for (name, options, says) in [
        ("no_units.dxf", Options { unit: Some(DrawingUnit::Mm), ..Options::default() }, "1 mm (as asked for)"),
        ("gap.dxf", Options { join: 0.3, ..Options::default() }, "are joined"),
        (
            "two_tools_in_one_name.dxf",
            Options { layers: vec![("punch_and_die".to_owned(), Some(Role::Punch))], ..Options::default() },
            "the punch moves down",
        ),
    ] {
        let notes = sections(&format!("faulty/{name}"), &options).notes.join("\n");
        assert!(notes.contains(says), "{name}: {notes}");
    }
    for (more, says) in [
        (&["--layer", "Stempel=punches"][..], "give punch, die, holder, none"),
        (&["--layer", "Stempel"], "NAME=punch"),
        (&["--layer", "Nothing=punch"], "there is no layer \"Nothing\""),
        (&["--unit", "parsec"], "give mm, cm"),
        (&["--join", "1 kg"], "a length"),
    ] {
        let (code, said) = faulty("unknown_layers.dxf", more);
        assert!(code == Some(2) && said.contains(says), "{more:?}: {said}");
    }
}

/// A drawing in mm of entities.
fn drawing(entities: &str) -> String {
    format!(
        "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n"
    )
}

/// The lines through points, in pieces of their own.
fn lines(layer: &str, points: &[[f64; 2]]) -> String {
    let line = |w: &[[f64; 2]]| {
        format!("0\nLINE\n8\n{layer}\n10\n{}\n20\n{}\n11\n{}\n21\n{}\n", w[0][0], w[0][1], w[1][0], w[1][1])
    };
    points.windows(2).map(line).collect()
}

/// A bowl, its points 0.02 mm apart along x.
fn bowl(n: u32) -> Vec<[f64; 2]> {
    (0..=n).map(|i| 0.02 * f64::from(i)).map(|x| [x, 1e-4 * x * x]).collect()
}

/// Refused or read by their number: comparing each with all others would take minutes.
#[test]
fn long_drawings_are_read_or_refused_by_their_number() {
    let points = bowl(200_000);
    let vertices: String = points.iter().map(|[x, y]| format!("10\n{x}\n20\n{y}\n")).collect();
    for entities in [format!("0\nLWPOLYLINE\n8\npunch\n70\n0\n{vertices}"), lines("punch", &points)] {
        let error = read(drawing(&entities).as_bytes(), &Options::default()).unwrap_err().to_string();
        assert!(error.contains("the punch is drawn in more than 5000 lines and arcs"), "{error}");
    }
    // Both halves, in any order, one of them twice.
    let right = bowl(1_600);
    let left: Vec<[f64; 2]> = right.iter().map(|[x, y]| [-x, *y]).collect();
    let entities = lines("punch", &right) + &lines("punch", &left) + &lines("punch", &right);
    let found = read(drawing(&entities).as_bytes(), &Options::default()).unwrap();
    assert_eq!(found.tool(Role::Punch).unwrap().profile.pieces().len(), 1_600);
    assert!(found.notes.iter().filter(|note| note.contains("it repeats LINE")).count() == 1_600);
    let apart: String = right.chunks_exact(2).map(|pair| lines("punch", pair)).collect();
    let error = read(drawing(&apart).as_bytes(), &Options::default()).unwrap_err().to_string();
    assert!(error.contains("has a gap of 0.02 mm"), "{error}");
}

/// What other programs write between the entities, and what is no number where one has to be.
#[test]
fn groups_that_are_no_shape_are_passed_over_and_damage_is_named_by_its_line() {
    let line = |more: &str| drawing(&format!("0\nLINE\n5\nA1\n8\npunch\n{more}10\n0\n20\n0\n11\n30\n21\n9\n"));
    let plain = read(line("").as_bytes(), &Options::default()).unwrap();
    for more in [
        "999\na remark\n",
        "100\nAcDbLine\n62\nred\n370\n-1\n",
        "1001\nACME\n1010\nx\n1070\n1e99\n",
        "90\n99999999999999999999\n",
    ] {
        assert_eq!(read(line(more).as_bytes(), &Options::default()).unwrap(), plain, "{more}");
    }
    let dated = line("").replace("9\n$INSUNITS", "9\n$TDCREATE\n40\n-1e300\n9\n$INSUNITS");
    assert_eq!(read(dated.as_bytes(), &Options::default()).unwrap(), plain);
    for (more, says) in [
        (
            "31\nten\n",
            "LINE #A1 of layer \"punch\" (line 16 of the file) cannot be read: line 22 has to be a number, and is \"ten\"",
        ),
        ("10\n1e999\n", "line 22 has to be a number, and is \"1e999\""),
        ("0\nSPLINE\n8\npunch\n20\n1\n", "line 26 belongs to a point that has no x before it"),
        ("0\nLWPOLYLINE\n42\n1\n", "line 24 belongs to a point that has no x before it"),
        ("ten\n0\n", "line 21 has to be a group code, and is \"ten\""),
    ] {
        let error = read(line(more).as_bytes(), &Options::default()).unwrap_err();
        assert!(error.to_string().contains(says) && error.line.is_some(), "{error}");
    }
    for (unit, says) in [
        ("3", "unit is miles ($INSUNITS)"),
        ("24", "unit is US survey miles"),
        ("0", "names no unit"),
        ("-1e300", "names no unit"),
    ] {
        let error = read(line("").replace("70\n4\n", &format!("70\n{unit}\n")).as_bytes(), &Options::default());
        assert!(error.unwrap_err().to_string().contains(says), "{unit}");
    }
    // The Windows code page: ü as one byte, € among those that Unicode has elsewhere.
    let windows = line("").replace("punch", "punch F?r 5 @");
    let bytes: Vec<u8> = windows
        .bytes()
        .map(|b| match b {
            b'?' => 0xfc,
            b'@' => 0x80,
            b => b,
        })
        .collect();
    assert!(read(&bytes, &Options::default()).unwrap().tools[0].made_of.contains("punch Für 5 €"));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]
    /// Files cut short, lines lost, doubled or replaced: sections or an error, never a panic.
    #[test]
    fn no_damaged_drawing_makes_the_reader_panic(
        drawing in prop::sample::select(vec![
            "makerjs_inches_both_halves.dxf", "dxfwriter_polylines_punch_below.dxf", "tarikjabiri_spline_cm.dxf",
            "ezdxf_r12_mirrored.dxf",
        ]),
        changes in prop::collection::vec(
            (0.0..1.0_f64, prop::sample::select(vec![
                None, Some("0"), Some("-1"), Some("1e400"), Some("nan"), Some("LINE"), Some("SPLINE"), Some("40"), Some(""),
                Some("99999999999999999999"), Some("ENDSEC"), Some("VERTEX"), Some("ß"),
            ])),
            1..6,
        ),
        kept in 0.2..1.5_f64,
    ) {
        let text = fs::read_to_string(Path::new("tests/drawings").join(drawing)).unwrap();
        let mut lines: Vec<&str> = text.lines().collect();
        for (place, change) in changes {
            let i = (place * lines.len() as f64) as usize;
            match change {
                Some(value) => lines[i] = value,
                None => { lines.remove(i); }
            }
        }
        lines.truncate((kept * lines.len() as f64) as usize);
        let options = Options { unit: Some(DrawingUnit::Mm), ..Options::default() };
        if let Err(error) = read(lines.join("\n").as_bytes(), &options) {
            prop_assert!(!error.to_string().is_empty());
        }
    }
}

/// Trust: Siebel's pressure goes with the tensile strength, and AA6016's is not that of the placeholder.
#[test]
fn an_imported_sheet_is_of_the_library_and_has_its_limit() {
    let dir = folder(Path::new("tests/drawings/ezdxf_lines_and_arcs.dxf"));
    let written = |more: &[&str]| {
        let done =
            stampflow(dir.path(), &[&["import", "ezdxf_lines_and_arcs.dxf", "--force", "-o", "d.toml"], more].concat());
        assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
        fs::read_to_string(dir.path().join("d.toml")).unwrap()
    };
    let pressure = |case: &str| case.lines().find(|line| line.starts_with("pressure = ")).expect("a holder").to_owned();
    let (placeholder, named) = (written(&[]), written(&["--material", "aa6016"]));
    for case in [&placeholder, &named] {
        assert!(case.contains("[forming_limit]\nhill = true"), "{case}");
    }
    assert!(named.contains("name = \"aa6016\"") && !named.contains("[material.hardening"), "{named}");
    assert_ne!(pressure(&placeholder), pressure(&named));
    let unknown = stampflow(dir.path(), &["import", "ezdxf_lines_and_arcs.dxf", "--force", "--material", "butter"]);
    assert_eq!(unknown.status.code(), Some(2), "{}", text(&unknown.stderr));
}

#[test]
fn a_drawing_without_a_die_is_refused() {
    let dir = folder(Path::new("tests/drawings/ezdxf_lines_and_arcs.dxf"));
    let done = stampflow(dir.path(), &["import", "ezdxf_lines_and_arcs.dxf", "--layer", "DIE=none"]);
    let said = text(&done.stderr);
    assert!(done.status.code() == Some(2) && said.contains("no die in") && said.contains("--layer NAME=die"), "{said}");
    assert!(!dir.path().join("ezdxf_lines_and_arcs.toml").exists());
}
