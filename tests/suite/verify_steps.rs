//! Verification of the steps in time: what is read off a run does not hang on their length.

use crate::common::prelude::*;

fn divided(by: f64) -> [String; 2] {
    [format!("solver.max_step={}", 0.01 / by), format!("solver.first_step={}", 0.002 / by)]
}

/// Trust: the same run with a fourth of the step, which is within a fifteenth of the error of second-order steps. 0.3 % is
/// what no press and no gauge tells apart; a porous sheet just before it tears multiplies every error by ten.
#[test]
fn thickness_force_and_pressure_do_not_hang_on_the_step() {
    let cases = "brite_cylindrical bulge chalmers_cup hydroform osu_stretch quickstart strip_draw superplastic_box \
                 superplastic_dome warm_cup woo_hemispherical woo_porous";
    for name in cases.split(' ') {
        let allowed = if name == "woo_porous" { 1e-2 } else { 3e-3 };
        let figures = |set: &[&str]| {
            let model = shipped(name, set);
            let run = solver::run(&model, &mut ());
            let end = last(&run);
            let thinnest = end.thinnest / model.blank.thickness;
            [thinnest, peak(&run), end.time, end.pressure, end.pole_height, model.blank.length - end.draw_in]
        };
        let (usual, fine) = (figures(&[]), figures(&divided(4.0).each_ref().map(String::as_str)));
        let errors = [0, 1, 2, 3, 4, 5].map(|i| {
            let scale = if i == 0 { 1.0 } else { fine[i].abs().max(1e-9) };
            (usual[i] - fine[i]) / scale
        });
        let worst = errors.iter().fold(0.0_f64, |worst, error| worst.max(error.abs()));
        assert!(worst < allowed, "{name}: {errors:?}");
    }
}

/// Trust: the second-order backward difference; the first steps, from a flat sheet whose rates are infinite, and the
/// elements that are not steady take a little of the order away. With 30 elements, none of them has a neighbourhood but itself:
/// what holds a place back by the last rates of its neighbours is of first order, and next to nothing. The foot of the contact
/// is long, so that the instant at which a node comes to lie on the die counts for little.
#[test]
fn a_bulge_is_of_second_order_in_the_step() {
    let height = |by: f64| {
        let set = divided(by);
        let coarse = ["blank.theory=membrane", "blank.elements=30", "solver.contact_smoothing=0.003"];
        let set: Vec<&str> = set.iter().map(String::as_str).chain(coarse).collect();
        last(&solver::run(&shipped("bulge", &set), &mut ())).pole_height
    };
    let orders = orders_of_changes(&[1.0, 2.0, 4.0, 8.0].map(height));
    assert!(orders.iter().all(|p| *p > 1.5), "{orders:?}");
}
