//! The cup of the quick start without a case file; lengths in mm, forces in N, stresses in MPa.

use stampflow::geometry::Profile;
use stampflow::material::{Hardening, Material, hardening::Swift};
use stampflow::model::{Blank, Model, Motion, Press, Role, Tool};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let t = 1.0;
    let steel = Material::plain(Hardening::Swift(Swift::new(520.0, 0.22, 0.005)?));
    let tool = |role, profile, motion| Tool { role, profile, friction: 0.08.into(), motion };
    let tools = vec![
        tool(Role::Punch, Profile::flat_punch(30.0, 6.0, t), Motion::Travel),
        tool(Role::Die, Profile::die(31.25, 6.0, t), Motion::Fixed),
        tool(Role::Holder, Profile::holder(32.0, t), Motion::Pressed(Press::constant(10_000.0))),
    ];
    let model = Model::new(Blank::new(55.0, t), steel, tools, 25.0);
    model.check()?;
    let solution = stampflow::run(&model, &mut ());
    let force = solution.steps.iter().map(|step| step.punch_force).fold(0.0, f64::max);
    println!("{}, {:.1} kN at most", solution.stop, 1e-3 * force);
    Ok(())
}
