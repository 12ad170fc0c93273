//! Drawing of cups: draw ratios, size of the blank, wrinkles, ears, trimming.

use super::estimate::{draw_ratio, has_land, held_area, siebel_pressure};
use super::{holder::if_open, tear::nose, *};
use crate::case::Finished;
use crate::measure::{part_height, wall_at};
use crate::model::Blank;
use crate::rules::{AUSTENITIC, Metal, ROUNDED_RATIO};

/// Advised pressure over the holder's \[–\]. Above 2 even a factor of 0.002, the least that is quoted for the rule, asks for
/// more; a force that was rounded after the rule may miss it by a percent.
const LIMITS: [f64; 2] = [1.01, 2.0];
/// Diameter of a blank less that of the punch, over the thickness, up to which a cup is drawn without a holder \[–\].
const FREE: [f64; 2] = [15.0, 20.0];
/// Tolerance on sizes of the finished part \[mm\], declared.
const TOLERANCE: f64 = 0.2;
/// Gap between a fixed holder and the die, over the thickness, above which waves can grow \[–\].
const GAP: f64 = 1.2;
const RATIOS: &str = "4ming, Forming handbook, table of draw ratios: 2 in the first draw, 1.3 of DC04 in the second";

pub(super) fn ratio(model: &Model) -> Option<Finding> {
    let (ratio, Metal { name, ratios: [limit, _], .. }) = (draw_ratio(model)?, Metal::of(&model.material));
    let text = format!("the draw ratio of {{}} is above {limit}, the limit of {name} in one draw (4ming)");
    let warning = Finding::warning("draw_ratio", "Draw ratio", text).number(Amount::ratio(ratio)).at_most(limit, None);
    warning.if_beyond().filter(|_| ratio > limit + ROUNDED_RATIO)
}

fn single(run: &Run) -> Option<Finding> {
    let model = &run.stages.first()?.model;
    let (ratio, [limit, _]) = (draw_ratio(model)?, Metal::of(&model.material).ratios);
    let draws = super::tear::tearing(run).is_some_and(|row| row.light == Light::Green);
    let text = "{} of blank to punch; whether it draws, Tearing says";
    let judged = Finding::judged("draw_ratio", "Draw ratio", text).number(Amount::ratio(ratio)).at_most(limit, None);
    let judged = judged.light(if ratio > limit + ROUNDED_RATIO { Light::Amber } else { Light::Green }).source(RATIOS);
    Some(judged.advice(if draws { "" } else { "a first draw to a larger diameter" }))
}

/// Radii of the blank and of the punches that draw it, each smaller than the one before \[mm\]; an earlier run's come first.
pub fn draws<'a>(models: impl Iterator<Item = &'a Model>) -> Vec<f64> {
    let mut radii: Vec<f64> = Vec::new();
    for model in models.filter(|model| model.geometry == Geometry::Axisymmetric) {
        let Blank { preform, meridian, length, .. } = &model.blank;
        match preform {
            _ if !radii.is_empty() => {}
            Some(preform) => radii.clone_from(&preform.draws),
            None => radii.extend(meridian.is_none().then_some(*length)),
        }
        let is_drawn = |radius: &f64| radii.last().is_some_and(|last| radius < last);
        radii.extend(model.tool(Role::Punch).map(|punch| extent(punch).1).filter(is_drawn));
    }
    radii
}

pub(super) fn redraw(run: &Run) -> Option<Finding> {
    let radii = draws(run.stages.iter().map(|stage| &stage.model));
    let [blank, first, .., last] = radii[..] else { return single(run) };
    let steeper = |a: &&[f64], b: &&[f64]| (a[0] / a[1]).total_cmp(&(b[0] / b[1]));
    let steepest = radii[1..].windows(2).max_by(steeper)?;
    let (metal, total, draws) = (Metal::of(&run.case.model().material), blank / last, radii.len() - 1);
    let (needed, [most, limit], begin) = (metal.draws(total), metal.ratios, blank / first);
    let (is_wide, is_deep) = (begin > most + ROUNDED_RATIO, needed > draws);
    let deep = is_deep.then(|| format!(", which takes {needed} draws of {}, not {draws}", metal.name));
    let wide = is_wide.then(|| format!("; {begin:.2} in the first draw, above {most}"));
    let (deep, wide) = (deep.unwrap_or_default(), wide.unwrap_or_default());
    let [from, to] = [0, 1].map(|i| Amount::drawn(2.0 * steepest[i]));
    let text = format!("{{}} from Ø {from} to Ø {to}; {total:.2} in all{deep}{wide}");
    let ratio = steepest[0] / steepest[1];
    let light = if ratio <= limit + ROUNDED_RATIO && !is_deep && !is_wide { Light::Green } else { Light::Amber };
    let judged = Finding::judged("redraw_ratio", "Redraw ratio", text).number(Amount::ratio(ratio));
    Some(judged.at_most(limit, None).light(light).source(RATIOS))
}

