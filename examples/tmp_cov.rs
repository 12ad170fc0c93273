use stampflow::study::scatter::*;
use std::f64::consts::PI;
fn values(sampling: &Sampling, f: impl Fn(&[f64]) -> f64) -> Vec<f64> {
    (0..sampling.rows()).map(|row| f(&sampling.unit(row))).collect()
}
fn ishigami(u: &[f64]) -> f64 {
    let [x, y, z] = [u[0], u[1], u[2]].map(|u| PI * (2.0 * u - 1.0));
    x.sin() + 7.0 * y.sin().powi(2) + 0.1 * z.powi(4) * x.sin()
}
fn tries(sampling: &Sampling, is_hit: impl Fn(&[f64]) -> bool) -> [Tries; REPLICATES] {
    let mut tries = [(0, 0); REPLICATES];
    for row in 0..sampling.rows() {
        let own = &mut tries[sampling.place(row).replicate];
        *own = (own.0 + u64::from(is_hit(&sampling.unit(row))), own.1 + 1);
    }
    tries
}
fn main() {
    let (a, b): (f64, f64) = (7.0, 0.1);
    let (v1, v2, v13) = (0.5 * (1.0 + b * PI.powi(4) / 5.0).powi(2), a * a / 8.0, 8.0 * b * b * PI.powi(8) / 225.0);
    let all = v1 + v2 + v13;
    let first = [v1 / all, v2 / all, 0.0];
    let total = [(v1 + v13) / all, v2 / all, v13 / all];
    for n in [1024, 2048, 4096] {
        let (mut held, mut intervals, mut worst) = (0, 0, 0.0f64);
        for seed in 0..40 {
            let sampling = Sampling::new(seed, n, vec![0, 1, 2], true);
            let found = indices(&sampling, &values(&sampling, ishigami)).expect("it varies");
            for (g, index) in found.iter().enumerate() {
                for (e, truth) in [(index.first, first[g]), (index.total, total[g])] {
                    worst = worst.max((e.value - truth).abs());
                    held += usize::from((e.low..=e.high).contains(&truth));
                    intervals += 1;
                }
            }
        }
        println!("ishigami {n}: worst {worst:.4}, held {held} of {intervals}");
    }
    type Event = (&'static str, f64, fn(&[f64]) -> bool);
    let events: [Event; 10] = [
        ("u<.032", 0.032, |u| u[0] < 0.032),
        ("u<.3", 0.3, |u| u[0] < 0.3),
        ("u<.002", 0.002, |u| u[0] < 0.002),
        ("circle", PI / 4.0, |u| u[0] * u[0] + u[1] * u[1] < 1.0),
        ("corner", 0.03125, |u| u[0] + u[1] < 0.25),
        ("corner small", 0.005, |u| u[0] + u[1] < 0.1),
        ("sum4", 1.0 / 24.0, |u| u[..4].iter().sum::<f64>() < 1.0),
        ("sum4 small", 1.0 / 384.0, |u| u[..4].iter().sum::<f64>() < 0.5),
        ("product 4", 0.05, |u| u.iter().all(|u| *u < 0.05f64.powf(0.25))),
        ("bits", 0.5, |u| u.iter().map(|u| (64.0 * u) as u64).sum::<u64>() % 2 == 0),
    ];
    for (name, truth, is_hit) in events {
        for points in [256, 1024, 2000] {
            let (mut held, mut width, mut plain) = (0, 0.0, 0.0);
            for seed in 0..400 {
                let sampling = Sampling::new(seed, points, vec![0, 1, 2, 3], false);
                let found = probability(&tries(&sampling, is_hit)).expect("tries");
                held += usize::from((found.low..=found.high).contains(&truth));
                width += (found.high - found.low) / 400.0;
                plain += (truth * (1.0 - truth) / points as f64).sqrt() * 3.92 / 400.0;
            }
            println!("{name:12} n {points} held {} width {width:.5} independent {plain:.5}", held as f64 / 4.0);
        }
    }
}
