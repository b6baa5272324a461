//! Triangles: shape functions, quadrature and the blended map.
//!
//! With the barycentric coordinates `l_0, l_1, l_2` and the kernels `K_k(a, b)`, the homogeneous polynomials of degree `k - 2` with
//! `a b K_k(a, b) = (a + b)^k N_k((b - a) / (a + b))`, the modes of degree `p` are (Szabo and Babuska 1991, sec. 6.1; the interior ones after
//! Karniadakis and Sherwin 2005, sec. 3.2)
//!
//! ```text
//! corners    l_i
//! edges      l_i l_j K_k(l_i, l_j)                                    k = 2 .. p
//! interior   l_0 l_1 l_2 K_k(l_0, l_1) P_m^(2k-1,1)(2 l_2 - 1)        k = 2 .. p-1,  m = 0 .. p-1-k
//! ```
//!
//! On its edge an edge mode is `N_k`, the mode of a quadrilateral there, so triangles and quadrilaterals meet. An edge curve with the offset
//! `E(t)` from its chord moves the triangle by `l_i l_j kappa(l_j - l_i)`, `kappa = 4 E / (1 - t^2)`, which is smooth up to the corners.
//!
//! Derivatives are by `l_1` and `l_2`. Points are also given in the collapsed square `[-1, 1]^2`, where the side `eta = 1` is corner 2:
//! `l_0 = (1-xi)(1-eta)/4`, `l_1 = (1+xi)(1-eta)/4`, `l_2 = (1+eta)/2`.

use crate::curve::Curve;
use crate::quadrature::gauss;

/// A number with its derivatives by `l_1` and `l_2`.
pub(crate) type Jet = [f64; 3];

/// Start and end of the edges of a triangle: local edges 0, 1 and 3.
const EDGES: [[usize; 2]; 3] = [[0, 1], [1, 2], [0, 2]];

/// Derivatives of the barycentric coordinates.
const SLOPES: [[f64; 2]; 3] = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];

fn times(a: Jet, b: Jet) -> Jet {
    [a[0] * b[0], a[1] * b[0] + a[0] * b[1], a[2] * b[0] + a[0] * b[2]]
}

fn sum(x: f64, a: Jet, y: f64, b: Jet) -> Jet {
    std::array::from_fn(|i| x * a[i] + y * b[i])
}

/// `K_2 .. K_highest`, by the recurrence of the Gegenbauer polynomials `C_n = P'_{n+1}` made homogeneous.
fn kernels(highest: usize, a: Jet, b: Jet) -> Vec<Jet> {
    let (t, s) = (sum(1.0, b, -1.0, a), sum(1.0, a, 1.0, b));
    let square = times(s, s);
    let mut c = vec![[1.0, 0.0, 0.0], t.map(|v| 3.0 * v)];
    for n in 2..highest.max(3) - 1 {
        let m = n as f64;
        c.push(sum((2.0 * m + 1.0) / m, times(t, c[n - 1]), -(m + 1.0) / m, times(square, c[n - 2])));
    }
    let scale = |k: usize| -2.0 * ((2 * (2 * k - 1)) as f64).sqrt() / (k * (k - 1)) as f64;
    (2..=highest).map(|k| c[k - 2].map(|v| v * scale(k))).collect()
}

/// Jacobi polynomials `P_0^(a,b) .. P_highest^(a,b)` (Abramowitz and Stegun 22.7.1).
fn jacobi(highest: usize, a: f64, b: f64, x: Jet) -> Vec<Jet> {
    let one = [1.0, 0.0, 0.0];
    let mut p = vec![one, sum(0.5 * (a - b), one, 0.5 * (a + b + 2.0), x)];
    for n in 1..highest {
        let k = n as f64;
        let s = 2.0 * k + a + b;
        let factor = sum((s + 1.0) * (a * a - b * b), one, s * (s + 1.0) * (s + 2.0), x);
        let next = sum(1.0, times(factor, p[n]), -2.0 * (k + a) * (k + b) * (s + 2.0), p[n - 1]);
        p.push(next.map(|v| v / (2.0 * (k + 1.0) * (k + a + b + 1.0) * s)));
    }
    p
}

