//! Round part by its finished sizes: draws planned by a rule and tried by runs, which also correct the blank.

mod stages;

use super::{sizes::Draw, *};
use crate::assess::{self, FailureMode};
use crate::case::parse;
use crate::part::Part;
use rules::Metal;

const RUNS: usize = 8;
/// Error of height or edge that is met, and below which runs go on with the case's own mesh \[mm\].
const MET: f64 = 0.1;
const NEAR: f64 = 1.0;
const MOST_GIVEN: usize = 6;
const AREA: &str = "half of D, area of the mid-surface with what is trimmed (Guldin)";
/// Step of a blank's radius or half-length \[mm\]: it is cut to 0.1 mm.
pub(super) const BLANK: f64 = 0.05;
/// Least flat beside the slope of a recess \[mm\].
const FLAT: f64 = 0.05;
/// Height of an early cup over that of its blank's area at an even thickness \[–\].
const HIGHER: f64 = 1.05;

struct Cup<'a> {
    inputs: &'a Inputs,
    sheet: &'a Sheet,
    metal: Metal,
    part: Part,
    nose: Picked,
}

#[derive(PartialEq)]
enum End {
    Met,
    Tears,
    Steep,
}

/// Radii of the punches, blank, and travel of the last punch where a flange or a step is left \[mm\].
struct Plan {
    radii: Vec<f64>,
    blank: Picked,
    travel: Picked,
    end: End,
}

/// Punch and die of a draw, and the cup that comes of it \[mm\].
struct Tools {
    radius: f64,
    nose: Picked,
    clearance: Picked,
    shoulder: Picked,
    travel: Picked,
    /// Height at an even thickness.
    cup: f64,
    /// Punch as TOML.
    punch: String,
}

pub(super) fn cup<const LEAST: usize>(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    let cup = Cup::read(inputs, sheet)?;
    cup.values(&cup.planned(LEAST)?, true)
}

fn part(inputs: &Inputs, thickness: f64, nose: f64, height: f64) -> Part {
    let (radius, given) = (inputs.value("punch-radius"), |key: &str| inputs.number(key));
    let step = given("step-radius").map(|radius| [radius, given("step-height").unwrap_or(0.5 * height)]);
    let flange = given("flange-radius").or(given("flange").map(|width| radius + thickness + width));
    let inner = || given("recess-radius").unwrap_or(0.5 * (radius - nose));
    let recess = given("recess").map(|depth| [inner(), depth]);
    let trim = inputs.pick("trim", || rules::trim(flange.unwrap_or(height), thickness)).value;
    Part { thickness, radius, nose, height, trim, flange, step, dome: given("dome-radius"), recess }
}

impl<'a> Cup<'a> {
    fn read(inputs: &'a Inputs, sheet: &'a Sheet) -> Result<Self, CaseError> {
        let radius = inputs.value("punch-radius");
        let nose = nose(inputs, sheet, inputs.number("step-radius").unwrap_or(radius))?;
        let part = part(inputs, sheet.thickness, nose.value, inputs.value("height"));
        let cup = Self { inputs, sheet, metal: Metal::of(&sheet.metal), part, nose };
        cup.check().map(|()| cup)
    }

    fn check(&self) -> Result<(), CaseError> {
        let Part { thickness, radius, nose, height, flange, step, dome, recess, .. } = self.part;
        let least = nose + thickness;
        let what = || format!("a height of {} leaves no wall above nose and bottom, {}", plain(height), plain(least));
        ensure(height > least, what, "make --height larger or --nose smaller")?;
        let fits = |[narrow, low]: [f64; 2]| narrow < radius && low > least && low < height;
        let what = || format!("a step within {} of radius and {} of height does not fit", plain(radius), plain(height));
        ensure(step.is_none_or(fits), what, "make --step-radius or --step-height smaller, or --nose smaller")?;
        let steepest = self.metal.ratios[1];
        let what = || format!("a step from {} of radius is a redraw of more than {steepest}", plain(radius));
        ensure(step.is_none_or(|[narrow, _]| radius / narrow <= steepest), what, "make --step-radius larger")?;
        let bottom = self.part.bottom_radius();
        let what = || format!("a dome needs a radius above the punch's of {}", plain(bottom));
        ensure(dome.is_none_or(|dome| dome > bottom), what, "make --dome-radius larger")?;
        if let Some([at, depth]) = recess {
            let half = 0.5 * self.part.slope(depth)[1] + FLAT;
            let what = || format!("the slope of a recess {} deep does not fit into the bottom", plain(depth));
            let fits = at > half && at + half < radius - nose;
            ensure(fits, what, "make --recess or --nose smaller, or --recess-radius other")?;
        }
        let first = self.inputs.number("first-radius");
        let what = || format!("the first punch is no wider than the last one of Ø {}", plain(2.0 * radius));
        ensure(first.is_none_or(|first| first > radius), what, "make --first-radius or --first-diameter larger")?;
        let outside = radius + thickness;
        let what = || format!("the flange is narrower than the cup, which has {} of radius outside", plain(outside));
        ensure(flange.is_none_or(|flange| flange > outside), what, "make the flange larger, or leave it out")?;
        self.inputs.either(["flange", "flange-radius"])?;
        self.inputs.only_with("step-height", "step-radius")?;
        self.inputs.only_with("recess-radius", "recess")?;
        let kinds = [flange.is_some(), step.is_some(), recess.is_some()];
        let what = || "a part has one of flange, step and recess here".to_owned();
        ensure(kinds.into_iter().filter(|is| *is).count() < 2, what, "leave one out; a later stage can make it")
    }

