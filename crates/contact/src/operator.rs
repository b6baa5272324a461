//! The contact of a pair of bodies, prepared once: compliance at the contact points.

use crate::error::Error;
use crate::held_points::HeldPoints;
use crate::lcp::Complementarity;
use crate::load::{ContactLoad, Friction};
use crate::matrices::Matrices;
use crate::pair::Pair;
use crate::point::ContactPoint;
use crate::products::rows_of;
use crate::response::Response;
use crate::segment::Station;
use crate::side::Side;
use crate::solution::ContactSolution;
use faer::Mat;
use hpfem::InterfaceOperator;
use std::sync::{Arc, Mutex, OnceLock};

/// Compliance of a pair at its contact points; every gap, load, coefficient of friction or prescribed motion reuses it.
///
/// `opening = gap + u_1 . n - u_2 . n = d + C lambda + C_nt sigma + Psi y`, with nodal normal forces `lambda >= 0`, nodal shear forces `sigma`
/// on body 1 and rigid coordinates `y`.
pub struct ContactOperator<'a> {
    pub(crate) pair: Pair<'a>,
    pub(crate) unit: Arc<UnitResponses>,
}

/// What a pair does under unit forces at its contact points: plain numbers that outlive the references of a [`ContactOperator`], for whoever
/// keeps the bodies elsewhere. The bodies are factorised at once; the compliance of all points is worked out when it is asked for first.
pub struct UnitResponses {
    pub(crate) points: Vec<ContactPoint>,
    pub(crate) stations: Vec<Station>,
    pub(crate) responses: Vec<Response>,
    /// Opening and slip by the coordinates of both bodies side by side, `points x coordinates`; no slip if shear was not asked for.
    pub(crate) influence: Mat<f64>,
    pub(crate) shear_influence: Option<Mat<f64>>,
    /// Those of all points.
    whole: OnceLock<Arc<Matrices>>,
    /// The points held last, with their matrices.
    pub(crate) held: Mutex<Option<Arc<HeldPoints>>>,
}

/// `[1, -1]`: sign of a body's displacement in the opening and of the contact force on it.
pub(crate) const SIGNS: [f64; 2] = [1.0, -1.0];

