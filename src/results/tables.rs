//! Tables of steps, frames, thickness points, strain paths and iterations.

use super::{StageView, csv::csv_with_texts, csv::number, csv::records};
use crate::forming_limit::Curve;
use crate::measure::{self, Change, Shape};
use crate::model::{Extent, Geometry, Model, PressureCap, Role};
use crate::plot::pressure_cycle::{CONTACT_SHARE, HEIGHT, PRESSURE as GAS_PRESSURE, STRAIN_RATE};
use crate::plot::residual_stress::{PLACE, released};
use crate::plot::{axis::capitalised, fields::element::*, fields::step::*};
use crate::solver::solution::{ElementRecord, Frame, IterationRecord, PointRecord, StageSolution, StepRecord};
use crate::solver::trace::IterationHistory;
use crate::table::{Column, Field, JOULES, Table, Unit, keyed, worded};
use crate::units::ZERO_CELSIUS;

const STEP: [Field<StepRecord>; 33] = [
    TRAVEL,
    PUNCH_FORCE,
    HOLDER_FORCE,
    EDGE_FORCE,
    DRAW_IN,
    THINNEST,
    THINNEST_S0,
    Field::new("work_external", "External work", Unit::Joule, |s| JOULES * s.work.external),
    Field::new("work_plastic", "Plastic work", Unit::Joule, |s| JOULES * s.work.plastic),
    Field::new("work_friction", "Friction work", Unit::Joule, |s| JOULES * s.work.friction),
    Field::new("work_contact", "Contact work", Unit::Joule, |s| JOULES * s.work.contact),
    Field::new("work_cutoff", "Work in cut-off points", Unit::Joule, |s| JOULES * s.work.cutoff),
    POLE_HEIGHT,
    PRESSURE,
    TEARING_INDEX,
    Field::new("holder_move", "Move of the holder towards the die", Unit::Mm, |s| s.holder_move),
    Field::new("penetration", "Penetration over thickness", Unit::None, |s| s.penetration),
    Field::new("ironing", "Reduction by ironing over thickness", Unit::None, |s| s.ironing),
    Field::new("ironing_force", "Ironing force of the die", Unit::N, |s| s.ironing_force),
    Field::new("ironing_friction", "Friction in the ironing force", Unit::N, |s| s.ironing_friction),
    Field::new("ironing_pressure", "Largest ironing pressure", Unit::MPa, |s| s.ironing_pressure),
    Field::new("rim_share", "Share of the holder force on the rim", Unit::None, |s| s.rim_share),
    Field::new("sticking", "Share of the nodes in contact that stick", Unit::None, |s| s.sticking),
    Field::new("flips", "Contacts that came or went", Unit::None, |s| s.contact_changes as f64),
    Field::new("sharpest_bend", "Thickness over the smallest bending radius", Unit::None, |s| s.sharpest_bend),
    Field::new("strain_increment", "Largest strain of the step", Unit::None, |s| s.strain_increment),
    Field::new("contact_share", "Contact share: the sheet on punch and die", Unit::None, |s| s.contact_share),
    Field::new("step", "Step", Unit::None, |s| s.step as f64),
    TIME,
    Field::new("iterations", "Iterations", Unit::None, |s| s.iterations as f64),
    Field::new("rejected", "Rejected tries", Unit::None, |s| s.rejected as f64),
    Field::new("velocity_norm", "Relative velocity increment", Unit::None, |s| s.velocity_norm),
    Field::new("residual_norm", "Relative residual", Unit::None, |s| s.residual_norm),
];
const VOIDS: Field<StepRecord> = Field::new("porosity", "Largest porosity", Unit::None, |s| s.porosity);
const HOLE: Field<StepRecord> = Field::new("hole_diameter", "Clear diameter of the hole", Unit::Mm, |s| s.hole);
const LARGEST_DAMAGE: Field<StepRecord> = Field::new("damage", "Largest damage", Unit::None, |s| s.damage);
const HEAT: [Field<StepRecord>; 5] = [
    Field::new("coldest", "Lowest temperature", Unit::Celsius, |s| s.coldest - ZERO_CELSIUS),
    Field::new("hottest", "Highest temperature", Unit::Celsius, |s| s.hottest - ZERO_CELSIUS),
    Field::new("heat_plastic", "Heat from plastic work", Unit::Joule, |s| JOULES * s.heat.plastic),
    Field::new("heat_tools", "Heat from the tools", Unit::Joule, |s| JOULES * s.heat.tools),
    Field::new("heat_stored", "Heat stored in the sheet", Unit::Joule, |s| JOULES * s.heat.stored),
];
const CYCLE: [Field<StepRecord>; 7] = [
    TIME,
    GAS_PRESSURE,
    STRAIN_RATE,
    HEIGHT,
    THINNEST,
    CONTACT_SHARE,
    Field::new("cap", "Cap in force: 0 none, 1 largest pressure, 2 its fastest rise", Unit::None, |s| match s.on_cap {
        None => 0.0,
        Some(PressureCap::Largest) => 1.0,
        Some(PressureCap::Rise) => 2.0,
    }),
];
const ITERATION: [Field<IterationRecord>; 11] = [
    Field::new("step", "Step", Unit::None, |i| i.step as f64),
    Field::new("travel", "Punch travel", Unit::Mm, |i| i.travel),
    Field::new("iteration", "Iteration", Unit::None, |i| i.iteration as f64),
    Field::new("velocity_norm", "Relative velocity increment", Unit::None, |i| i.velocity_norm),
    Field::new("residual_norm", "Relative residual", Unit::None, |i| i.residual_norm),
    Field::new("cut", "Share of the increment taken", Unit::None, |i| i.share),
    Field::new("active_contacts", "Active contacts", Unit::None, |i| i.active_contacts as f64),
    Field::new("worst_r", "Radius of the largest residual", Unit::Mm, |i| i.worst_r),
    Field::new("cut_off_elements", "Elements in cut-off", Unit::None, |i| i.cut_off as f64),
    Field::new("contacts", "Points in contact", Unit::None, |i| i.touching as f64),
    Field::new("sticking", "Points that stick", Unit::None, |i| i.sticking as f64),
];

