//! Round part by its finished sizes: draws planned by a rule and tried by runs, which also correct the blank.

use super::*;
use super::{redraw::Ring, sizes::Draw};
use crate::assess::{self, Answer, FailureMode};
use crate::case::parse;
use crate::part::Part;
use rules::Metal;

/// Most runs that correct the blank.
const RUNS: usize = 8;
/// Error of height or edge that is met, and below which runs go on with the case's own mesh \[mm\].
const MET: f64 = 0.1;
const NEAR: f64 = 1.0;
/// Most draws that `--draws` takes.
const MOST_GIVEN: usize = 6;
/// Least flat beside the slope of a recess \[mm\].
const FLAT: f64 = 0.05;
/// Height of an early cup over that of its blank's area at an even thickness \[–\].
const HIGHER: f64 = 1.05;

/// Part, what its sheet takes, and what was given.
struct Cup<'a> {
    inputs: &'a Inputs,
    sheet: &'a Sheet,
    metal: Metal,
    part: Part,
    nose: Picked,
}

/// Radii of the punches, blank, and travel of the last punch where a flange or a step is left \[mm\].
struct Plan {
    radii: Vec<f64>,
    blank: Picked,
    travel: f64,
}

/// Punch and die of a draw, and the cup that comes of it \[mm\].
struct Tools {
    radius: f64,
    nose: Picked,
    clearance: Picked,
    travel: Picked,
    /// Height at an even thickness.
    cup: f64,
    /// Punch as TOML.
    punch: String,
}

pub(super) fn cup(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    Cup::read(inputs, sheet)?.planned(1)
}

pub(super) fn redraw(inputs: &Inputs, sheet: &Sheet) -> Result<Values, CaseError> {
    Cup::read(inputs, sheet)?.planned(2)
}

