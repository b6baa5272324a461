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

/// Load cases that follow nodal normal forces, as what each does and what it follows; where they are as many as the points, forces stand for them.
pub(crate) struct Followers {
    /// What a unit of each does; its points are the cases.
    pub(crate) by_case: Followed,
    /// Their factors by nodal normal forces, `cases x points`.
    pub(crate) factors: Mat<f64>,
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
        self.check_following(load)?;
        Ok(Some(self.done_by(&load.following, self.unit.points.len())))
    }

    /// The same one by one; none where nothing follows.
    pub(crate) fn followers(&self, load: &ContactLoad) -> Result<Option<Followers>, Error> {
        self.check_following(load)?;
        let n = self.unit.points.len();
        let mut cases = Vec::new();
        for (b, following) in load.following.iter().enumerate() {
            let Some(following) = following else { continue };
            let follows = |row: &usize| (0..n).any(|j| following[(*row, j)] != 0.0);
            cases.extend((0..following.nrows()).filter(follows).map(|row| (b, row)));
        }
        let many = cases.len();
        if many >= n {
            return Ok(Some(Followers { by_case: self.done_by(&load.following, n), factors: Mat::identity(n, n) }));
        }
        let unit = |b: usize, following: &Mat<f64>| {
            Mat::from_fn(following.nrows(), many, |row, k| f64::from(u8::from(cases[k] == (b, row))))
        };
        let of = |b: usize| load.following[b].as_ref();
        let factors = Mat::from_fn(many, n, |k, j| of(cases[k].0).map_or(0.0, |following| following[(cases[k].1, j)]));
        let units = [0, 1].map(|b| of(b).map(|following| unit(b, following)));
        Ok((many > 0).then(|| Followers { by_case: self.done_by(&units, many), factors }))
    }

    /// What the load cases of both bodies do, given their factors by each of so many quantities.
    fn done_by(&self, following: &[Option<Mat<f64>>; 2], many: usize) -> Followed {
        let mut opening = Mat::zeros(self.unit.points.len(), many);
        let mut forces = Vec::new();
        for ((b, response), following) in self.unit.responses.iter().enumerate().zip(following) {
            let coordinates = response.motions.ncols();
            let Some(following) = following else {
                forces.push(Mat::zeros(coordinates, many));
                continue;
            };
            let (moved, cases) = (response.normal_by_columns(), following.nrows());
            opening += faer::Scale(SIGNS[b]) * (moved.subcols(0, cases) * following);
            forces.push(response.motion_columns.submatrix(0, 0, coordinates, cases) * following);
        }
        let rows: Vec<(usize, usize)> =
            forces.iter().enumerate().flat_map(|(b, m)| (0..m.nrows()).map(move |row| (b, row))).collect();
        let forces = Mat::from_fn(many, rows.len(), |i, j| forces[rows[j].0][(rows[j].1, i)]);
        Followed { opening, forces }
    }

    /// Refuses matrices of other shapes, and with entries that are no numbers.
    fn check_following(&self, load: &ContactLoad) -> Result<(), Error> {
        let n = self.unit.points.len();
        for (b, following) in load.following.iter().enumerate().take(self.unit.responses.len()) {
            let Some(following) = following else { continue };
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
        }
        Ok(())
    }
}
