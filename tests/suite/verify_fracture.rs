//! Ductile fracture: damage against closed forms, from stage to stage, and its light.

use crate::common::prelude::*;
use stampflow::material::fracture::{CockcroftLatham, FractureStress, Oyane, RiceTracey};

const A: f64 = 0.424;
const GROWTH: f64 = 0.283;

/// The criteria with critical values of 1, in the order of the columns below.
fn criteria() -> [Fracture; 4] {
    let critical = 1.0;
    [
        Fracture::CockcroftLatham(CockcroftLatham { critical }),
        Fracture::Brozzo(Brozzo { critical }),
        Fracture::Oyane(Oyane { a: A, critical }),
        Fracture::RiceTracey(RiceTracey { critical }),
    ]
}

/// dD/dε̄ of an isotropic metal, by hand: σ_m/σ̄ is 1/3, 1/√3 and 2/3, σ₁/σ̄ is 1, 2/√3 and 1.
fn by_hand(path: &str) -> [f64; 4] {
    let root = 3f64.sqrt();
    match path {
        "tension" => [1.0, 1.0, 1.0 + 1.0 / (3.0 * A), GROWTH * 0.5f64.exp()],
        "plane strain" => [2.0 / root, 4.0 / 3.0, 1.0 + 1.0 / (root * A), GROWTH * (0.5 * root).exp()],
        "equi-biaxial" => [1.0, 2.0, 1.0 + 2.0 / (3.0 * A), GROWTH * 1f64.exp()],
        "compression" => [0.0, 0.0, 1.0 - 1.0 / (3.0 * A), GROWTH * (-0.5f64).exp()],
        // 1 − 2/(3 a) is negative: damage does not heal.
        "biaxial compression" => [0.0, 0.0, 0.0, GROWTH * (-1f64).exp()],
        "tension under half its stress as pressure" => {
            [0.5, 2.0 / 3.0 * 0.5 / (2.0 / 3.0), 1.0 - 1.0 / (6.0 * A), GROWTH * (-0.25f64).exp()]
        }
        path => panic!("{path}"),
    }
}

/// Trust: by hand.
#[test]
fn criteria_have_their_closed_forms_at_a_point() {
    for (path, s, normal) in [
        ("tension", [300.0, 0.0], 0.0),
        ("plane strain", [100.0, 200.0], 0.0),
        ("equi-biaxial", [250.0, 250.0], 0.0),
        ("compression", [0.0, -300.0], 0.0),
        ("biaxial compression", [-200.0, -200.0], 0.0),
        ("tension under half its stress as pressure", [0.0, 300.0], -150.0),
    ] {
        let stress = FractureStress::new(&YieldCriterion::default(), [s[0], s[1], 0.0], normal);
        for (criterion, exact) in criteria().iter().zip(by_hand(path)) {
            assert!((criterion.at(stress) - exact).abs() < 1e-12, "{criterion}, {path}: {}", criterion.at(stress));
        }
    }
    // Hill 1948: σ₁/σ̄ = (1 + r̄)/√(1 + 2 r̄) in plane strain, where σ₂ = r̄/(1 + r̄) σ₁.
    let r = 1.8;
    let stress = FractureStress::new(&Hill48::new(r).into(), [100.0, 100.0 * r / (1.0 + r), 0.0], 0.0);
    assert!((criteria()[0].at(stress) - (1.0 + r) / (1.0 + 2.0 * r).sqrt()).abs() < 1e-12);
}

