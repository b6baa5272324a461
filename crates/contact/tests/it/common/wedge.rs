//! Wedge pushed up an inclined plane of slope `tan a`: NAFEMS CGS-4, `F / G = (tan a + mu) / (1 - mu tan a)`.

use super::material;
use hpfem::*;

const KINEMATICS: Kinematics = Kinematics::PlaneStrain { thickness: 1.0 };

/// A quadrilateral of two cells between `bottom` and `top` lines (three points each); one of them is the contact.
fn strip(bottom: [[f64; 2]; 2], top: [[f64; 2]; 2], contact: Side) -> Mesh {
    let name = |side, name| Named { side, range: None, name };
    Mesh::ruled(&Ruled {
        bottom: Curve::Line { start: bottom[0], end: bottom[1] },
        top: Curve::Line { start: top[0], end: top[1] },
        breaks: &[-1.0, 0.0, 1.0],
        levels: &[0.0, 1.0],
        closed: false,
        material: 0,
        names: &[name(contact, "contact"), name(if contact == Side::Bottom { Side::Top } else { Side::Bottom }, "back")],
    })
    .unwrap()
}

/// Wedge (its back a rigid edge, free in x and z) and plane, as interface operators.
pub(crate) fn bodies(slope: f64) -> (InterfaceOperator, InterfaceOperator) {
    let incline = [[0.0, 0.0], [6.0, 6.0 * slope]];
    let height = 4.0 + 6.0 * slope.max(0.0);
    let wedge = strip(incline, [[0.0, height], [6.0, height]], Side::Bottom);
    let plane = strip([[0.0, -6.0], [6.0, -6.0]], incline, Side::Top);
    let problem = |mesh| BodyProblem::new(mesh, 6, KINEMATICS).material(material(206e3, 0.3)).keep("contact");
    let edge = RigidEdge { boundary: "back".into(), reference: [3.0, height], free: [true, true, false] };
    let wedge = BodyProblem { rigid_edge: Some(edge), ..problem(wedge) };
    let reduced = |problem| Body::new(problem).unwrap().interface;
    (reduced(wedge), reduced(problem(plane).clamp("back")))
}
