//! Block shoe on a drum: arc of radius 200 mm, half angle 30 degrees, ring from 100 mm, 10 kN on the flat top.

use super::{material, touching};
use hpfem::*;
use std::f64::consts::{FRAC_PI_2, PI};

pub(crate) const RADIUS: f64 = 200.0;
pub(crate) const HALF_ANGLE: f64 = PI / 6.0;
const KINEMATICS: Kinematics = Kinematics::PlaneStress { thickness: 10.0 };

pub(crate) struct Drum {
    shoe: Mesh,
    drum: Mesh,
    degree: usize,
    layers: usize,
    materials: [Material; 2],
}

impl Drum {
    /// Meshes with `layers` cells of ratio 0.15 at both ends of the contact.
    pub(crate) fn new(degree: usize, layers: usize, young: [f64; 2]) -> Drum {
        let half_chord = RADIUS * HALF_ANGLE.sin();
        let end = |sign: f64| [sign * half_chord, RADIUS * HALF_ANGLE.cos()];
        let name = |side, name| Named { side, range: None, name };
        let inner = Curve::Arc { centre: [0.0; 2], radius: RADIUS, from: FRAC_PI_2 + HALF_ANGLE, to: FRAC_PI_2 - HALF_ANGLE };
        let top = Curve::Line { start: [-half_chord, 300.0], end: [half_chord, 300.0] };
        let names = [name(Side::Bottom, "contact"), name(Side::Top, "top"), name(Side::Left, "left"), name(Side::Right, "right")];
        let shoe = Mesh::ruled(&Ruled {
            bottom: inner,
            top,
            breaks: &[-1.0, 0.0, 1.0],
            levels: &[0.0, 1.0],
            closed: false,
            material: 0,
            names: &names,
        })
        .unwrap();
        let refined = |mesh: Mesh| {
            let corners = [mesh.nearest_vertex(end(-1.0)), mesh.nearest_vertex(end(1.0))];
            mesh.refined_towards(&corners, 0.15, layers).unwrap()
        };
        let breaks = [-1.0, -2.0 / 3.0, -1.0 / 3.0, -1.0 / 6.0, 0.0, 1.0 / 6.0, 1.0 / 3.0, 2.0 / 3.0, 1.0];
        let arc = |radius| Curve::Arc { centre: [0.0; 2], radius, from: FRAC_PI_2 + PI, to: FRAC_PI_2 - PI };
        let contact = Named { side: Side::Top, range: Some([-1.0 / 6.0, 1.0 / 6.0]), name: "contact" };
        let drum = Mesh::ruled(&Ruled {
            bottom: arc(100.0),
            top: arc(RADIUS),
            breaks: &breaks,
            levels: &[0.0, 1.0],
            closed: true,
            material: 0,
            names: &[name(Side::Bottom, "hub"), name(Side::Top, "outer"), contact],
        })
        .unwrap();
        Drum { shoe: refined(shoe), drum: refined(drum), degree, layers, materials: young.map(|e| material(e, 0.3)) }
    }

    pub(crate) fn bodies(&self) -> (Body, Body) {
        self.bodies_of_degrees([self.degree, self.degree])
    }

    pub(crate) fn bodies_of_degrees(&self, degrees: [usize; 2]) -> (Body, Body) {
        let problem =
            |mesh: &Mesh, body: usize| touching(mesh.clone(), [degrees[body], self.layers], KINEMATICS, self.materials[body]);
        let shoe = problem(&self.shoe, 0).hold("left", Direction::First).hold("right", Direction::First);
        let shoe = shoe.load("force", EdgeTraction::new("top", |_| [0.0, -5.0]));
        let drum = problem(&self.drum, 1).clamp("hub");
        (Body::new(shoe).unwrap(), Body::new(drum).unwrap())
    }
}
