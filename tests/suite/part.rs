//! Pictures of the part: coloured by thinning, over the travel, and its thickness band by band.

use crate::common::{drawn, pixels::pixels, shipped};
use stampflow::measure::bands;
use stampflow::model::{Geometry, Release};
use stampflow::plot::chart::{Chart, Look, Scale, Series};
use stampflow::results::{Make, OUTPUTS, png};
use stampflow::solver::solution::{StageSolution, Stop};

/// The chart of a file.
fn chart(file: &str, stage: &StageSolution) -> Option<Chart> {
    let output = OUTPUTS.iter().find(|output| output.file == file).expect("an output of that name");
    let Make::Plot(make) = output.make else { panic!("{file} is a plot") };
    make(&drawn::view(stage))
}

fn labelled(series: &[Series], look: Look) -> Vec<(&str, &[(f64, f64)])> {
    let those = series.iter().filter(|series| series.look == look);
    those.map(|series| (series.label.as_deref().expect("a label"), &series.points[..])).collect()
}

/// The part's section of the drawn cup.
fn part(stage: &StageSolution) -> Vec<Series> {
    chart("part.png", stage).expect("a part").panels.swap_remove(0).series
}

/// Trust: the drawn cup's thinnest element and its numbers by hand; the mirror image of every outline is an outline.
#[test]
fn the_part_is_whole_and_its_thinnest_place_is_named() {
    for geometry in [Geometry::Axisymmetric, Geometry::PlaneStrain] {
        let run = drawn::run(&drawn::model(geometry));
        let last = run.frames.last().unwrap();
        let thinnest = last.elements.iter().min_by(|a, b| a.thickness.total_cmp(&b.thickness)).unwrap();
        let series = part(&run);
        let [(text, points)] = labelled(&series, Look::Callout)[..] else { panic!("one callout") };
        // The blank is 1 mm thick; the summary tells shares by the same rule.
        let share = stampflow::units::Amount::share(1.0 - thinnest.thickness).to_string();
        assert_eq!(text, format!("{:.2}\u{a0}mm, {share} thinner", thinnest.thickness));
        assert_eq!(points[0], (thinnest.r, thinnest.z));

        let areas = || series.iter().filter(|series| matches!(series.look, Look::Area { .. }));
        let extent = |points: &[(f64, f64)]| {
            let x = || points.iter().map(|p| p.0);
            (x().fold(f64::INFINITY, f64::min), x().fold(f64::NEG_INFINITY, f64::max))
        };
        for area in areas() {
            let (low, high) = extent(&area.points);
            assert!(areas().any(|other| extent(&other.points) == (-high, -low)), "{low} to {high} mm has no image");
        }
        let chart = chart("part.png", &run).unwrap();
        let [(left, right), _] = chart.panels[0].ranges();
        assert!(left == -right && right > last.nodes.last().unwrap().r, "{left} {right}");
    }
}

/// Trust: the place that the run says of itself, on the other side of the middle.
#[test]
fn a_tear_is_crossed_out_where_the_verdict_has_it() {
    let mut run = drawn::run(&drawn::model(Geometry::Axisymmetric));
    let plain = part(&run);
    let torn = run.frames.last().unwrap().elements[30];
    run.stop = Stop::Localised { travel: 50.0, s0: torn.s0, share: 0.5, why: Default::default() };
    let series = part(&run);
    let callouts = labelled(&series, Look::Callout);
    assert_eq!(callouts[1].0, "tears here");
    assert_eq!(callouts[1].1[0], (-torn.r, torn.z));
    let crossing = series.iter().filter(|series| match series.look {
        Look::Line { .. } => {
            series.points.len() == 2 && {
                let [(a, b), (c, d)] = [series.points[0], series.points[1]];
                (0.5 * (a + c) + torn.r).abs() < 1e-9 && (0.5 * (b + d) - torn.z).abs() < 1e-9
            }
        }
        _ => false,
    });
    assert_eq!(crossing.count(), 4, "two lines, black on white");
    assert_eq!(series.len(), plain.len() + 5);
}

