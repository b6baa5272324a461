//! Sectors of a corner, and displacement and traction in one of them by the coefficients of its corner solution (the formulas of `singular.rs`).

use crate::error::Error;
use crate::kinematics::Kinematics;
use crate::material::Material;
use nalgebra::Complex;

pub(crate) type C = Complex<f64>;

/// What holds on a face of a corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Face {
    /// No displacement prescribed.
    Free,
    /// All displacement components prescribed.
    Fixed,
    /// The component along this direction prescribed, given as angle from the face's own ray, radians: `pi / 2` for a roller.
    Held(f64),
}

/// One sector of a corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sector {
    /// Opening angle, radians.
    pub angle: f64,
    /// Its constants.
    pub constants: Constants,
}

/// Constants of an isotropic sector.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Constants {
    /// Young's modulus, MPa; for a potential twice the conductivity.
    pub young: f64,
    /// Poisson's ratio, no unit; zero for a potential.
    pub poisson: f64,
}

impl Constants {
    /// The constants of materials.
    ///
    /// # Errors
    /// [`Error::Anisotropic`]: the functions of this page are those of isotropic sectors.
    pub fn of(materials: &[Material], kinematics: Kinematics) -> Result<Vec<Constants>, Error> {
        let one = |material: &Material| {
            let known = match material.conductivity().filter(|_| kinematics.is_conduction()) {
                Some([[k, _], _]) if material.is_isotropic(kinematics) => Some(Constants { young: 2.0 * k, poisson: 0.0 }),
                Some(_) => None,
                None => material.young().zip(material.poisson()).map(|(young, poisson)| Constants { young, poisson }),
            };
            let reason = "exponents of corners are known for isotropic materials alone".to_string();
            known.ok_or(Error::Anisotropic { reason })
        };
        materials.iter().map(one).collect()
    }
}

/// Rows of displacement (first half) and traction (second half) of a sector by its coefficients; two of each of a scalar problem.
pub(crate) type State = [[C; 4]; 4];

/// Rows of displacement (first half) and traction (second half) of a sector at angle `t`, by its coefficients.
pub(crate) fn plane(l: C, sector: &Sector, t: f64, kinematics: Kinematics) -> State {
    let Constants { young, poisson: nu } = sector.constants;
    let plane_stress = matches!(kinematics, Kinematics::PlaneStress { .. });
    let kappa = if plane_stress { (3.0 - nu) / (1.0 + nu) } else { 3.0 - 4.0 * nu };
    // Coefficients in units that keep displacements and tractions near one for any modulus.
    let shear = young / (1.0 + nu);
    let unit = shear / (shear + 1.0);
    let ([cm, sm], [cp, sp]) = (cosine_and_sine((l - 1.0) * t), cosine_and_sine((l + 1.0) * t));
    let ratio = unit / shear;
    [
        [(-l + kappa) * cm, (-l + kappa) * sm, cp, sp].map(|v| v * ratio),
        [(l + kappa) * sm, -(l + kappa) * cm, -sp, cp].map(|v| v * ratio),
        [(l + 1.0) * cm, (l + 1.0) * sm, -cp, -sp].map(|v| v * l * unit),
        [(l - 1.0) * sm, -(l - 1.0) * cm, -sp, cp].map(|v| v * l * unit),
    ]
}

/// Cosine and sine of a complex number from one of each of its parts: `cos(x + iy) = cos x cosh y - i sin x sinh y`.
fn cosine_and_sine(z: C) -> [C; 2] {
    let ((sine, cosine), (hyperbolic_sine, hyperbolic_cosine)) = (z.re.sin_cos(), (z.im.sinh(), z.im.cosh()));
    [C::new(cosine * hyperbolic_cosine, -sine * hyperbolic_sine), C::new(sine * hyperbolic_cosine, cosine * hyperbolic_sine)]
}

/// `w = r^l (a cos(l t) + b sin(l t))`, `tau_tz = mu w_,t / r`.
pub(crate) fn antiplane(l: C, sector: &Sector, t: f64) -> State {
    let shear = 0.5 * sector.constants.young / (1.0 + sector.constants.poisson);
    let (zero, [c, s]) = (C::new(0.0, 0.0), cosine_and_sine(l * t));
    [[c, s, zero, zero], [-s * l * shear, c * l * shear, zero, zero], [zero; 4], [zero; 4]]
}

/// Conditions of a face on `[u.., traction..]`, as many as `rows`.
pub(crate) fn condition(face: Face, state: &State, rows: usize) -> [[C; 4]; 2] {
    let mix = |a: &[C; 4], x: f64, b: &[C; 4], y: f64| std::array::from_fn(|k| a[k] * x + b[k] * y);
    match face {
        Face::Fixed => [state[0], state[1]],
        Face::Free => [state[rows], state[(rows + 1) % 4]],
        Face::Held(_) if rows == 1 => [state[0], state[1]],
        Face::Held(angle) => {
            let (s, c) = angle.sin_cos();
            // Tractions are (s_tt along t, s_rt along r).
            [mix(&state[0], c, &state[1], s), mix(&state[3], -s, &state[2], c)]
        }
    }
}