/// Forces, draw-in, energy and effort: one row per accepted step.
pub fn load_travel(stage: &StageSolution) -> Table {
    let (model, extent) = (&stage.model, stage.model.extent());
    let damage = model.material.fracture.map(|_| &LARGEST_DAMAGE);
    let heat = model.heat.iter().flat_map(|_| &HEAT);
    let voids = model.material.gtn.map(|_| &VOIDS);
    let others = [model.tool(Role::Pad).map(|_| &PAD_FORCE), model.blank.has_hole().then_some(&HOLE)];
    let fields = STEP.iter().chain(voids).chain(damage).chain(heat).chain(others.into_iter().flatten());
    let mut columns: Vec<Column> = fields.map(|field| field.column(extent, &stage.steps)).collect();
    let die = model.tool_index(Role::Die).map(|die| ("die", stage.pressing(die)));
    columns.extend(die.into_iter().chain(stage.further_forces()).map(|(name, values)| {
        let (key, title) = (format!("{}_force", keyed(name)), format!("{} force", capitalised(name)));
        Column::new(key, title, extent.force_unit(), values)
    }));
    columns.insert(7, edge_diameter(model.geometry, model.blank.edge_radius(), &stage.steps));
    Table::new(columns)
}

pub(super) fn press(view: &StageView) -> Vec<Column> {
    let press = view.case.filter(|_| view.model().release.is_none()).map(|case| &case.press);
    let Some((press, drive)) = press.and_then(|press| Some((press, press.drive.as_ref()?))) else { return Vec::new() };
    let column = |key, label, unit, value: &dyn Fn(f64) -> f64| {
        let left = view.stage.steps.iter().map(|step| view.model().travel - step.travel);
        Column::new(key, label, unit, left.map(value).collect())
    };
    let unit = view.extent().force_unit();
    vec![
        column("slide_angle", "Crank angle before the bottom dead centre", Unit::Degree, &|left| drive.degrees(left)),
        column("permitted_force", "Permitted press force", unit, &|left| press.permitted(left).unwrap_or(f64::NAN)),
    ]
}

