//! Heat that passes a joint of two bodies with a conductance, and the balance of all that goes in and out.

use crate::common::*;
use crate::heat::conduction;
use approx::assert_relative_eq;
use faer::Mat;
use faer::linalg::solvers::Solve;
use hpfem::*;
use std::f64::consts::PI;

const PLANE: Kinematics = Kinematics::PlaneStress { thickness: 0.7 };

/// Two layers of width 1 joined by the conductance `h` (mW/(mm^2 K)), cold below and warm above, both faces wavy:
///
/// ```text
///   T = 100 + 30 cos(pi x)       z = d_1      T_i = A_i + B_i z + (C_i cosh(pi z) + D_i sinh(pi z)) cos(pi x)
///   ------ body 1, k_1 ------
///   q = h (T_1 - T_2)            z = 0        k_1 T_1,z = k_2 T_2,z = h (T_1 - T_2)
///   ------ body 2, k_2 ------
///   T = 20                       z = -d_2
/// ```
struct Layers {
    conductivity: [f64; 2],
    height: [f64; 2],
    conductance: f64,
}

impl Layers {
    /// Coefficients of the mean and of the wave, `[[A_1, B_1, A_2, B_2], [C_1, D_1, C_2, D_2]]`.
    fn coefficients(&self) -> [[f64; 4]; 2] {
        let ([k1, k2], [d1, d2]) = (self.conductivity, self.height);
        // What each layer lets through a unit of temperature: of the mean k/d, of the wave k pi coth(pi d) and so on; resistances in series.
        let resistance = d1 / k1 + 1.0 / self.conductance + d2 / k2;
        let flux = (100.0 - 20.0) / resistance;
        let mean = [100.0 - flux * d1 / k1, flux / k1, 20.0 + flux * d2 / k2, flux / k2];
        // Wave: T_1 = C_1 cosh + D_1 sinh, 30 at d_1; T_2 = C_2 cosh + D_2 sinh, 0 at -d_2; k_i pi D_i = q.
        let (t1, t2) = ((PI * d1).tanh(), (PI * d2).tanh());
        let q = 30.0 / (PI * d1).cosh() / (t1 / (k1 * PI) + 1.0 / self.conductance + t2 / (k2 * PI));
        let [w1, w2] = [q / (k1 * PI), q / (k2 * PI)];
        [mean, [30.0 / (PI * d1).cosh() - w1 * t1, w1, w2 * t2, w2]]
    }

    fn temperature(&self, body: usize, [x, z]: [f64; 2]) -> f64 {
        let [mean, wave] = self.coefficients();
        let (i, s) = (2 * body, PI * z);
        mean[i] + mean[i + 1] * z + (wave[i] * s.cosh() + wave[i + 1] * s.sinh()) * (PI * x).cos()
    }

    /// Largest error of the temperatures, relative to 100, by the operators of both bodies and the flux between them as Legendre polynomials:
    /// `S_i T_i = f_i +- B_i q`, `B_1^T T_1 - B_2^T T_2 + M q / h = 0`, q from body 2 into body 1.
    fn error(&self, degree: usize) -> f64 {
        let body = |number: usize| {
            let d = self.height[number];
            let (z, joint, held) = if number == 0 { ([0.0, d], "bottom", "top") } else { ([-d, 0.0], "top", "bottom") };
            let profile: fn([f64; 2]) -> f64 = if number == 0 { |x| 100.0 + 30.0 * (PI * x[0]).cos() } else { |_| 20.0 };
            let mesh = crate::classics::rectangle([0.0, 1.0], z);
            let problem = conduction(&mesh, degree, PLANE).material(Material::conductor(self.conductivity[number]).unwrap());
            Body::new(problem.support(Support::hold(held, Direction::First).varying(profile)).keep(joint)).unwrap()
        };
        let bodies = [body(0), body(1)];
        let n = bodies.each_ref().map(|body| body.interface.stiffness.nrows());
        let (all, size) = (n[0] + n[1], n[0] + n[1] + degree);
        let mut matrix = Mat::<f64>::zeros(size, size);
        let mut right = Mat::<f64>::zeros(size, 1);
        for (number, body) in bodies.iter().enumerate() {
            let (interface, first) = (&body.interface, number * n[0]);
            matrix.submatrix_mut(first, first, n[number], n[number]).copy_from(&interface.stiffness);
            let none = TraceLoad { unknowns: vec![0.0; n[number]], ..TraceLoad::default() };
            let own = interface.right_hand_side(&none, &interface.factors(&[]).unwrap());
            own.into_iter().enumerate().for_each(|(i, value)| right[(first + i, 0)] = value);
            let sign = if number == 0 { -1.0 } else { 1.0 };
            for k in 0..degree {
                let load = interface.trace.load(interface.kinematics, degree, |p| [wave(k, p.position[0]), 0.0]);
                for (i, value) in load.unknowns.into_iter().enumerate() {
                    matrix[(first + i, all + k)] = sign * value;
                    matrix[(all + k, first + i)] = sign * value;
                }
            }
        }
        for k in 0..degree {
            matrix[(all + k, all + k)] = -0.7 / (2.0 * k as f64 + 1.0) / self.conductance;
        }
        let x = matrix.full_piv_lu().solve(&right);
        let mut error = 0.0_f64;
        for (number, body) in bodies.iter().enumerate() {
            let unknowns = (0..n[number]).map(|i| x[(number * n[0] + i, 0)]).collect();
            let factors = body.interface.factors(&[]).unwrap();
            let field = body.field(&InterfaceState { unknowns, factors, load: TraceLoad::default() }).unwrap();
            for (xi, eta) in sample_points() {
                let value = field.at(0, xi, eta).unwrap().displacement[0];
                error = error.max((value - self.temperature(number, field.position(0, xi, eta))).abs());
            }
        }
        error / 100.0
    }
}