    /// Sizes for as many draws as the rule plans, `least` at least; where the sheet tears in runs of them, for one more.
    fn planned(&self, least: usize) -> Result<Plan, CaseError> {
        let (part, metal, stepped) = (self.part, self.metal, usize::from(self.part.step.is_some()));
        let is_single = part.flange.is_some() || part.recess.is_some();
        let first = self.inputs.number("first-radius");
        let what = || "--first-radius is of two draws or more; a flange or a recess is made in one here".to_owned();
        ensure(!is_single || first.is_none(), what, "leave it out")?;
        let least = least.max(1 + usize::from(first.is_some()));
        if let Some(given) = self.inputs.number("draws") {
            let (draws, most_given) = (given as usize, if is_single { 1 } else { MOST_GIVEN });
            let why = if is_single { ": a flange or a recess is made in one draw here" } else { "" };
            let what = || format!("--draws {given} is no number of draws for this part{why}");
            let fits = draws as f64 == given && (least + stepped..=most_given).contains(&draws);
            ensure(fits, what, &format!("from {} to {most_given}", least + stepped))?;
            return self.tried(draws, true);
        }
        let (most, limit, of, or) = if is_single {
            // A flange that stays outside takes load off the wall: beyond the metal's own limit runs decide.
            let of = "what one draw of a flange or a recess can do (declared)";
            let or = "a larger --punch-radius; a flange or a recess is made in one draw here";
            let wide = self.inputs.number("flange").filter(|width| *width > part.radius).map(mm);
            let diameter = |wide| format!("--flange is a width, --flange-diameter {wide} the diameter; or ");
            (1, rules::LIMITING_RATIO, of.to_owned(), wide.map_or(String::new(), diameter) + or)
        } else {
            let most = rules::MOST_DRAWS - stepped;
            let of = format!("what {most} draws, the most without --draws, take of {} (4ming)", metal.name);
            let or = format!("a larger --punch-radius; or --draws up to {MOST_GIVEN}: its run judges them");
            (most, metal.total(most), of, or)
        };
        let blank = |height: f64| self::part(self.inputs, part.thickness, part.nose, height).blank(height);
        let ratio = draw_ratio(blank, [part.nose + part.thickness, part.height], part.radius, (limit, &of), &or)?;
        let first = metal.draws(ratio).min(most).max(least) + stepped;
        let mut kept = first;
        for draws in [first, first + 1] {
            let plan = self.tried(draws, is_single)?;
            match plan.end {
                End::Steep => kept = draws,
                End::Tears if !is_single => {}
                _ => return Ok(plan),
            }
        }
        self.tried(kept, true)
    }

    fn radii(&self, blank: f64, draws: usize) -> Vec<f64> {
        let Part { radius: last, step, .. } = self.part;
        let early = draws - 1 - usize::from(step.is_some());
        let share = (blank / last).ln() / self.metal.total(early + 1).ln();
        // The ring of a reverse redraw is as wide as its ratio lets it be.
        let widest = self.inputs.is_on("reverse").then(|| last * self.metal.ratios[1].powi(early as i32));
        let radius = |i: usize| match self.inputs.number("first-radius").or(widest) {
            Some(first) => first * (last / first).powf(i as f64 / early as f64),
            None => Picked::nearest(blank / self.metal.total(i + 1).powf(share), 0.05, "").value,
        };
        (0..early).map(radius).chain([last]).chain(step.map(|[narrow, _]| narrow)).collect()
    }

