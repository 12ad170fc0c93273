//! Loads of a hat section against continuum solids.

use crate::common::prelude::*;

/// Trust: solids refined until they change by less than a percent; the moment of the contact pressure is left out.
#[test]
fn a_hat_s_load_is_that_of_solids_within_three_percent() {
    for (name, friction, holder, source, limit) in [
        ("without friction", "0.0", "gap = '0.78 mm'", "hat,solid_q8r_own,", 0.03),
        ("with friction 0.144", "0.144", "force = '70 N/mm'", "hat_mu_0.144,calculix_cpe8r_step_0.019_mm,", 0.021),
    ] {
        let text = r"
            title = 'hat'
            geometry = 'plane_strain'
            blank = { half_length = '70 mm', thickness = '0.78 mm', elements = 200, layers = 15 }
            material = { mode = 'elasto_viscoplastic', young = '206 GPa', poisson = 0.3, hardening = { swift = LAW } }
            [tools]
            punch = { flat = { half_width = '25 mm', nose = '5 mm' }, travel = '9.3 mm', friction = MU }
            die = { throat = '25.9984 mm', shoulder = '5 mm', friction = MU }
            holder = { inner_half_width = '30.9984 mm', HOLDER, friction = MU }";
        let text = text.replace("LAW", "{ k = '565.32 MPa', offset = 0.007117, n = 0.2589 }");
        let run = solver::run(parsed(&text.replace("MU", friction).replace("HOLDER", holder), &[]).model(), &mut ());
        let rows = include_str!("../../reference_data/strip_over_cylinder.csv").lines();
        let deviations: Vec<f64> = rows
            .filter_map(|line| {
                let cells: Vec<f64> = line.strip_prefix(source)?.split(',').map(|x| x.parse().unwrap_or(0.0)).collect();
                let near = run.steps.iter().filter(|r| (r.travel - cells[3]).abs() <= 0.3);
                let forces: Vec<f64> = near.map(|r| 0.5 * r.punch_force).collect();
                Some(forces.iter().sum::<f64>() / forces.len() as f64 / cells[4] - 1.0)
            })
            .collect();
        assert!(deviations.len() >= 7 && deviations.iter().all(|d| d.abs() < limit), "{name}: {deviations:?}");
        let mean = deviations.iter().sum::<f64>() / deviations.len() as f64;
        let worst = deviations.into_iter().fold(0.0, |worst: f64, d| if d.abs() > worst.abs() { d } else { worst });
        let row = format!("| hat {name}, ρ/t 6.4: mean and worst of the travel | {{}}, {{}} % |");
        told("docs/contact_on_faces.md", &row, &signed(&[mean, worst], 1));
    }
}
