//! Drawings by other programs: each gives the profile that was drawn, a faulty one says what is wrong and where.

use crate::common::prelude::*;
use stampflow::{import::Sections, import::read, model::tool_sizes::extent};

fn sections(drawing: &str, options: &Options) -> Sections {
    let bytes = fs::read(Path::new("tests/drawings").join(drawing)).unwrap();
    read(&bytes, options).unwrap_or_else(|error| panic!("{drawing}: {error}"))
}

pub fn line(from: [f64; 2], to: [f64; 2]) -> Piece {
    Piece::Segment(Segment::new(from.into(), to.into()))
}

/// A quarter of a circle about `center` that turns to the right as one goes along it: a convex corner.
fn corner(center: [f64; 2], radius: f64, start_degrees: f64) -> Piece {
    Piece::Arc(Arc::new(center.into(), radius, start_degrees.to_radians(), -FRAC_PI_2))
}

/// A flat punch: half-width of its flat, nose, level of its face and of its end, z downward along the travel.
fn punch(flat: f64, nose: f64, face: f64, end: f64) -> Vec<Piece> {
    let wall = flat + nose;
    vec![
        line([0.0, face], [flat, face]),
        corner([flat, face - nose], nose, 90.0),
        line([wall, face - nose], [wall, end]),
    ]
}

/// A die from outside inward: reach of its face, throat, shoulder, level of its face and of its end.
fn die(reach: f64, throat: f64, shoulder: f64, face: f64, end: f64) -> Vec<Piece> {
    vec![
        line([reach, face], [throat + shoulder, face]),
        corner([throat + shoulder, face + shoulder], shoulder, -90.0),
        line([throat, face + shoulder], [throat, end]),
    ]
}

fn holder(inner: f64, face: f64, end: f64) -> Vec<Piece> {
    vec![line([inner, end], [inner, face]), line([inner, face], [90.0, face])]
}

/// Every piece with both ends, and an arc with centre, radius and sense, is the one expected (1e-6 mm: drawings are written
/// with 16 digits, and joints of round-off are closed).
fn assert_is(sections: &Sections, role: Role, expected: &[Piece], drawing: &str) {
    let found = &sections.operations[0].tool(role).unwrap_or_else(|| panic!("{drawing}: no {}", role.name())).profile;
    assert_same(found, expected, drawing);
}

fn assert_same(found: &Profile, expected: &[Piece], drawing: &str) {
    assert_eq!(found.pieces().len(), expected.len(), "{drawing}: {found:?}");
    for (a, b) in found.pieces().iter().zip(expected) {
        assert!((a.first() - b.first()).norm().max((a.last() - b.last()).norm()) < 1e-6, "{drawing}: {a:?} {b:?}");
        assert_bends(a, b, Point::zeros(), drawing);
    }
}

/// Both are lines, or arcs with one centre, radius and sense but for a shift.
pub fn assert_bends(a: &Piece, b: &Piece, shift: Point, name: &str) {
    match (a, b) {
        (Piece::Segment(_), Piece::Segment(_)) => {}
        (Piece::Arc(a), Piece::Arc(b)) => {
            assert!((a.center + shift - b.center).norm() < 1e-6 && (a.radius - b.radius).abs() < 1e-6, "{name}");
            assert!((a.sweep - b.sweep).abs() < 1e-6, "{name}: {a:?} {b:?}");
        }
        _ => panic!("{name}: {a:?} instead of {b:?}"),
    }
}

