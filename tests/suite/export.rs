//! Drawings that are exported: what import reads of them is the case again.

use crate::common::prelude::*;
use crate::drawings::assert_bends;
use stampflow::{export::Drawing, export::Format, import, import::Operation};

fn unsolved(case: Case) -> Solution {
    Solution { case, stages: vec![], wall: None }
}

/// Stages with a tool that the stage before has not.
fn drawn(case: &Case) -> Vec<&Stage> {
    let stood = |i: usize, tool: &Tool| {
        let before = i.checked_sub(1).map_or(&[][..], |before| &case.stages[before].model.tools);
        before.iter().any(|old| old.role == tool.role && old.profile == tool.profile)
    };
    let is_drawn = |(i, stage): &(usize, &Stage)| !stage.model.tools.iter().all(|tool| stood(*i, tool));
    case.stages.iter().enumerate().filter(is_drawn).map(|(_, stage)| stage).collect()
}

/// Every corner, radius and centre is that of the case but for one shift along z. An endless wall is shorter, on its own line.
/// Trust: 1e-6 mm is that of the acceptance; a file has 12 decimals.
fn assert_same(operation: &Operation, stage: &Stage, name: &str) {
    assert_eq!(operation.tools.len(), stage.model.tools.len(), "{name}");
    for tool in &stage.model.tools {
        let read = &operation.tool(tool.role).unwrap_or_else(|| panic!("{name}: {:?}", tool.role)).profile;
        let (a, b) = (read.pieces(), tool.profile.pieces());
        assert_eq!(a.len(), b.len(), "{name}");
        let shift = if b.len() > 1 { b[0].last() - a[0].last() } else { b[0].first() - a[0].first() };
        assert!(shift.x.abs() < 1e-6, "{name}: {shift}");
        for (i, (a, b)) in a.iter().zip(b).enumerate() {
            let ends = [(a.first(), b.first(), i == 0), (a.last(), b.last(), i + 1 == read.pieces().len())];
            for (a, b, is_end) in ends {
                let off = a + shift - b;
                let along = if is_end { tool.profile.pieces()[i].tangent(i > 0) } else { Point::zeros() };
                assert!((off - off.dot(&along) * along).norm() < 1e-6, "{name}: {:?} {a} {b}", tool.role);
            }
            assert_bends(a, b, shift, name);
        }
    }
}

fn assert_comes_back(solution: &Solution, name: &str) {
    // A ring for a punch is meant: the axis is at x = 0.
    for (format, unit) in [(Format::DxfR12, DrawingUnit::MM), (Format::Dxf2000, DrawingUnit::INCH)] {
        // Of wide tools in inches import asks for the unit.
        let known = name.starts_with("cases").then_some(unit);
        let options = Options { axis: Some(0.0), unit: known, ..Options::default() };
        let text = Drawing::new(solution, unit).text(format);
        let read = import::read(text.as_bytes(), &options).unwrap_or_else(|error| panic!("{name}: {error}"));
        let (stages, operations) = (drawn(&solution.case), &read.operations);
        assert_eq!(operations.len(), stages.len(), "{name}");
        operations.iter().zip(stages).for_each(|(operation, stage)| assert_same(operation, stage, name));
    }
}

#[test]
fn every_template_and_case_with_a_punch_comes_back_from_its_export() {
    let templates = TEMPLATES.iter().map(|one| (one.name.to_owned(), parse(&one.fill(&[]).unwrap(), "new.toml", &[])));
    let cases =
        files("cases", "toml").into_iter().map(|path| (format!("cases: {}", path.display()), case::load(path, &[])));
    let mut count = 0;
    for (name, case) in templates.chain(cases) {
        let case = case.unwrap();
        // Tools are drawn as far as a tube once it is solved.
        let draws = |stage: &&Stage| !stage.model.tools.is_empty() && stage.model.blank.meridian.is_none();
        if !drawn(&case).is_empty() && drawn(&case).iter().all(draws) {
            assert_comes_back(&unsolved(case), &name);
            count += 1;
        }
    }
    assert!(count > 20, "{count}");
}

/// Trust: the case's own sizes.
#[test]
fn a_solved_case_comes_back_with_its_sheet_beside_it() {
    for (template, layers) in [
        ("cup", "BLANK PUNCH DIE HOLDER SHEET MIDLINE TRIM AXIS"),
        (
            "redraw",
            "BLANK OP10_PUNCH OP10_DIE OP10_HOLDER OP10_SHEET OP10_MIDLINE OP20_PUNCH OP20_DIE OP20_HOLDER OP20_SHEET OP20_MIDLINE TRIM AXIS",
        ),
    ] {
        let solution = made(template, &[], &[]).solve(&mut ());
        let drawing = Drawing::new(&solution, DrawingUnit::MM);
        let names: Vec<&str> = drawing.layers.iter().map(|layer| layer.name.as_str()).collect();
        assert_eq!(names.join(" "), layers);
        assert_comes_back(&solution, template);
        let sheet = drawing.layers.iter().find(|layer| layer.name.ends_with("SHEET")).unwrap();
        let rim = solution.stages[0].frames.last().unwrap().nodes.last().unwrap();
        let to_rim = |piece: &Piece| (piece.first() - Point::new(rim.r, rim.z)).norm();
        let nearest = sheet.pieces.iter().map(to_rim).fold(f64::INFINITY, f64::min);
        // Half the thickness is between the middle and a face.
        assert!((nearest - 0.5 * rim.thickness).abs() < 1e-9, "{nearest}");
        let svg = drawing.text(Format::Svg);
        let page = Document::parse(&svg).unwrap();
        assert_eq!(page.descendants().filter(|node| node.has_tag_name("g")).count(), names.len());
        let pieces: usize = drawing.layers.iter().map(|layer| layer.pieces.len()).sum();
        assert_eq!(drawing.text(Format::Csv).lines().count(), pieces + 1);
    }
}

