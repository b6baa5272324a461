//! What can be wrong with a contact problem.

use crate::side::Side;
use hpfem::Kinematics;

/// Wrong input, with the numbers that show it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The two boundaries do not lie on each other, or face each other.
    #[error(
        "the contact boundaries are {distance:.3e} apart at edge {edge} of the one with the contact points; give both bodies the same contact surface"
    )]
    Unmatched {
        /// Number of the edge along the path.
        edge: usize,
        /// Distance to the other boundary.
        distance: f64,
    },
    /// A body was reduced to no boundary.
    #[error("the {} keeps no boundary: name its contact surface by `BodyProblem::keep`", side.words())]
    NothingKept {
        /// The body.
        side: Side,
    },
    /// Two bodies that do not mean the same by their coordinates or forces, or of unlike thickness.
    #[error(
        "bodies in contact need the same coordinates, as many components of the displacement and the same thickness: plane stress and plane strain go together, {:?} and {:?} do not",
        kinematics[0], kinematics[1]
    )]
    Unlike {
        /// Those of both bodies.
        kinematics: [Kinematics; 2],
    },
    /// A body has no normal and tangential displacement.
    #[error("the {} has no displacement along a normal: reduce it as an elastic body", side.words())]
    NoNormal {
        /// The body.
        side: Side,
        /// Its kinematics.
        kinematics: Kinematics,
    },
    /// A body with its rigid edge held can still move.
    #[error("the {} is not held although its rigid edge is", side.words())]
    NotHeld {
        /// The body.
        side: Side,
    },
    /// A body has no displacement around an axis.
    #[error("the {} has no displacement around an axis: reduce it in `Kinematics::Torsion`", side.words())]
    NoTurn {
        /// The body.
        side: Side,
        /// Its kinematics.
        kinematics: Kinematics,
    },
    /// A body can turn about the axis.
    #[error("the {} can turn about the axis: hold it there against turning", side.words())]
    FreeToTurn {
        /// The body.
        side: Side,
    },
    /// Limits of friction, slips or turn of a twist are wrong.
    #[error(
        "a twist needs a finite angle or torque, and for each of the {points} contact points a limit of at least 0 and a slip; {given} were given"
    )]
    Twist {
        /// Number of values given.
        given: usize,
        /// Number of contact points.
        points: usize,
    },
    /// The gap does not fit the contact points.
    #[error("the gap needs one finite value for each of the {points} contact points; {given} were given")]
    Gap {
        /// Number of values given.
        given: usize,
        /// Number of contact points.
        points: usize,
    },
    /// The load factors do not fit the load cases.
    #[error("body {body} has {cases} load cases and needs as many finite factors; {given} were given")]
    Factors {
        /// 1 or 2.
        body: usize,
        /// Number of factors given.
        given: usize,
        /// Number of load cases.
        cases: usize,
    },
    /// Coefficient or directions of friction are wrong.
    #[error(
        "friction needs a coefficient of at least 0 (it is {coefficient}) and a drag within -1..=1 for each of the {points} contact points; {given} were given"
    )]
    Drag {
        /// Coefficient of friction.
        coefficient: f64,
        /// Number of directions given.
        given: usize,
        /// Number of contact points.
        points: usize,
    },
    /// What shares the frictional heat is out of its range.
    #[error("a share of heat lies within 0..=1, and a conductance is at least 0; it is {value}")]
    HeatSplit {
        /// Share or conductance.
        value: f64,
    },
    /// The points held in contact cannot hold the bodies.
    #[error("the points held in contact cannot balance the load: the linear system is singular")]
    Singular,
    /// Friction is asked of an operator made without shear, or of a compliance that has none.
    #[error("the contact knows no shear; friction needs an operator made with shear, or a compliance along normals and tangents")]
    ShearNotPrepared,
    /// The pivoting method knows no stick and slip.
    #[error("stick and slip are not solved by pivoting: use `solve`")]
    StickBySolve,
    /// A matrix or list has the wrong size.
    #[error("the {name} must be {} x {}; it is {} x {}", wanted[0], wanted[1], given[0], given[1])]
    Shape {
        /// What it is.
        name: &'static str,
        /// Rows and columns it should have.
        wanted: [usize; 2],
        /// Rows and columns it has.
        given: [usize; 2],
    },
    /// An entry of a matrix is not a finite number.
    #[error("the {name} is not finite in row {row}, column {column}")]
    NotFinite {
        /// Which matrix.
        name: &'static str,
        /// Row, from 0.
        row: usize,
        /// Column, from 0.
        column: usize,
    },
    /// A matrix that must be symmetric is not.
    #[error(
        "the {name} is not symmetric: {below:e} in row {row}, column {column}, {above:e} across; take half the sum with its transpose if that is \
         an error of discretisation"
    )]
    NotSymmetric {
        /// Which matrix.
        name: &'static str,
        /// Row, from 0.
        row: usize,
        /// Column, from 0.
        column: usize,
        /// Entry there.
        below: f64,
        /// Entry in row `column`, column `row`.
        above: f64,
    },
    /// A number that must be above 0 (on a diagonal, or a weight) is not.
    #[error("the {name} must be above 0 at place {place}; it is {value:e}")]
    NotPositive {
        /// Which matrix or list.
        name: &'static str,
        /// Place on the diagonal or in the list, from 0.
        place: usize,
        /// Number there.
        value: f64,
    },
    /// A stiffness has no inverse with positive energies.
    #[error("the stiffness is not positive definite; hold the bodies, and give the motions they are free to make as motions")]
    NotDefinite,
}
