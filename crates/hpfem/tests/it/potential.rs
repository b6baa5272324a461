//! Scalar potentials: manufactured solutions, the logarithm of an annulus, a film.

use crate::classics::{quarter_ring, rectangle};
use crate::common::*;
use crate::exact::bessel;
use approx::assert_relative_eq;
use hpfem::*;

const PLANE: Kinematics = Kinematics::Potential { thickness: 0.7 };
const REVOLVED: Kinematics = Kinematics::AxisymmetricPotential;

/// A manufactured solution: value, gradient and `-div(k grad u)`.
#[derive(Clone, Copy)]
struct Manufactured {
    kinematics: Kinematics,
    conductivity: [[f64; 2]; 2],
    value: fn([f64; 2]) -> f64,
    gradient: fn([f64; 2]) -> [f64; 2],
    source: fn([f64; 2]) -> f64,
}

/// `e^(x) cos z`.
const HARMONIC: Manufactured = Manufactured {
    kinematics: PLANE,
    conductivity: [[2.0, 0.0], [0.0, 2.0]],
    value: |[x, z]| x.exp() * z.cos(),
    gradient: |[x, z]| [x.exp() * z.cos(), -x.exp() * z.sin()],
    source: |_| 0.0,
};

/// `sin(1.3 x - 0.8 z)`, with a full conductivity.
const POISSON: Manufactured = Manufactured {
    kinematics: PLANE,
    conductivity: [[2.0, 0.5], [0.5, 1.0]],
    value: |[x, z]| (1.3 * x - 0.8 * z).sin(),
    gradient: |[x, z]| [1.3, -0.8].map(|a| a * (1.3 * x - 0.8 * z).cos()),
    source: |[x, z]| (2.0 * 1.69 - 2.0 * 0.5 * 1.04 + 0.64) * (1.3 * x - 0.8 * z).sin(),
};

/// `J_0(0.9 r) e^(0.9 z)`.
const REVOLVED_HARMONIC: Manufactured = Manufactured {
    kinematics: REVOLVED,
    conductivity: [[1.5, 0.0], [0.0, 1.5]],
    value: |[r, z]| bessel(0, 0.9 * r) * (0.9 * z).exp(),
    gradient: |[r, z]| [-0.9 * bessel(1, 0.9 * r), 0.9 * bessel(0, 0.9 * r)].map(|v| v * (0.9 * z).exp()),
    source: |_| 0.0,
};

/// `r^2 e^z`, `-(4 + r^2) e^z`.
const REVOLVED_POISSON: Manufactured = Manufactured {
    kinematics: REVOLVED,
    conductivity: [[1.0, 0.0], [0.0, 1.0]],
    value: |[r, z]| r * r * z.exp(),
    gradient: |[r, z]| [2.0 * r * z.exp(), r * r * z.exp()],
    source: |[r, z]| -(4.0 + r * r) * z.exp(),
};

impl Manufactured {
    /// `k grad u`.
    fn flow(&self, x: [f64; 2]) -> [f64; 2] {
        let g = (self.gradient)(x);
        self.conductivity.map(|row| row[0] * g[0] + row[1] * g[1])
    }

    /// Largest error of `k grad u`, relative, and of the value on the held boundary.
    fn error(self, mesh: &Mesh, degree: usize, held: &str) -> f64 {
        let others = ["bottom", "right", "top", "left"].into_iter().filter(|name| *name != held);
        let flux = |name| {
            EdgeTraction::new(name, move |p| {
                let q = self.flow(p.position);
                [q[0] * p.outward[0] + q[1] * p.outward[1], 0.0]
            })
        };
        let material = Material::conductor(1.0).unwrap().conducting(self.conductivity).unwrap();
        let problem = BodyProblem::new(mesh.clone(), degree, self.kinematics).material(material).keep("right");
        let problem = problem.support(Support::hold(held, Direction::First).varying(self.value));
        let problem = others.fold(problem, |problem, name| problem.load("0", flux(name)));
        let source = self.source;
        let body = Body::new(problem.load("0", BodyForce::new(move |x| [source(x), 0.0]))).unwrap();
        let field = body.field(&solved(&body, &[1.0])).unwrap();
        let values = (0..mesh.cells.len()).flat_map(|c| sample_points().map(move |x| (c, x))).map(|(cell, (xi, eta))| {
            (field.at(cell, xi, eta).unwrap().displacement[0] - (self.value)(field.position(cell, xi, eta))).abs()
        });
        let flows = stress_error(&field, mesh, |x| {
            let q = self.flow(x);
            [q[0], q[1], 0.0, 0.0]
        });
        values.fold(flows, f64::max)
    }
}

#[test]
fn potentials_converge_exponentially_on_turned_curved_cells() {
    for exact in [HARMONIC, POISSON, REVOLVED_HARMONIC, REVOLVED_POISSON] {
        let meshes = TURNS.iter().flat_map(|t| [patch(*t, Shape::Arcs, 0.0), mixed(*t, Shape::Polynomial(3), 0.0)]);
        for (mesh, held) in meshes.zip(["top", "left", "bottom"].into_iter().cycle()) {
            let errors = [2, 4, 6, 8, 10, 12].map(|p| exact.error(&mesh, p, held));
            assert!(errors[5] < 2e-7, "{held}: {errors:?}");
            assert!((errors[0] / errors[5]).ln() / 10.0 > 2.5_f64.ln(), "{held}: {errors:?}");
        }
    }
}

