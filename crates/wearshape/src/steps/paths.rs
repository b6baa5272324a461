//! Displacement, stress and temperature along lines through the bodies.

use hpfem::{Field, PointSearch, Stress};
use scene::Fault;

use crate::parts::Parts;
use crate::path_profile::PathProfile;
use crate::problem::{Path, Problem};
use crate::steps::heat::fields::Warm;

/// The fields of both bodies at the reported moment.
pub(crate) struct Sources<'a> {
    /// Displacement and stress.
    pub fields: &'a [Field; 2],
    /// Twist about the axis.
    pub twists: Option<&'a [Field; 2]>,
    /// Temperature.
    pub warm: Option<&'a Warm>,
    /// The plane of symmetry x = middle, where the half beyond it alone was computed.
    pub mirror: Option<f64>,
}

/// Refuses lines that leave their bodies.
pub(crate) fn check(problem: &Problem, parts: &Parts, mirror: Option<f64>) -> Result<(), Fault> {
    for path in &problem.paths {
        let mesh = parts.parts[path.body].mesh();
        let search = PointSearch::new(mesh);
        for &(s, x) in &path.places {
            search.locate(seen(x, mirror).0).map_err(|_| left(path, s, x))?;
        }
    }
    Ok(())
}

/// The numbers along all lines.
pub(crate) fn along(paths: &[Path], sources: &Sources<'_>) -> Result<Vec<PathProfile>, Fault> {
    paths.iter().map(|path| sources.along(path)).collect()
}

impl Sources<'_> {
    fn along(&self, path: &Path) -> Result<PathProfile, Fault> {
        let field = &self.fields[path.body];
        let mut found = PathProfile {
            name: path.name.clone(),
            body: path.body + 1,
            revolved: field.kinematics().is_revolved(),
            twisted: self.twists.is_some(),
            ..PathProfile::default()
        };
        for &(s, x) in &path.places {
            let (place, sign) = seen(x, self.mirror);
            let failed = |_| left(path, s, x);
            let (cell, xi, eta) = field.locate(place).map_err(failed)?;
            let state = field.at(cell, xi, eta).map_err(failed)?;
            let mut stress = Stress::new(state.stress, [0.0; 2]);
            stress.xz *= sign;
            let mut around = 0.0;
            if let Some(twist) = self.twists.map(|twists| &twists[path.body]) {
                let twisted = twist.at(cell, xi, eta).map_err(failed)?;
                around = twisted.displacement[0];
                (stress.xy, stress.yz) = (twisted.stress[0], twisted.stress[1]);
            }
            found.s.push(s);
            found.position.push(x);
            found.displacement.push([sign * state.displacement[0], around, state.displacement[1]]);
            found.stress.push(stress);
            if let Some(warm) = self.warm {
                found.temperature.push(warm.at(path.body, (cell, xi, eta), place)?);
            }
        }
        Ok(found)
    }
}

/// Where a point is found, and the sign of what changes it in a mirror.
fn seen([x, z]: [f64; 2], mirror: Option<f64>) -> ([f64; 2], f64) {
    match mirror {
        Some(middle) if x < middle => ([2.0 * middle - x, z], -1.0),
        _ => ([x, z], 1.0),
    }
}

fn left(path: &Path, s: f64, [x, z]: [f64; 2]) -> Fault {
    let message = format!(
        "the path `{}` leaves body {}: ({x}, {z}), {} mm from its beginning, lies outside",
        path.name,
        path.body + 1,
        scene::short(s)
    );
    Fault::at(
        path.key.clone(),
        "outside",
        message,
        "keep it inside the body as it is drawn; end it at a hole and begin another one behind it",
    )
}