/// Trust: travels, sizes and the way through the die are in the drawing, friction and holder pressure are the same rule. Other
/// elements and the steps of a longer travel change the numbers by up to 1 %.
#[test]
fn a_drawn_part_runs_as_the_case_that_it_was_drawn_from() {
    let can = [("punch-diameter", "38 mm"), ("height", "70 mm"), ("material", "1.4301"), ("thickness", "0.8 mm")];
    let hat = [("springback", "1 °"), ("length", "800 mm"), ("flange", "15 mm")];
    let nosed = [("land", "8 mm"), ("end", "17 mm")];
    let flat = [("cup", &can[..]), ("cup", &[]), ("cup", &hat[2..]), ("hat-section", &hat)];
    let tubes = [("tube-end", &[][..]), ("tube-end", &nosed[..1]), ("tube-end", &nosed), ("tube-inversion", &[])];
    let pressed = [("tube-bulge", &[("feed", "0 mm")][..]), ("hydroform", &[])];
    for (template, sizes) in flat.into_iter().chain(tubes).chain(pressed) {
        let own = made(template, sizes, &[]).solve(&mut ());
        assert_comes_back(&own, template);
        let drawing = Drawing::new(&own, DrawingUnit::MM).text(Format::DxfR12);
        let material = sizes.iter().find(|(key, _)| *key == "material").map(|(_, name)| (*name).to_owned());
        let imported = Import { material, ..Import::default() }.read(drawing.as_bytes(), Path::new("new.dxf")).unwrap();
        let again = imported.case.clone().solve(&mut ());
        let open = again.case.model().placeholders().unwrap();
        assert!(!open.contains("travel") && imported.to_string().lines().count() < 25, "{imported}");
        let read = |part: &Solution| (part.case.finished, part.stages.len(), part.case.model().depth);
        assert_eq!(read(&again), read(&own), "{sizes:?}");
        let numbers = |solution: &Solution| {
            let end = solution.stages.last().unwrap().frames.last().unwrap();
            let thinnest = end.nodes.iter().map(|node| node.thickness).fold(f64::INFINITY, f64::min);
            [solution.stages.iter().map(peak).fold(0.0, f64::max), thinnest, part_height(end).unwrap()]
        };
        own.stages.iter().zip(&again.stages).for_each(|(own, again)| assert_eq!(own.stop.kind, again.stop.kind));
        let within = if own.case.model().tool(Role::Punch).is_some() { 0.01 } else { 0.03 };
        for (own, again) in numbers(&own).into_iter().zip(numbers(&again)) {
            assert_relative_eq!(own, again, max_relative = within);
        }
    }
}

#[test]
fn the_round_of_the_verbs_gives_the_same_case() {
    let dir = TempDir::new().unwrap();
    let run = |line: &str| {
        let out = stampflow(dir.path(), &line.split(' ').collect::<Vec<_>>());
        (out.status.code(), text(&out.stderr).to_owned() + text(&out.stdout))
    };
    assert_eq!(run("new cup --thickness 1mm --punch-diameter 80mm --height 30mm -o cup.toml").0, Some(0));
    assert_eq!(run("export cup.toml -o tools.dxf -q").0, Some(0));
    let case = Case::load(dir.path().join("cup.toml")).unwrap();
    let whole = "import tools.dxf --material dc04 --friction 0.08 --holder-force 9572N -o whole.toml";
    assert!(!run(whole).1.contains("placeholders"));
    assert_eq!(run(&format!("import tools.dxf --travel {}mm -o again.toml", case.model().travel)).0, Some(0));
    let sizes = |case: &Case| (case.model().blank.length, case.model().blank.thickness, case.model().travel);
    assert_eq!(sizes(&case), sizes(&Case::load(dir.path().join("again.toml")).unwrap()));
    let wider = case::load(dir.path().join("again.toml"), &["tools.die.profile.2.radius=9 mm".to_owned()]).unwrap();
    let shoulder = wider.model().tool(Role::Die).unwrap().profile.pieces()[1];
    assert!(matches!(shoulder, Piece::Arc(arc) if (arc.radius - 9.0).abs() < 1e-9), "{shoulder:?}");
    assert!(run("export cup.toml -o tools.dxf").1.contains("is there already"));
}