    fn plan(&self, draws: usize) -> Plan {
        let Part { step, height, thickness, .. } = self.part;
        let blank = self.inputs.pick("blank-radius", || Picked::nearest(self.part.blank(height), BLANK, AREA));
        let travel = Picked::nearest(step.map_or(height - thickness, |[_, low]| low), 0.1, "height inside");
        Plan { radii: self.radii(blank.value, draws), blank, travel, end: End::Met }
    }

    /// Plan whose run meets the sizes, or comes as near as runs that end do. Whether it tears the last run says, on the case's
    /// own mesh. If the number of draws is not kept, runs end where the blank takes more.
    fn tried(&self, draws: usize, is_kept: bool) -> Result<Plan, CaseError> {
        let mut plan = self.plan(draws);
        let runs = if plan.blank.is_given() { 0 } else { RUNS };
        let mut is_coarse = draws > 1;
        for _ in 0..runs {
            let text = self.values(&plan, false)?.fill(find("cup")?.text);
            let elements = (0.7 * rules::elements(plan.blank.value, self.part.nose) as f64) as usize;
            let coarse = if is_coarse { vec![format!("blank.elements={elements}")] } else { Vec::new() };
            let Ok(case) = parse(&text, "cup.toml", &coarse) else { break };
            let solution = case.solve(&mut ());
            let findings = assess::after(&solution.case, &solution.stages);
            let tears = FailureMode::all(&solution.stages, &findings).contains(&FailureMode::Tears);
            let frame = solution.stages.last().and_then(|stage| stage.frames.last());
            let missing = frame.filter(|_| solution.is_complete()).and_then(|frame| self.part.missing(frame));
            plan.end = if tears || missing.is_none() { End::Tears } else { End::Met };
            let [area, low] = match missing {
                Some(missing) => missing,
                None if std::mem::take(&mut is_coarse) => continue,
                None => break,
            };
            let error = low.abs().max(area.abs() / (2.0 * PI * self.part.flange.unwrap_or(self.part.radius)));
            let blank = (plan.blank.value.powi(2) + area / PI).sqrt();
            if !is_kept && error < NEAR && self.metal.draws(blank / self.part.bottom_radius()) > draws {
                plan.end = End::Steep;
                break;
            }
            if error < if tears && !is_kept { NEAR } else { MET } && !is_coarse {
                break;
            }
            plan.blank = Picked::nearest(blank, BLANK, format!("{AREA}, corrected by runs of this case"));
            if plan.blank.value > self.metal.ratios[0] * plan.radii[0] {
                plan.radii = self.radii(plan.blank.value, draws);
            }
            plan.travel = Picked::nearest(plan.travel.value + low, 0.1, "as runs of this case need for the height");
            is_coarse &= error > NEAR;
        }
        Ok(plan)
    }

    fn tools(&self, plan: &Plan) -> Vec<Tools> {
        let Part { thickness: t, height, trim, flange, step, .. } = self.part;
        let (blank, draws) = (plan.blank.value, plan.radii.len());
        // A flange stays outside.
        let drawn_in = flange.map_or(blank, |_| Part { flange: None, trim: 0.0, ..self.part }.blank(height));
        let (mut radius_before, mut rim_before) = (blank, t);
        let tools = |(i, radius): (usize, &f64)| {
            let is_last = i + 1 == draws;
            let round = if is_last { self.part.nose } else { self.part.nose.max(rules::tool_radius(t).value) };
            let nose = Picked { value: round, ..self.nose.clone() };
            let cup = self.part.cup_height(blank, *radius, nose.value);
            let rim = rules::rim(rim_before, radius_before / radius, self.sheet.r_value());
            let given = self.inputs.number("last-clearance").filter(|_| is_last).or(self.inputs.number("clearance"));
            let clearance = Picked::or(given, || rules::drawing_clearance(t, drawn_in / radius));
            let room = flange.map_or(f64::INFINITY, |flange| (flange - radius - clearance.value - t).floor());
            let fits = |rule: &Picked| rule.value <= room || room < rules::THIN * t;
            let narrow = || Picked::by(room, "what the flange leaves beside a thickness of flat (declared)");
            let rule = || Some(rules::drawn_shoulder(rim)).filter(fits).unwrap_or_else(narrow);
            let shoulder = self.inputs.pick("shoulder", rule);
            (radius_before, rim_before) = (*radius, rim.min(clearance.value));
            let travel = || match is_last {
                true if flange.is_some() || step.is_some() => plan.travel.clone(),
                true => rules::drawn_travel(height + trim, shoulder.value, t),
                false => rules::drawn_travel(HIGHER * cup, shoulder.value, t),
            };
            let travel = Picked::or(self.inputs.number("travel").filter(|_| is_last), travel);
            let punch = self.punch(is_last, *radius, nose.value, clearance.value);
            Tools { radius: *radius, nose, clearance, shoulder, travel, cup, punch }
        };
        plan.radii.iter().enumerate().map(tools).collect()
    }

