//! How body 1 stands on body 2 in a picture: its rigid motion and its finished surface, which its displacements leave out.

use wearshape::{Problem, Profile};

use crate::contact_line::ContactLine;

/// The rigid motion of body 1 with its gap.
pub(crate) struct Touch<'a> {
    line: ContactLine<'a>,
    gap: Vec<f64>,
    normal: Vec<[f64; 2]>,
    /// Shift along x and z (mm), and rotation (rad), positive clockwise in the picture.
    rigid: [f64; 3],
    about: [f64; 2],
    /// Distance from the contact at which the finished surface is no longer seen (mm).
    depth: f64,
    /// Mean gap of the points in contact where the gap is the form of the bodies (mm); none where it is machined or worn into body 1.
    own_form: Option<f64>,
}

impl<'a> Touch<'a> {
    /// What closes the opening at the contact points: opening - gap - (u1 - u2) . n is rigid. None without displacements.
    pub(crate) fn new(problem: &Problem, profile: &'a Profile) -> Option<Touch<'a>> {
        let line = ContactLine::new(&profile.position, &profile.pressure)?;
        let normal: Vec<[f64; 2]> = profile.normal.iter().map(|n| [n[0], n[2]]).collect();
        let [first, second] = &profile.normal_displacement;
        let closed = |k: usize| 1e-3 * (profile.opening[k] - profile.gap[k] - first[k] + second[k]);
        let gap: Vec<f64> = profile.gap.iter().map(|gap| 1e-3 * gap).collect();
        let all = profile.s.len();
        if (0..all).any(|k| !closed(k).is_finite()) {
            return None;
        }
        let total: f64 = profile.weight.iter().sum();
        let mean = |c: usize| (0..all).map(|k| profile.weight[k] * profile.position[k][c]).sum::<f64>() / total;
        let about = [mean(0), mean(2)];
        let revolved = problem.scene().kinematics == Some(scene::Kinematics::Axisymmetric);
        let reach =
            (0..all).map(|k| (profile.position[k][0] - about[0]).hypot(profile.position[k][2] - about[1])).fold(0.0, f64::max);
        let row = |k: usize| {
            let [x, z] = [profile.position[k][0] - about[0], profile.position[k][2] - about[1]];
            let turned = (z * normal[k][0] - x * normal[k][1]) / reach;
            if revolved { [0.0, normal[k][1], 0.0] } else { [normal[k][0], normal[k][1], turned] }
        };
        let [x, z, turn] = least_squares((0..all).map(|k| (row(k), closed(k), profile.weight[k] / total)));
        let pressed: Vec<usize> = (0..all).filter(|k| profile.pressure[*k] > 0.0).collect();
        let force: f64 = pressed.iter().map(|k| profile.weight[*k]).sum();
        let own = pressed.iter().map(|k| profile.weight[*k] * gap[*k]).sum::<f64>() / force;
        let own_form = problem.contact_shape().is_none().then_some(if own.is_finite() { own } else { 0.0 });
        Some(Touch { line, gap, normal, rigid: [x, z, turn / reach], about, depth: 2.0 * reach, own_form })
    }

    /// What body 1 is moved by at a place, beyond its displacement, all magnified.
    pub(crate) fn shift(&self, place: [f64; 2], magnified: f64) -> [f64; 2] {
        let [x, z] = [place[0] - self.about[0], place[1] - self.about[1]];
        let rigid = [self.rigid[0] + self.rigid[2] * z, self.rigid[1] - self.rigid[2] * x].map(|u| magnified * u);
        let (row, share, distance) = self.line.nearest(place);
        if let Some(gap) = self.own_form {
            // The form of the bodies is not magnified: without this they would lie within one another.
            return [rigid[0], rigid[1] + (magnified - 1.0) * gap];
        }
        let share = share.clamp(0.0, 1.0);
        let between = |a: f64, b: f64| (1.0 - share) * a + share * b;
        let gap = between(self.gap[row], self.gap[row + 1]) * (1.0 - distance / self.depth).max(0.0);
        [0, 1].map(|c| rigid[c] + magnified * gap * between(self.normal[row][c], self.normal[row + 1][c]))
    }
}

/// Three numbers that fit rows of coefficients to values by their weights; what no row determines is zero.
fn least_squares(rows: impl Iterator<Item = ([f64; 3], f64, f64)>) -> [f64; 3] {
    let (mut a, mut b) = ([[0.0; 3]; 3], [0.0; 3]);
    for (row, value, weight) in rows {
        for i in 0..3 {
            b[i] += weight * row[i] * value;
            (0..3).for_each(|j| a[i][j] += weight * row[i] * row[j]);
        }
    }
    let ridge = 1e-9 * (a[0][0] + a[1][1] + a[2][2]);
    (0..3).for_each(|i| a[i][i] += ridge);
    for i in 0..3 {
        for k in i + 1..3 {
            let factor = a[k][i] / a[i][i];
            (i..3).for_each(|j| a[k][j] -= factor * a[i][j]);
            b[k] -= factor * b[i];
        }
    }
    let mut x = [0.0; 3];
    for i in (0..3).rev() {
        let known: f64 = (i + 1..3).map(|j| a[i][j] * x[j]).sum();
        x[i] = (b[i] - known) / a[i][i];
    }
    x
}

#[cfg(test)]
mod tests {
    use super::least_squares;

    #[test]
    fn a_rigid_motion_is_found_and_what_nothing_shows_is_zero() {
        let rows = (0..11).map(|k| 0.2 * f64::from(k) - 1.0).map(|x| ([0.0, 1.0, -x], 0.3 - 0.1 * x, 1.0));
        let [x, z, turn] = least_squares(rows);
        assert!(x == 0.0 && (z - 0.3).abs() < 1e-6 && (turn - 0.1).abs() < 1e-6, "{x} {z} {turn}");
    }
}
