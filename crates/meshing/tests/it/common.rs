//! Couples of the templates, and bodies given by a few cells.

use std::sync::Arc;

use hpfem::{Kinematics, Mesh};
use meshing::{Body, CONTACT, ContactLine, Couple, Extent, LoadedEdge, contact_line, read_cells, sound};
use scene::{Document, LoadKind, Material, Pressure};

/// A block shoe above a drum.
pub(crate) const SHOE: &str = "shoe-block = { radius = 200, half_angle = '30 deg', top = 300 }";
pub(crate) const SEGMENT: &str = "ring-segment = { inner = 200, outer = 215, x = [-90, 120] }";
pub(crate) const DRUM: &str = "ring = { inner = 100, outer = 200 }";
pub(crate) const PUNCH: &str = "rectangle = { x = [-30, 30], z = [0, 100] }";
pub(crate) const PLATE: &str = "rectangle = { x = [-70, 80], z = [-60, 0] }";
pub(crate) const DISC: &str = "half-disc = { radius = 50, centre = [4, 50] }";
pub(crate) const UNDER_DISC: &str = "rectangle = { x = [-56, 64], z = [-80, 0] }";

/// The block shoe as a lining and a back, cut where no template is: at 7 deg.
///
/// ```text
///   i---top---h---top---g    z = 300
///   |   back  |  back   |
///   f---------e---------d    radius 210
///    a---face--b--face--c    radius 200, at -30, 7, 30 deg
/// ```
pub(crate) const SHOE_CELLS: &str = "
    blocks.points.a = { radius = 200, angle = '-30 deg' }
    blocks.points.b = { radius = 200, angle = '7 deg' }
    blocks.points.c = { radius = 200, angle = '30 deg' }
    blocks.points.d = { radius = 210, angle = '30 deg' }
    blocks.points.e = { radius = 210, angle = '7 deg' }
    blocks.points.f = { radius = 210, angle = '-30 deg' }
    blocks.points.g = [110, 300]
    blocks.points.h = [25, 300]
    blocks.points.i = [-110, 300]
    blocks.curves.ab.arc = { ends = ['a', 'b'] }
    blocks.curves.bc.arc = { ends = ['b', 'c'] }
    blocks.curves.ed.arc = { ends = ['e', 'd'] }
    blocks.curves.fe.arc = { ends = ['f', 'e'] }
    blocks.curves.af.line = ['a', 'f']
    blocks.curves.be.line = ['b', 'e']
    blocks.curves.cd.line = ['c', 'd']
    blocks.curves.fi.line = ['f', 'i']
    blocks.curves.eh.line = ['e', 'h']
    blocks.curves.dg.line = ['d', 'g']
    blocks.curves.ih.line = ['i', 'h']
    blocks.curves.hg.line = ['h', 'g']
    blocks.cells.one = { curves = ['ab', 'be', 'fe', 'af'] }
    blocks.cells.two = { curves = ['bc', 'cd', 'ed', 'be'] }
    blocks.cells.three = { curves = ['fe', 'eh', 'ih', 'fi'] }
    blocks.cells.four = { curves = ['ed', 'dg', 'hg', 'eh'] }
    blocks.edges.inner = ['ab', 'bc']
    blocks.edges.bond = ['fe', 'ed']
    blocks.edges.left = ['fi']
    blocks.edges.right = ['dg']
    blocks.edges.top = ['ih', 'hg']
";

/// A rectangle of two cells that meet at x = `middle`, with the edges of the template.
pub(crate) fn two_cells([left, middle, right]: [f64; 3], [low, high]: [f64; 2]) -> String {
    format!(
        "
    blocks.points = {{ a = [{left}, {low}], b = [{middle}, {low}], c = [{right}, {low}], d = [{right}, {high}], e = [{middle}, {high}], f = [{left}, {high}] }}
    blocks.curves.ab.line = ['a', 'b']
    blocks.curves.bc.line = ['b', 'c']
    blocks.curves.cd.line = ['c', 'd']
    blocks.curves.ed.line = ['e', 'd']
    blocks.curves.fe.line = ['f', 'e']
    blocks.curves.af.line = ['a', 'f']
    blocks.curves.be.line = ['b', 'e']
    blocks.cells.one = {{ curves = ['ab', 'be', 'fe', 'af'] }}
    blocks.cells.two = {{ curves = ['bc', 'cd', 'ed', 'be'] }}
    blocks.edges = {{ bottom = ['ab', 'bc'], top = ['fe', 'ed'], left = ['af'], right = ['cd'] }}
"
    )
}

/// A body of the scene language: its geometry, the edge that touches, and what is held, as in `left = ['x']`.
pub(crate) fn body(key: &'static str, geometry: &str, contact: &str, support: &str) -> Body {
    let text = format!(
        "units = 'N-mm'\n[{key}]\nmaterial = {{ young = 1e5, poisson = 0.3 }}\nsupport = {{ {support} }}\n[{key}.geometry]\n{geometry}\n"
    );
    let document = Document::read("body.toml", &text, &[]).unwrap();
    let body = if key == "body1" { document.scene.body1 } else { document.scene.body2 };
    let mut body = body.unwrap();
    sound(key, &mut body.geometry, false).unwrap();
    let given = read_cells(key, &mut body, &|_| Err("no files".to_string())).unwrap();
    let cells = given.map(|given| Arc::new(given.mesh));
    let materials = vec![Material::elastic(Pressure(1e5), 0.3)];
    Body {
        key,
        geometry: body.geometry,
        cells,
        materials,
        supports: body.support,
        contact: contact.to_string(),
        loads: Vec::new(),
    }
}

/// Two bodies in plane stress, the first pressed through `edge`.
pub(crate) fn couple(first: Body, second: Body, edge: &str, kind: LoadKind) -> Couple {
    let load = LoadedEdge { edge: edge.to_string(), kind, strip: None, about: [0.0; 2], direction: 0.0, level: false };
    Couple { kinematics: Kinematics::PlaneStress { thickness: 1.0 }, bodies: [first, second], load, longest: 1.0 }
}

/// The extent that the contact edge of body 1 has.
pub(crate) fn extent(couple: &Couple) -> Extent {
    match contact_line(&couple.bodies[0], true).unwrap() {
        ContactLine::Circle { angles, .. } => Extent::Angles(angles),
        ContactLine::Line { x, .. } => Extent::X(x),
    }
}

/// The coordinate of a point on the contact surface.
pub(crate) fn coordinate(couple: &Couple, extent: Extent, x: [f64; 2]) -> f64 {
    match (contact_line(&couple.bodies[0], true).unwrap(), extent) {
        (ContactLine::Circle { centre, angles, .. }, Extent::Angles(_)) => {
            let middle = 0.5 * (angles[0] + angles[1]);
            let angle = (x[0] - centre[0]).atan2(x[1] - centre[1]) - middle;
            middle + (angle + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI
        }
        _ => x[0],
    }
}

/// Ascending coordinates of the break points of a mesh on the contact surface.
pub(crate) fn breaks(couple: &Couple, extent: Extent, mesh: &Mesh) -> Vec<f64> {
    let edges = mesh.boundary(CONTACT).unwrap();
    let mut vertices: Vec<usize> = edges.iter().flat_map(|e| mesh.edges[*e].vertices).collect();
    vertices.sort_unstable();
    vertices.dedup();
    let mut places: Vec<f64> = vertices.iter().map(|v| coordinate(couple, extent, mesh.vertices[*v])).collect();
    places.sort_by(f64::total_cmp);
    places
}