/// Diameter at the edge of a blank of this length \[mm\]; in plane strain the width between both edges.
pub(super) fn edge_diameter(geometry: Geometry, length: f64, steps: &[StepRecord]) -> Column {
    let label = worded(geometry, "Diameter at the edge", "Width between the edges");
    Column::new("edge_diameter", label, Unit::Mm, steps.iter().map(|s| 2.0 * (length - s.draw_in)).collect())
}

pub(super) fn pressure_cycle(view: &StageView) -> Option<Table> {
    view.stage.steps.first().and(view.model().rate_control())?;
    Some(Table::new(CYCLE.iter().map(|field| field.column(view.extent(), &view.stage.steps)).collect()))
}

pub(super) fn element_fields(model: &Model) -> Vec<Field<ElementRecord>> {
    let strains = [THICKNESS, STRAIN_MERIDIONAL, STRAIN_HOOP, STRAIN_THICKNESS, STRAIN_EQUIVALENT];
    let others = [STRESS_MERIDIONAL, STRESS_HOOP, STRAIN_EQUIVALENT_MAX, TEARING_INDEX_NOW, TEARING_INDEX_MAX];
    let porosity = model.material.gtn.map(|_| POROSITY);
    let damage = model.material.fracture.map(|_| DAMAGE);
    let temperature = model.heat.as_ref().map(|_| TEMPERATURE);
    strains.into_iter().chain(others).chain(porosity).chain(damage).chain(temperature).collect()
}

/// Shape, thickness, strains and stresses: one row per frame and element, from the axis outward.
pub fn profile(model: &Model, frames: &[Frame]) -> Table {
    let travel = frames.iter().flat_map(|f| std::iter::repeat_n(f.travel, f.elements.len())).collect();
    let column = |field: Field<ElementRecord>| field.column(model.extent(), frames.iter().flat_map(|f| &f.elements));
    let columns = [S0, R, Z].into_iter().chain(element_fields(model)).map(column);
    Table::new(std::iter::once(TRAVEL.filled(model.extent(), travel)).chain(columns).collect())
}

pub(super) fn residual_stress(view: &StageView) -> Option<Table> {
    let (frame, elements) = released(view)?;
    let (extent, layers) = (view.extent(), &frame.through.layers);
    layers.first().and(elements.first())?;
    let points = &frame.through.points[..elements.len() * layers.len()];
    let of_elements = |field: Field<ElementRecord>| {
        let values = elements.iter().flat_map(|e| std::iter::repeat_n((field.value)(e), layers.len())).collect();
        field.filled(extent, values)
    };
    let of_points = |field: Field<ElementRecord>, value: fn(&PointRecord) -> f64| {
        field.filled(extent, points.iter().map(value).collect())
    };
    let place = elements.iter().flat_map(|_| layers.iter().map(|layer| 0.5 * layer.xi));
    let zeta = elements.iter().flat_map(|e| layers.iter().map(|layer| 0.5 * layer.xi * e.thickness));
    Some(Table::new(vec![
        of_elements(S0),
        of_elements(R),
        of_elements(Z),
        Column::new("place", PLACE, Unit::None, place.collect()),
        Column::new("zeta", "ζ, from the mid-surface towards the punch", Unit::Mm, zeta.collect()),
        of_points(STRESS_MERIDIONAL, |p| p.stress_meridional),
        of_points(STRESS_HOOP, |p| p.stress_hoop),
        of_points(STRAIN_EQUIVALENT, |p| p.strain_equivalent),
    ]))
}

/// Changes of a stage that takes its tools away.
pub fn springback_changes(stage: &StageSolution) -> Option<Vec<Change>> {
    let [before, after] = stage.released()?;
    Some(measure::changes(&Shape::of(before), &Shape::of(after)))
}

