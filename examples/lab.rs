use stampflow::material::hardening::*;
use stampflow::{geometry::*, material::*, model::*, solver};
fn tool(role: Role, profile: Profile, mu: f64, motion: Motion) -> Tool {
    Tool { role, profile, friction: mu, motion }
}
pub fn model(name: &str) -> Model {
    let base = |length, thickness, elements, edge, hardening, travel: f64| Model {
        title: name.into(),
        notes: vec![],
        geometry: Geometry::Axisymmetric,
        blank: Blank { length, thickness, elements, grading: Grading::Radii, theory: Theory::Bending, layers: 5, edge },
        material: Material { hardening, elastic: None },
        tools: vec![],
        travel,
        speed: 1.0,
        frames: (1..=8).map(|i| travel * i as f64 / 8.0).collect(),
        settings: Settings::default(),
    };
    match name {
        "osu" | "osu_friction" | "thin" => {
            let t = if name == "thin" { 0.85 } else { 1.0 };
            let mu = match name {
                "osu" => 0.0,
                "thin" => 0.17,
                _ => 0.15,
            };
            let mut m =
                base(59.18, t, 60, Edge::Clamped, Hardening::Swift(Swift::new(589.0, 0.216, 1e-4).unwrap()), 34.0);
            m.tools = vec![
                tool(Role::Punch, Profile::hemispherical_punch(50.8, t), mu, Motion::Travel),
                tool(Role::Die, Profile::die(52.83, 6.35, t), mu, Motion::Fixed),
            ];
            m
        }
        "woo" => {
            let t = 0.889;
            let mut m = base(56.388, t, 50, Edge::Free, Hardening::examples().remove(0).1, 45.0);
            m.tools = vec![
                tool(Role::Punch, Profile::hemispherical_punch(25.4, t), 0.04, Motion::Travel),
                tool(Role::Die, Profile::die(27.0, 6.35, t), 0.04, Motion::Fixed),
                tool(Role::Holder, Profile::holder(33.35, t), 0.04, Motion::Force(5000.0)),
            ];
            m
        }
        "chalmers" => {
            let t = 1.0;
            let mut m = base(100.0, t, 163, Edge::Free, Hardening::Swift(Swift::new(547.0, 0.18, 1e-3).unwrap()), 50.0);
            m.tools = vec![
                tool(Role::Punch, Profile::flat_punch(50.0, 9.0, t), 0.05, Motion::Travel),
                tool(Role::Die, Profile::die(51.25, 7.0, t), 0.05, Motion::Fixed),
                tool(Role::Holder, Profile::holder(58.25, t), 0.05, Motion::Force(80000.0)),
            ];
            m
        }
        "strip" => {
            let t = 0.8;
            let mut m = base(
                420.0,
                t,
                200,
                Edge::Free,
                Hardening::Swift(Swift::new(750.0 * (3f64.sqrt() / 2.0).powf(1.23), 0.23, 1e-4).unwrap()),
                70.0,
            );
            m.geometry = Geometry::PlaneStrain;
            m.blank.theory = Theory::Membrane;
            m.blank.layers = 1;
            m.tools = vec![
                tool(Role::Punch, Profile::crowned_punch(330.0, 2800.0, 10.0, t), 0.1, Motion::Travel),
                tool(Role::Die, Profile::die(331.0, 10.0, t), 0.1, Motion::Fixed),
                tool(Role::Holder, Profile::holder(341.0, t), 0.1, Motion::Force(1300.0)),
            ];
            m
        }
        _ => panic!(),
    }
}
struct Trace(bool);
impl solver::Observer for Trace {
    fn iteration(&mut self, r: &stampflow::record::IterationRecord) {
        if self.0 {
            println!(
                "   it {} {:.4} v {:.1e} r {:.1e} cut {:.2} c {}",
                r.iteration, r.travel, r.velocity_norm, r.residual_norm, r.cut, r.active_contacts
            )
        }
    }
}
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let mut m = model(&args[1]);
    let mut verbose = false;
    let mut csv = false;
    for a in &args[2..] {
        let (k, v) = a.split_once('=').unwrap_or((a, ""));
        let f = || v.parse::<f64>().unwrap();
        match k {
            "n" => m.blank.elements = f() as usize,
            "step" => m.settings.max_step = f(),
            "trace" => verbose = true,
            "csv" => csv = true,
            "layers" => m.blank.layers = f() as usize,
            "facets" => m.settings.facets = Some(f() as usize),
            "newton" => m.settings.iteration = Iteration::Newton,
            "secant" => m.settings.iteration = Iteration::Secant,
            "raw" => m.settings.round_facets = false,
            "uniform" => m.blank.grading = Grading::Uniform,
            "tol" => m.settings.tolerance = f(),
            "cut" => m.settings.cutoff_strain = f(),
            "k" => m.settings.contact_stiffness = f(),
            "delta" => m.settings.contact_smoothing = f(),
            "slip" => m.settings.slip_speed = f(),
            "travel" => {
                m.travel = f();
                m.frames = (1..=8).map(|i| m.travel * i as f64 / 8.0).collect()
            }
            "membrane" => {
                m.blank.theory = Theory::Membrane;
                m.blank.layers = 1
            }
            "mu" => {
                for t in &mut m.tools {
                    t.friction = f()
                }
            }
            "hold" => {
                for t in &mut m.tools {
                    if let Motion::Force(x) = &mut t.motion {
                        *x = f()
                    }
                }
            }
            _ => panic!("{a}"),
        }
    }
    let start = std::time::Instant::now();
    let run = solver::run(&m, &mut Trace(verbose));
    let wall = start.elapsed();
    if csv {
        for r in &run.history {
            println!(
                "{:.4},{:.2},{:.1},{},{:.2e},{:.2e},{:.2e}",
                r.travel,
                r.punch_force,
                r.holder_force,
                r.iterations,
                r.residual_norm,
                r.penetration,
                r.work.imbalance()
            )
        }
    }
    let Some(last) = run.history.last() else {
        println!("nothing: {}", run.stop);
        return;
    };
    let peak = run.history.iter().max_by(|a, b| a.punch_force.total_cmp(&b.punch_force)).unwrap();
    println!(
        "{}: {} steps, {} it, {} rej, {:?} | peak {:.1} at {:.3} | thin {:.5} at {:.2}, draw-in {:.3} | imb {:.2e} cut {:.2e} | pen {:.2e} | {}",
        args[1],
        run.history.len(),
        run.history.iter().map(|r| r.iterations).sum::<usize>(),
        run.history.iter().map(|r| r.rejected).sum::<usize>(),
        wall,
        peak.punch_force,
        peak.travel,
        last.thinnest,
        last.thinnest_s0,
        last.draw_in,
        last.work.imbalance(),
        last.work.cutoff / last.work.plastic,
        run.history.iter().map(|r| r.penetration).fold(0.0, f64::max),
        run.stop
    );
    if args[1].starts_with("osu") {
        for f in [3e3, 6e3, 1e4, 2e4, 3e4, 4e4, 5e4, 6e4] {
            if let Some(w) = run.history.windows(2).find(|w| w[1].punch_force >= f) {
                let x = w[0].travel
                    + (f - w[0].punch_force) / (w[1].punch_force - w[0].punch_force) * (w[1].travel - w[0].travel);
                print!("{:.0}kN {:.2}  ", f / 1e3, x)
            }
        }
        println!()
    }
    for w in &run.warnings {
        println!("  ! {w}")
    }
}
