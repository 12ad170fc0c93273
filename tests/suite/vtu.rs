//! Files for ParaView, read back and measured; `tests/foreign` holds other readers against them.

use crate::common::prelude::*;
use roxmltree::Node;

struct Grid {
    points: Vec<[f64; 2]>,
    cells: Vec<Vec<usize>>,
    fields: BTreeMap<String, Vec<f64>>,
}

fn numbers(array: Node) -> Vec<f64> {
    array.text().unwrap_or_default().split_whitespace().map(|number| number.parse().unwrap()).collect()
}

fn read(path: &Path) -> Grid {
    let text = fs::read_to_string(path).unwrap();
    let file = Document::parse(&text).unwrap();
    let arrays = |inside: &str| {
        let parent = file.descendants().find(|node| node.has_tag_name(inside)).expect("the element");
        let arrays = parent.children().filter(|node| node.has_tag_name("DataArray"));
        arrays.map(|array| (array.attribute("Name").unwrap().to_owned(), numbers(array))).collect::<BTreeMap<_, _>>()
    };
    let cells = arrays("Cells");
    let ends: Vec<usize> = cells["offsets"].iter().map(|end| *end as usize).collect();
    let starts = std::iter::once(0).chain(ends.iter().copied());
    let corners = |(from, to): (usize, &usize)| cells["connectivity"][from..*to].iter().map(|i| *i as usize).collect();
    let grid = Grid {
        points: arrays("Points")["Points"].chunks(3).map(|p| [p[0], p[1]]).collect(),
        cells: starts.zip(&ends).map(corners).collect(),
        fields: arrays("CellData"),
    };
    let piece = file.descendants().find(|node| node.has_tag_name("Piece")).unwrap();
    let count = |name: &str| piece.attribute(name).unwrap().parse::<usize>().unwrap();
    assert_eq!((count("NumberOfPoints"), count("NumberOfCells")), (grid.points.len(), grid.cells.len()));
    assert!(cells["types"].iter().zip(&grid.cells).all(|(kind, cell)| (*kind, cell.len()) == (9.0, 4)));
    assert!(grid.fields.values().all(|values| values.len() == grid.cells.len()));
    grid
}

fn columns(path: &Path) -> BTreeMap<String, Vec<f64>> {
    let text = fs::read_to_string(path).unwrap();
    let mut lines = text.lines().map(|line| line.split(','));
    let headers: Vec<&str> = lines.next().unwrap().collect();
    let rows: Vec<Vec<f64>> = lines.map(|line| line.map(|cell| cell.parse().unwrap()).collect()).collect();
    headers.iter().enumerate().map(|(i, name)| (name.to_string(), rows.iter().map(|row| row[i]).collect())).collect()
}

fn collection(path: &Path) -> Vec<(f64, String)> {
    let text = fs::read_to_string(path).unwrap();
    let file = Document::parse(&text).unwrap();
    let sets = file.descendants().filter(|node| node.has_tag_name("DataSet"));
    sets.map(|set| (set.attribute("timestep").unwrap().parse().unwrap(), set.attribute("file").unwrap().to_owned()))
        .collect()
}

/// Trust: profile.csv, which other tests hold against closed forms, and the volume of the blank, π 55² · 1 mm³.
#[test]
fn the_section_is_that_of_the_profile_and_keeps_its_volume() {
    let dir = folder(CUP);
    // Steps end at kept frames, and those of whole fifths are among the states.
    ends(&stampflow(dir.path(), &["run", "cases/cup.toml", "-q", "--vtu", "--set", "output.count=5"]), 0, "");
    let out = dir.path().join("out/cup");
    let profile = columns(&out.join("profile.csv"));
    let sets = collection(&out.join("section.pvd"));
    for i in 0..5 {
        let rows = 30 * i..30 * (i + 1);
        let of = |key: &str| &profile[key][rows.clone()];
        let (_, name) = sets.iter().find(|set| (set.0 - of("travel_mm")[0]).abs() < 1e-8).expect("the state");
        let grid = read(&out.join(name));
        assert_eq!((grid.points.len(), grid.cells.len()), (62, 30));
        for (field, key) in
            [("thickness [mm]", "thickness_mm"), ("s0 [mm]", "s0_mm"), ("stress_hoop [MPa]", "stress_hoop_MPa")]
        {
            // The CSV has nine digits.
            let apart = grid.fields[field].iter().zip(of(key)).map(|(a, b)| (a - b).abs() / (1.0 + b.abs()));
            assert!(apart.fold(0.0, f64::max) < 1e-8, "{field}");
        }
        let mut shell = 0.0;
        for (quad, row) in grid.cells.iter().zip(rows.clone()) {
            let middle = |a: usize, b: usize| [0, 1].map(|i| 0.5 * (grid.points[quad[a]][i] + grid.points[quad[b]][i]));
            let (inner, outer) = (middle(0, 1), middle(2, 3));
            let [r, z] = [0, 1].map(|i| 0.5 * (inner[i] + outer[i]));
            assert!((r - profile["r_mm"][row]).abs() < 1e-7 && (z - profile["z_mm"][row]).abs() < 1e-7);
            let length = (outer[0] - inner[0]).hypot(outer[1] - inner[1]);
            shell += TAU * r * profile["thickness_mm"][row] * length;
        }
        let blank = 0.5 * TAU * 55.0 * 55.0;
        assert!((shell / blank - 1.0).abs() < 1e-4, "{shell} of {blank}");
    }
}
