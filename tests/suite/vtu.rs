//! What is written for ParaView, read back by a reader of its own and measured; `tests/foreign` holds the readers of others
//! against it.

use crate::common::cli::{CUP, STAGES, folder, stampflow, text};
use crate::common::files::files;
use nalgebra::Vector3;
use roxmltree::{Document, Node};
use stampflow::results::vtk::{SECTORS, STATES};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

/// Cells by their numbers in VTK.
const QUAD: u8 = 9;
const HEXAHEDRON: u8 = 12;
const WEDGE: u8 = 13;

/// A file's points, cells and fields.
struct Grid {
    points: Vec<Vector3<f64>>,
    cells: Vec<(u8, Vec<usize>)>,
    fields: BTreeMap<String, Vec<f64>>,
}

/// Base64 by the letters' places in the alphabet, six bits each.
fn decoded(text: &str) -> Vec<u8> {
    let value = |letter: u8| match letter {
        b'A'..=b'Z' => letter - b'A',
        b'a'..=b'z' => letter - b'a' + 26,
        b'0'..=b'9' => letter - b'0' + 52,
        b'+' => 62,
        b'/' => 63,
        other => panic!("{} is no letter of base64", char::from(other)),
    };
    let (mut bytes, mut bits, mut held) = (Vec::new(), 0_u32, 0);
    for letter in text.trim_end_matches('=').bytes() {
        bits = bits << 6 | u32::from(value(letter));
        held += 6;
        if held >= 8 {
            held -= 8;
            bytes.push((bits >> held) as u8);
        }
    }
    bytes
}

/// The first element of that name inside another.
fn of<'a, 'input>(node: Node<'a, 'input>, name: &str) -> Node<'a, 'input> {
    node.descendants().find(|child| child.has_tag_name(name)).expect("the element")
}

fn read(path: &Path) -> Grid {
    let text = fs::read_to_string(path).unwrap();
    let file = Document::parse(&text).unwrap();
    let root = file.root_element();
    assert_eq!((root.attribute("byte_order"), root.attribute("header_type")), (Some("LittleEndian"), Some("UInt64")));
    let bytes = |array: Node| {
        let bytes = decoded(array.text().unwrap());
        let (count, bytes) = bytes.split_first_chunk().unwrap();
        assert_eq!(u64::from_le_bytes(*count), bytes.len() as u64);
        bytes.to_vec()
    };
    let doubles = |array: Node| -> Vec<f64> {
        assert_eq!(array.attribute("type"), Some("Float64"));
        bytes(array).chunks(8).map(|eight| f64::from_le_bytes(eight.try_into().unwrap())).collect()
    };
    let cells = |name: &str, kind: &str| {
        let mut arrays = of(root, "Cells").children();
        let array = arrays.find(|array| array.attribute("Name") == Some(name)).expect("the array");
        assert_eq!(array.attribute("type"), Some(kind));
        bytes(array)
    };
    let numbers = |bytes: Vec<u8>| -> Vec<usize> {
        bytes.chunks(8).map(|eight| i64::from_le_bytes(eight.try_into().unwrap()) as usize).collect()
    };
    let (connectivity, offsets) = (numbers(cells("connectivity", "Int64")), numbers(cells("offsets", "Int64")));
    let starts = std::iter::once(&0).chain(&offsets);
    let corners = starts.zip(&offsets).map(|(&from, &to)| connectivity[from..to].to_vec());
    let fields = || of(root, "CellData").children().filter(Node::is_element);
    // What a viewer shows first.
    let shown = of(root, "CellData").attribute("Scalars").expect("a field to colour by");
    assert!(["thinning [%]", "role [-]"].contains(&shown), "{shown}");
    assert!(fields().any(|array| array.attribute("Name") == Some(shown)), "{shown}");
    let grid = Grid {
        points: doubles(of(of(root, "Points"), "DataArray")).chunks(3).map(Vector3::from_column_slice).collect(),
        cells: cells("types", "UInt8").into_iter().zip(corners).collect(),
        fields: fields().map(|array| (array.attribute("Name").unwrap().to_owned(), doubles(array))).collect(),
    };
    let count = |name: &str| of(root, "Piece").attribute(name).unwrap().parse::<usize>().unwrap();
    assert_eq!((count("NumberOfPoints"), count("NumberOfCells")), (grid.points.len(), grid.cells.len()));
    assert!(grid.fields.values().all(|values| values.len() == grid.cells.len()));
    grid
}