impl<'a> Cup<'a> {
    fn read(inputs: &'a Inputs, sheet: &'a Sheet) -> Result<Self, CaseError> {
        let ([radius, height], thickness) = (inputs.values(["punch-radius", "height"]), sheet.thickness);
        let given = |key: &str| inputs.number(key);
        let step = given("step-radius").map(|radius| [radius, given("step-height").unwrap_or(0.5 * height)]);
        let nose = nose(inputs, sheet, step.map_or(radius, |[narrow, _]| narrow))?;
        let flange = given("flange-radius").or(given("flange").map(|width| radius + thickness + width));
        let inner = || given("recess-radius").unwrap_or(0.5 * (radius - nose.value));
        let recess = given("recess").map(|depth| [inner(), depth]);
        let trim = inputs.pick("trim", || rules::trim(flange.unwrap_or(height), thickness)).value;
        let dome = given("dome-radius");
        let part = Part { thickness, radius, nose: nose.value, height, trim, flange, step, dome, recess };
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
            let help = "make --recess or --nose smaller, or --recess-radius other";
            ensure(at > half && at + half < radius - nose, what, help)?;
        }
        let first = self.inputs.number("first-radius");
        let what = || format!("the first punch is no wider than the last one of {}", plain(radius));
        ensure(first.is_none_or(|first| first > radius), what, "make --first-radius larger")?;
        let kinds = [flange.is_some(), step.is_some(), recess.is_some()];
        let what = || "a part has one of flange, step and recess here".to_owned();
        ensure(kinds.into_iter().filter(|is| *is).count() < 2, what, "leave one out; a later stage can make it")
    }

    /// Sizes for as many draws as the rule plans, `least` at least; where the sheet tears in runs of them, for one more.
    fn planned(&self, least: usize) -> Result<Values, CaseError> {
        let (part, metal, stepped) = (self.part, self.metal, usize::from(self.part.step.is_some()));
        let is_single = part.flange.is_some() || part.recess.is_some();
        if let Some(given) = self.inputs.number("draws") {
            let (draws, most) = (given as usize, if is_single { 1 } else { MOST_GIVEN });
            let what = || format!("--draws {given} is no number of draws for this part");
            let fits = draws as f64 == given && (1 + stepped..=most).contains(&draws);
            ensure(fits, what, &format!("from {} to {most}", 1 + stepped))?;
            return self.values(&self.tried(draws)?.0, "");
        }
        let (most, or) = match is_single {
            true => (1, "a larger --punch-radius; a flange or a recess is made in one draw here"),
            false => (rules::MOST_DRAWS - stepped, "a larger --punch-radius"),
        };
        // A flange that stays outside takes load off the wall: beyond the metal's own limit runs decide.
        let (limit, of) = match is_single {
            true => (rules::LIMITING_RATIO, "what one draw of a flange or a recess can do (declared)".to_owned()),
            false => (metal.total(most), format!("what {most} draws of {} can do (4ming)", metal.name)),
        };
        let ratio = draw_ratio(|height| part.blank(height), part.height, part.radius, (limit, &of), or)?;
        let first = metal.draws(ratio).unwrap_or(most).min(most).max(least) + stepped;
        for draws in first..=if is_single { first } else { first + 1 } {
            if let (plan, true) = self.tried(draws)? {
                return self.values(&plan, "");
            }
        }
        let warning = " Runs of it tear: a wider or lower part, a larger --nose or less friction helps.";
        self.values(&self.plan(first), warning)
    }

    /// Radii in equal shares of what each draw takes, and the blank by area.
    fn plan(&self, draws: usize) -> Plan {
        let Part { radius: last, step, height, thickness, .. } = self.part;
        let (blank, early) = (self.part.blank(height), draws - 1 - usize::from(step.is_some()));
        let share = (blank / last).ln() / self.metal.total(early + 1).ln();
        let first = self.inputs.number("first-radius");
        let radius = |i: usize| match first {
            Some(first) => first * (last / first).powf(i as f64 / early as f64),
            None => 0.1 * (10.0 * blank / self.metal.total(i + 1).powf(share)).round(),
        };
        let radii = (0..early).map(radius).chain([last]).chain(step.map(|[narrow, _]| narrow)).collect();
        let why = "half of D, area of the mid-surface with what is trimmed (Guldin), corrected by runs of this case";
        let travel = step.map_or(height - thickness, |[_, low]| low);
        Plan { radii, blank: self.inputs.pick("blank-radius", || Picked::by(blank, why)), travel }
    }

    /// Plan whose run meets the sizes, and true; the uncorrected one and false if the sheet tears on the way.
    fn tried(&self, draws: usize) -> Result<(Plan, bool), CaseError> {
        let mut plan = self.plan(draws);
        let runs = if plan.blank.is_given() { 0 } else { RUNS };
        let mut is_coarse = draws > 1;
        for _ in 0..runs {
            let sizes = self.values(&plan, "")?;
            let text = sizes.fill(find("cup")?.text);
            let elements = (0.7 * rules::elements(plan.blank.value, self.part.nose) as f64) as usize;
            let coarse = if is_coarse { vec![format!("blank.elements={elements}")] } else { Vec::new() };
            let Ok(case) = parse(&text, "cup.toml", &coarse) else { break };
            let solution = case.solve(&mut ());
            let frame = solution.stages.last().and_then(|stage| stage.frames.last());
            let Some(frame) = frame.filter(|_| solution.is_complete()) else { return Ok((self.plan(draws), false)) };
            let findings = assess::after(&solution.case, &solution.stages);
            let failures = Answer::of(&solution.case, &solution.stages, &findings).failures;
            if failures.contains(&FailureMode::Tears) {
                return Ok((self.plan(draws), false));
            }
            let Some([area, low]) = self.part.missing(frame) else { break };
            let error = low.abs().max(area.abs() / (2.0 * PI * self.part.flange.unwrap_or(self.part.radius)));
            if error < MET && !is_coarse {
                break;
            }
            let blank = (plan.blank.value.powi(2) + area / PI).sqrt();
            plan.blank = Picked::by(blank, plan.blank.why);
            plan.travel += low;
            is_coarse &= error > NEAR;
        }
        Ok((plan, true))
    }

    /// Punch and die of each draw.
    fn tools(&self, plan: &Plan, shoulder: f64) -> Vec<Tools> {
        let Part { thickness: t, height, trim, flange, step, .. } = self.part;
        let (blank, draws) = (plan.blank.value, plan.radii.len());
        // A flange stays outside.
        let drawn_in = flange.map_or(blank, |_| Part { flange: None, trim: 0.0, ..self.part }.blank(height));
        let tools = |(i, radius): (usize, &f64)| {
            let is_last = i + 1 == draws;
            let round = if is_last { self.part.nose } else { self.part.nose.max(rules::tool_radius(t).value) };
            let nose = Picked { value: round, ..self.nose.clone() };
            let cup = self.part.cup_height(blank, *radius, nose.value);
            let travel = || match is_last {
                true if flange.is_some() || step.is_some() => {
                    Picked::by(plan.travel, "as runs of this case need for the height")
                }
                true => rules::drawn_travel(height + trim, shoulder, t),
                false => rules::drawn_travel(HIGHER * cup, shoulder, t),
            };
            let travel = Picked::or(self.inputs.number("travel").filter(|_| is_last), travel);
            let clearance = self.inputs.pick("clearance", || rules::drawing_clearance(t, drawn_in / radius));
            let punch = self.punch(is_last, *radius, nose.value, clearance.value);
            Tools { radius: *radius, nose, clearance, travel, cup, punch }
        };
        plan.radii.iter().enumerate().map(tools).collect()
    }

    fn values(&self, plan: &Plan, warning: &str) -> Result<Values, CaseError> {
        let (Self { inputs, sheet, .. }, Part { radius, height, flange, recess, .. }) = (self, self.part);
        let (blank, t) = (plan.blank.clone(), sheet.thickness);
        let shoulder = inputs.pick("shoulder", || rules::drawn_shoulder(t, blank.value / radius, sheet.r_value()));
        let tools = self.tools(plan, shoulder.value);
        let first = &tools[0];
        let end = radius + first.clearance.value + shoulder.value;
        let what = || format!("the flange ends on the die's shoulder, which ends at a radius of {}", plain(end));
        ensure(flange.is_none_or(|flange| flange > end), what, "make the flange wider, or --shoulder smaller")?;
        let (corner, clearance, ratio) = (first.nose.value, first.clearance.clone(), blank.value / first.radius);
        let draw = Draw { punch: first.radius, corner, ratio, clearance, shoulder: shoulder.clone(), blank };
        let (mut sizes, pressure) = draw.values(inputs, sheet)?;
        if !warning.is_empty() {
            sizes.set("warning", warning, "");
        }
        self.describe(&tools, &mut sizes);
        let is_through = inputs.number("travel").is_none();
        sizes.lengths([("travel", &first.travel)]);
        if is_through {
            sizes.lengths([("height", &Picked::input(height))]);
        }
        match flange {
            Some(flange) => sizes.lengths([("flange_diameter", &Picked::input(2.0 * flange))]),
            None => sizes.lengths([("inside", &Picked::input(2.0 * radius))]),
        }
        sizes.set("punch", &first.punch, &first.nose.reason("nose: "));
        if recess.is_some() {
            let [by, shoulder, closed] = [&first.clearance, &shoulder, &first.travel].map(|length| mm(length.value));
            let die = format!("{{ offset_of = \"punch\", by = {by}, shoulder = {shoulder}, closed_at = {closed} }}");
            sizes.set("die", die, "closed at the end, its bottom makes the recess");
            sizes.drop(&["throat", "shoulder"]);
        } else if flange.is_none() && is_through {
            sizes.set("through", true, "");
        }
        if tools.len() > 1 {
            // With usual elements the force oscillates as nodes leave the shoulder.
            sizes.elements(plan.blank.value, shoulder.value.min(self.part.nose), 2);
            sizes.set("stages", self.redraws(&tools, shoulder.value, pressure), "");
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
        sizes.set("end", if flange.is_some() { "flange" } else { "trimmed rim" }, "");
        sizes.set("wall_height", plain(height), "");
        sizes.set("diameter", plain(2.0 * radius), "");
    }

    /// Text of the stages after the first draw, with the holder's pressure of that \[MPa\].
    fn redraws(&self, tools: &[Tools], shoulder: f64, pressure: f64) -> String {
        let (thickness, mut is_held, mut text) = (self.sheet.thickness, true, String::new());
        for (i, pair) in tools.windows(2).enumerate() {
            let [before, now] = [&pair[0], &pair[1]];
            let throat = throat(now.radius, &now.clearance).value;
            let ring =
                Ring { thickness, outer: before.radius - 0.5 * thickness, nose: before.nose.value, throat, shoulder };
            let mut stage = Values::default();
            let name = if i > 0 { format!("\"redraw-{}\"", i + 1) } else { "\"redraw\"".into() };
            let why = joined(&["throat and shoulder", &plain(throat), &plain(shoulder)]);
            let given = [("name", name, ""), ("punch", now.punch.clone(), ""), ("die", ring.die(), why.as_str())];
            given.into_iter().for_each(|(name, value, why)| stage.set(name, value, why));
            stage.set("friction", rounded(self.inputs.value("friction")), "");
            stage.lengths([("move", &now.travel)]);
            let has_sleeve = ring.has_room();
            if has_sleeve {
                stage.set("sleeve", ring.sleeve(4.0 * before.cup), "");
                let why = "the first holder's pressure on the sleeve's ring (declared)";
                stage.set("force", newtons(pressure * ring.area()), why);
            } else if is_held {
                stage.set("remove", "[\"holder\"]", "no room for a sleeve: a cup as thick for its width needs none");
            }
            is_held = has_sleeve;
            text += &stage.fill(include_str!("redraw_stage.toml"));
            text.push('\n');
        }
        text.trim_end().to_owned()
    }

    /// Punch of a draw; the last one has the bottom's shape, a recess's a hollow deeper by what the gap has over the sheet.
    fn punch(&self, is_last: bool, radius: f64, nose: f64, gap: f64) -> String {
        let [wall, corner] = [radius, nose].map(mm);
        match (self.part.dome, self.part.recess) {
            (Some(dome), _) if is_last => {
                format!("crowned = {{ radius = {wall}, face = {}, nose = {corner} }}", mm(dome))
            }
            (_, Some([at, depth])) => {
                let depth = depth + gap - self.sheet.thickness;
                let [bend, width] = self.part.slope(depth);
                let [from, to, flat] = [at - 0.5 * width, at + 0.5 * width, radius - nose];
                let arc = |x: f64, y: f64, center: [f64; 2], left: bool| {
                    (Point::new(x, y), Some((Point::new(center[0], center[1]), left)))
                };
                let steps = [
                    (Point::new(from, -depth), None),
                    arc(at, -0.5 * depth, [from, bend - depth], true),
                    arc(to, 0.0, [to, -bend], false),
                    (Point::new(flat, 0.0), None),
                    arc(radius, -nose, [flat, -nose], false),
                    (Point::new(radius, -4.0 * self.part.height), None),
                ];
                format!("profile = {}", profile_text(Point::new(0.0, -depth), &steps, mm))
            }
            _ => format!("flat = {{ radius = {wall}, nose = {corner} }}"),
        }
    }
}
