//! What can be wrong with a problem handed to this crate.

/// Wrong input, with the numbers that show it.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A cell's map is folded or has no area.
    #[error(
        "cell {cell} is folded or degenerate: its Jacobian is {jacobian:.3e} at ({x:.6}, {z:.6}); its corners must run anti-clockwise with every angle below 180 degrees"
    )]
    FoldedCell {
        /// Index of the cell.
        cell: usize,
        /// Value of the Jacobian determinant, mm^2.
        jacobian: f64,
        /// First coordinate of the place, mm.
        x: f64,
        /// Second coordinate of the place, mm.
        z: f64,
    },
    /// An edge's curve does not join the edge's vertices.
    #[error("the curve given for the edge {a}-{b} misses its vertices by {distance:.3e}")]
    CurveMissesVertex {
        /// First vertex.
        a: usize,
        /// Second vertex.
        b: usize,
        /// Largest distance between curve end and vertex, mm.
        distance: f64,
    },
    /// An edge named in a curve or boundary is not an edge of any cell.
    #[error("{a}-{b} is not an edge of any cell")]
    NoSuchEdge {
        /// First vertex.
        a: usize,
        /// Second vertex.
        b: usize,
    },
    /// A boundary name that the mesh does not have.
    #[error("the mesh has no boundary \"{name}\"; it has: {known}")]
    NoSuchBoundary {
        /// The name asked for.
        name: String,
        /// The names there are.
        known: String,
    },
    /// A degree outside the supported range.
    #[error("degree {degree} of cell {cell} is outside 1..={max}", max = crate::MAX_DEGREE)]
    Degree {
        /// Index of the cell.
        cell: usize,
        /// Its degree.
        degree: usize,
    },
    /// A material that cannot exist.
    #[error("Young's modulus {young} must be positive and Poisson's ratio {poisson} must be in (-1, 0.5)")]
    Material {
        /// Young's modulus, MPa.
        young: f64,
        /// Poisson's ratio, no unit.
        poisson: f64,
    },
    /// The body can move without strain and neither a support nor the kept boundary holds it.
    #[error("the body is not held: {motion}; add a support against it, or keep a boundary that it moves")]
    NotHeld {
        /// The free motion in words, as in "it can slide along the first axis".
        motion: String,
    },
    /// Elimination met a pivot without stiffness although the body is held.
    #[error(
        "elimination met a pivot without stiffness at {place}: moduli, lengths or degrees there are too far apart for the digits there are"
    )]
    NoStiffness {
        /// Words for the place.
        place: String,
    },
    /// The loads work on a motion that nothing holds.
    #[error(
        "the loads do not balance: nothing holds the body, {motion}, and the load along that motion is {load:.3e}; add a support, or balance the loads"
    )]
    Unbalanced {
        /// The free motion in words.
        motion: String,
        /// Work of the loads on a unit of the motion, N or N mm.
        load: f64,
    },
    /// One displacement component is prescribed twice, with two values.
    #[error(
        "\"{boundary}\" prescribes {value:e} at {place}, where another support prescribes {known:e} along the same direction"
    )]
    HeldTwice {
        /// The boundary of the second support.
        boundary: String,
        /// Words for the place.
        place: String,
        /// What it prescribes, mm.
        value: f64,
        /// What the other supports prescribe along its direction, mm.
        known: f64,
    },
    /// A support or pin at a vertex of the rigid edge, against one of its free motions or with a displacement.
    #[error(
        "{boundary} holds the rigid edge at {place}, where it is free to move, or moves it; say so by the free motions of the rigid edge"
    )]
    TiedAndHeld {
        /// The boundary of the support.
        boundary: String,
        /// Words for the place.
        place: String,
    },
    /// A support, load or rigid edge that the kinematics has no meaning for.
    #[error("{what} has no meaning in {kinematics}")]
    NoMeaning {
        /// What was given.
        what: String,
        /// The kinematics in words.
        kinematics: &'static str,
    },
    /// A load case that the body does not have.
    #[error("the body has no load case \"{name}\"; it has: {known}")]
    NoSuchLoadCase {
        /// The name asked for.
        name: String,
        /// The names there are.
        known: String,
    },
    /// An iteration that did not settle.
    #[error("{what} did not settle within {steps} steps")]
    NotConverged {
        /// What was sought.
        what: &'static str,
        /// The number of steps.
        steps: usize,
    },
    /// Parts of an interface operator that contradict each other.
    #[error("the parts of the interface operator do not fit: {what}")]
    Inconsistent {
        /// What is wrong.
        what: &'static str,
    },
    /// Two load cases of one name.
    #[error("there are two load cases \"{name}\"; give each a name of its own")]
    DuplicateLoadCase {
        /// The name.
        name: String,
    },
    /// A state that belongs to other load cases than the body has now.
    #[error("the state has {given} factors, but the body has {expected} right-hand sides: solve again after adding loads")]
    OtherLoads {
        /// Number of factors of the state.
        given: usize,
        /// Number of right-hand sides of the body.
        expected: usize,
    },
    /// A temperature that was computed on other cells than those of the body that it heats.
    #[error("the temperature is of another mesh: the body must have the same cells, vertex for vertex, in the same order")]
    OtherMesh,
    /// Moduli that cannot be, or a question that is answered for isotropic materials alone.
    #[error("an anisotropic material: {reason}")]
    Anisotropic {
        /// What is wrong.
        reason: String,
    },
    /// A material without what the kinematics asks for.
    #[error("material {number} has no {property}, which this kinematics needs")]
    MaterialLacks {
        /// Index of the material.
        number: usize,
        /// What it lacks.
        property: &'static str,
    },
    /// The boundary to be kept is not one connected path of edges.
    #[error("the edges of boundary \"{name}\" do not form one path")]
    NotAPath {
        /// Name of the boundary.
        name: String,
    },
    /// The point is in no cell.
    #[error("the point ({x}, {z}) lies in no cell of the mesh")]
    OutsideMesh {
        /// First coordinate, mm.
        x: f64,
        /// Second coordinate, mm.
        z: f64,
    },
    /// A number outside its valid range.
    #[error("{quantity} is {value}, but must be {range}")]
    OutOfRange {
        /// What the number is, with its place.
        quantity: String,
        /// Its value, in the unit of the quantity.
        value: f64,
        /// The valid range in words.
        range: &'static str,
    },
    /// Two lists that belong together have different lengths.
    #[error("{what}: {given} given, {expected} expected")]
    Count {
        /// What is counted.
        what: String,
        /// The number given.
        given: usize,
        /// The number expected.
        expected: usize,
    },
    /// An index beyond what there is.
    #[error("{by} names {what} {index}, but there are {count} in all, counted from 0")]
    Beyond {
        /// What the index is given for.
        by: String,
        /// What it is the index of.
        what: &'static str,
        /// The index given.
        index: usize,
        /// How many there are.
        count: usize,
    },
    /// A pin along the normal, by its vertex.
    #[error("the pin at vertex {0} holds along a normal, but a vertex has none: give a direction or an angle")]
    NoNormal(usize),
    /// More than two cells share an edge, or two cells lie on the same side of it.
    #[error("the edge {a}-{b} is walked the same way by two cells, or shared by more than two")]
    Overlapping {
        /// First vertex.
        a: usize,
        /// Second vertex.
        b: usize,
    },
    /// A cell touches two of the vertices that the mesh shall be graded towards.
    #[error(
        "cell {cell} touches the vertices {first} and {second}, towards which the mesh shall both be graded; cut the cell between them"
    )]
    TwoGradedCorners {
        /// The cell.
        cell: usize,
        /// First vertex.
        first: usize,
        /// Second vertex.
        second: usize,
    },
    /// A cell reaches from one edge of a boundary to another, so that it cannot be cut along one of them.
    #[error(
        "cell {cell} reaches from one edge of boundary \"{boundary}\" to another, towards which the mesh shall be graded; refine the mesh first, with quadrilaterals in the corners of the boundary"
    )]
    BetweenGradedEdges {
        /// The cell.
        cell: usize,
        /// Name of the boundary.
        boundary: String,
    },
    /// Something that needs a straight boundary was asked of a curved one.
    #[error("{what} needs straight edges in one line, but boundary \"{boundary}\" is curved or bent")]
    NotStraight {
        /// What was asked.
        what: &'static str,
        /// Name of the boundary.
        boundary: String,
    },
    /// A vertex cannot be moved along the boundary as asked.
    #[error("vertex {vertex} cannot be moved by {shift} along the boundary: {reason}")]
    Immovable {
        /// The vertex.
        vertex: usize,
        /// The shift asked for, mm.
        shift: f64,
        /// Why not.
        reason: &'static str,
    },
    /// The elimination would need more memory than the crate allows itself.
    #[error(
        "eliminating {unknowns} unknowns on edges and vertices would hold {bytes} bytes, more than {limit}; take fewer cells or a lower degree"
    )]
    TooLarge {
        /// Number of unknowns on edges and vertices.
        unknowns: usize,
        /// Estimated memory, bytes.
        bytes: u64,
        /// The limit, bytes.
        limit: u64,
    },
    /// A mesh without cells.
    #[error("a mesh needs at least one cell, but has none")]
    NoCells,
    /// Two cells lie on one place.
    #[error("the middle of cell {a}, ({x:.6}, {z:.6}), lies inside cell {b}; bodies on one place must share their cells")]
    CellsOverlap {
        /// The cell whose middle it is.
        a: usize,
        /// The cell that holds it.
        b: usize,
        /// First coordinate of the middle, mm.
        x: f64,
        /// Second coordinate of the middle, mm.
        z: f64,
    },
    /// Two cells of one mesh touch without sharing the vertex or edge there.
    #[error(
        "cells {cell} and {other} touch at ({x:.6}, {z:.6}) without sharing vertices there: vertex {vertex} hangs on an edge of cell {cell} that it is no end of; cut that edge there, or let both cells have the same vertices"
    )]
    TouchingApart {
        /// The vertex.
        vertex: usize,
        /// The cell whose edge it lies on.
        cell: usize,
        /// A cell that the vertex belongs to.
        other: usize,
        /// First coordinate of the vertex, mm.
        x: f64,
        /// Second coordinate of the vertex, mm.
        z: f64,
    },
    /// A mesh in pieces that share no edge.
    #[error(
        "cell {cell} at ({x:.6}, {z:.6}) is in another piece than cell 0: no common edges join them; join them along edges, or take each as a body of its own"
    )]
    Pieces {
        /// The first cell of another piece than that of cell 0.
        cell: usize,
        /// First coordinate of its first corner, mm.
        x: f64,
        /// Second coordinate of its first corner, mm.
        z: f64,
    },
    /// Two meshes to be joined have no edge in common.
    #[error("the meshes share no edge within {tolerance:.3e}; their closest boundary vertices are {distance:.3e} apart")]
    NotTouching {
        /// Distance up to which vertices are merged, mm.
        tolerance: f64,
        /// Distance of the closest two boundary vertices, mm.
        distance: f64,
    },
    /// A vertex of one mesh has more than one partner in the other.
    #[error(
        "more than one vertex lies within {tolerance:.3e} of the vertex at ({x:.6}, {z:.6}) on the other mesh; take a smaller tolerance, or join away from slits"
    )]
    AmbiguousVertex {
        /// Distance up to which vertices are merged, mm.
        tolerance: f64,
        /// First coordinate of the vertex, mm.
        x: f64,
        /// Second coordinate of the vertex, mm.
        z: f64,
    },
    /// The edges of two meshes between the same vertices run differently.
    #[error("the edges of the two meshes at ({x:.6}, {z:.6}) are {distance:.3e} apart, but must be the same curve")]
    CurvesDisagree {
        /// First coordinate of the place, mm.
        x: f64,
        /// Second coordinate of the place, mm.
        z: f64,
        /// Distance of the curves there, mm.
        distance: f64,
    },
    /// A vertex of one mesh lies on an edge of the other, between its ends.
    #[error(
        "the vertex at ({x:.6}, {z:.6}) of one mesh lies between the ends of an edge of the other; cut that edge there first"
    )]
    HangingVertex {
        /// First coordinate of the vertex, mm.
        x: f64,
        /// Second coordinate of the vertex, mm.
        z: f64,
    },
    /// Two meshes to be joined lie on one place.
    #[error("the meshes overlap at ({x:.6}, {z:.6})")]
    MeshesOverlap {
        /// First coordinate of the place, mm.
        x: f64,
        /// Second coordinate of the place, mm.
        z: f64,
    },
    /// A boundary does not lie on the circle or line that it shall lie on.
    #[error("vertex {vertex} of boundary \"{boundary}\" is {distance:.3e} away from the outline, more than {allowed:.3e}")]
    OffOutline {
        /// Name of the boundary.
        boundary: String,
        /// The vertex.
        vertex: usize,
        /// Its distance from the outline, mm.
        distance: f64,
        /// The distance allowed, mm.
        allowed: f64,
    },
    /// An edge of a boundary runs elsewhere than the circle or line that it shall lie on.
    #[error(
        "the edge {a}-{b} of boundary \"{boundary}\" has its middle {distance:.3e} away from the outline, more than {allowed:.3e}: it runs elsewhere"
    )]
    EdgeOffOutline {
        /// Name of the boundary.
        boundary: String,
        /// First vertex of the edge.
        a: usize,
        /// Second vertex of the edge.
        b: usize,
        /// Distance of its middle from the outline, mm.
        distance: f64,
        /// The distance allowed, mm.
        allowed: f64,
    },
}