/// Columns of a CSV file.
fn columns(path: &Path) -> BTreeMap<String, Vec<f64>> {
    let text = fs::read_to_string(path).unwrap();
    let mut lines = text.lines();
    let headers: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows: Vec<Vec<f64>> = lines.map(|line| line.split(',').map(|cell| cell.parse().unwrap()).collect()).collect();
    let column = |i: usize| rows.iter().map(|row| row[i]).collect();
    headers.iter().enumerate().map(|(i, header)| (header.to_string(), column(i))).collect()
}

/// The timesteps of a collection, and its files.
fn collection(path: &Path) -> Vec<(f64, String)> {
    let text = fs::read_to_string(path).unwrap();
    let value = |line: &str, key: &str| {
        let rest = line.split_once(&format!("{key}=\"")).unwrap().1;
        rest.split_once('"').unwrap().0.to_owned()
    };
    let sets = text.lines().filter(|line| line.contains("<DataSet "));
    sets.map(|line| (value(line, "timestep").parse().unwrap(), value(line, "file"))).collect()
}

/// Volume of a cell by its tetrahedra, each positive where the first face's normal points to the face opposite; VTK's own
/// filter finds these cells positive too.
fn volume(grid: &Grid, (kind, corners): &(u8, Vec<usize>)) -> f64 {
    let tetrahedra: &[[usize; 4]] = match *kind {
        HEXAHEDRON => &[[0, 1, 2, 6], [0, 2, 3, 6], [0, 3, 7, 6], [0, 7, 4, 6], [0, 4, 5, 6], [0, 5, 1, 6]],
        WEDGE => &[[0, 1, 2, 5], [0, 1, 5, 4], [0, 4, 5, 3]],
        other => panic!("a cell of type {other} has no volume"),
    };
    let point = |i: usize| grid.points[corners[i]];
    let one = |t: &[usize; 4]| {
        let [a, b, c, d] = t.map(point);
        (b - a).cross(&(c - a)).dot(&(d - a)) / 6.0
    };
    tetrahedra.iter().map(one).inspect(|v| assert!(*v > 0.0, "{kind}: {v}")).sum()
}

/// 2π ∫ r dA of a quadrilateral, by its two triangles (Pappus).
fn turned(grid: &Grid, quad: &[usize]) -> f64 {
    let p = |i: usize| grid.points[quad[i]];
    let one = |[a, b, c]: [usize; 3]| {
        let (u, v) = (p(b) - p(a), p(c) - p(a));
        TAU * 0.5 * (u.x * v.y - u.y * v.x) * (p(a).x + p(b).x + p(c).x) / 3.0
    };
    one([0, 1, 2]) + one([0, 2, 3])
}