/// Trust: the programs drew these shapes (write.py, write.mjs), which are stated here anew as a tool maker would.
#[test]
fn drawings_give_the_profiles_that_were_drawn() {
    let mm = Options { unit: Some(DrawingUnit::MM), ..Options::default() };
    let header = Options::default();
    let axis = |at: f64| Options { axis: Some(at), ..Options::default() };
    let quickstart = (punch(24.0, 6.0, -20.0, -200.0), die(90.0, 31.25, 6.0, 0.5, 120.0), holder(32.0, -10.0, -40.0));
    let two_columns = vec![
        line([32.0, -40.0], [32.0, -10.0]),
        line([32.0, -10.0], [61.0, -10.0]),
        line([61.0, -10.0], [90.0, -10.0]),
    ];
    let at_zero = |end: f64| (punch(24.0, 6.0, 0.0, -end), die(90.0, 31.25, 6.0, 1.0, end));
    let (halves, bulges) = ((punch(24.0, 6.0, 0.0, -80.0), die(90.0, 31.25, 6.0, 1.0, 90.0)), at_zero(100.0));
    let inches = (punch(25.4, 6.35, 0.0, -101.6), die(88.9, 33.02, 6.35, 1.016, 101.6));
    let (closed, below) = (holder(32.0, 0.0, -30.0), holder(32.0, 0.0, -20.0));
    let operation = (punch(33.0, 6.0, 0.0, -120.0), die(90.0, 40.5, 6.5, 1.0, 120.0));
    for (drawing, options, punch, die, holder) in [
        ("ezdxf_lines_and_arcs.dxf", header.clone(), &quickstart.0, &quickstart.1, Some(&quickstart.2)),
        ("ezdxf_inches.dxf", header.clone(), &quickstart.0, &quickstart.1, Some(&quickstart.2)),
        ("ezdxf_outlines.dxf", header.clone(), &quickstart.0, &quickstart.1, Some(&quickstart.2)),
        ("ezdxf_blocks.dxf", header.clone(), &quickstart.0, &quickstart.1, Some(&two_columns)),
        ("ezdxf_both_halves.dxf", header.clone(), &halves.0, &halves.1, Some(&closed)),
        ("ezdxf_r12_mirrored.dxf", mm, &bulges.0, &bulges.1, None),
        ("ezdxf_untidy.dxf", axis(200.0), &bulges.0, &bulges.1, None),
        ("ezdxf_operations.dxf", header.clone(), &operation.0, &operation.1, Some(&holder(47.5, 0.0, -40.0))),
        ("tarikjabiri_bulges.dxf", header.clone(), &bulges.0, &bulges.1, None),
        ("makerjs_inches_both_halves.dxf", header.clone(), &inches.0, &inches.1, None),
        ("dxfwriter_polylines_punch_below.dxf", header.clone(), &bulges.0, &bulges.1, Some(&below)),
        ("faulty/off_the_axis.dxf", axis(100.0), &quickstart.0, &quickstart.1, Some(&quickstart.2)),
        ("faulty/off_the_axis_with_a_centre_line.dxf", axis(-100.0), &quickstart.0, &quickstart.1, Some(&quickstart.2)),
    ] {
        let found = sections(drawing, &options);
        assert_is(&found, Role::Punch, punch, drawing);
        assert_is(&found, Role::Die, die, drawing);
        match holder {
            Some(holder) => assert_is(&found, Role::Holder, holder, drawing),
            None => assert!(found.operations[0].tool(Role::Holder).is_none(), "{drawing}"),
        }
    }
    assert_is(&sections("faulty/whole_off_the_axis.dxf", &axis(30.0)), Role::Punch, &halves.0, "whole_off_the_axis");
}

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
        let pieces = found.operations[0].tool(Role::Punch).unwrap().profile.pieces();
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

        let die = &found.operations[0].tool(Role::Die).unwrap().profile;
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
        let (wall, curve) = parabola.operations[0].tool(Role::Punch).unwrap().profile.pieces().split_last().unwrap();
        assert!(along(curve).all(|p| (p.y + p.x * p.x / 100.0).abs() < 1.08 * near));
        assert!((wall.first() - Point::new(20.0, -4.0)).norm() < 1e-6);
        assert!((wall.last() - Point::new(20.0, -80.0)).norm() < 1e-6);
    }
}

