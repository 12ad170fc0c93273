//! Tools of one's own: read from points, offset from another tool, mirrored; from the case file to the run.

use crate::common::prelude::*;

const FLAT: &str = r#"flat = { radius = "30 mm", nose = "6 mm" }"#;
const DIE: &str = r#"throat = "31.25 mm", shoulder = "6 mm""#;
const HOLDER: &str = r#"holder = { inner_radius = "32 mm", force = "10 kN" }"#;

fn text(punch: &str, die: &str, holder: &str, travel: &str) -> String {
    let blank = MINIMAL.split("[material").next().expect("a blank");
    format!(
        "{blank}elements = 40\n{LAW}[tools]\npunch = {{ {punch}, friction = 0.08, travel = \"{travel}\" }}\n\
         die = {{ {die}, friction = 0.08 }}\n{holder}\n"
    )
}

fn read_in(folder: &Path, text: &str) -> Case {
    let name = folder.join("case.toml");
    case::parse(text, &name.to_string_lossy(), &[]).unwrap_or_else(|e| panic!("{}", e.render(false)))
}

fn read(text: &str) -> Case {
    read_in(Path::new("tests/profiles"), text)
}

/// Reads a case whose punch is the CSV file `points`.
fn with_punch(points: &str, section: &str, travel: &str) -> Case {
    let folder = temp_dir::TempDir::new().unwrap();
    std::fs::write(folder.path().join("punch.csv"), points).unwrap();
    read_in(folder.path(), &text(&format!("profile = {section}"), DIE, HOLDER, travel))
}

fn profile(model: &Model, role: Role) -> &Profile {
    &model.tool(role).unwrap().profile
}

/// Points around the punch's nose.
fn around() -> impl Iterator<Item = Point> {
    (0..400).map(|i| Point::new(0.1 * f64::from(i), 3.0 - 0.04 * f64::from(i)))
}

/// The quickstart's punch as points: chords of 3° around the nose, in a unit.
fn chords(unit: &str, mm: f64) -> String {
    let mut csv = format!("r_{unit},z_{unit}\n0,0\n");
    for i in 0..=30 {
        let angle = (3.0 * f64::from(i)).to_radians();
        writeln!(csv, "{:.9},{:.9}", (24.0 + 6.0 * angle.sin()) / mm, (-6.0 + 6.0 * angle.cos()) / mm).unwrap();
    }
    writeln!(csv, "{:.9},{:.9}", 30.0 / mm, -200.0 / mm).unwrap();
    csv
}

/// Trust: the standard shape. Tangent arcs through points of an arc are that arc (1e-5 mm: points rounded to 1e-9 in).
#[test]
fn chords_of_a_punch_are_the_punch() {
    let standard = Profile::flat_punch(30.0, 6.0, 1.0);
    for (unit, mm) in [("mm", 1.0), ("in", 25.4)] {
        let case = with_punch(&chords(unit, mm), "\"punch.csv\"", "25 mm");
        assert!(are_alike(profile(case.model(), Role::Punch), &standard, 1e-5, around()), "{unit}");
    }
}

/// Trust: the standard shape, from three points with a fillet; spreadsheets add a mark, CR LF and repeated points.
#[test]
fn a_fillet_makes_the_standard_punch_of_three_points() {
    let standard = Profile::flat_punch(30.0, 6.0, 1.0);
    let plain = "r_mm,z_mm\n0,0\n30,0\n30,-200\n";
    let marked = "\u{feff}r_mm,z_mm\r\n0,0\r\n30,0\r\n30,0\r\n30,-200\r\n30,-200\r\n";
    let column = "# a punch\nz_mm, r_mm, radius_mm\n0,0,\n0,30,6\n-200,30,\n";
    let file = r#"{ file = "punch.csv", fillet = "6 mm" }"#;
    for (points, section) in [(plain, file), (marked, file), (column, "\"punch.csv\"")] {
        let case = with_punch(points, section, "25 mm");
        assert!(are_alike(profile(case.model(), Role::Punch), &standard, 1e-9, around()), "{points}");
    }
}

