//! Load cases whose factors follow the pressure, as those of frictional heat do: what they add to the compliance of a contact.

use crate::error::Error;
use crate::load::ContactLoad;
use crate::operator::{ContactOperator, SIGNS};
use crate::products::rows_of;
use faer::Mat;

/// What load cases do that follow nodal normal forces.
pub(crate) struct Followed {
    /// Opening at the points by nodal normal forces, `points x points`.
    pub(crate) opening: Mat<f64>,
    /// Force along each coordinate by nodal normal forces, `points x coordinates`.
    pub(crate) forces: Mat<f64>,
}

impl Followed {
    /// The same at some of the points.
    pub(crate) fn at(&self, at: &[usize]) -> Followed {
        Followed {
            opening: Mat::from_fn(at.len(), at.len(), |i, j| self.opening[(at[i], at[j])]),
            forces: rows_of(&self.forces, at),
        }
    }
}

const FOLLOWING: &str = "matrix of the load cases that follow the pressure";

impl ContactOperator<'_> {
    /// Opening at the points by unit normal forces through the load cases that follow them, `points x points`, rigid coordinates at zero; zero where
    /// nothing follows.
    ///
    /// # Errors
    /// [`Error::Shape`] and [`Error::NotFinite`] of [`ContactLoad::following`].
    pub fn opening_by_following(&self, load: &ContactLoad) -> Result<Mat<f64>, Error> {
        let n = self.unit.points.len();
        Ok(self.followed(load)?.map_or_else(|| Mat::zeros(n, n), |followed| followed.opening))
    }

    /// What follows the nodal normal forces of a load; none where nothing does.
    pub(crate) fn followed(&self, load: &ContactLoad) -> Result<Option<Followed>, Error> {
        if load.following.iter().all(Option::is_none) {
            return Ok(None);
        }
        let n = self.unit.points.len();
        let mut opening = Mat::zeros(n, n);
        let mut forces = Vec::new();
        for (b, response) in self.unit.responses.iter().enumerate() {
            let coordinates = response.motions.ncols();
            let Some(following) = &load.following[b] else {
                forces.push(Mat::zeros(coordinates, n));
                continue;
            };
            let cases = self.operator(b).load_cases.len();
            if following.nrows() != cases || following.ncols() != n {
                let given = [following.nrows(), following.ncols()];
                return Err(Error::Shape { name: FOLLOWING, wanted: [cases, n], given });
            }
            for (column, values) in following.col_iter().enumerate() {
                if let Some(row) = values.iter().position(|v| !v.is_finite()) {
                    return Err(Error::NotFinite { name: FOLLOWING, row, column });
                }
            }
            let unknowns = response.to_columns.nrows();
            let moved = response.normal.product(&(response.to_columns.submatrix(0, 0, unknowns, cases) * following));
            opening += faer::Scale(SIGNS[b]) * moved;
            forces.push(response.motion_columns.submatrix(0, 0, coordinates, cases) * following);
        }
        let rows: Vec<(usize, usize)> =
            forces.iter().enumerate().flat_map(|(b, m)| (0..m.nrows()).map(move |row| (b, row))).collect();
        let forces = Mat::from_fn(n, rows.len(), |i, j| forces[rows[j].0][(rows[j].1, i)]);
        Ok(Some(Followed { opening, forces }))
    }
}