/// Siebel's pressure over the least that the holder exerts on the flange's first area, without the force that closes beads;
/// for a fixed holder its gap. For the first stage of an axisymmetric draw.
pub(super) fn wrinkling(run: &Run) -> Option<Finding> {
    let first = run.stages.first()?;
    let (model, t) = (&first.model, first.model.blank.thickness);
    draw_ratio(model)?;
    let judged = |label, text: String| Finding::judged("wrinkling", label, text);
    if let Some(open) = if_open(first, judged("Wrinkle index", "not judged: the holder stands open by {}".into())) {
        return Some(open.limit("a holder that is closed on the flange"));
    }
    let itself = "an axisymmetric run itself cannot wrinkle";
    Some(match model.tool(Role::Holder).map(|holder| &holder.motion) {
        Some(Motion::Pressed(press)) if !press.is_idle() => {
            let pressure = (press.force.smallest() - estimate::closing_of_beads(model)).max(0.0) / held_area(model)?;
            let advised = siebel_pressure(model)?;
            let [wanted, least] = [advised, pressure].map(Amount::stress);
            judged("Wrinkle index", format!("{{}}; Siebel's least, {wanted}, over the holder's {least}; {itself}"))
                .number(Amount::ratio(advised / pressure))
                .at_most(LIMITS[0], LIMITS[1])
                .limit(format!("1 at most, red above {}", LIMITS[1]))
                .source("Siebel's holder pressure, after Kugler (2009) in 4ming; red is a declared rule of thumb")
        }
        Some(Motion::Gap(gap)) => judged("Wrinkle room", format!("holder fixed {{}} from the die; {itself}"))
            .number(Amount::thicknesses(gap / t))
            .at_most(GAP, None),
        _ => {
            let beyond = model.tool(Role::Punch).map_or(0.0, |punch| 2.0 * (model.blank.length - extent(punch).1));
            let text = format!("blank less punch diameter {{}}; nothing holds the flange; {itself}");
            let judged = judged("Wrinkle index", text).number(Amount::thicknesses(beyond / t));
            judged.at_most(FREE[0], FREE[1]).advice("a holder that presses on the flange")
        }
    })
}

pub(super) fn wall_wrinkles(run: &Run) -> Option<Finding> {
    let first = run.stages.first()?;
    let (is_redrawn, is_flat) = (first.model.blank.preform.is_some(), first.model.blank.meridian.is_none());
    if is_flat {
        draw_ratio(&first.model)?;
    }
    let bottom = run.stages.last()?.model.tool(Role::Punch).and_then(|punch| punch.profile.pieces().first());
    let is_domed = matches!(bottom, Some(Piece::Arc(_)));
    let has = |model: &Model, role: Role| model.release.is_none() && model.tool(role).is_some();
    let is_free = |model: &Model| has(model, Role::Punch) && !has(model, Role::Holder) && !has_land(model);
    let mut redraws = run.stages.iter().enumerate().skip(usize::from(!is_redrawn));
    let text = match redraws.find(|(_, stage)| is_free(&stage.model)) {
        _ if !is_flat && !is_redrawn => "a wall that is pressed along or around may buckle out of its circle".into(),
        _ if !is_redrawn && nose(first).is_none_or(|(_, is_upright)| !is_upright) => {
            "part of the wall hangs free between punch and die".into()
        }
        _ if is_domed => "the ring round the dome hangs free until the punch has come to it".into(),
        Some((i, _)) => run.of_stage("no sleeve holds the wall that is redrawn".into(), i),
        None => return None,
    };
    let judged = Finding::judged("wall_wrinkles", "Wall wrinkles", text).light(Light::Grey);
    Some(judged.limit("an axisymmetric run cannot wrinkle, and no rule for it could be read"))
}