/// Tools that were taken away are not drawn, those that formed the part are.
#[test]
fn a_released_part_stands_alone() {
    let mut run = drawn::run(&drawn::model(Geometry::Axisymmetric));
    let edged = |run: &StageSolution| {
        part(run).iter().filter(|series| matches!(series.look, Look::Area { edge: Some(_), .. })).count()
    };
    // The punch is one with its image, die and holder are two.
    assert_eq!(edged(&run), 5);
    run.model.release = Some(Release::default());
    assert_eq!(edged(&run), 0);
}

/// Trust: the drawn cup's punch stands at its travel in every frame; the punch's lowest point is its travel and half a
/// thickness less.
#[test]
fn every_state_has_its_own_frame_and_the_tools_of_its_time() {
    let run = drawn::run(&drawn::model(Geometry::Axisymmetric));
    let chart = chart("shapes.png", &run).unwrap();
    let small: Vec<_> = chart.panels.iter().filter(|panel| matches!(panel.scale, Scale::Small { .. })).collect();
    assert_eq!(small.len(), run.frames.len());
    for (panel, frame) in small.iter().zip(&run.frames) {
        let [(caption, _)] = labelled(&panel.series, Look::Text)[..] else { panic!("one caption") };
        assert_eq!(caption, format!("Punch travel {}\u{a0}mm", frame.travel));
        let punch = panel.series[0].points.iter().map(|p| p.1).fold(f64::NEG_INFINITY, f64::max);
        assert!((punch - (frame.travel - 0.5)).abs() < 1e-9, "{punch} at {}", frame.travel);
    }
    assert_eq!(chart.panels.last().unwrap().scale, Scale::Bar);
}

/// Trust: three pictures side by side: what a row of pixels half-way down the first panel crosses of their borders, two
/// each.
#[test]
fn small_panels_stand_side_by_side() {
    let run = drawn::run(&drawn::model(Geometry::Axisymmetric));
    let mut chart = chart("shapes.png", &run).unwrap();
    chart.panels.truncate(3);
    chart.panels.iter_mut().for_each(|panel| panel.series.clear());
    chart.notes.clear();
    let pixels = pixels(&png(&chart));
    let row = |y: usize| &pixels.rgb[y * pixels.width..(y + 1) * pixels.width];
    let borders = |y: usize| row(y).chunk_by(|a, b| a == b).filter(|run| run[0][0] < 100).count();
    assert!((0..pixels.rgb.len() / pixels.width).any(|y| borders(y) == 6));
}

/// Trust: the bands that `measure` finds, each named once, with a border between each two.
#[test]
fn thickness_is_shown_over_the_part_band_by_band() {
    let stage = shipped::solve(&shipped::shipped("quickstart", &[]));
    let chart = chart("thickness.png", &stage).unwrap();
    let [over_blank, over_part] = &chart.panels[..] else { panic!("two panels") };
    let bands = bands(&stage);
    let names: Vec<&str> = labelled(&over_part.series, Look::Name).iter().map(|name| name.0).collect();
    assert_eq!(names, bands.iter().map(|stretch| stretch.band.name()).collect::<Vec<_>>());
    let borders: Vec<f64> =
        over_part.series.iter().filter(|series| series.points.len() == 2).map(|series| series.points[0].0).collect();
    assert_eq!(borders, bands[1..].iter().map(|stretch| stretch.along[0]).collect::<Vec<_>>());
    // The same thicknesses as over the blank, at other places.
    let values = |series: &Series| series.points.iter().map(|p| p.1).collect::<Vec<_>>();
    let curve = over_part.series.iter().max_by_key(|series| series.points.len()).expect("a curve");
    assert_eq!(values(curve), values(over_blank.series.last().unwrap()));
    assert_eq!(curve.look, over_blank.series.last().unwrap().look);
}
