//! Lines of a summary: load, part, energies, condition, and the numerical solution.

use super::*;

struct Lines<'a> {
    view: &'a StageView<'a>,
    model: &'a Model,
    run: &'a StageSolution,
    /// Last step, or the sheet at its start.
    last: StepRecord,
    group: Group,
    lines: Vec<Line>,
}

pub(super) fn lines(view: &StageView) -> Vec<Line> {
    let (model, run) = (view.model(), view.stage);
    let last = run.steps.last().copied().unwrap_or_else(|| as_begun(run));
    let mut lines = Lines { view, model, run, last, group: Group::Case, lines: Vec::new() };
    lines.plain("case", "Case", view.name.clone());
    lines.plain("title", "Title", model.title.clone());
    lines.plain("section", "Section", section_of(model.extent()));
    lines.group = Group::Part;
    lines.load();
    lines.part();
    lines.condition();
    lines.group = Group::Solution;
    lines.solution();
    lines.group = Group::Case;
    for (key, label, entries) in [
        ("overrides", "Set on the command line", view.case.map_or_else(Vec::new, |case| case.overrides.clone())),
        ("derived", "Assumed while reading", sentences(&view.findings, Kind::Assumption)),
        ("warnings", "Warnings", sentences(&view.findings, Kind::Warning)),
        ("notes", "Declared assumptions", model.notes.clone()),
    ] {
        let rows = entries.iter().map(|entry| [String::new(), format!("- {entry}")]).collect();
        lines.add(key, label, Value::Rows(rows, entries.into()));
    }
    lines.lines
}