pub(super) fn delayed_cracking(run: &Run) -> Option<Finding> {
    let (first, last) = (&run.stages.first()?.model, &run.stages.last()?.model);
    let (most, ratio) = (AUSTENITIC.total(2), first.blank.length / extent(last.tool(Role::Punch)?).1);
    let is_annealed = run.case.stages.iter().any(|stage| stage.begin.anneal);
    let text = format!(
        "the draw ratio of {{}} in all is above {most}, two draws of austenitic steel without annealing (4ming); whether it \
         cracks hours or days later, as others did (Berveiller et al. 2009, 10.1051/esomat/200906005), is not judged"
    );
    draw_ratio(first).filter(|_| Metal::of(&first.material) == AUSTENITIC && !is_annealed)?;
    let warning = Finding::warning("delayed_cracking", "Delayed cracking", text).number(Amount::ratio(ratio));
    let advice = "anneal between draws, `anneal = true` in a stage, and soon after the last";
    warning.at_most(most + ROUNDED_RATIO, None).advice(advice).if_beyond()
}

pub(super) fn ears(run: &Run) -> Option<Finding> {
    let last = run.stages.last()?;
    let frame = last.frames.last()?;
    if last.model.geometry != Geometry::Axisymmetric || last.model.blank.edge == Edge::Clamped {
        return None;
    }
    let Some(r) = run.case.r_values else {
        run.case.finished.height?;
        let grey = Finding::judged("ears", "Ears", "not computed without r-values by direction").light(Light::Grey);
        return Some(grey.limit("trimmed off").advice("`anisotropy = { r0, r45, r90 }` in [material]"));
    };
    let lengths = frame.nodes.windows(2).map(|pair| (pair[1].r - pair[0].r).hypot(pair[1].z - pair[0].z));
    let ears = r.rim_heights(lengths.zip(frame.elements.iter().map(|element| element.strain_hoop)));
    let height = ears.into_iter().fold(f64::NEG_INFINITY, f64::max) - ears.into_iter().fold(f64::INFINITY, f64::min);
    let ([along, diagonal, across], planar) = (ears.map(Amount::place), Amount::ratio(r.planar()));
    let text = format!(
        "ears of {{}}; at 0, 45 and 90° the rim lies {along}, {diagonal} and {across} beyond the mean (Δr = {planar})"
    );
    let source = "an estimate: hoop compression with r by direction (Yoon, Dick and Barlat 2011)";
    let judged = Finding::judged("ears", "Ears", text).number(Amount::place(height));
    Some(judged.limit("none: more is trimmed off").source(source))
}

pub(super) fn trim_allowance(run: &Run) -> Option<Finding> {
    let Finished { height, diameter, flange_diameter } = run.case.finished;
    let is_whole = run.stages.len() == run.case.stages.len() && run.stages.iter().all(|stage| stage.stop.is_complete());
    let frame = run.stages.last().filter(|_| is_whole)?.frames.last()?;
    let (height, drawn, edge) = (height?, part_height(frame)?, frame.nodes.last()?);
    let (spare, off, size, of, wanted) = match flange_diameter {
        Some(flange) => (edge.r - 0.5 * flange, "off the flange all round", drawn, "high over all", Some(height)),
        None => {
            let [r, _, thickness] = wall_at(frame, height).unwrap_or([edge.r, edge.z, edge.thickness]);
            (drawn - height, "off the rim", 2.0 * r - thickness, "inside diameter there", diameter)
        }
    };
    let is_off = wanted.is_some_and(|wanted| (size - wanted).abs() > TOLERANCE);
    let finding = Finding::judged("trim_allowance", "Trim", format!("{{}} {off}; {} {of}", Amount::place(size)))
        .number(Amount::place(spare));
    let finding = finding.at_least(0.0, -TOLERANCE);
    let light = finding.light.max(if is_off { Light::Amber } else { Light::Green });
    let limit = format!("nothing missing, sizes within {}", Amount::place(TOLERANCE));
    let advice = if is_off { "another clearance or travel" } else { "a larger blank" };
    Some(finding.light(light).limit(limit).source("the case's [finished]").advice(advice))
}

pub(super) fn trim(stage: &StageSolution) -> Option<Finding> {
    let cut = stage.trimmed?;
    let wanted = Amount::size(cut.asked);
    let text = format!("the sheet is cut to r = {{}} instead of {wanted}: {} whole elements go", cut.elements);
    Some(Finding::warning("trim", "Trim", text).number(Amount::size(cut.edge)).limit(wanted).source("the case's trim"))
}
