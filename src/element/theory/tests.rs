//! Element of the equations of `docs/theory.md`.

use super::kinematics::{EPS_S, EPS_T, GAMMA, Generalised, KAPPA_S, KAPPA_T, Reference};
use super::{Geometry, Node, Theory, section::Section, surface::stations};
use crate::equations::{Matrix, Random, Symbols, column};
use crate::geometry::{Point, turned};
use crate::material::PointLaw;
use crate::material::flow::{PointSnapshot, StressUpdate, Tangent, Triple, tests::matrix};
use crate::numerics::quadrature::midpoint;
use std::{array::from_fn, f64::consts::PI};

/// Law that records the strains of thickness points and answers with given numbers.
struct Recorder;

impl PointLaw for Recorder {
    type PointState = (StressUpdate, Tangent);
    type Iterate = [f64; 5];

    fn respond(&self, given: &Self::PointState, e: &mut [f64; 5], [s, t, g]: Triple, k: [f64; 2]) -> Self::PointState {
        *e = [s, t, k[0], k[1], g];
        *given
    }

    fn snapshot(&self, _: &Self::PointState, _: &[f64; 5], _: &StressUpdate) -> PointSnapshot {
        unreachable!("no iteration is traced")
    }
}

pub fn stress(update: &StressUpdate) -> Matrix {
    let StressUpdate { stress: [s, t, shear], moment, .. } = update;
    column(&[*s, *t, moment[0], moment[1], *shear])
}

pub fn tangent(tangent: &Tangent) -> Matrix {
    Matrix::from_column_slice(5, 5, matrix(tangent).as_slice())
}

fn nodes(u: Random) -> [Node; 2] {
    let a = [u(20.0, 30.0), u(-2.0, 2.0), u(-0.3, 0.3)];
    [a, [a[0] + u(0.8, 1.5), a[1] + u(-1.0, 1.0), a[2] + u(-0.2, 0.2)]]
}