    fn values(&self, plan: &Plan, is_ironed: bool) -> Result<Values, CaseError> {
        let (Self { inputs, sheet, .. }, Part { radius, height, flange, recess, .. }) = (self, self.part);
        let (blank, tools) = (plan.blank.clone(), self.tools(plan));
        let first = &tools[0];
        let end = radius + first.clearance.value + first.shoulder.value;
        let what = || format!("the flange ends on the die's shoulder, which ends at a radius of {}", plain(end));
        ensure(flange.is_none_or(|flange| flange > end), what, "make the flange wider, or --shoulder smaller")?;
        let (corner, clearance, ratio) = (first.nose.value, first.clearance.clone(), blank.value / first.radius);
        let draw = Draw { punch: first.radius, corner, ratio, clearance, shoulder: first.shoulder.clone(), blank };
        let (mut sizes, pressure) = draw.values(inputs, sheet)?;
        if plan.end == End::Tears {
            let warning = " Its run tears or stops: a wider or lower part, a larger --nose or less friction helps.";
            sizes.set("warning", warning, "");
        }
        self.describe(&tools, &mut sizes);
        let is_through = inputs.number("travel").is_none();
        sizes.lengths([("travel", &first.travel)]);
        let walls = if is_ironed { self.walls(&tools[tools.len() - 1])? } else { Vec::new() };
        if is_through && walls.is_empty() {
            sizes.lengths([("height", &Picked::input(height))]);
        }
        let (key, trimmed) = flange.map_or(("inside", radius), |flange| ("flange_diameter", flange));
        sizes.lengths([(key, &Picked::input(2.0 * trimmed))]);
        sizes.set("punch", &first.punch, &first.nose.reason("nose: "));
        if recess.is_some() {
            let [by, shoulder, closed] = [&first.clearance, &first.shoulder, &first.travel].map(|size| mm(size.value));
            let die = format!("{{ offset_of = \"punch\", by = {by}, shoulder = {shoulder}, closed_at = {closed} }}");
            sizes.set("die", die, "closed at the end, its bottom makes the recess");
            sizes.drop(&["throat", "shoulder"]);
        } else if flange.is_none() && is_through {
            sizes.set("through", true, "");
        }
        if tools.len() > 1 || !walls.is_empty() {
            // With usual elements the force oscillates as nodes leave the shoulder.
            sizes.elements(
                plan.blank.value,
                first.shoulder.value.min(self.part.nose),
                if tools.len() > 1 { 2.0 } else { 1.5 },
            );
            sizes.set("stages", self.later(&tools, pressure, &walls), "");
        }
        Ok(sizes)
    }

    fn describe(&self, tools: &[Tools], sizes: &mut Values) {
        let Part { radius, height, flange, step, dome, recess, .. } = self.part;
        let kinds = [flange, step.map(|step| step[0]), dome, recess.map(|recess| recess[0])];
        let kinds = kinds.into_iter().zip(["Flanged cup", "Stepped cup", "Domed cup", "Recessed cup"]);
        let kind = kinds.into_iter().find_map(|(is, kind)| is.map(|_| kind)).unwrap_or("Cup");
        let radii: Vec<String> = tools.iter().map(|tools| plain(2.0 * tools.radius)).collect();
        sizes.set("kind", kind, "");
        sizes.set("part", format!("{kind}, drawn to inside diameters of {}", radii.join(", then ")), "");
        let end = if self.inputs.number("wall").is_some() { "trimmed rim before it is ironed" } else { "trimmed rim" };
        sizes.set("end", if flange.is_some() { "flange" } else { end }, "");
        sizes.set("wall_height", plain(height), "");
        sizes.set("diameter", plain(2.0 * radius), "");
    }
}