/// Trust: homogeneous, so that D = f ε̄ with ε̄ = (2/√3) ln(l/l₀) in plane strain and 2 ln(r/r₀) of a disc; by the flow law to
/// round-off. An elastic strip comes from Poisson's σ₂ = 0.3 σ₁ to 0.5 σ₁ over a yield strain, a hundredth of its strain: of D
/// over the plastic strain that is a tenth of it.
#[test]
fn pulled_sheets_have_the_damage_of_their_path() {
    for (geometry, path, per_strain) in
        [(Geometry::PlaneStrain, "plane strain", 2.0 / 3f64.sqrt()), (Geometry::Axisymmetric, "equi-biaxial", 2.0)]
    {
        for (mode, theory) in
            [(Mode::Flow, Theory::Membrane), (Mode::Flow, Theory::Bending), (Mode::ElastoViscoplastic, Theory::Bending)]
        {
            for (criterion, rate) in criteria().into_iter().zip(by_hand(path)) {
                let mut model = simple::pulled(geometry, theory, 12.0);
                model.mode = mode;
                model.material.elastic = Some(Elastic { young: 206e3, poisson: 0.3 });
                model.material.fracture = Some(criterion);
                let run = solve(&model);
                let (strain, allowed) = match mode {
                    Mode::Flow => (per_strain * (52.0f64 / 40.0).ln(), 1e-10),
                    _ => (run.end.points[(3, 2)].strain, 1e-3),
                };
                let error = last(&run).damage / (rate * strain) - 1.0;
                assert!(error.abs() < allowed, "{criterion}, {path}, {mode:?}, {theory:?}: {error:e}");
            }
        }
    }
}

/// Trust: pure bending over the nose: the faces strain by ±t/2ρ, ρ the nose and half the thickness, so that ε̄ = (2/√3) t/2ρ, of which
/// ln(1 + t/2ρ) is short by t/4ρ, 2 %. The elastic strain takes 4 % off, the strip is bent 2 % more than the nose is round.
#[test]
fn a_bent_strip_is_damaged_on_its_outer_face() {
    let compressed = [0.0, 0.0, 0.0, GROWTH * (-0.5 * 3f64.sqrt()).exp()];
    let case = made("v-bend", &[("nose", "12 mm"), ("thickness", "1 mm")], &["material.yield_condition=hill48"]);
    for (i, criterion) in criteria().into_iter().enumerate() {
        let run = solve(&with(case.model().clone(), criterion));
        let faces = run.end.face_damage.iter().copied().max_by(|a, b| a[0].total_cmp(&b[0])).expect("elements");
        let strain = 2.0 / 3f64.sqrt() * 0.5 / 12.5;
        for (found, exact) in faces.into_iter().zip([by_hand("plane strain")[i], compressed[i]]) {
            assert!((found / strain - exact).abs() <= 0.03 * exact, "{criterion}: {} {exact}", found / strain);
        }
    }
}

/// Trust: each face is stretched by t/2ρ once, on the nose's or shoulder's outside or as the other is straightened: D = (4/3) t/2ρ
/// by Cockcroft and Latham. The wall's force stretches the strip a little and bends it sharper, with its elastic part 5 to 10 %.
#[test]
fn straightening_damages_the_other_face() {
    let run = solve(&with(shipped("hat_springback", &[]), criteria()[0]));
    let exact = 4.0 / 3.0 * 0.5 * 0.78 / (5.0 + 0.39);
    let wall = (0..run.end.face_damage.len()).filter(|&e| (45.0..78.0).contains(&run.end.middle(e)));
    for faces in wall.map(|e| run.end.face_damage[e]) {
        assert!(faces.iter().all(|damage| (1.0..1.12).contains(&(damage / exact))), "{faces:?} {exact}");
        assert!((faces[0] / faces[1] - 1.0).abs() < 0.05, "{faces:?}");
    }
}

fn with(mut model: Model, criterion: Fracture) -> Model {
    model.material.fracture = Some(criterion);
    model
}