impl Lines<'_> {
    fn add(&mut self, key: &'static str, label: &str, value: Value) {
        self.lines.push(Line { group: self.group, key, label: label.to_owned(), value });
    }

    fn number(&mut self, key: &'static str, label: &str, amount: impl Into<Option<Amount>>) {
        let Some(amount) = amount.into() else { return };
        self.add(key, label, Value::Number(self.view.half(amount).map_or(amount, |bar| amount.with_bar(bar))));
    }

    fn plain(&mut self, key: &'static str, label: &str, value: impl Into<Json>) {
        self.add(key, label, Value::Plain(value.into()));
    }

    fn force(&self, force: f64) -> Amount {
        Amount::force(force, self.model.extent().force_unit())
    }

    fn load(&mut self) {
        let Self { view, model, run, last, .. } = *self;
        self.plain("hardening", "Hardening", model.material.describe());
        let is_full = run.stop.kind == StopKind::FullTravel;
        self.plain("stop", "Ended", if is_full { format!("{} reached", stop_text(run)) } else { run.stop.to_string() });
        self.plain("complete", "", run.stop.is_complete());
        let models = || view.case.iter().flat_map(|case| &case.stages).map(|stage| &stage.model);
        let until = models().position(|other| other == model).map_or(0, |own| own + 1);
        self.plain("draws_mm", "", draws(models().take(until)));
        if model.travel > 0.0 {
            let loads = run.steps.iter().copied().zip(run.working_force());
            let (peak, force) = loads.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or_default();
            self.number("travel", &format!("{} reached", capitalised(&view.progress())), Amount::place(last.travel));
            self.number("peak_punch_force", &format!("Peak {}", model.force_label().to_lowercase()), self.force(force));
            self.number("peak_travel", "  at a travel of", Amount::place(peak.travel));
        }
        if !model.gas.is_empty() {
            self.number("peak_pressure", "Largest pressure", Amount::stress(largest(run, |s| s.pressure.abs())));
            let height = Some(last.pole_height).filter(|_| !model.blank.is_open());
            self.number("pole_height", "Height of the middle", height.map(Amount::place));
        }
        if let Some(control) = model.rate_control() {
            let rate = |rate| Amount::new(rate, Unit::PerSecond, Digits::Significant(3));
            let least = run.steps.iter().map(|s| s.held_rate).reduce(f64::min).unwrap_or(0.0);
            self.number("held_rate_target", "Strain rate to be held", rate(control.target));
            self.number("held_rate_least", "  least", rate(least));
            self.number("held_rate_largest", "  largest", rate(largest(run, |s| s.held_rate)));
            let before = std::iter::once(0.0).chain(run.steps.iter().map(|s| s.time));
            let capped = run.steps.iter().zip(before).filter(|(s, _)| s.on_cap.is_some());
            let capped: f64 = capped.map(|(s, before)| s.time - before).sum();
            let capped = (last.time > 0.0).then(|| Amount::share(capped / last.time));
            self.number("time_on_cap", "  time on a cap of the pressure", capped);
            self.number("time", "Time of the cycle", Amount::time(last.time));
        }
        let touching = Some(last.contact_share).filter(|share| *share > 0.0);
        self.number("contact_share", "Sheet on its tools at the end", touching.map(Amount::share));
        self.add("events", "Events", Value::events(run));
    }

    fn part(&mut self) {
        let Self { view, model, run, last, .. } = *self;
        let end = run.frames.last();
        let is_open = model.blank.is_open();
        self.number("part_height", "Height over all", end.and_then(part_height).map(Amount::place));
        if let Some(changes) = tables::springback_changes(run) {
            self.add("springback", "Spring-back", Value::changes(&changes));
        } else if let Some(angle) = end.filter(|_| !is_open).and_then(|end| Shape::of(end).wall_angle()) {
            self.number("wall_angle", "Wall to the punch direction", Amount::angle(angle));
        }
        let over_initial = |thickness, s0| Amount::share(thickness / model.blank.unformed_thickness(s0));
        let from = worded(model.geometry, "from the axis", "from the symmetry plane");
        let from = &format!("  at s0, initially {}", if is_open { "along the sheet" } else { from });
        self.number("stretch", "Stretch between the clamps", stretch(run).map(Amount::share));
        self.number("thinnest", "Thinnest place", Amount::thickness(last.thinnest));
        let share = over_initial(last.thinnest, last.thinnest_s0);
        self.number("thinnest_over_initial", "  over the initial thickness", share);
        self.number("thinnest_s0", from, Amount::place(last.thinnest_s0));
        if let Some((thickest, s0)) = end.and_then(thickest) {
            self.number("thickest", "Thickest place", Amount::thickness(thickest));
            self.number("thickest_over_initial", "  over the initial thickness", over_initial(thickest, s0));
            self.number("thickest_s0", from, Amount::place(s0));
        }
        let pulled = Some(largest(run, |s| s.tearing_index)).filter(|index| *index > 0.0);
        self.number("tearing_index", "Tearing index at its largest", pulled.map(Amount::share));
        self.number("ring_opening", "Opening of a slit ring", view.ring_opening().map(Amount::opening));
        if let (Some(assessment), Some(curve)) = (view.forming_limit(), &model.forming_limit) {
            let (worst, least) = (assessment.worst(), Amount::ratio(curve.plane_strain()));
            self.plain("forming_limit", "Forming limit", curve.name);
            self.number("forming_limit_plane_strain", "  at plane strain, true strain", least);
            self.number("forming_margin", "  least margin in major true strain", Amount::ratio(worst.margin()));
            self.number("forming_ratio", "  major strain over the limit there", Amount::share(worst.ratio()));
            self.number("forming_margin_s0", "  at s0, its initial distance", Amount::place(worst.s0));
            self.plain("forming_margin_path_crooked", "  its path is not straight", worst.is_crooked());
            self.plain("forming_paths_crooked", "  elements whose path is not straight", assessment.crooked());
            self.plain("forming_limit_reached", "  reached", assessment.reached.is_some());
            if let Some(reached) = assessment.reached {
                let has_travel = model.travel > 0.0;
                let [travel, time] = [Amount::place(reached.travel), Amount::time(reached.time)];
                self.number("forming_limit_travel", "    first at a travel of", has_travel.then_some(travel));
                self.number("forming_limit_time", "    first at a time of", (!has_travel).then_some(time));
                self.number("forming_limit_s0", "    at s0, its initial distance", Amount::place(reached.s0));
            }
        }
        match model.blank.edge {
            Edge::Free if !is_open => self.number("draw_in", "Draw-in of the edge", Amount::draw_in(last.draw_in)),
            _ => self.plain("draw_in_mm", "", rounded(last.draw_in)),
        }
    }

    fn condition(&mut self) {
        let Self { model, run, last, .. } = *self;
        let energy = |energy: f64| Amount::force(JOULES * energy, model.extent().energy_unit());
        let work = last.work.without_round_off();
        if work.external < 0.0 {
            self.number("work_given_back", "Work given back to the tools", energy(-work.external));
            self.number("work_out_of_sheet", "  out of the sheet's elasticity", energy(0.0 - work.elastic));
            self.number("work_out_of_contact", "  out of the contact", energy(0.0 - work.contact));
        }
        self.number("work_external", "Work of the tools", energy(work.external));
        self.number("work_plastic", "  plastic", energy(work.plastic));
        self.number("work_elastic", "  stored in the sheet", (model.mode != Mode::Flow).then(|| energy(work.elastic)));
        self.number("work_friction", "  friction", energy(work.friction));
        self.number("work_contact", "  stored in contact", energy(work.contact));
        if model.heat.as_ref().is_some_and(|heat| heat.flow.is_some()) {
            self.number("heat_stored", "Heat stored in the sheet", energy(last.heat.stored));
            self.number("heat_plastic", "  from plastic work", energy(last.heat.plastic));
            self.number("heat_tools", "  from the tools", energy(last.heat.tools));
        }
        if model.material.gtn.is_some() {
            self.number("porosity", "Largest porosity", Amount::share(last.porosity));
            self.number("porous_s0", "  at an initial distance of", Amount::place(last.porous_s0));
        }
        if model.material.fracture.is_some() {
            self.number("damage", "Largest damage over its critical value", Amount::share(last.damage));
            self.number("damage_s0", "  at an initial distance of", Amount::place(last.damage_s0));
        }
        if let Some(heat) = &model.heat {
            // A run that never started has the temperature it was given.
            let coldest = run.steps.iter().map(|s| s.coldest).reduce(f64::min).unwrap_or(heat.initial.smallest());
            let hottest = run.steps.iter().map(|s| s.hottest).reduce(f64::max).unwrap_or(heat.initial.largest());
            self.number("coldest", "Lowest temperature", Amount::temperature(coldest - ZERO_CELSIUS));
            self.number("hottest", "Highest temperature", Amount::temperature(hottest - ZERO_CELSIUS));
        }
        let ironing = largest(run, |s| s.ironing);
        if ironing > 0.0 {
            let [force, friction] = [largest(run, |s| s.ironing_force), largest(run, |s| s.ironing_friction)];
            let pressure = Amount::stress(largest(run, |s| s.ironing_pressure));
            self.number("ironing", "Ironing: reduction of the thickness", Amount::share(ironing));
            self.number("ironing_force", "Largest ironing force of the die", self.force(force));
            self.number("ironing_friction", "Largest friction in it", self.force(friction));
            self.number("ironing_pressure", "Largest ironing pressure", pressure);
        }
        // A flat sheet has no bend.
        let sharpest = largest(run, |s| s.sharpest_bend);
        let radius = if sharpest > 0.0 { 1.0 / sharpest } else { 0.0 };
        self.number("sharpest_bend", "Smallest bending radius", Amount::thicknesses(radius));
        let pad = model.tool(Role::Pad).filter(|_| model.release.is_none());
        self.number("peak_pad_force", "Largest pad force", pad.map(|_| self.force(largest(run, |s| s.pad_force))));
        if !model.further.is_empty() && model.release.is_none() {
            self.add("further_tools", "Further tools", Value::further(run));
        }
        if model.tool(Role::Holder).is_none() || model.release.is_some() {
            return;
        }
        if let Some(closing) = run.closing {
            self.number("closing_way", "Way of the holder to close over the sheet", Amount::place(closing.way));
            self.number("closing_gap", "  stands open by", Amount::thickness(closing.gap));
            self.number("closing_force", "  with a force of", self.force(closing.force));
        }
        self.number("peak_holder_force", "Largest holder force", self.force(largest(run, |s| s.holder_force)));
        let rim = format!("  last share on the outer {}", Amount::given_thicknesses(StepRecord::RIM));
        let last = run.steps.iter().rev().find(|s| s.holder_force > 0.0).map_or(0.0, |s| s.rim_share);
        self.number("rim_share", &rim, Amount::share(last));
        let lift = holder_lift(run).map(Amount::thickness);
        self.number("holder_lift", "  lifted by up to, while there is a flange", lift);
    }

    fn solution(&mut self) {
        let Self { view, model, run, last, .. } = *self;
        let (effort, work) = (&run.effort, last.work.without_round_off());
        let share = |part: f64, whole: f64| Amount::share(if whole == 0.0 { 0.0 } else { part / whole });
        let count = |value: fn(&StepRecord) -> usize| run.steps.iter().map(value).sum::<usize>();
        self.number("imbalance", "Work missing in the balance", share(last.work.missing(), run.largest_work()));
        self.number("cutoff_share", "Plastic work in nearly rigid zones", share(work.cutoff, work.plastic));
        let bent = run.frames.last().filter(|_| model.mode != Mode::Flow && model.release.is_none());
        let missed = bent.and_then(moment_error).map(Amount::share);
        self.number("moment_error", "Bending moment missed by the layers, estimated", missed);
        let [deepest, strain] = [largest(run, |s| s.penetration), largest(run, |s| s.strain_increment)];
        self.number("penetration", "Tools in the sheet, of its thickness", Amount::share(deepest));
        self.number("sticking", "Contacts that stick at the end", Amount::share(last.sticking));
        self.plain("flips", "Contacts that came or went", count(|s| s.contact_changes));
        self.number("strain_increment", "Largest strain of one step", Amount::ratio(strain));
        self.plain("mesh", "Mesh", mesh(model));
        let [matrix, norm] = model.settings.corrector();
        let corrector = format!("{matrix} matrix, {norm} norm below {}", Amount::norm(model.settings.tolerance));
        self.plain("corrector", "Corrector", corrector);
        self.plain("steps", "Steps", run.steps.len());
        self.plain("iterations", "Iterations", count(|s| s.iterations));
        // Where the residual alone decides, a step may be accepted without an increment that says how far it was.
        let known = run.steps.iter().map(|s| s.velocity_norm).filter(|norm| norm.is_finite());
        self.number("velocity_norm", "Largest accepted velocity norm", known.reduce(f64::max).map(Amount::norm));
        self.number("residual_norm", "Largest accepted residual norm", Amount::norm(largest(run, |s| s.residual_norm)));
        self.plain("rejected", "Rejected tries", count(|s| s.rejected) + effort.abandoned);
        self.plain("steps_from_predictor", "", effort.predictor);
        self.plain("steps_from_secant", "", effort.secant);
        self.plain("steps_from_softened", "", effort.softened);
        self.plain("steps_halved", "", effort.halved);
        self.plain("steps_overstrained", "", effort.overstrained);
        self.plain("steps_overstepped", "", effort.overstepped);
        self.number("wall_time", "Wall time", view.wall.map(|wall| Amount::time(wall.as_secs_f64())));
        self.plain("program", "", concat!(env!("CARGO_PKG_NAME"), " ", env!("CARGO_PKG_VERSION")));
        self.plain("case_sha256", "", sha256([view.case.map_or("", |case| &case.text)]));
    }
}

fn as_begun(run: &StageSolution) -> StepRecord {
    let blank = &run.model.blank;
    let (elements, nodes) = run.start.as_ref().map_or((&[][..], &[][..]), |start| (&start.elements, &start.nodes));
    let thinnest = elements.iter().min_by(|a, b| a.thickness.total_cmp(&b.thickness));
    let (thinnest, thinnest_s0) = thinnest.map_or((blank.thickness, 0.0), |element| (element.thickness, element.s0));
    let draw_in = nodes.last().map_or(0.0, |node| blank.edge_radius() - node.r);
    let pole_height = nodes.first().map_or(0.0, |node| node.z);
    StepRecord { thinnest, thinnest_s0, draw_in, pole_height, ..StepRecord::default() }
}

fn mesh(model: &Model) -> String {
    let blank = &model.blank;
    let bending = || format!("bending, {} layers", blank.layers);
    let theory = if blank.theory == Theory::Membrane { "membrane".to_owned() } else { bending() };
    let grading = if blank.grading == Grading::Uniform { "uniform" } else { "graded by the tools' radii" };
    format!("{} elements, {theory}, {grading}", blank.elements)
}
