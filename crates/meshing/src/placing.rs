//! Where a mesh file is put: scaled, turned about the origin, moved.

use hpfem::{Curve, Mesh};
use scene::MeshFile;

/// x -> scale R x + shift, R the rotation by an angle with this cosine and sine.
pub(crate) struct Placing {
    scale: f64,
    angle: f64,
    turn: [f64; 2],
    shift: [f64; 2],
}

impl Placing {
    /// What the keys scale, rotate and move say; none where there are none.
    pub(crate) fn of(file: &MeshFile) -> Option<Placing> {
        if file.scale.is_none() && file.rotate.is_none() && file.shift.is_none() {
            return None;
        }
        let angle = file.rotate.map_or(0.0, |angle| angle.0);
        // Quarter turns are exact: what lies on an axis stays on one.
        let exact = |x: f64| if x.abs() < 1e-15 { 0.0 } else { x };
        let turn = [angle.cos(), angle.sin()].map(exact);
        let shift = file.shift.map_or([0.0; 2], |shift| shift.map(|x| x.0));
        Some(Placing { scale: file.scale.map_or(1.0, |scale| scale.0), angle, turn, shift })
    }

    /// Puts a mesh in its place.
    pub(crate) fn put(&self, mesh: &mut Mesh) {
        mesh.vertices.iter_mut().for_each(|x| *x = self.point(*x));
        mesh.edges.iter_mut().for_each(|edge| edge.curve = self.curve(&edge.curve));
    }

    fn curve(&self, curve: &Curve) -> Curve {
        match curve {
            Curve::Line { start, end } => Curve::Line { start: self.point(*start), end: self.point(*end) },
            Curve::Arc { centre, radius, from, to } => Curve::Arc {
                centre: self.point(*centre),
                radius: self.scale * radius,
                from: from + self.angle,
                to: to + self.angle,
            },
            Curve::Polynomial { start, end, modes } => {
                Curve::Polynomial { start: self.point(*start), end: self.point(*end), modes: modes.map(|mode| self.turned(mode)) }
            }
        }
    }

    fn point(&self, x: [f64; 2]) -> [f64; 2] {
        let [a, b] = self.turned(x);
        [a + self.shift[0], b + self.shift[1]]
    }

    fn turned(&self, [x, z]: [f64; 2]) -> [f64; 2] {
        let [cos, sin] = self.turn;
        [self.scale * (cos * x - sin * z), self.scale * (sin * x + cos * z)]
    }
}
