//! Half of a round body on half of a block, both cut at the plane of symmetry x = 0 (or the axis r = 0).
//!
//! ```text
//!   z = R  C-----M-----E     nested cells around the point of contact O, with
//!          |     |    /      break points x_0 = end of contact, x_1 = end of
//!          A-----D   /       the candidate surface, then growing
//!          |     |  /
//!          O--x0-x1'         counter block below, mirrored
//! ```

use hpfem::*;

/// Sizes of a round body on a block.
#[derive(Clone, Copy)]
pub(crate) struct Sizes {
    pub(crate) radius: f64,
    pub(crate) width: f64,
    pub(crate) depth: f64,
}

/// Break points: the wanted nodes (the last is the end of contact), the end of the candidate surface, and on to the side of the round body's lower part.
fn breaks(sizes: &Sizes, nodes: &[f64], candidate: f64) -> Vec<f64> {
    let end = nodes[nodes.len() - 1];
    let last = sizes.radius * 0.5_f64.sqrt();
    let start = candidate * end;
    let count = ((last / start).ln() / 2.0_f64.ln()).ceil().max(1.0) as usize;
    let grown = (0..=count).map(|j| start * (last / start).powf(j as f64 / count as f64));
    nodes.iter().copied().chain(grown).collect()
}

fn towards(nodes: &[f64], layers: usize) -> Vec<([f64; 2], usize)> {
    nodes.iter().map(|x| ([*x, 0.0], layers)).collect()
}

struct Plan {
    vertices: Vec<[f64; 2]>,
    quads: Vec<Quad>,
}

impl Plan {
    /// Nested cells around the origin in the quadrant `x >= 0`, `z >= 0`, and the vertices `[B, D, A]` of the last level.
    fn nested(levels: &[f64], shrink: f64) -> (Plan, [usize; 3]) {
        let mut vertices = vec![[0.0, 0.0]];
        let mut quads = Vec::new();
        let quad = |corners| Quad { corners, material: 0, layer: 0 };
        for (j, x) in levels.iter().enumerate() {
            let first = vertices.len();
            vertices.extend([[*x, 0.0], [shrink * x, shrink * x], [0.0, shrink * x]]);
            if j == 0 {
                quads.push(quad([0, 1, 2, 3]));
            } else {
                let before = first - 3;
                quads.push(quad([before, first, first + 1, before + 1]));
                quads.push(quad([before + 2, before + 1, first + 1, first + 2]));
            }
        }
        let first = vertices.len() - 3;
        (Plan { vertices, quads }, [first, first + 1, first + 2])
    }

    fn add(&mut self, vertices: &[[f64; 2]], quads: &[[usize; 4]]) {
        self.vertices.extend(vertices);
        self.quads.extend(quads.iter().map(|c| Quad { corners: *c, material: 0, layer: 0 }));
    }

    /// The straight mesh, refined towards the given places.
    fn refined(&self, places: &[([f64; 2], usize)]) -> Mesh {
        let mut mesh = Mesh::new(self.vertices.clone(), &self.quads, &[], &[]).unwrap();
        for (place, layers) in places {
            mesh = mesh.refined_towards(&[mesh.nearest_vertex(*place)], 0.15, *layers).unwrap();
        }
        mesh
    }
}

/// Same topology with moved vertices, curved edges and names by the straight positions of the edge ends.
fn moved(
    straight: &Mesh,
    place: impl Fn([f64; 2]) -> [f64; 2],
    curve: impl Fn([f64; 2], [f64; 2]) -> Option<Curve>,
    names: impl Fn([f64; 2], [f64; 2]) -> Vec<&'static str>,
) -> Mesh {
    let quads: Vec<Quad> =
        straight.cells.iter().map(|c| Quad { corners: c.corners, material: c.material, layer: c.layer }).collect();
    let ends = |e: &Edge| e.vertices.map(|v| straight.vertices[v]);
    let curves: Vec<_> = straight.edges.iter().filter_map(|e| curve(ends(e)[0], ends(e)[1]).map(|c| (e.vertices, c))).collect();
    let named: Vec<_> =
        straight.edges.iter().flat_map(|e| names(ends(e)[0], ends(e)[1]).into_iter().map(|n| (e.vertices, n))).collect();
    Mesh::new(straight.vertices.iter().map(|v| place(*v)).collect(), &quads, &curves, &named).unwrap()
}

