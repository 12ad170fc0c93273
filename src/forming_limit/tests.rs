use super::*;
use crate::material::Anisotropy;
use crate::material::hardening::{Hardening, Hollomon};
use approx::assert_relative_eq;

fn power(n: f64, r: f64) -> Material {
    let law = Hollomon::with_offset(500.0, n, 1e-6).expect("valid");
    Material { anisotropy: Anisotropy::new(r), ..Material::plain(Hardening::Hollomon(law)) }
}

#[test]
fn scratch() {
    for (n, r, f) in [
        (0.2, 1.0, 0.995),
        (0.2, 1.0, 0.999),
        (0.2, 1.0, 0.98),
        (0.2, 1.8, 0.995),
        (0.2, 0.6, 0.995),
        (0.36, 0.36, 0.995),
    ] {
        let m = power(n, r);
        let sheet = Sheet { material: &m, thickness: 1.0, temperature: 293.0 };
        let start = std::time::Instant::now();
        for beta in [-0.4, -0.2, 0.0, 0.2, 0.5, 0.8, 1.0] {
            let mk = MarciniakKuczynski { imperfection: f, strain_rate: 1.0 };
            println!("{n} {r} {f} {beta} {:?}", mk.limit(&sheet, beta));
        }
        println!("{:?}", start.elapsed());
    }
}