/// Trust: profile.csv, which other tests hold against closed forms, and the volume of the blank, π 55² · 1 mm³.
#[test]
fn the_section_is_that_of_the_profile_and_keeps_its_volume() {
    let dir = folder(CUP);
    // Steps end at kept frames, and those of whole fifths are among the states.
    let done = stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--vtu", "--set", "output.count=5"]);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    let out = dir.path().join("out/cup");
    let profile = columns(&out.join("profile.csv"));
    let sets = collection(&out.join("section.pvd"));
    assert_eq!(profile["travel_mm"].len(), 5 * 30);
    for i in 0..5 {
        let rows = 30 * i..30 * (i + 1);
        let of = |key: &str| &profile[key][rows.clone()];
        let (_, name) = sets.iter().find(|set| (set.0 - of("travel_mm")[0]).abs() < 1e-8).expect("the state");
        let grid = read(&out.join(name));
        assert_eq!((grid.points.len(), grid.cells.len()), (62, 30));
        assert!(grid.cells.iter().all(|cell| cell.0 == QUAD));
        for (field, key) in [
            ("thickness [mm]", "thickness_mm"),
            ("s0 [mm]", "s0_mm"),
            ("strain_meridional [-]", "strain_meridional"),
            ("strain_hoop [-]", "strain_hoop"),
            ("strain_equivalent [-]", "strain_equivalent"),
            ("stress_meridional [MPa]", "stress_meridional_MPa"),
            ("stress_hoop [MPa]", "stress_hoop_MPa"),
        ] {
            // The CSV has nine digits.
            let apart = grid.fields[field].iter().zip(of(key)).map(|(a, b)| (a - b).abs() / (1.0 + b.abs()));
            assert!(apart.fold(0.0, f64::max) < 1e-8, "{field}");
        }
        let thinning = grid.fields["thinning [%]"].iter().zip(of("thickness_mm"));
        assert!(thinning.into_iter().all(|(percent, t)| (percent - 100.0 * (1.0 - t)).abs() < 1e-6));
        // The faces' middle is the element's middle, so that nothing is beside its place.
        let mut shell = 0.0;
        for ((_, quad), row) in grid.cells.iter().zip(rows.clone()) {
            let p = |corner: usize| grid.points[quad[corner]];
            let (inner, outer) = (0.5 * (p(0) + p(1)), 0.5 * (p(2) + p(3)));
            let middle = 0.5 * (inner + outer);
            assert!((middle.x - profile["r_mm"][row]).abs() < 1e-7 && (middle.y - profile["z_mm"][row]).abs() < 1e-7);
            shell += TAU * middle.x * profile["thickness_mm"][row] * (outer - inner).norm();
        }
        let solid: f64 = grid.cells.iter().map(|(_, quad)| turned(&grid, quad)).sum();
        let blank = 0.5 * TAU * 55.0 * 55.0;
        // The shell keeps its volume; its faces, drawn with nodal thicknesses and normals, by the size of an element.
        assert!((shell / blank - 1.0).abs() < 1e-4, "{shell} of {blank}");
        assert!((solid / shell - 1.0).abs() < 4e-3, "{solid} of {shell}");
    }
}

/// Trust: the flat blank is level, of one thickness and at rest; between states lies a twenty-fifth of the travel, give or
/// take a step, which is a hundredth at most.
#[test]
fn states_are_spread_evenly_from_the_flat_blank_to_the_end() {
    let dir = folder(CUP);
    stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--vtu"]);
    let out = dir.path().join("out/cup");
    let sets = collection(&out.join("section.pvd"));
    let full = *columns(&out.join("load_travel.csv"))["travel_mm"].last().unwrap();
    assert!(sets.len().abs_diff(STATES + 1) <= 1, "{} states", sets.len());
    assert!(sets[0].0 == 0.0 && (sets[sets.len() - 1].0 - full).abs() < 1e-8, "{sets:?}");
    for pair in sets.windows(2) {
        let share = (pair[1].0 - pair[0].0) / full;
        assert!(share > 0.0 && share < 1.0 / STATES as f64 + 0.0101, "{share}");
    }
    let blank = read(&out.join(&sets[0].1));
    assert!(blank.points.iter().all(|point| (point.y.abs() - 0.5).abs() < 1e-12));
    assert!(blank.fields["strain_equivalent [-]"].iter().all(|strain| *strain == 0.0));
}