/// All modes of degree `degree` at a point: interior, corners, edges 0, 1 and 3.
pub(crate) fn triangle_modes(degree: usize, l: [f64; 3]) -> Vec<Jet> {
    let l: [Jet; 3] = std::array::from_fn(|i| [l[i], SLOPES[i][0], SLOPES[i][1]]);
    let mut modes = Vec::with_capacity((degree + 1) * (degree + 2) / 2);
    let edges = EDGES.map(|[i, j]| (times(l[i], l[j]), kernels(degree, l[i], l[j])));
    let bubble = times(edges[0].0, l[2]);
    let x = sum(2.0, l[2], -1.0, [1.0, 0.0, 0.0]);
    for k in 2..degree {
        let base = times(bubble, edges[0].1[k - 2]);
        let along = jacobi(degree - 1 - k, (2 * k - 1) as f64, 1.0, x);
        modes.extend(along[..degree - k].iter().map(|p| times(base, *p)));
    }
    modes.extend(l);
    for (ends, kernels) in &edges {
        modes.extend(kernels.iter().map(|k| times(*ends, *k)));
    }
    modes
}

/// Barycentric coordinates of a point of the collapsed square.
pub(crate) fn barycentric(xi: f64, eta: f64) -> [f64; 3] {
    let c = 0.25 * (1.0 - eta);
    [c * (1.0 - xi), c * (1.0 + xi), 0.5 * (1.0 + eta)]
}

/// The point of the collapsed square; the collapsed corner itself is at `xi = 0`.
pub(crate) fn collapsed(l: [f64; 3]) -> (f64, f64) {
    let s = l[0] + l[1];
    (if s > 0.0 { (l[1] - l[0]) / s } else { 0.0 }, 2.0 * l[2] - 1.0)
}

/// Gauss points of the collapsed square as barycentric coordinates, and weights for the area element `dl_1 dl_2`.
pub(crate) fn triangle_rule(points: usize) -> (Vec<[f64; 3]>, Vec<f64>) {
    // One more point takes the factor 1 - eta of the area.
    let (along, across) = (gauss(points), gauss(points + 1));
    let mut rule = (Vec::new(), Vec::new());
    for (eta, v) in across.points.iter().zip(&across.weights) {
        for (xi, w) in along.points.iter().zip(&along.weights) {
            rule.0.push(barycentric(*xi, *eta));
            rule.1.push(0.125 * v * w * (1.0 - eta));
        }
    }
    rule
}

/// The blended map of a triangle with the given corners and edges 0, 1 and 3: position and `[[x_1, x_2], [z_1, z_2]]`.
pub(crate) fn triangle_map(corners: [[f64; 2]; 3], edges: &[Curve; 3], l: [f64; 3]) -> ([f64; 2], [[f64; 2]; 2]) {
    let mut x: [f64; 2] = std::array::from_fn(|i| (0..3).map(|k| l[k] * corners[k][i]).sum());
    let mut d: [[f64; 2]; 2] = std::array::from_fn(|i| [1, 2].map(|k| corners[k][i] - corners[0][i]));
    for ([i, j], curve) in EDGES.iter().zip(edges).filter(|(_, curve)| !curve.is_straight()) {
        let (kernel, slope) = offset_kernel(curve, l[*j] - l[*i]);
        let product = l[*i] * l[*j];
        for c in 0..2 {
            x[c] += product * kernel[c];
            for k in 0..2 {
                let (si, sj) = (SLOPES[*i][k], SLOPES[*j][k]);
                d[c][k] += (si * l[*j] + l[*i] * sj) * kernel[c] + product * slope[c] * (sj - si);
            }
        }
    }
    (x, d)
}

/// `kappa = 4 E / (1 - t^2)` and its derivative, `E` being the offset of a curve from its chord.
fn offset_kernel(curve: &Curve, t: f64) -> ([f64; 2], [f64; 2]) {
    let (start, end) = (curve.point(-1.0), curve.point(1.0));
    let q = (1.0 - t) * (1.0 + t);
    if q < 1e-7 {
        // The limit at the end; its derivative is only ever multiplied by something smaller than q.
        let side = t.signum();
        let d = curve.derivative(side);
        return (std::array::from_fn(|i| -2.0 * side * (d[i] - 0.5 * (end[i] - start[i]))), [0.0; 2]);
    }
    let (x, d) = (curve.point(t), curve.derivative(t));
    let offset = |i: usize| x[i] - 0.5 * ((1.0 - t) * start[i] + (1.0 + t) * end[i]);
    let kernel = [0, 1].map(|i| 4.0 * offset(i) / q);
    let slope = [0, 1].map(|i| (4.0 * (d[i] - 0.5 * (end[i] - start[i])) + 2.0 * t * kernel[i]) / q);
    (kernel, slope)
}