#[test]
fn potentials_of_revolution_are_regular_on_the_axis() {
    for exact in [REVOLVED_HARMONIC, REVOLVED_POISSON] {
        for mesh in [patch(TURNS[6], Shape::Arcs, 1.0), mixed(TURNS[5], Shape::Arcs, 1.0)] {
            let error = exact.error(&mesh, 12, "top");
            assert!(error < 2e-7, "{error:.1e}");
        }
    }
}

#[test]
fn the_potential_between_two_radii_is_a_logarithm() {
    let (k, inner) = (3.0, 40.0);
    let flow = move |r: f64| -k * inner / 2.0_f64.ln() / r;
    let material = Material::conductor(k).unwrap();
    let between = |mesh: &Mesh, kinematics, [hot, cold]: [&str; 2]| {
        let problem = BodyProblem::new(mesh.clone(), 16, kinematics).material(material).hold(cold, Direction::First);
        let body = Body::new(problem.support(Support::moved(hot, Direction::First, inner))).unwrap();
        let state = body.solve(&[]).unwrap();
        // What flows in by the hot face, and out by the cold one.
        let flows = [1, 0].map(|support| body.interface.reaction(support, &state)[0]);
        (body.field(&state).unwrap(), flows)
    };
    let mesh = rectangle([1.0, 2.0], [0.0, 0.5]);
    let (field, flows) = between(&mesh, REVOLVED, ["left", "right"]);
    assert!(stress_error(&field, &mesh, |x| [flow(x[0]), 0.0, 0.0, 0.0]) < 1e-9);
    let whole = std::f64::consts::TAU * 0.5 * -flow(1.0);
    assert_relative_eq!(flows[0], whole, max_relative = 1e-10);
    assert_relative_eq!(flows[1], -whole, max_relative = 1e-10);
    let ring = quarter_ring(2);
    let (field, flows) = between(&ring, PLANE, ["inner", "outer"]);
    let radial = |x: [f64; 2]| x.map(|v| v * flow(x[0].hypot(x[1])) / x[0].hypot(x[1]));
    assert!(stress_error(&field, &ring, |x| [radial(x)[0], radial(x)[1], 0.0, 0.0]) < 1e-9);
    assert_relative_eq!(flows[0], 0.7 * std::f64::consts::FRAC_PI_2 * -flow(1.0), max_relative = 1e-10);
}

#[test]
fn a_film_carries_the_heat_of_a_slab_to_what_is_around() {
    // k u'(L) = -h (u(L) - u_0): u = T - (T - u_0) h x / (k + h L).
    let (k, h, length, hot, around) = (2.0, 5.0, 3.0, 90.0, 20.0);
    let mesh = rectangle([0.0, length], [0.0, 1.0]);
    for kept in [None, Some("right"), Some("top")] {
        let problem = BodyProblem::new(mesh.clone(), 3, PLANE).material(Material::conductor(k).unwrap());
        let problem = BodyProblem { kept: kept.iter().map(|name| name.to_string()).collect(), ..problem }
            .support(Support::moved("left", Direction::First, hot))
            .foundation(Foundation::new("right", h, 0.0))
            .load("air", EdgeTraction::new("right", move |_| [h * around, 0.0]));
        let body = Body::new(problem).unwrap();
        let field = body.field(&body.solve(&[("air", 1.0)]).unwrap()).unwrap();
        for (xi, eta) in sample_points() {
            let x = field.position(0, xi, eta)[0];
            let wanted = hot - (hot - around) * h * x / (k + h * length);
            assert_relative_eq!(field.at(0, xi, eta).unwrap().displacement[0], wanted, max_relative = 1e-12);
        }
    }
}

#[test]
fn a_potential_that_nothing_holds_needs_sources_that_balance() {
    let mesh = rectangle([0.0, 1.0], [0.0, 1.0]);
    let problem = || BodyProblem::new(mesh.clone(), 2, PLANE).material(Material::conductor(1.0).unwrap());
    assert!(matches!(Body::new(problem()), Err(Error::NotHeld { .. })));
    let flux = |name, q: f64| EdgeTraction::new(name, move |_| [q, 0.0]);
    let body = Body::new(problem().keep("top").load("in", flux("left", 1.0)).load("out", flux("right", -1.0))).unwrap();
    assert!(matches!(body.solve(&[("in", 1.0)]), Err(Error::Unbalanced { .. })));
    let field = body.field(&body.solve(&[("in", 2.0), ("out", 2.0)]).unwrap()).unwrap();
    assert!(stress_error(&field, &mesh, |_| [-2.0, 0.0, 0.0, 0.0]) < 1e-12);
    let elastic = BodyProblem::new(mesh.clone(), 2, PLANE).material(steel()[0]).keep("top");
    assert!(matches!(Body::new(elastic), Err(Error::MaterialLacks { number: 0, property: "conductivity" })));
}