/// Trust: the same run with an eighth of the step. The end of the step stands for all of it: first order.
#[test]
fn damage_does_not_hang_on_the_step() {
    for (name, divisors) in [("quickstart", &[1.0, 2.0, 4.0, 8.0][..]), ("hat_springback", &[1.0, 8.0])] {
        let damage = divisors.iter().map(|by| {
            let set = [format!("solver.max_step={}", 0.01 / by), format!("solver.first_step={}", 0.002 / by)];
            last(&solve(&with(shipped(name, &set.each_ref().map(String::as_str)), criteria()[1]))).damage
        });
        let damage: Vec<f64> = damage.collect();
        let orders = orders_of_changes(&damage);
        assert!((damage[0] / damage[divisors.len() - 1] - 1.0).abs() < 5e-3, "{name}: {damage:?}");
        assert!(name != "quickstart" || orders.iter().all(|order| *order > 0.8), "{orders:?}");
    }
}

/// Trust: nothing is computed between two stages; annealing takes strain and stress and closes no void.
#[test]
fn damage_goes_from_stage_to_stage() {
    let draw = with(shipped("quickstart", &["tools.punch.travel=8 mm"]), criteria()[1]);
    let run = solve(&draw);
    for anneal in [false, true] {
        let begin = Beginning { anneal, ..Beginning::default() };
        let next = enter(&Stage { name: "next".into(), model: draw.clone(), begin }, &draw, run.end.clone());
        let damage = |state: &State| state.points.iter().map(|point| point.damage).collect::<Vec<_>>();
        assert!(damage(&next).iter().any(|damage| *damage > 0.01));
        assert_eq!((damage(&next), next.face_damage), (damage(&run.end), run.end.face_damage.clone()));
    }
}

#[test]
fn fracture_has_its_light() {
    for (critical, light, failures, parts) in [
        ("0.35", Light::Green, &[][..], &["uses 8", "on the punch's face"][..]),
        ("0.3", Light::Amber, &[], &["uses 9", "die radius"]),
        ("0.25", Light::Red, &[FailureMode::Tears], &["uses 11", "reached at 13"]),
    ] {
        let set = format!("material.fracture={{brozzo={{critical={critical}}}}}");
        let case = shipped_case("quickstart", &[&set, "material.fracture_source=a notched test"]);
        let solution = case.solve(&mut ());
        let (stages, all) = (&solution.stages, findings(&solution));
        let (found, answer) = (row(&all, "fracture"), Answer::of(&solution.case, stages, &all));
        assert_eq!((found.light, &answer.failures[..], &*found.source), (light, failures, "a notched test"));
        assert!(parts.iter().all(|part| found.statement().contains(part)), "{}", found.statement());
        let picture = OUTPUTS.iter().find(|output| output.file == "damage.png").expect("an output");
        let profile = tables::profile(&stages[0].model, &stages[0].frames);
        let largest = profile.column("damage").values.iter().fold(0.0, |a: f64, b| a.max(*b));
        assert!(!picture.files(&solution.views()[0]).is_empty() && largest == last(&stages[0]).damage);
        assert_eq!(answer.sentence.starts_with("it breaks "), light == Light::Red, "{}", answer.sentence);
    }
    let whole = shipped_case("quickstart", &["tools.punch.travel=3 mm"]).solve(&mut ());
    assert!(findings(&whole).iter().all(|finding| finding.key != "fracture"));
}

/// Trust: a dome whose place, instant and word are those of the first event, fracture or forming limit.
#[test]
fn the_first_tear_has_the_sentence() {
    for (critical, verb) in [("0.2", "it breaks"), ("3", "it tears")] {
        let set = format!("material.fracture={{brozzo={{critical={critical}}}}}");
        let solution = shipped_case("osu_stretch", &[&set]).solve(&mut ());
        let stage = &solution.stages[0];
        let answer = Answer::of(&solution.case, &solution.stages, &findings(&solution));
        let first = stage.steps.iter().find(|step| step.damage >= 1.0);
        assert!(answer.sentence.starts_with(verb) && answer.sentence.contains("mm of travel"), "{}", answer.sentence);
        assert_eq!(first.is_some_and(|step| assess::tears_at(stage) == Some(step.damage_s0)), verb == "it breaks");
    }
}
