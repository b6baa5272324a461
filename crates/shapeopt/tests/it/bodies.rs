//! Finite element bodies of the tests: translating punch on a plate, block shoe on a drum.

use contact::ContactOperator;
use hpfem::*;
use nalgebra::Vector3;
use std::f64::consts::{FRAC_PI_2, PI};
use wear::SurfacePoint;

pub const RADIUS: f64 = 200.0;
pub const HALF_ANGLE: f64 = PI / 6.0;
const PLANE_STRESS: Kinematics = Kinematics::PlaneStress { thickness: 10.0 };

/// Two bodies of one discretisation.
pub struct Bodies {
    /// All but their degrees.
    problems: [BodyProblem; 2],
    degree: usize,
    layers: usize,
}

/// A steel plate of 10 mm that keeps its boundary "contact".
fn steel(mesh: Mesh) -> BodyProblem {
    BodyProblem::new(mesh, 1, PLANE_STRESS).material(Material::isotropic(210e3, 0.3).unwrap()).keep("contact")
}

fn named(side: Side, name: &str) -> Named<'_> {
    Named { side, range: None, name }
}

fn refined(mesh: &Mesh, corners: &[[f64; 2]], layers: usize) -> Mesh {
    let at: Vec<usize> = corners.iter().map(|c| mesh.nearest_vertex(*c)).collect();
    mesh.refined_towards(&at, 0.15, layers).unwrap()
}

fn rectangle(x: &[f64], z: &[f64], side: Side, contact: [f64; 2]) -> Mesh {
    let ([x0, x1], [z0, z1]) = ([x[0], x[x.len() - 1]], [z[0], z[z.len() - 1]]);
    let t = |v: f64| 2.0 * (v - x0) / (x1 - x0) - 1.0;
    let breaks: Vec<f64> = x.iter().map(|v| t(*v)).collect();
    let levels: Vec<f64> = z.iter().map(|v| (v - z0) / (z1 - z0)).collect();
    Mesh::ruled(&Ruled {
        bottom: Curve::Line { start: [x0, z0], end: [x1, z0] },
        top: Curve::Line { start: [x0, z1], end: [x1, z1] },
        breaks: &breaks,
        levels: &levels,
        closed: false,
        material: 0,
        names: &[
            named(Side::Bottom, "bottom"),
            named(Side::Top, "top"),
            Named { side, range: Some(contact.map(t)), name: "contact" },
        ],
    })
    .unwrap()
}

/// Punch 60 x 100 mm on a clamped plate 120 x 100 mm; `tilts` frees the rotation of its rigid top.
pub fn punch(degree: usize, layers: usize, tilts: bool) -> Bodies {
    let ends = [[-30.0, 100.0], [30.0, 100.0]];
    let punch = rectangle(&[-30.0, 0.0, 30.0], &[100.0, 150.0, 200.0], Side::Bottom, [-30.0, 30.0]);
    let plate = rectangle(&[-60.0, -30.0, 0.0, 30.0, 60.0], &[0.0, 50.0, 100.0], Side::Top, [-30.0, 30.0]);
    let top = RigidEdge { boundary: "top".into(), reference: [0.0, 200.0], free: [false, true, tilts] };
    let punch = BodyProblem { rigid_edge: Some(top), ..steel(refined(&punch, &ends, layers)) };
    Bodies { problems: [punch, steel(refined(&plate, &ends, layers)).clamp("bottom")], degree, layers }
}

/// Shoe on an arc of radius 200 mm and half angle 30 degrees, guided at its sides, 10 kN on its flat top; drum from 100 mm.
pub fn drum(degree: usize, layers: usize) -> Bodies {
    let half_chord = RADIUS * HALF_ANGLE.sin();
    let ends = [-1.0, 1.0].map(|sign| [sign * half_chord, RADIUS * HALF_ANGLE.cos()]);
    let arc = |radius, angle| Curve::Arc { centre: [0.0; 2], radius, from: FRAC_PI_2 + angle, to: FRAC_PI_2 - angle };
    let shoe = Mesh::ruled(&Ruled {
        bottom: arc(RADIUS, HALF_ANGLE),
        top: Curve::Line { start: [-half_chord, 300.0], end: [half_chord, 300.0] },
        breaks: &[-1.0, 0.0, 1.0],
        levels: &[0.0, 1.0],
        closed: false,
        material: 0,
        names: &[named(Side::Bottom, "contact"), named(Side::Top, "top"), named(Side::Left, "left"), named(Side::Right, "right")],
    })
    .unwrap();
    let drum = Mesh::ruled(&Ruled {
        bottom: arc(100.0, PI),
        top: arc(RADIUS, PI),
        breaks: &[-1.0, -2.0 / 3.0, -1.0 / 3.0, -1.0 / 6.0, 0.0, 1.0 / 6.0, 1.0 / 3.0, 2.0 / 3.0, 1.0],
        levels: &[0.0, 1.0],
        closed: true,
        material: 0,
        names: &[
            named(Side::Bottom, "hub"),
            named(Side::Top, "outer"),
            Named { side: Side::Top, range: Some([-1.0 / 6.0, 1.0 / 6.0]), name: "contact" },
        ],
    })
    .unwrap();
    let shoe = steel(refined(&shoe, &ends, layers)).hold("left", Direction::First).hold("right", Direction::First);
    let shoe = shoe.load("force", EdgeTraction::new("top", |_| [0.0, -5.0]));
    Bodies { problems: [shoe, steel(refined(&drum, &ends, layers)).clamp("hub")], degree, layers }
}

impl Bodies {
    /// The same with every point of the shaped body moved by a map.
    pub fn with_shaped(mut self, map: impl Fn([f64; 2]) -> [f64; 2]) -> Bodies {
        self.problems[0].mesh = self.problems[0].mesh.mapped(map).unwrap().into();
        self
    }

    pub fn reduced(&self) -> [Body; 2] {
        self.problems.clone().map(|problem| {
            let fall = |layer: usize| (layer * self.degree).checked_div(self.layers).unwrap_or(0);
            let degree = |cell: &Cell| (self.degree + 1).saturating_sub(fall(cell.layer)).clamp(2, self.degree);
            let degrees = problem.mesh.cells.iter().map(degree).collect();
            Body::new(problem.degrees(degrees)).unwrap()
        })
    }
}

/// The contact points as surface points with one sliding speed.
pub fn surface_points(operator: &ContactOperator<'_>, speed: f64) -> Vec<SurfacePoint> {
    let spatial = |v: [f64; 2]| Vector3::new(v[0], 0.0, v[1]);
    operator
        .points()
        .iter()
        .map(|p| SurfacePoint {
            position: spatial(p.position),
            normal: spatial(p.normal),
            weight: p.weight,
            sliding_speed: speed,
            drag: spatial(p.tangent),
        })
        .collect()
}