/// Quarter of a disc: the part x >= 0 of a half-disc of the given radius about (0, R), cut at z = R. Boundaries "contact" (up to
/// `candidate` times the last node), "axis", "top".
pub(crate) fn round(sizes: &Sizes, nodes: &[f64], candidate: f64, layers: usize) -> Mesh {
    let r = sizes.radius;
    let levels = breaks(sizes, nodes, candidate);
    let (mut plan, [b, d, a]) = Plan::nested(&levels, 0.7);
    let e = plan.vertices.len();
    plan.add(&[[r, r], [0.5 * r, r], [0.0, r]], &[[b, e, e + 1, d], [a, d, e + 1, e + 2]]);
    let straight = plan.refined(&towards(nodes, layers));
    let sag = |x: f64| x * x / (r + (r * r - x * x).max(0.0).sqrt());
    let place = |v: [f64; 2]| if v[0] >= r { v } else { [v[0], v[1] + sag(v[0]) * (1.0 - v[1] / r)] };
    let angle = |v: [f64; 2]| if v[0] >= r { 0.0 } else { (v[0] / r).asin() - std::f64::consts::FRAC_PI_2 };
    let on_arc = |v: [f64; 2]| v[1] == 0.0 || v[0] >= r;
    let last = candidate * nodes[nodes.len() - 1] * (1.0 + 1e-12);
    moved(
        &straight,
        place,
        |p, q| (on_arc(p) && on_arc(q)).then(|| Curve::Arc { centre: [0.0, r], radius: r, from: angle(p), to: angle(q) }),
        |p, q| {
            let mut names = Vec::new();
            if p[1] == 0.0 && q[1] == 0.0 && p[0] <= last && q[0] <= last {
                names.push("contact");
            }
            if p[0] == 0.0 && q[0] == 0.0 {
                names.push("axis");
            }
            if p[1] == r && q[1] == r {
                names.push("top");
            }
            names
        },
    )
}

/// Half of the block below z = 0: boundaries "contact", "axis", "bottom".
pub(crate) fn block(sizes: &Sizes, nodes: &[f64], candidate: f64, layers: usize) -> Mesh {
    let (w, h) = (sizes.width, sizes.depth);
    let mut levels = breaks(sizes, nodes, candidate);
    levels.push(w.min(h));
    let (mut plan, [_, d, a]) = Plan::nested(&levels, 1.0);
    let n = plan.vertices.len();
    if h > w {
        plan.add(&[[w, h], [0.0, h]], &[[a, d, n, n + 1]]);
    }
    let straight = plan.refined(&[towards(nodes, layers), vec![([w, h], layers)]].concat());
    let last = candidate * nodes[nodes.len() - 1] * (1.0 + 1e-12);
    // Mirrored: the cells are turned to stay anti-clockwise.
    let turned: Vec<Quad> = straight
        .cells
        .iter()
        .map(|c| Quad { corners: [c.corners[1], c.corners[0], c.corners[3], c.corners[2]], material: 0, layer: c.layer })
        .collect();
    let mut names = Vec::new();
    for e in &straight.edges {
        let [p, q] = e.vertices.map(|v| straight.vertices[v]);
        if p[1] == 0.0 && q[1] == 0.0 && p[0] <= last && q[0] <= last {
            names.push((e.vertices, "contact"));
        }
        if p[0] == 0.0 && q[0] == 0.0 {
            names.push((e.vertices, "axis"));
        }
        if p[1] == h && q[1] == h {
            names.push((e.vertices, "bottom"));
        }
    }
    Mesh::new(straight.vertices.iter().map(|v| [v[0], -v[1]]).collect(), &turned, &[], &names).unwrap()
}

/// A mesh and its mirror image in x = 0, joined along the axis; names are kept.
pub(crate) fn mirrored(half: &Mesh) -> Mesh {
    let mut vertices = half.vertices.clone();
    let image: Vec<usize> = half
        .vertices
        .iter()
        .enumerate()
        .map(|(i, v)| {
            if v[0] == 0.0 {
                return i;
            }
            vertices.push([-v[0], v[1]]);
            vertices.len() - 1
        })
        .collect();
    let plain = half.cells.iter().map(|c| Quad { corners: c.corners, material: c.material, layer: c.layer });
    let turned = half.cells.iter().map(|c| {
        let k = c.corners.map(|v| image[v]);
        Quad { corners: [k[1], k[0], k[3], k[2]], material: c.material, layer: c.layer }
    });
    let quads: Vec<Quad> = plain.chain(turned).collect();
    let mut curves = Vec::new();
    let mut names = Vec::new();
    for e in &half.edges {
        let other = e.vertices.map(|v| image[v]);
        curves.push((e.vertices, e.curve));
        if let Curve::Arc { centre, radius, from, to } = e.curve {
            let turn = |a: f64| -std::f64::consts::PI - a;
            let centre = [-centre[0], centre[1]];
            curves.push((other, Curve::Arc { centre, radius, from: turn(from), to: turn(to) }));
        }
        for tag in &e.tags {
            let name = half.boundaries[*tag].as_str();
            names.extend([(e.vertices, name), (other, name)]);
        }
    }
    Mesh::new(vertices, &quads, &curves, &names).unwrap()
}
