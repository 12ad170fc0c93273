//! Drive of a press against closed forms; a punch that moves with it is in `verify_motion.rs`.

use crate::common::prelude::*;
use stampflow::press::{Drive, Linkage, Pace};

/// Trust: closed forms. The lever arm against the difference quotient of the height, 1e-6 rad apart: rounding of 1e-9 mm; the angle
/// of a height is where it came from; the torque's work over the stroke from the nominal height is that of the permitted force.
#[test]
fn speed_torque_and_work_of_a_crank_are_those_of_the_closed_forms() {
    for ratio in [0.0, 0.1, 0.25, 0.9] {
        let linkage = Linkage::Crank { radius: 100.0, ratio };
        assert!((linkage.height(PI) - linkage.stroke()).abs() < 1e-9 && linkage.height(0.0) == 0.0);
        for angle in (1..=30).map(|i| 0.1 * f64::from(i)) {
            let slope = (linkage.height(angle + 1e-6) - linkage.height(angle - 1e-6)) / 2e-6;
            assert!((slope - linkage.lever(angle)).abs() < 1e-6, "{ratio} {angle}: {slope}");
            assert!((linkage.angle(linkage.height(angle)) - angle).abs() < 1e-8, "{ratio} {angle}");
        }
        // F_N = 1: above the nominal height, F dh is the work of the nominal torque over the angle.
        let drive = Drive { linkage, pace: Some(Pace::Strokes(30.0)), nominal_height: 6.0 };
        let [top, end] = [60.0, 6.0].map(|height| drive.linkage.angle(height));
        let (n, torque) = (20_000, drive.linkage.lever(end));
        let heights = (0..n).map(|i| 6.0 + 54.0 * (f64::from(i) + 0.5) / f64::from(n));
        let work: f64 = heights.map(|height| drive.permitted(height) * 54.0 / f64::from(n)).sum();
        assert!((work / (torque * (top - end)) - 1.0).abs() < 1e-6, "{ratio}: {work}");
        assert!(drive.permitted(3.0) == 1.0 && drive.permitted(0.0) == 1.0);
        let &(time, travel) = drive.schedule(60.0).expect("a crank that turns").points().last().expect("points");
        assert!((time - top / PI).abs() < 1e-12 && travel == 60.0, "{time} {travel}");
    }
    // sin φ of a crank without a rod: half the nominal lever arm, twice the force.
    let crank = Linkage::Crank { radius: 100.0, ratio: 0.0 };
    let drive = Drive { nominal_height: crank.height(PI / 6.0), linkage: crank, pace: None };
    assert!((drive.permitted(100.0) - 0.5).abs() < 1e-12 && (drive.degrees(100.0) - 90.0).abs() < 1e-9);
    assert_eq!(drive.schedule(50.0), None);
}

/// Trust: by hand. A table's lever arm is the slope of its line, and a servo's punch moves as its heights fall.
#[test]
fn link_drives_and_servo_presses_follow_their_points() {
    let curve = |points: &[(f64, f64)]| PiecewiseLinear::new(points.to_vec()).expect("rising");
    let linkage = Linkage::Link(curve(&[(0.0, 0.0), (0.5, 5.0), (1.0, 25.0), (3.0, 125.0)]));
    let pace = Some(Pace::Servo(curve(&[(0.0, 0.0), (2.0, 10.0), (3.0, 50.0)])));
    let drive = Drive { linkage, pace, nominal_height: 5.0 };
    assert!((drive.permitted(15.0) - 0.25).abs() < 1e-12 && drive.linkage.stroke() == 125.0);
    let schedule = drive.schedule(30.0).expect("a motion");
    assert!((schedule.at(0.5) - 20.0).abs() < 1e-9 && (schedule.points()[60].0 - 2.5).abs() < 1e-12);
    assert_eq!(drive.reach(), 50.0);
}