/// Trust: at closing every point of the die's cavity is `by` away from the punch (1e-7 mm: round-off of arcs).
#[test]
fn a_die_around_a_punch_closes_with_the_gap_asked_for() {
    for (more, closed) in [("", 25.0), (", closed_at = \"27 mm\"", 27.0)] {
        let die = format!(r#"profile = {{ offset_of = "punch", by = "1.25 mm", shoulder = "6 mm"{more} }}"#);
        let case = read(&text(FLAT, &die, HOLDER, "25 mm"));
        let (punch, die) = (profile(case.model(), Role::Punch).shifted(closed), profile(case.model(), Role::Die));
        let shoulder_end = 31.25;
        let cavity = die.polyline(0.02).into_iter().filter(|p| p.x <= shoulder_end + 1e-9);
        let gaps: Vec<f64> = cavity.map(|p| punch.closest(p).distance).collect();
        assert!(gaps.len() > 50 && gaps.iter().all(|gap| (gap - 1.25).abs() < 1e-7), "{gaps:?}");
        // The flat sheet lies on its face.
        assert!((die.closest(Point::new(50.0, 0.0)).distance - 0.5).abs() < 1e-9);
        solve(case.model());
    }
}

#[test]
fn a_holder_can_be_the_mirror_image_of_the_die() {
    let case = read(&text(FLAT, DIE, r#"holder = { profile = { mirror_of = "die" }, force = "10 kN" }"#, "25 mm"));
    let (holder, die) = (profile(case.model(), Role::Holder), profile(case.model(), Role::Die));
    for i in 0..200 {
        let x = Point::new(20.0 + 0.2 * f64::from(i), 0.02 * f64::from(i % 7));
        assert!((holder.closest(Point::new(x.x, -x.y)).distance - die.closest(x).distance).abs() < 1e-9);
    }
    solve(case.model());
}

/// Trust: by hand. One corner of 90° that the sheet is bent over.
#[test]
fn sharp_corners_are_warned_of_where_the_sheet_meets_them() {
    let sharp = |punch: &str, travel: &str| {
        let case = with_punch(punch, "\"punch.csv\"", travel);
        check::report(&case).warnings.into_iter().filter(|w| w.to_string().contains("sharp corner")).collect::<Vec<_>>()
    };
    let found = sharp("r_mm,z_mm\n0,0\n30,0\n30,-200\n", "25 mm");
    assert!(found.len() == 1 && found[0].to_string().contains("of 90° at r = 30 mm, z = -0.5 mm"), "{found:?}");
    // A foot 50 mm below the face is out of the sheet's reach.
    let foot = "r_mm,z_mm,radius_mm\n0,0,\n28,0,6\n28,-50,\n29.5,-50,\n29.5,-90,\n";
    assert_eq!(sharp(foot, "25 mm"), Vec::<String>::new());
    assert!(sharp(foot, "52 mm")[0].to_string().contains("and at 1 more"));
}

/// Trust: by hand. A nose of 6 mm drawn to its 45°, (24 + 6 sin 45°, −6 (1 − cos 45°)) = (28.243, −1.757) from the face.
#[test]
fn a_line_that_ends_before_the_travel_is_warned_of() {
    let nose = r#"{ from = ["0 mm", "0 mm"] }, { to = ["24 mm", "0 mm"] },
        { arc_to = ["28.242641 mm", "-1.757359 mm"], center = ["24 mm", "-6 mm"], turn = "right" }"#;
    let warned = |wall: &str, travel: &str| {
        let case = read(&text(&format!("profile = [{nose}{wall}]"), DIE, HOLDER, travel).replace("\n        ", " "));
        check::report(&case).warnings.into_iter().filter(|w| w.to_string().contains("line ends")).collect::<Vec<_>>()
    };
    let [found] = &warned("", "25 mm")[..] else { panic!("one warning") };
    assert!(found.contains("r = 28.243 mm, z = -2.257 mm") && found.contains("1.757 mm of the 25 mm"), "{found}");
    assert_eq!(warned("", "1.7 mm"), Vec::<String>::new());
    assert_eq!(warned(r#", { to = ["28.242641 mm", "-3 mm"] }"#, "25 mm"), Vec::<String>::new());
}
