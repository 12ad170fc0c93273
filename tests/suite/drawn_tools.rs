//! Tools in blocks, as outlines, of several operations, in other words, and beside the axis.

use crate::drawings::{assert_is, die, folder, holder, line, punch, sections, stampflow, text};
use stampflow::case;
use stampflow::geometry::{Arc, Piece};
use stampflow::import::{Heading, Options, read};
use stampflow::model::Role;
use stampflow::model::tool_sizes::extent;
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// Trust: the program was told these shapes (write.py), which are stated here anew as a tool maker would.
#[test]
fn blocks_are_placed_scaled_mirrored_turned_nested_and_in_arrays() {
    let drawing = "ezdxf_blocks.dxf";
    let found = sections(drawing, &Options::default());
    assert_is(&found, Role::Punch, &punch(24.0, 6.0, -20.0, -200.0), drawing);
    assert_is(&found, Role::Die, &die(90.0, 31.25, 6.0, 0.5, 120.0), drawing);
    let two_columns =
        [line([32.0, -40.0], [32.0, -10.0]), line([32.0, -10.0], [61.0, -10.0]), line([61.0, -10.0], [90.0, -10.0])];
    assert_is(&found, Role::Holder, &two_columns, drawing);
    let notes = found.notes.join("\n");
    assert!(notes.contains("both halves of the punch are drawn and are alike"), "{notes}");
    // A block without a layer is known by its name.
    assert!(found.tool(Role::Holder).unwrap().made_of.contains("\"Blechhalter\""));
}

/// Trust: by hand: cos 30°, sin 30°. A quarter of a circle is turned about its block's base, and its mirror image the other way.
#[test]
fn a_turned_and_mirrored_arc_keeps_its_place_and_sense() {
    let block = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nB\n10\n10\n20\n0\n0\nARC\n8\n0\n10\n10\n20\n0\n40\n5\n50\n0\n51\n90\n0\nENDBLK\n0\nENDSEC\n";
    let placed = |scale: &str| {
        let insert = format!("0\nINSERT\n8\npunch\n2\nb\n10\n20\n20\n7\n{scale}50\n30\n");
        let text = format!("{block}0\nSECTION\n2\nENTITIES\n{insert}0\nENDSEC\n0\nEOF\n");
        let options = Options {
            unit: Some(stampflow::import::DrawingUnit::Mm),
            axis: Some(0.0),
            punch_moves: Some(Heading::Up),
            ..Options::default()
        };
        read(text.as_bytes(), &options).unwrap().tools.remove(0).profile.pieces().to_vec()
    };
    let [half, root] = [0.5, 0.75_f64.sqrt()];
    let ends = |pieces: &[Piece]| {
        let Piece::Arc(arc) = pieces[0] else { panic!("an arc") };
        assert!(
            (arc.center - stampflow::geometry::Point::new(20.0, 7.0)).norm() < 1e-9 && pieces.len() == 1,
            "{arc:?}"
        );
        (arc.radius, [pieces[0].first(), pieces[0].last()])
    };
    for (scale, radius, expected) in [
        ("", 5.0, [[20.0 - 5.0 * half, 7.0 + 5.0 * root], [20.0 + 5.0 * root, 7.0 + 5.0 * half]]),
        // The x axis is mirrored before it is turned, and all is twice as large.
        ("41\n-2\n42\n2\n", 10.0, [[20.0 - 10.0 * root, 7.0 - 10.0 * half], [20.0 - 10.0 * half, 7.0 + 10.0 * root]]),
    ] {
        let (found, [first, last]) = ends(&placed(scale));
        assert!((found - radius).abs() < 1e-9, "{found}");
        for (point, expected) in [first, last].iter().zip(expected) {
            assert!((point - stampflow::geometry::Point::from(expected)).norm() < 1e-9, "{point} {expected:?}");
        }
    }
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
        let error = read(text.as_bytes(), &Options::default());
        let mm = Options { unit: Some(stampflow::import::DrawingUnit::Mm), ..Options::default() };
        assert!(error.is_err(), "no unit");
        let error = read(text.as_bytes(), &mm).unwrap_err().to_string();
        assert!(error.contains("with its blocks the drawing has more than 200000 entities"), "{error}");
    }
}