/// Spring-back: one row per quantity; the opening of a slit ring \[mm\] stands after the release.
pub(super) fn springback(view: &StageView) -> Option<String> {
    let cells = |key: &str, unit: Unit, values: [Option<f64>; 3]| {
        let [before, after, change] = values.map(|value| value.map_or_else(String::new, number));
        [key.to_owned(), unit.spelled().to_owned(), before, after, change]
    };
    let mut rows = vec![["quantity", "unit", "before", "after", "change"].map(str::to_owned)];
    let changes = springback_changes(view.stage)?;
    rows.extend(changes.iter().map(|c| cells(c.quantity.key, c.quantity.unit, [c.before, c.after, c.change()])));
    rows.extend(view.ring_opening().map(|opening| cells("ring_opening", Unit::Mm, [None, Some(opening), None])));
    String::from_utf8(records(rows)).ok()
}

const MINOR: [&str; 2] = ["strain_minor", "Minor true strain, mid-surface"];
const MAJOR: [&str; 2] = ["strain_major", "Major true strain, mid-surface"];

pub(super) fn forming_limit(curve: &Curve) -> Table {
    let column = |i: usize, [key, label]: [&'static str; 2]| {
        Column::new(key, label, Unit::None, curve.points.iter().map(|point| point[i]).collect())
    };
    Table::new(vec![column(0, MINOR), column(1, MAJOR)])
}

/// Most instants of a path in its table, apart from the end; declared: twice the steps of a run by default.
const INSTANTS: usize = 200;

pub(super) fn strain_paths(view: &StageView) -> Option<Table> {
    let (assessment, curve) = (view.forming_limit()?, view.model().forming_limit.as_ref()?);
    let (paths, extent) = (view.stage.paths.thinned(INSTANTS), view.extent());
    let mut columns: [Vec<f64>; 10] = Default::default();
    for (e, judged) in assessment.elements.iter().enumerate() {
        for (instant, [minor, major]) in paths.instants.iter().zip(paths.of(e)) {
            let [meridional, hoop] = instant.strains[e];
            let limit = if curve.knows(minor) { curve.major_at(minor) } else { f64::NAN };
            let place = [judged.s0, instant.time, instant.travel, minor, major, meridional, hoop];
            let row = place.into_iter().chain([limit, limit - major, judged.crookedness]);
            columns.iter_mut().zip(row).for_each(|(column, value)| column.push(value));
        }
    }
    let [s0, time, travel, minor, major, meridional, hoop, limit, margin, crookedness] = columns;
    let plain = |[key, label]: [&'static str; 2], values| Column::new(key, label, Unit::None, values);
    Some(Table::new(vec![
        S0.filled(extent, s0),
        TIME.filled(extent, time),
        TRAVEL.filled(extent, travel),
        plain(MINOR, minor),
        plain(MAJOR, major),
        STRAIN_MERIDIONAL.filled(extent, meridional),
        STRAIN_HOOP.filled(extent, hoop),
        plain(["limit_major", "Major strain of the limit"], limit),
        plain(["margin", "Margin in major strain"], margin),
        plain(["crookedness", "Distance of the path from a straight line, over its length"], crookedness),
    ]))
}

/// Iterations of the corrector, of rejected steps too: one row each.
pub fn iteration_table<'a>(iterations: impl Iterator<Item = &'a IterationRecord> + Clone) -> Table {
    Table::new(ITERATION.iter().map(|field| field.column(Extent::Ring, iterations.clone())).collect())
}

/// Iterations of one step with several matrices as CSV, with the method, the start and the matrix of each row.
pub fn step_iterations(histories: &[IterationHistory]) -> Vec<u8> {
    let rows = || histories.iter().flat_map(|history| history.rows.iter().map(move |row| (history.matrix, row)));
    let texts = [
        ("method", rows().map(|(method, _)| method.key().to_owned()).collect()),
        ("start", rows().map(|(_, row)| row.start.key().to_owned()).collect()),
        ("matrix", rows().map(|(_, row)| row.matrix.key().to_owned()).collect()),
    ];
    csv_with_texts(&iteration_table(rows().map(|(_, row)| row)), &texts)
}
