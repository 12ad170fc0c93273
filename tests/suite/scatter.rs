//! `scatter`: samples, what is estimated from them and how sure that is, and the verb.

use std::f64::consts::PI;
use stampflow::study::scatter::{REPLICATES, Sampling, Tries, indices, probability};

/// Values of a function at every row of a sample.
fn values(sampling: &Sampling, f: impl Fn(&[f64]) -> f64) -> Vec<f64> {
    (0..sampling.rows()).map(|row| f(&sampling.unit(row))).collect()
}

/// Ishigami's function with a = 7 and b = 0.1, of coordinates from 0 to 1.
fn ishigami(u: &[f64]) -> f64 {
    let [x, y, z] = [u[0], u[1], u[2]].map(|u| PI * (2.0 * u - 1.0));
    x.sin() + 7.0 * y.sin().powi(2) + 0.1 * z.powi(4) * x.sin()
}

/// Trust: the closed form of T. Ishigami, T. Homma (1990): V₁ = ½ (1 + b π⁴/5)², V₂ = a²/8, V₁₃ = 8 b² π⁸/225; what is asked
/// for is 0.02, and each interval must hold the truth in about 95 of 100 studies: fewer than 85 of the 6 × 40 here together
/// would be a mistake, more than 99.5 intervals that say nothing.
#[test]
fn the_indices_of_ishigamis_function_are_its_closed_form() {
    let (a, b): (f64, f64) = (7.0, 0.1);
    let (v1, v2, v13) =
        (0.5 * (1.0 + b * PI.powi(4) / 5.0).powi(2), a * a / 8.0, 8.0 * b * b * PI.powi(8) / 225.0);
    let all = v1 + v2 + v13;
    let first = [v1 / all, v2 / all, 0.0];
    let total = [(v1 + v13) / all, v2 / all, v13 / all];
    let (mut held, mut intervals, mut worst) = (0, 0, 0.0f64);
    for seed in 0..40 {
        let sampling = Sampling::new(seed, 4096, vec![0, 1, 2], true);
        let found = indices(&sampling, &values(&sampling, ishigami)).expect("it varies");
        for (group, index) in found.iter().enumerate() {
            for (estimate, truth) in [(index.first, first[group]), (index.total, total[group])] {
                worst = worst.max((estimate.value - truth).abs());
                held += usize::from((estimate.low..=estimate.high).contains(&truth));
                intervals += 1;
            }
        }
    }
    println!("ishigami: worst {worst:.4}, held {held} of {intervals}");
    assert!(worst < 0.02, "{worst}");
    let share = held as f64 / intervals as f64;
    assert!((0.85..0.995).contains(&share), "{share}");
}

/// Hits of an event by scramblings.
fn tries(sampling: &Sampling, is_hit: impl Fn(&[f64]) -> bool) -> [Tries; REPLICATES] {
    let mut tries = [(0, 0); REPLICATES];
    for row in 0..sampling.rows() {
        let own = &mut tries[sampling.place(row).replicate];
        *own = (own.0 + u64::from(is_hit(&sampling.unit(row))), own.1 + 1);
    }
    tries
}

#[test]
fn intervals_of_a_probability_hold_it_in_95_of_100_studies() {
    type Event = (&'static str, f64, fn(&[f64]) -> bool);
    let events: [Event; 9] = [
        ("u<.032", 0.032, |u| u[0] < 0.032),
        ("u<.3", 0.3, |u| u[0] < 0.3),
        ("u<.002", 0.002, |u| u[0] < 0.002),
        ("circle", PI / 4.0, |u| u[0] * u[0] + u[1] * u[1] < 1.0),
        ("corner", 0.03125, |u| u[0] + u[1] < 0.25),
        ("sum4", 1.0 / 24.0, |u| u[..4].iter().sum::<f64>() < 1.0),
        ("sum4 small", 1.0 / 384.0, |u| u[..4].iter().sum::<f64>() < 0.5),
        ("product 4", 0.05, |u| u.iter().all(|u| *u < 0.05f64.powf(0.25))),
        ("bits", 0.5, |u| u.iter().map(|u| (64.0 * u) as u64).sum::<u64>() % 2 == 0),
    ];
    for (name, truth, is_hit) in events {
        for points in [256, 1000, 2000] {
            let (mut held, mut width, mut never) = (0, 0.0, 0.0);
            for seed in 0..200 {
                let sampling = Sampling::new(seed, points, vec![0, 1, 2, 3], false);
                let found = probability(&tries(&sampling, is_hit)).expect("tries");
                held += usize::from((found.low..=found.high).contains(&truth));
                width += (found.high - found.low) / 200.0;
                never += (truth * (1.0 - truth) / points as f64).sqrt() * 3.92 / 200.0;
            }
            println!("{name:12} n {points} held {} width {width:.5} binomial {never:.5}", held as f64 / 2.0);
        }
    }
}