/// Legendre polynomial `P_k` on `0 < x < 1`.
fn wave(k: usize, x: f64) -> f64 {
    legendre(k.max(1), 2.0 * x - 1.0)[k]
}

#[test]
fn two_layers_meet_through_any_conductance_by_their_operators_alone() {
    for conductance in [1e-12, 1e-3, 7.0, 1e4, 1e12, f64::INFINITY] {
        for conductivity in [[50.0, 0.4], [0.4, 50.0], [1.0, 1e6]] {
            let layers = Layers { conductivity, height: [0.6, 0.9], conductance };
            let error = layers.error(16);
            assert!(error < 1e-11, "h = {conductance:.0e}, k = {conductivity:?}: {error:.1e}");
        }
    }
    let layers = Layers { conductivity: [50.0, 0.4], height: [0.6, 0.9], conductance: 2.0 };
    let errors = [4, 8, 12].map(|degree| layers.error(degree));
    assert!(errors.windows(2).all(|e| e[1] < 1e-3 * e[0]), "{errors:?}");
}

/// Source, flux, held temperature and film at once: what goes in comes out, the heat of the film being `h (int T dA - T_0 A)`, where the
/// work of a unit flux on the temperature is the first integral.
#[test]
fn all_heat_that_goes_into_a_body_comes_out_of_it() {
    let (film, around) = (3.0, 25.0);
    for (turns, kinematics) in TURNS.into_iter().zip([PLANE, Kinematics::Axisymmetric].into_iter().cycle()) {
        for (degree, kept) in [(3, None), (6, Some("right")), (6, Some("top"))] {
            let mesh = mixed(turns, Shape::Arcs, 0.0);
            let problem = conduction(&mesh, degree, kinematics).material(Material::conductor(2.0).unwrap());
            let problem = BodyProblem { kept: kept.iter().map(|name: &&str| name.to_string()).collect(), ..problem }
                .support(Support::moved("left", Direction::First, 140.0))
                .foundation(Foundation::new("right", film, 0.0))
                .load("source", BodyForce::new(|x| [4.0 * x[0] + x[1] * x[1], 0.0]))
                .load("flux", EdgeTraction::new("bottom", |p| [11.0 + p.position[0], 0.0]))
                .load("around", EdgeTraction::new("right", move |_| [film * around, 0.0]))
                .load("area", EdgeTraction::new("right", |_| [1.0, 0.0]));
            let body = Body::new(problem).unwrap();
            let given = ["source", "flux", "around"];
            let state = body.solve(&given.map(|name| (name, 1.0))).unwrap();
            let interface = &body.interface;
            let put_in: f64 = given.iter().map(|name| brought(&body, kinematics, name)).sum();
            let by_film = film * interface.column_work(interface.load_case("area").unwrap(), &state);
            let held = interface.reaction(0, &state)[0];
            assert_relative_eq!(put_in + held, by_film, max_relative = 1e-11);
            assert!(by_film > 10.0 && put_in > 10.0);
        }
    }
}

/// The heat that a load case brings: what the support takes of it from a body without a film.
fn brought(body: &Body, kinematics: Kinematics, name: &str) -> f64 {
    let problem = body.problem();
    let case = problem.load_cases.iter().find(|case| case.name == name).unwrap().clone();
    let alone =
        conduction(&problem.mesh, problem.degrees[0], kinematics).material(Material::conductor(1.0).unwrap()).clamp("left");
    let alone = Body::new(BodyProblem { load_cases: vec![case], ..alone }).unwrap();
    -alone.interface.reaction(0, &alone.solve(&[(name, 1.0)]).unwrap())[0]
}