/// A folder with one drawing.
fn folder(drawing: impl AsRef<Path>) -> TempDir {
    let (dir, path) = (TempDir::new().unwrap(), Path::new("tests/drawings").join(drawing));
    fs::copy(&path, dir.path().join(path.file_name().unwrap())).unwrap();
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
        let dir = folder(path.strip_prefix("tests/drawings").unwrap());
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

/// Trust: the whole way. The case that is written has the profiles of the drawing, placed; it can be checked and run.
#[test]
fn an_imported_case_can_be_checked_and_run() {
    for (drawing, more) in [
        ("ezdxf_lines_and_arcs.dxf", &[][..]),
        ("tarikjabiri_bulges.dxf", &["--thickness", "0.9 mm", "--travel", "5 mm", "--geometry", "plane_strain"]),
        ("ezdxf_splines.dxf", &["--tolerance", "0.01 mm"]),
        ("ezdxf_operations.dxf", &["--thickness", "1 mm", "--travel", "30 mm"]),
    ] {
        let dir = folder(drawing);
        ends(&stampflow(dir.path(), &[&["import", drawing, "-o", "cases/die.toml"], more].concat()), 0, "");
        assert!(fs::metadata(dir.path().join("cases/die.png")).unwrap().len() > 10_000);
        for args in [&["check", "cases/die.toml"][..], &["run", "cases/die.toml", "--quiet", "--no-advice"]] {
            ends(&stampflow(dir.path(), args), 0, "");
        }
    }
}

/// The case that a drawing gives, and what is printed.
fn imported(drawing: &str, args: &[&str]) -> (Case, String) {
    let dir = folder(drawing);
    let done = stampflow(dir.path(), &[&["import", drawing, "-o", "made.toml"], args].concat());
    ends(&done, 0, "");
    (loaded(dir.path().join("made.toml"), &[]), text(&done.stdout).to_owned() + text(&done.stderr))
}

fn check_value(case: &Case, label: &str) -> f64 {
    crate::check::value(&check::report(case), label)
}

/// Trust: the cup of `new`; the holder's pressure is 2.5 MPa, which is usual for steel (Tschätsch) and above Siebel's.
#[test]
fn an_import_picks_material_friction_and_pressure_as_new_does() {
    let (drawn, _) = imported("ezdxf_lines_and_arcs.dxf", &[]);
    let cup = made("cup", &[], &[]);
    assert_eq!(drawn.model().material, cup.model().material);
    for (tool, picked) in drawn.model().tools.iter().zip(&cup.model().tools) {
        assert_eq!(tool.friction, picked.friction);
    }
    let [pressure, least] = ["holder pressure", "least pressure"].map(|label| check_value(&drawn, label));
    assert!((pressure - 2.5).abs() < 1e-6 && least < pressure, "{pressure} MPa, {least} MPa at least");
    let (named, _) = imported("ezdxf_lines_and_arcs.dxf", &["--material", "aa6016"]);
    assert!(named.model().forming_limit.is_some() && named.model().material != drawn.model().material);
    assert_ne!(check_value(&named, "holder pressure"), check_value(&drawn, "holder pressure"));
}

/// Trust: by hand, tan α = 0.36: where the cone meets the level of its face it is 0.95 + 0.25 tan(45° − α/2) in, and 25 mm
/// behind it 9 mm more. Its top is 46.9 mm, the throat 44.45 mm. Sizes are written to a micrometre.
#[test]
fn a_cone_wider_than_its_die_is_drawn_as_far_as_it_fits() {
    let (given, _) = imported("ezdxf_cone_inches.dxf", &["--travel", "25 mm", "--blank-radius", "91 mm"]);
    let slope = 0.36_f64.atan();
    let mouth = 25.4 * (0.95 + 0.25 * (FRAC_PI_4 - 0.5 * slope).tan()) + 0.36 * 25.0;
    assert!((check_value(&given, "draw ratio") - 91.0 / mouth).abs() < 6e-4);
    // The cone and the shoulder, a circle of 0.25 in: the distance of its centre from the cone, less the radius.
    let (r, z) = (50.8, 0.5 + 6.35);
    let away = (r - mouth + 0.36 * (z + 0.5)) * slope.cos() - 6.35;
    assert!((check_value(&given, "clearance") - away).abs() < 6e-4);
    let (picked, _) = imported("ezdxf_cone_inches.dxf", &[]);
    assert!(check_value(&picked, "clearance") >= 1.0 && check_value(&picked, "draw ratio") < 2.0);
}

/// Trust: of the drawing in inches read as mm the punch is 1.18 mm and the gap 0.05 mm; that in mm, 180 mm wide, would be 4.6 m as
/// inches of a wrong header. Without its punch it makes no run.
#[test]
fn a_doubtful_drawing_is_asked_about() {
    for (unit, is_doubted) in [("mm", true), ("m", true), ("in", false)] {
        let (_, printed) = imported("ezdxf_inches.dxf", &["--unit", unit]);
        assert!(printed.contains("warning: ") == is_doubted, "{unit}: {printed}");
    }
    let (dir, unit) = (folder("ezdxf_lines_and_arcs.dxf"), Regex::new("(INSUNITS\n *70\n *)[14]\n").unwrap());
    for (name, header, wrong) in
        [("ezdxf_inches", "${1}4\n", "mm.dxf"), ("ezdxf_lines_and_arcs", "${1}1\n", "inches.dxf")]
    {
        let drawing = fs::read_to_string(format!("tests/drawings/{name}.dxf")).unwrap().replace("\r\n", "\n");
        let other = unit.replace(&drawing, header).into_owned();
        assert!(other != drawing);
        fs::write(dir.path().join(wrong), other).unwrap();
    }
    for (args, code, says) in [
        (&["mm.dxf"][..], 2, "try --unit in"),
        (&["inches.dxf"], 2, "--unit mm"),
        (&["inches.dxf", "--unit", "mm"], 0, ""),
        (&["inches.dxf", "--unit", "mm"], 2, "--force"),
        (&["inches.dxf", "--unit", "in", "--force"], 0, ""),
        (&["ezdxf_lines_and_arcs.dxf", "--layer", "PUNCH=none"], 2, "--layer NAME=punch"),
        (&["ezdxf_lines_and_arcs.dxf", "--layer", "DIE=none"], 2, "\"DIE\" (3 entities)"),
    ] {
        ends(&stampflow(dir.path(), &[&["import"], args].concat()), code, says);
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
    assert_eq!(found.operations[0].tool(Role::Punch).unwrap().profile.pieces().len(), 1_600);
    assert!(found.notes.iter().filter(|note| note.contains("it repeats LINE")).count() == 1_600);
    let apart: String = right.chunks_exact(2).map(|pair| lines("punch", pair)).collect();
    let error = read(drawing(&apart).as_bytes(), &Options::default()).unwrap_err().to_string();
    assert!(error.contains("has a gap of 0.02 mm"), "{error}");
}

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
    // The Windows code page: ü as one byte, € among those that Unicode has elsewhere.
    let windows = line("").replace("punch", "punch F?r 5 @");
    let bytes: Vec<u8> =
        windows.bytes().map(|b| [b, 0xfc, 0x80][usize::from(b == b'?') + 2 * usize::from(b == b'@')]).collect();
    assert!(read(&bytes, &Options::default()).unwrap().operations[0].tools[0].made_of.contains("punch Für 5 €"));
}

/// Trust: each option is the remedy that the message on its drawing names.
#[test]
fn options_are_the_remedies_of_faulty_drawings() {
    let punch = vec![("punch_and_die".to_owned(), Some(Role::Punch))];
    sections("faulty/no_units.dxf", &Options { unit: Some(DrawingUnit::MM), ..Options::default() });
    sections("faulty/gap.dxf", &Options { join: 0.3, ..Options::default() });
    sections("faulty/two_tools_in_one_name.dxf", &Options { layers: punch, ..Options::default() });
}

/// Refused by number: two columns and rows that would be millions, and blocks whose copies double twenty times.
#[test]
fn blocks_that_would_fill_the_memory_are_refused() {
    let mut blocks = String::from("0\nBLOCK\n2\nB0\n0\nLINE\n8\npunch\n11\n30\n0\nENDBLK\n");
    for i in 1..=20 {
        let two = format!("0\nINSERT\n2\nB{}\n", i - 1).repeat(2);
        let _ = write!(blocks, "0\nBLOCK\n2\nB{i}\n{two}0\nENDBLK\n");
    }
    for insert in ["2\nB0\n70\n30000\n71\n30000\n", "2\nB20\n"] {
        let text = format!(
            "0\nSECTION\n2\nBLOCKS\n{blocks}0\nENDSEC\n0\nSECTION\n2\nENTITIES\n0\nINSERT\n{insert}0\nENDSEC\n0\nEOF\n"
        );
        let mm = Options { unit: Some(DrawingUnit::MM), ..Options::default() };
        let error = read(text.as_bytes(), &mm).unwrap_err().to_string();
        assert!(error.contains("with its blocks the drawing has more than 200000 entities"), "{error}");
    }
}

/// Trust: the numbers that write.py has, with z downward; the cone of 40° leads to a shoulder of 50°.
#[test]
fn layers_with_numbers_are_stages() {
    let found = sections("ezdxf_operations.dxf", &Options::default());
    let [first, later] = &found.operations[..] else { panic!("two stages") };
    assert_eq!((first.number, later.number, later.name().as_str()), (Some(20), Some(30), "OP30"));
    assert_same(&later.tool(Role::Punch).unwrap().profile, &punch(24.0, 6.0, 0.0, -160.0), "OP30");
    let pieces = later.tool(Role::Die).unwrap().profile.pieces();
    assert!(matches!(pieces[1], Piece::Arc(Arc { radius, sweep, .. })
        if (radius - 6.8).abs() < 1e-6 && (sweep + 50_f64.to_radians()).abs() < 1e-6));
    let (case, _) = imported("ezdxf_operations.dxf", &["--thickness", "1 mm", "--travel", "30 mm"]);
    let names: Vec<&str> = case.stages.iter().map(|stage| stage.name.as_str()).collect();
    assert_eq!(names, ["op20", "op30"]);
    let second = &case.stages[1].model;
    assert!((extent(second.tool(Role::Punch).unwrap()).1 - 30.0).abs() < 1e-6);
    assert!((extent(second.tool(Role::Die).unwrap()).0 - 31.5).abs() < 1e-6);
}

#[test]
fn layers_are_understood_in_three_languages() {
    let english = fs::read_to_string("tests/drawings/ezdxf_lines_and_arcs.dxf").unwrap();
    let same = sections("ezdxf_lines_and_arcs.dxf", &Options::default());
    for words in [
        ["Stempel", "Matrize", "Niederhalter"],
        ["POINÇON", "MATRICE", "SERRE-FLAN"],
        ["draw punch", "Draw Ring", "Binder"],
    ] {
        let mut text = english.clone();
        for (layer, word) in ["PUNCH", "DIE", "HOLDER"].iter().zip(words) {
            text = text.replace(&format!("\n{layer}\n"), &format!("\n{word}\n"));
        }
        let found = read(text.as_bytes(), &Options::default()).unwrap();
        for (a, b) in found.operations[0].tools.iter().zip(&same.operations[0].tools) {
            assert_eq!((a.role, &a.profile), (b.role, &b.profile), "{words:?}");
        }
        assert_eq!(found.operations[0].tools.len(), 3);
    }
}

/// Trust: the case's profile against the section that was read, moved along z only.
#[test]
fn the_written_case_holds_the_sections_exactly() {
    let dir = folder("ezdxf_lines_and_arcs.dxf");
    ends(&stampflow(dir.path(), &["import", "ezdxf_lines_and_arcs.dxf", "--thickness", "1 mm"]), 0, "");
    let case = case::load(dir.path().join("ezdxf_lines_and_arcs.toml"), &[]).unwrap();
    // By hand: the punch's face is drawn at y = 20 and goes to z = -0.5; the die's at y = -0.5 and is there already.
    for (role, expected, moved) in [
        (Role::Punch, punch(24.0, 6.0, -20.0, -200.0), 19.5),
        (Role::Die, die(90.0, 31.25, 6.0, 0.5, 120.0), 0.0),
        (Role::Holder, holder(32.0, -10.0, -40.0), 9.5),
    ] {
        let placed = Profile::new(expected).unwrap().shifted(moved);
        assert_same(&case.model().tool(role).unwrap().profile, placed.pieces(), role.name());
    }
    // What is there stays, unless it is asked to go.
    ends(&stampflow(dir.path(), &["import", "ezdxf_lines_and_arcs.dxf"]), 2, "--force");
}

/// Trust: what `export` draws of a cup is read back as the tool that it was, and its mid-surface as a sheet from the axis to the rim.
#[test]
fn a_case_takes_tools_and_sheet_from_a_drawing() {
    let dir = crate::common::cli::folder(CUP);
    ends(&stampflow(dir.path(), &["export", "cases/cup.toml", "-o", "cases/cup.dxf"]), 0, "");
    let drawn = r#"die = { profile = { file = "cup.dxf", layer = "die" }, friction = 0.08 }"#;
    let case = CUP.replace(r#"die = { throat = "31.25 mm", shoulder = "6 mm", friction = 0.08 }"#, drawn);
    let load = |text: &str| {
        fs::write(dir.path().join("cases/drawn.toml"), text).unwrap();
        stampflow::case::load(dir.path().join("cases/drawn.toml"), &[])
    };
    let die = |case: &Case| case.model().tool(Role::Die).expect("a die").profile.clone();
    // The die's far end is drawn no further than the picture goes.
    let corner = |text: &str| die(&load(text).expect("a case")).pieces()[1];
    assert_bends(&corner(&case), &corner(CUP), Point::zeros(), "cup.dxf");
    let sheet = |layer: &str| {
        let profile = format!("profile = {{ file = \"cup.dxf\", layer = \"{layer}\" }}\nedge = \"clamped\"");
        let case = CUP.replace("radius = \"55 mm\"", &profile);
        load(&case[..case.find("die =").expect("a die")])
    };
    let blank = sheet("MIDLINE").expect("a case").model().blank.clone();
    assert!(blank.ends()[0] == 0.0 && (50.0..60.0).contains(&blank.length), "{blank:?}");
    let error = sheet("RIM").expect_err("no such layer").to_string();
    assert!(error.contains("its layers are AXIS, BLANK, DIE"), "{error}");
}
