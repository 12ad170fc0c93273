//! Round parts of a catalogue from their finished sizes alone: what `new cup` plans, and what a run of it gives.
//!
//!     cargo bench --bench catalogue
//!
//! Expected number of draws: D² = d² + 4 d h of a sharp cup and the part's own flange, and ratios of 2 in the first draw, then of
//! the second by metal (Oehler and Kaiser, in 4ming), and 1.2 in later ones (Ghosh and Mallik, Manufacturing Science, not read).

use stampflow::assess::{self, Answer, Light};
use stampflow::author::templates::find;
use stampflow::case;
use stampflow::measure::{part_height, wall_at};
use std::time::Instant;

/// Tolerance of the finished sizes \[mm\].
const TOLERANCE: f64 = 0.2;

fn expected(sheet: &str, diameter: f64, height: f64, flange: Option<f64>) -> usize {
    let second = [("1.4301", 1.25), ("en-aw-5754", 1.5)].into_iter().find(|(name, _)| *name == sheet);
    let outer = flange.unwrap_or(diameter);
    let mut ratio = (outer * outer + 4.0 * diameter * height).sqrt() / diameter / 2.0;
    let mut draws = 1;
    while ratio > 1.0 {
        ratio /= if draws == 1 { second.map_or(1.3, |(_, ratio)| ratio) } else { 1.2 };
        draws += 1;
    }
    draws
}

fn main() {
    let (mut within, mut right, mut sound, mut slowest, mut count) = (0, 0, 0, 0.0_f64, 0);
    println!("| part | sheet | draws, expected | height or flange off by mm | diameter off by mm | light | s |");
    println!("|---|---|---|---|---|---|---|");
    for line in include_str!("catalogue.csv").lines().skip(1) {
        let [part, sheet, thickness, diameter, height, more] = line.split(',').collect::<Vec<_>>()[..] else {
            panic!("{line}")
        };
        count += 1;
        let [t, d, h] = [thickness, diameter, height].map(|text| text.parse::<f64>().expect("a number"));
        let sizes = [("thickness", t), ("punch-diameter", d), ("height", h)].map(|(key, mm)| (key, format!("{mm} mm")));
        let mut given: Vec<(&str, &str)> = sizes.iter().map(|(key, text)| (*key, text.as_str())).collect();
        given.push(("material", sheet));
        given.extend(more.split_once('='));
        let begin = Instant::now();
        let text = match find("cup").and_then(|cup| cup.fill(&given)) {
            Ok(text) => text,
            Err(error) => {
                println!("| {part} | {sheet} | {error} |");
                continue;
            }
        };
        let seconds = begin.elapsed().as_secs_f64();
        let solution = case::parse(&text, "cup.toml", &[]).expect("a case").solve(&mut ());
        let (finished, stages) = (solution.case.finished, solution.stages.len());
        let frame = solution.stages.last().and_then(|stage| stage.frames.last()).expect("frames");
        let drawn = part_height(frame).expect("a height");
        let trim = (0.04 * finished.flange_diameter.map_or(h, |flange| 0.5 * flange)).max(2.0 * t);
        // Above that a flange bends away.
        let inside = wall_at(frame, if finished.flange_diameter.is_some() { 0.4 * h } else { h });
        let wide = inside.map_or(f64::NAN, |[r, _, thickness]| 2.0 * r - thickness - d);
        let high = match finished.flange_diameter {
            Some(flange) => (drawn - h).abs().max((frame.nodes.last().expect("a rim").r - 0.5 * flange - trim).abs()),
            None => (drawn - h - trim).abs(),
        };
        let findings = assess::after(&solution.case, &solution.stages);
        let answer = Answer::of(&solution.case, &solution.stages, &findings);
        let wanted = expected(sheet, d, h, finished.flange_diameter);
        within += usize::from(high < TOLERANCE && wide.abs() < TOLERANCE);
        right += usize::from(stages == wanted);
        sound += usize::from(answer.light < Light::Red);
        slowest = slowest.max(seconds);
        let light = answer.light.name();
        println!(
            "| {part} | {sheet} | {stages}, {wanted} | {high:.3} | {wide:+.3} | {light}: {} | {seconds:.1} |",
            answer.sentence
        );
    }
    println!(
        "\n{within} of {count} within {TOLERANCE} mm, {right} with the expected draws, {sound} not red, {slowest:.1} s at most"
    );
}
