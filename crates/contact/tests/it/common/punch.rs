//! Rectangle pressed on a rectangle: translating punch and, in axisymmetric kinematics, annular punch on a disc.

use super::{material, touching};
use hpfem::*;

pub(crate) struct Punch {
    pub(crate) meshes: [Mesh; 2],
    pub(crate) kinematics: Kinematics,
    pub(crate) degree: usize,
    pub(crate) layers: usize,
    pub(crate) materials: [Material; 2],
    pub(crate) rigid_edge: Option<RigidEdge>,
    /// Pull on the top, MPa.
    pub(crate) load: Option<f64>,
}

/// Rectangle with vertical cuts at `x` and horizontal ones at `z`; the part of the bottom or top between the `contact` points is
/// named "contact".
pub(crate) fn rectangle(x: &[f64], z: &[f64], side: Side, contact: [f64; 2]) -> Mesh {
    let (x0, x1) = (x[0], x[x.len() - 1]);
    let (z0, z1) = (z[0], z[z.len() - 1]);
    let t = |v: f64| 2.0 * (v - x0) / (x1 - x0) - 1.0;
    let breaks: Vec<f64> = x.iter().map(|v| t(*v)).collect();
    let levels: Vec<f64> = z.iter().map(|v| (v - z0) / (z1 - z0)).collect();
    let name = |side, name| Named { side, range: None, name };
    Mesh::ruled(&Ruled {
        bottom: Curve::Line { start: [x0, z0], end: [x1, z0] },
        top: Curve::Line { start: [x0, z1], end: [x1, z1] },
        breaks: &breaks,
        levels: &levels,
        closed: false,
        material: 0,
        names: &[
            name(Side::Bottom, "bottom"),
            name(Side::Top, "top"),
            name(Side::Left, "left"),
            name(Side::Right, "right"),
            Named { side, range: Some(contact.map(t)), name: "contact" },
        ],
    })
    .unwrap()
}

fn refined(mesh: &Mesh, corners: &[[f64; 2]], layers: usize) -> Mesh {
    let at: Vec<usize> = corners.iter().map(|c| mesh.nearest_vertex(*c)).collect();
    mesh.refined_towards(&at, 0.15, layers).unwrap()
}

impl Punch {
    /// Punch 60 x 100 mm with a rigid top edge, held against rotation and sideways motion by `free`, on a clamped plate 120 x 100 mm.
    pub(crate) fn translating(degree: usize, layers: usize, free: [bool; 3]) -> Punch {
        let ends = [[-30.0, 100.0], [30.0, 100.0]];
        let punch = rectangle(&[-30.0, 0.0, 30.0], &[100.0, 150.0, 200.0], Side::Bottom, [-30.0, 30.0]);
        let plate = rectangle(&[-60.0, -30.0, 0.0, 30.0, 60.0], &[0.0, 50.0, 100.0], Side::Top, [-30.0, 30.0]);
        Punch {
            meshes: [
                refined(&punch, &[ends[0], ends[1], [-30.0, 200.0], [30.0, 200.0]], layers),
                refined(&plate, &[ends[0], ends[1], [-60.0, 0.0], [60.0, 0.0]], layers),
            ],
            kinematics: Kinematics::PlaneStress { thickness: 10.0 },
            degree,
            layers,
            materials: [material(210e3, 0.3), material(210e3, 0.3)],
            rigid_edge: Some(RigidEdge { boundary: "top".into(), reference: [0.0, 200.0], free }),
            load: None,
        }
    }

    /// Annulus 20 <= r <= 120 mm under 100 MPa on a clamped disc 10 <= r <= 140 mm.
    pub(crate) fn annular(degree: usize, layers: usize) -> Punch {
        let ends = [[20.0, 50.0], [120.0, 50.0]];
        let punch = rectangle(&[20.0, 70.0, 120.0], &[50.0, 100.0], Side::Bottom, [20.0, 120.0]);
        let disc = rectangle(&[10.0, 20.0, 70.0, 120.0, 140.0], &[0.0, 50.0], Side::Top, [20.0, 120.0]);
        let mut disc = refined(&disc, &ends, layers);
        disc = refined(&disc, &[[10.0, 0.0], [140.0, 0.0]], layers);
        Punch {
            meshes: [refined(&punch, &ends, layers), disc],
            kinematics: Kinematics::Axisymmetric,
            degree,
            layers,
            materials: [material(210e3, 0.3), material(210e3, 0.3)],
            rigid_edge: None,
            load: Some(-100.0),
        }
    }

    pub(crate) fn bodies(&self) -> (Body, Body) {
        let problem =
            |body: usize| touching(self.meshes[body].clone(), [self.degree, self.layers], self.kinematics, self.materials[body]);
        let mut punch = BodyProblem { rigid_edge: self.rigid_edge.clone(), ..problem(0) };
        if let Some(pull) = self.load {
            punch = punch.load("force", EdgeTraction::new("top", move |_| [0.0, pull]));
        }
        (Body::new(punch).unwrap(), Body::new(problem(1).clamp("bottom")).unwrap())
    }
}