/// Trust: the same tools as an open line each, up to where the outline goes on behind them.
#[test]
fn of_outlines_the_side_towards_the_sheet_is_read() {
    let drawing = "ezdxf_outlines.dxf";
    let found = sections(drawing, &Options::default());
    assert_is(&found, Role::Punch, &punch(24.0, 6.0, -20.0, -200.0), drawing);
    assert_is(&found, Role::Die, &die(90.0, 31.25, 6.0, 0.5, 120.0), drawing);
    assert_is(&found, Role::Holder, &holder(32.0, -10.0, -40.0), drawing);
    let notes = found.notes.join("\n");
    for says in [
        "the punch moves down in the drawing (the punch is above the die)",
        "the die is drawn all round: the side towards the sheet is read, from x = 90 mm, y = -0.5 mm to x = 31.25 mm, y = -120 mm",
        "the holder is drawn all round: the side towards the sheet is read, from x = 32 mm, y = 40 mm to x = 90 mm, y = 10 mm",
    ] {
        assert!(notes.contains(says), "{says} is not in\n{notes}");
    }
}

/// Trust: by hand. A body that is drawn upside down, walked either way, is the same tool for a punch that moves up.
#[test]
fn an_outline_may_be_walked_either_way_and_lie_on_either_side() {
    let ring = [[31.0, -1.0], [90.0, -1.0], [90.0, -50.0], [31.0, -50.0]];
    let die = |points: &[[f64; 2]]| {
        let vertices: String = points.iter().fold(String::new(), |text, [x, y]| text + &format!("10\n{x}\n20\n{y}\n"));
        format!("0\nLWPOLYLINE\n8\ndie\n70\n1\n{vertices}")
    };
    let read_die = |points: &[[f64; 2]], heading| {
        let text = format!("0\nSECTION\n2\nENTITIES\n{}0\nENDSEC\n0\nEOF\n", die(points));
        let options = Options {
            unit: Some(stampflow::import::DrawingUnit::Mm),
            punch_moves: Some(heading),
            ..Options::default()
        };
        read(text.as_bytes(), &options).unwrap()
    };
    let expected = [line([90.0, 1.0], [31.0, 1.0]), line([31.0, 1.0], [31.0, 50.0])];
    for turn in 0..4 {
        let mut points = ring.to_vec();
        points.rotate_left(turn);
        for _ in 0..2 {
            points.reverse();
            assert_is(&read_die(&points, Heading::Down), Role::Die, &expected, "down");
            let upside_down: Vec<[f64; 2]> = points.iter().map(|[x, y]| [*x, -y]).collect();
            assert_is(&read_die(&upside_down, Heading::Up), Role::Die, &expected, "up");
        }
    }
}

/// Trust: the numbers that write.py was told, with z downward; the cone of 40° leads to a shoulder of 50°.
#[test]
fn layers_with_numbers_are_stages() {
    let drawing = "ezdxf_operations.dxf";
    let found = sections(drawing, &Options::default());
    assert_eq!(found.number, Some(20));
    assert_is(&found, Role::Punch, &punch(33.0, 6.0, 0.0, -120.0), drawing);
    assert_is(&found, Role::Die, &die(90.0, 40.5, 6.5, 1.0, 120.0), drawing);
    assert_eq!(found.later.len(), 1);
    let later = &found.later[0];
    assert_eq!((later.number, later.name().as_str()), (Some(30), "OP30"));
    let pieces = later.tool(Role::Punch).unwrap().profile.pieces();
    for (a, b) in pieces.iter().zip(&punch(24.0, 6.0, 0.0, -160.0)) {
        assert!((a.first() - b.first()).norm() < 1e-6 && (a.last() - b.last()).norm() < 1e-6, "{a:?} {b:?}");
    }
    let pieces = later.tool(Role::Die).unwrap().profile.pieces();
    assert!(matches!(pieces[1], Piece::Arc(Arc { radius, sweep, .. })
        if (radius - 6.8).abs() < 1e-6 && (sweep + 50_f64.to_radians()).abs() < 1e-6));
}