impl<'a> ContactOperator<'a> {
    /// Factorises both bodies for unit forces at the contact points: normal ones, and tangential ones if `shear` is asked for.
    ///
    /// # Errors
    /// [`Error::NotHeld`] if a body with its rigid edge held could still move; [`Error::NoNormal`] for torsion and potentials.
    pub fn new(pair: &Pair<'a>, shear: bool) -> Result<ContactOperator<'a>, Error> {
        ContactOperator::made(pair, shear, None)
    }

    /// The same, the points expected in contact ([`Pair::points`]) being known: what stands at these alone, as in [`ContactOperator::solve_on`], costs
    /// least.
    ///
    /// # Errors
    /// As [`ContactOperator::new`]; [`Error::Gap`] for another number of points.
    pub fn near(pair: &Pair<'a>, shear: bool, near: &[bool]) -> Result<ContactOperator<'a>, Error> {
        ContactOperator::made(pair, shear, Some(near))
    }

    fn made(pair: &Pair<'a>, shear: bool, near: Option<&[bool]>) -> Result<ContactOperator<'a>, Error> {
        let (points, stations) = pair.stations();
        let near = near.map_or_else(|| vec![true; points.len()], <[bool]>::to_vec);
        if near.len() != points.len() {
            return Err(Error::Gap { given: near.len(), points: points.len() });
        }
        let mut responses = Vec::new();
        for side in [Side::Shaped, Side::Counter] {
            if let Some(body) = pair.side(side) {
                if body.kinematics.components() != 2 {
                    return Err(Error::NoNormal { side, kinematics: body.kinematics });
                }
                responses.push(Response::new(body, side, &near, &stations, shear)?);
            }
        }
        let side_by_side = |component: usize| {
            let columns: Vec<(usize, usize)> =
                responses.iter().enumerate().flat_map(|(b, r)| (0..r.motions.ncols()).map(move |j| (b, j))).collect();
            Mat::from_fn(points.len(), columns.len(), |i, j| {
                let (b, k) = columns[j];
                SIGNS[b] * responses[b].motion[component][(i, k)]
            })
        };
        let influence = side_by_side(0);
        let shear_influence = shear.then(|| side_by_side(1));
        let (whole, held) = Default::default();
        let unit = UnitResponses { points, stations, responses, influence, shear_influence, whole, held };
        Ok(ContactOperator { pair: *pair, unit: Arc::new(unit) })
    }

    /// The operator of a pair whose unit responses are known from an earlier [`ContactOperator::new`] on the same bodies.
    pub fn with(pair: &Pair<'a>, unit: Arc<UnitResponses>) -> ContactOperator<'a> {
        ContactOperator { pair: *pair, unit }
    }

    /// The unit responses, to be kept.
    pub fn unit_responses(&self) -> Arc<UnitResponses> {
        Arc::clone(&self.unit)
    }

    /// The contact points, in order along the boundary.
    pub fn points(&self) -> &[ContactPoint] {
        &self.unit.points
    }

    /// The bodies.
    pub fn pair(&self) -> &Pair<'a> {
        &self.pair
    }

    /// Normal compliance `C` at the points, `points x points`: opening by nodal normal forces with the rigid coordinates at zero.
    pub fn compliance(&self) -> &Mat<f64> {
        &self.unit.matrices().normal
    }

    /// Solves for a gap (one value a point, positive open) under a load, from an earlier solution if there is one.
    ///
    /// # Errors
    /// [`Error::Gap`], [`Error::Factors`], [`Error::Drag`], [`Error::ShearNotPrepared`] on wrong sizes; [`Error::Shape`] and [`Error::NotFinite`] for
    /// motions, slips before or an earlier solution that do not fit.
    pub fn solve(&self, gap: &[f64], load: &ContactLoad, warm_start: Option<&ContactSolution>) -> Result<ContactSolution, Error> {
        let stage = self.stage(gap, load)?;
        let warm = warm_start.map(|solution| stage.warm(solution, gap.len())).transpose()?;
        let ending = stage.plain.solve(&load.friction, warm, &|mu, read| self.with_friction(gap, load, mu, read))?;
        Ok(self.assemble(&stage, ending))
    }

    /// Solves with the exact active-set method alone, as a second opinion.
    ///
    /// # Errors
    /// As [`ContactOperator::solve`]; [`Error::StickBySolve`] for [`Friction::Coulomb`].
    pub fn solve_by_pivoting(&self, gap: &[f64], load: &ContactLoad) -> Result<ContactSolution, Error> {
        if matches!(load.friction, Friction::Coulomb { .. }) {
            return Err(Error::StickBySolve);
        }
        let stage = self.stage(gap, load)?;
        let answer = stage.plain.problem.solve_by_pivoting();
        Ok(self.assemble(&stage, stage.plain.judged(answer)))
    }

    /// Gives the problem of another coefficient of friction to `read`; sizes and numbers of the load were found right before.
    pub(crate) fn with_friction(
        &self,
        gap: &[f64],
        load: &ContactLoad,
        coefficient: f64,
        read: &mut dyn FnMut(&Complementarity<'_>),
    ) {
        let Friction::Sliding { drag, .. } = &load.friction else { return };
        let friction = Friction::Sliding { coefficient, drag: drag.clone() };
        if let Ok(stage) = self.stage(gap, &ContactLoad { friction, ..load.clone() }) {
            read(&stage.plain.problem);
        }
    }

    pub(crate) fn operator(&self, body: usize) -> &'a InterfaceOperator {
        match (body, self.pair.counter) {
            (1, Some(counter)) => counter,
            _ => self.pair.shaped,
        }
    }

    /// Motion of the shaped body's rigid edge that coordinate `j` is.
    pub(crate) fn edge_motion(&self, j: usize) -> Option<usize> {
        self.unit.responses[0].edge_motion.get(j).copied().flatten()
    }
}

impl UnitResponses {
    /// The matrices of all points.
    pub(crate) fn matrices(&self) -> &Arc<Matrices> {
        self.whole.get_or_init(|| Arc::new(self.matrices_at(&(0..self.points.len()).collect::<Vec<usize>>())))
    }

    /// The matrices of some of the points.
    pub(crate) fn matrices_at(&self, at: &[usize]) -> Matrices {
        let square = || Mat::zeros(at.len(), at.len());
        let mut normal = square();
        let mut sheared = self.shear_influence.as_ref().map(|_| [square(), square()]);
        for response in &self.responses {
            let (pressed, slid) = response.half_solved(at);
            pressed.add(&mut normal);
            if let (Some([by_shear, tangential]), Some(slid)) = (&mut sheared, slid) {
                pressed.add_by(&slid, by_shear);
                slid.add(tangential);
            }
        }
        let (normal_by_shear, tangential) = sheared.map(|[by_shear, tangential]| (by_shear, tangential)).unzip();
        let influence = rows_of(&self.influence, at);
        let shear_influence = self.shear_influence.as_ref().map(|all| rows_of(all, at));
        Matrices { normal, normal_by_shear, tangential, influence, shear_influence }
    }
}