/// Trust: each sector is a straight prism over its chord, so the volume is sin α/α of the round body's, exactly.
#[test]
fn the_turned_sheet_has_the_volume_of_its_sectors() {
    let dir = folder(CUP);
    stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--vtu"]);
    let out = dir.path().join("out/cup");
    let sections = collection(&out.join("section.pvd"));
    let revolved = collection(&out.join("revolved.pvd"));
    assert_eq!(sections.len(), revolved.len());
    for ((at, section), (when, name)) in sections.iter().zip(&revolved) {
        assert_eq!(at, when);
        let (section, grid) = (read(&out.join(section)), read(&out.join(name)));
        assert_eq!(grid.cells.len(), 30 * SECTORS);
        assert_eq!(grid.cells.iter().filter(|cell| cell.0 == WEDGE).count(), SECTORS);
        let round: f64 = section.cells.iter().map(|(_, quad)| turned(&section, quad)).sum();
        let volume: f64 = grid.cells.iter().map(|cell| volume(&grid, cell)).sum();
        let alpha = TAU / SECTORS as f64;
        assert!((volume / (round * alpha.sin() / alpha) - 1.0).abs() < 1e-10, "{volume} of {round}");
        for (name, values) in &grid.fields {
            assert!(values.chunks(30).all(|sector| sector == section.fields[name]), "{name}");
        }
    }
}

#[test]
fn tools_stand_where_the_punch_has_come_to() {
    let dir = folder(CUP);
    stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--vtu"]);
    let out = dir.path().join("out/cup");
    for (travel, name) in collection(&out.join("tools.pvd")) {
        let grid = read(&out.join(name));
        let roles = &grid.fields["role [-]"];
        let mut each = roles.clone();
        each.dedup();
        assert_eq!(each, [0.0, 1.0, 2.0]);
        assert_eq!(roles.len(), grid.cells.len());
        let punch = grid.cells.iter().zip(roles).filter(|(_, role)| **role == 0.0).flat_map(|(cell, _)| &cell.1);
        let lowest = punch.map(|&i| grid.points[i].y).fold(f64::NEG_INFINITY, f64::max);
        // Tools are drawn on the faces of the flat sheet; the punch's is half a thickness below z = 0 and starts a few
        // smoothing lengths of contact (3e-3 of the thickness) away.
        assert!((lowest - (travel - 0.5)).abs() < 0.05, "{lowest} at {travel}");
    }
}

/// What an earlier run left is removed, stages have their own, and a plane section is not turned.
#[test]
fn vtk_files_come_and_go_with_their_option() {
    let dir = folder(CUP);
    let out = dir.path().join("out/cup");
    let vtk = || files(&out, "vtu").len() + files(&out, "pvd").len();
    let run = || stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--vtu"]);
    run();
    let first = vtk();
    assert_eq!(first, 3 * collection(&out.join("section.pvd")).len() + 3);
    for name in ["section_0999.vtu", "mine.vtu"] {
        fs::write(out.join(name), "old").unwrap();
    }
    run();
    assert_eq!(vtk(), first + 1);
    stampflow(dir.path(), &["run", "cases/cup.toml", "-q"]);
    assert_eq!(vtk(), 1);

    fs::write(dir.path().join("cases/cup.toml"), format!("{CUP}{STAGES}")).unwrap();
    let done = stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--vtu"]);
    assert_eq!(done.status.code(), Some(0), "{}", text(&done.stderr));
    for stage in ["1-draw", "2-retract"] {
        assert!(out.join(stage).join("revolved.pvd").is_file(), "{stage}");
    }
    assert!(!out.join("section.pvd").exists());

    let strip = include_str!("../../cases/hat_springback.toml");
    fs::write(dir.path().join("cases/cup.toml"), strip).unwrap();
    stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--vtu"]);
    let first = fs::read_dir(&out).unwrap().map(|e| e.unwrap().path()).find(|p| p.join("section.pvd").is_file());
    let first = first.expect("a stage with a section");
    assert!(!first.join("revolved.pvd").exists());
}