/// The whole way: the case of two operations can be checked and run, its second stage with the tools of the second operation.
#[test]
fn a_case_of_two_operations_runs_to_its_end() {
    let dir = folder(Path::new("tests/drawings/ezdxf_operations.dxf"));
    let imported =
        stampflow(dir.path(), &["import", "ezdxf_operations.dxf", "--thickness", "1 mm", "--travel", "30 mm"]);
    assert_eq!(imported.status.code(), Some(0), "{}", text(&imported.stderr));
    let said = text(&imported.stdout);
    assert!(said.contains("layer \"OP30_BINDER\""), "{said}");
    let case = case::load(dir.path().join("ezdxf_operations.toml"), &[]).unwrap();
    let names: Vec<&str> = case.stages.iter().map(|stage| stage.name.as_str()).collect();
    assert_eq!(names, ["op20", "op30"]);
    let model = &case.stages[1].model;
    assert!((extent(model.tool(Role::Punch).unwrap()).1 - 30.0).abs() < 1e-6);
    assert!((extent(model.tool(Role::Die).unwrap()).0 - 31.5).abs() < 1e-6);
    let done = stampflow(dir.path(), &["run", "ezdxf_operations.toml", "--quiet"]);
    assert_eq!(done.status.code(), Some(0), "{}{}", text(&done.stderr), text(&done.stdout));
}

/// A drawing that stands beside the axis is asked about; with the answer it is the same tools.
#[test]
fn the_axis_that_is_asked_for_gives_the_tools() {
    for (name, axis) in [("off_the_axis", 100.0), ("off_the_axis_with_a_centre_line", -100.0)] {
        let drawing = format!("faulty/{name}.dxf");
        let found = sections(&drawing, &Options { axis: Some(axis), ..Options::default() });
        assert_is(&found, Role::Punch, &punch(24.0, 6.0, -20.0, -200.0), &drawing);
        assert_is(&found, Role::Die, &die(90.0, 31.25, 6.0, 0.5, 120.0), &drawing);
        // x = 0 is an answer too: a punch that is a ring.
        let ring = sections(&drawing, &Options { axis: Some(0.0), ..Options::default() });
        let inner = extent_of(ring.tool(Role::Punch).unwrap().profile.pieces());
        assert!((inner.abs() - 70.0).abs() < 1e-6 || (inner.abs() - 100.0).abs() < 1e-6, "{inner}");
    }
    let whole = sections("faulty/whole_off_the_axis.dxf", &Options { axis: Some(30.0), ..Options::default() });
    let expected = [punch(24.0, 6.0, 0.0, -80.0)].concat();
    assert_is(&whole, Role::Punch, &expected, "whole_off_the_axis");
}

/// Smallest x of pieces.
fn extent_of(pieces: &[Piece]) -> f64 {
    pieces.iter().flat_map(|piece| [piece.first().x, piece.last().x]).fold(f64::INFINITY, f64::min)
}

/// A centre line at x = 0 says that a ring is one.
#[test]
fn a_centre_line_at_zero_answers_for_a_ring() {
    let text = fs::read_to_string("tests/drawings/faulty/off_the_axis.dxf").unwrap();
    let line = "  0\nLINE\n  8\nMittellinie\n 10\n0\n 20\n-10\n 11\n0\n 21\n10\n";
    let at = text.find("ENTITIES\n").unwrap() + "ENTITIES\n".len();
    let with = format!("{}{line}{}", &text[..at], &text[at..]);
    let ring = read(with.as_bytes(), &Options::default()).unwrap();
    assert!((extent_of(ring.tool(Role::Punch).unwrap().profile.pieces()) - 100.0).abs() < 1e-6);
    assert!(read(text.as_bytes(), &Options::default()).unwrap_err().to_string().contains("--axis \"100 mm\""));
}

/// Every layer of the trade is its tool without being told.
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
        for (a, b) in found.tools.iter().zip(&same.tools) {
            assert_eq!((a.role, &a.profile), (b.role, &b.profile), "{words:?}");
        }
        assert_eq!(found.tools.len(), 3);
    }
}