/// An element that moves, with five thickness parts.
pub fn element(u: Random) -> Symbols {
    let [a, b] = nodes(u);
    let [da, db] = [0; 2].map(|_| [0; 3].map(|_| u(-0.1, 0.1)));
    let [p, q]: [Node; 2] = [from_fn(|d| a[d] + da[d]), from_fn(|d| b[d] + db[d])];
    let reference = Reference::new(Geometry::Axisymmetric, Theory::Bending, a, b);
    let current = reference.moved(da, db).expect("sound");
    let (rule, thickness) = (midpoint(5), u(0.5, 2.0));
    let volume = reference.area() * thickness;
    let points = [0; 5].map(|_| {
        let [stress, moment] = [[0; 3].map(|_| u(-9.0, 9.0)), [0; 3].map(|_| u(-9.0, 9.0))];
        let (own, coupling) = ([0; 6].map(|_| u(1.0, 9.0)), [0; 3].map(|_| u(1.0, 9.0)));
        let outer = [0; 2].map(|_| [0; 5].map(|_| u(1.0, 3.0)));
        let update = StressUpdate { stress, moment: [moment[0], moment[1]], ..StressUpdate::default() };
        (update, Tangent { own, coupling, across: u(0.1, 0.5), outer })
    });
    let section = Section { law: &Recorder, rule: &rule, slack_tension: 0.0, last_move: 0.0, forces_alone: false };
    let (mut parts, mut updates) = ([[0.0; 5]; 5], [StressUpdate::default(); 5]);
    let (force, matrix) = section.internal(&current, volume, thickness, &points, &mut parts, &mut updates);
    let slope = |a: Node, b: Node| (b[1] - a[1]).atan2(b[0] - a[0]);
    let [before, after] = [(a, b), (p, q)].map(|(a, b)| [(b[1] - a[1]).hypot(b[0] - a[0]), 0.5 * (a[0] + b[0])]);
    let mut known = Symbols::default();
    known.numbers(r"\pi, k, t_b, V", [PI, 5.0, thickness, volume]);
    known.numbers(r"l_b, r_b, l, r", [before[0], before[1], after[0], after[1]]);
    known.numbers(r"\varphi, \Delta\varphi", [slope(p, q), slope(p, q) - slope(a, b)]);
    let turned = [a[2] + b[2], p[2] + q[2], da[2] + db[2]].map(|sum| 0.5 * sum);
    known.numbers(r"\theta_{mb}, \theta_m, \Delta\theta_m", turned);
    known.numbers(r"\Delta\theta_1, \Delta\theta_2", [da[2], db[2]]);
    let strain = &current.strain;
    let membrane = [EPS_S, EPS_T, GAMMA].map(|i| strain[i]);
    known.numbers(r"\Delta\varepsilon_s, \Delta\varepsilon_\theta, \Delta\gamma", membrane);
    known.numbers(r"\Delta\kappa_s, \Delta\kappa_\theta", [strain[KAPPA_S], strain[KAPPA_T]]);
    known.column(r"\Delta\boldsymbol\varepsilon", strain.as_slice());
    // The resultants are what the forces say of them: B has full rank.
    let b = Matrix::from_column_slice(5, 6, current.strain_displacement().as_slice());
    let resultants = (&b * b.transpose()).try_inverse().expect("regular") * &b * column(force.as_slice());
    let own = Generalised::from_column_slice(resultants.as_slice());
    known.numbers("N_1, N_2, N_4, N_5", [own[0], own[1], own[3], own[4]]);
    known.set(r"\mathbf N", [resultants]);
    for (row, name) in [(0, r"\mathbf b_1"), (1, r"\mathbf b_2"), (4, r"\mathbf b_5")] {
        known.set(name, [b.rows(row, 1).transpose()]);
    }
    known.column(r"\mathbf b_m", &[0.0, 0.0, 0.5, 0.0, 0.0, 0.5]);
    known.set(r"\mathbf B", [b]);
    known.column(r"\mathbf F_I", force.as_slice());
    known.set(r"\mathbf K_\sigma", [Matrix::from_column_slice(6, 6, current.geometric_stiffness(&own).as_slice())]);
    known.set(r"\mathbf K", [Matrix::from_column_slice(6, 6, matrix.expect("asked for").as_slice())]);
    known.list("i", (1..=5).map(f64::from));
    known.set(r"\Delta\mathbf e_i", parts.map(|e| column(&e)));
    known.set(r"\boldsymbol\sigma_i", points.map(|(update, _)| stress(&update)));
    known.set(r"\mathbf C_i", points.map(|(_, own)| tangent(&own)));
    known
}

/// An element on which tools act.
pub fn surface(u: Random) -> Symbols {
    let [a, b] = nodes(u);
    let (along, thickness) = (Point::new(b[0] - a[0], b[1] - a[1]), u(0.5, 2.0));
    let mut known = Symbols::default();
    known.numbers(r"t_b, l, l_b, r_b", [thickness, along.norm(), along.norm(), 0.5 * (a[0] + b[0])]);
    known.numbers(r"\theta_1, \theta_2, \theta_{1b}, \theta_{2b}", [a[2], b[2], a[2], b[2]]);
    known.numbers(r"\theta_{mb}, S", [0.5 * (a[2] + b[2]), 1.0]);
    known.list("S_f", Reference::new(Geometry::Axisymmetric, Theory::Bending, a, b).faces(b[2] - a[2], thickness));
    known.list(r"\xi", stations(true).map(|station| station.xi));
    known.set(r"\mathbf x", stations(true).map(|station| column(station.position(&a, &b).as_slice())));
    known.column(r"\mathbf x_1", &a[..2]);
    known.column(r"\mathbf x_2", &b[..2]);
    known.column(r"\mathbf n", turned(along.normalize()).as_slice());
    known
}
