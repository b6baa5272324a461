//! Columns at the points of a half-disc's contact, for the whole scene when half of it was computed.

use contact::{ContactOperator, ContactPoint, ContactSolution, ContactState, Pair, Side};
use hpfem::InterfaceState;
use meshing::CANDIDATE;
use nalgebra::Vector3;
use shapeopt::Gauge;

use crate::options::{Sampling, trapezoid_weights};
use crate::parts::MEAN_COLUMNS;
use crate::profile::Profile;
use crate::results::ContactResult;
use crate::stage::mean_columns;
use crate::steps::ends_setting::Setting;
use crate::words::PointStatus;

/// A solved contact with the ends its nodes stand on.
pub(crate) struct Rows<'r> {
    pub setting: &'r Setting<'r>,
    pub pair: &'r Pair<'r>,
    pub operator: &'r ContactOperator<'r>,
    pub found: &'r ContactSolution,
    pub gap: &'r [f64],
    /// The nodes on the ends.
    pub nodes: &'r [f64],
    /// The ends themselves, closer by the step that the nodes still ask for.
    pub ends: &'r [f64],
    /// Whether a node stands on both ends of stick.
    pub stick_node: bool,
    /// How far the shear force has moved the contact from its nodes ([`shift`]), mm.
    pub shift: f64,
}

/// How far a shear force moves a contact along the surface, mm: to first order the pressure keeps its form, and its middle is where its force acts,
/// `int (x - x_middle) p dx / int p dx`. Without shear, and where half of the scene stands for the whole, it stays where it is.
pub(crate) fn shift(setting: &Setting<'_>, operator: &ContactOperator<'_>, found: &ContactSolution) -> f64 {
    if setting.shear == 0.0 || !setting.disc.whole {
        return 0.0;
    }
    let forces = operator.points().iter().zip(&found.nodal_force);
    let [moment, force] = forces.fold([0.0; 2], |[moment, sum], (point, force)| {
        [moment + (point.position[0] - setting.disc.middle) * force, sum + force]
    });
    moment / force
}

/// A place of the surface: a computed point, or one between, and whether it is seen in the mirror.
struct Place {
    point: ContactPoint,
    node: Option<usize>,
    mirrored: bool,
}

impl Rows<'_> {
    /// Whether half of the scene stands for the whole.
    fn halved(&self) -> bool {
        self.setting.copies() > 1.0
    }

    /// Pressure at a distance from the middle.
    pub(crate) fn pressure_at(&self, distance: f64) -> f64 {
        let start = self.operator.points()[0].position[0] - self.setting.disc.middle;
        self.between(&self.found.pressure, distance - start)
    }

    /// The polynomial through the points of the edge at an arc length: [`ContactOperator::value_at`] but for the last digits, since the points stand at
    /// their arc lengths here and at their edge parameters there.
    fn between(&self, values: &[f64], arc: f64) -> f64 {
        let Some(counter) = self.pair.counter else { return f64::NAN };
        let (edge, t) = counter.trace.locate(arc);
        let first: usize = counter.trace.edges[..edge].iter().map(|e| e.degree).sum();
        let last = first + counter.trace.edges[edge].degree;
        let arcs: Vec<f64> = self.operator.points()[first..=last].iter().map(|p| p.arc).collect();
        let (from, to) = (arcs[0], arcs[arcs.len() - 1]);
        let places: Vec<f64> = arcs.iter().map(|a| 2.0 * (a - from) / (to - from) - 1.0).collect();
        let shapes = hpfem::lagrange(&places, &hpfem::barycentric_weights(&places), t.clamp(-1.0, 1.0));
        shapes.iter().zip(&values[first..=last]).map(|(l, v)| l * v).sum()
    }

    /// Motion of body 1's load edge: of the rigid edge, or the mean.
    pub(crate) fn rigid_motion(&self) -> [f64; 2] {
        let (body, state) = (self.pair.shaped, &self.found.shaped);
        [0, 1].map(|k| match body.frame[k] {
            Some(unknown) => state.unknowns[unknown],
            None if body.load_cases.len() > MEAN_COLUMNS[k] && !(k == 0 && self.nodes_from_axis()) => {
                body.column_work(MEAN_COLUMNS[k], state)
            }
            None => 0.0,
        })
    }

    /// The state of body 1 with that motion taken out, as its columns have it.
    pub(crate) fn held(&self) -> InterfaceState {
        let body = self.pair.shaped;
        let on_edge = body.frame.iter().any(Option::is_some);
        let gauge = if on_edge { Gauge::HeldEdge } else { Gauge::MeanOf(mean_columns(self.pair)) };
        let mut held = self.found.shaped.clone();
        gauge.zero(body, &mut held);
        held
    }

    /// Distance of a point from the middle of the contact.
    fn distance(&self, point: &ContactPoint) -> f64 {
        (point.position[0] - self.setting.disc.middle - self.shift).abs()
    }

    /// Whether the meshed part begins at the plane of symmetry or the axis.
    fn nodes_from_axis(&self) -> bool {
        !self.setting.disc.whole
    }

    /// The computed points.
    pub(crate) fn own(&self) -> Profile {
        let points = self.operator.points();
        let place = |node: usize, mirrored: bool| Place { point: points[node], node: Some(node), mirrored };
        let mut places: Vec<Place> = (0..points.len()).map(|i| place(i, false)).collect();
        if self.halved() {
            places[0].point.weight *= 2.0;
            places = (1..points.len()).rev().map(|i| place(i, true)).chain(places).collect();
        }
        self.profile(&places)
    }

    /// Points of the candidate surface, with trapezoid weights in x.
    pub(crate) fn sampled(&self, sampling: Sampling<'_>) -> Profile {
        let end = CANDIDATE * self.nodes[self.nodes.len() - 1];
        let from = if self.setting.revolved() { 0.0 } else { -end };
        let start = if self.setting.disc.whole { -end } else { 0.0 };
        let at = sampling.places([from, end]);
        let places: Vec<Place> = at
            .iter()
            .zip(trapezoid_weights(&at))
            .map(|(x, weight)| {
                let x = *x;
                let mirrored = self.halved() && x < 0.0;
                let mut point = self.pair.at_arc((if mirrored { -x } else { x } - start).max(0.0));
                point.weight = weight * self.pair.shaped.kinematics.measure(point.position[0]);
                Place { point, node: None, mirrored }
            })
            .collect();
        self.profile(&places)
    }

    fn profile(&self, places: &[Place]) -> Profile {
        let middle = self.setting.disc.middle;
        let x = |place: &Place| {
            let x = place.point.position[0] - middle;
            if place.mirrored { -x } else { x }
        };
        let surface: Vec<wear::SurfacePoint> = places
            .iter()
            .map(|place| wear::SurfacePoint {
                position: Vector3::new(middle + x(place), 0.0, place.point.position[1]),
                normal: Vector3::z(),
                weight: place.point.weight,
                sliding_speed: 0.0,
                drag: Vector3::zeros(),
            })
            .collect();
        let mut profile = Profile::new(places.iter().map(x).collect(), &surface);
        // Body 2 moves against the shear force relative to body 1.
        let sense = if self.setting.shear > 0.0 { -1.0 } else { 1.0 };
        let rigid = self.rigid_motion();
        let states = [Some(&self.found.shaped), self.found.counter.as_ref()];
        for (row, place) in places.iter().enumerate() {
            let value = |values: &[f64]| match place.node {
                Some(node) => values[node],
                None => self.between(values, place.point.arc),
            };
            let distance = self.distance(&place.point);
            profile.pressure[row] = value(&self.found.pressure).max(0.0);
            profile.shear[row] = sense * value(&self.found.shear);
            profile.gap[row] = match place.node {
                Some(node) => 1e3 * self.gap[node],
                None => 1e3 * self.setting.disc.gap(place.point.position[0]),
            };
            profile.opening[row] = 1e3 * value(&self.found.opening).max(0.0);
            let turn = if place.mirrored { -sense } else { sense };
            for (body, side) in [Side::Shaped, Side::Counter].into_iter().enumerate() {
                let Some(state) = states[body] else { continue };
                let u = self.pair.displacement(side, state, &place.point);
                let held = if body == 0 { rigid } else { [0.0; 2] };
                profile.normal_displacement[body][row] = 1e3 * (u[0] - held[1]);
                profile.tangential_displacement[body][row] = 1e3 * turn * (u[1] - held[0]);
            }
            let state = match place.node {
                Some(node) => self.found.states[node],
                None if distance > self.nodes[self.nodes.len() - 1] => ContactState::Open,
                None => self.state_near(&place.point),
            };
            profile.status[row] = match (state, self.setting.shear != 0.0) {
                (ContactState::Open, _) => PointStatus::Open,
                (_, false) => PointStatus::Contact,
                (ContactState::Stick, true) => PointStatus::Stick,
                (_, true) => PointStatus::Slip,
            };
        }
        profile
    }

    /// State inside the contact between computed points: that between the nodes, or of the nearest point.
    fn state_near(&self, point: &ContactPoint) -> ContactState {
        if self.stick_node {
            let sticks = self.distance(point) <= self.nodes[0];
            return if sticks { ContactState::Stick } else { ContactState::Backward };
        }
        let points = self.operator.points();
        let far = |i: &usize| (points[*i].position[0] - point.position[0]).abs();
        let nearest = (0..points.len()).min_by(|i, j| far(i).total_cmp(&far(j)));
        nearest.map_or(ContactState::Open, |i| self.found.states[i])
    }

    /// Ends of stick from the middle: the nodes on them, or the outermost points that stick.
    fn stick_ends(&self) -> Vec<f64> {
        if self.stick_node {
            return vec![self.shift - self.ends[0], self.shift + self.ends[0]];
        }
        let sticking = self.operator.points().iter().zip(&self.found.states).filter(|(_, s)| **s == ContactState::Stick);
        let places: Vec<f64> = sticking.map(|(point, _)| point.position[0] - self.setting.disc.middle).collect();
        match (places.first(), places.last()) {
            (Some(first), Some(last)) => vec![*first, *last],
            _ => Vec::new(),
        }
    }

    /// The largest shear stands at the end of stick, from where on it is `mu p`: its slope is infinite inside, so that values of points are coarse.
    fn largest_shear(&self) -> f64 {
        if self.stick_node {
            // Of both ends of stick the pressure is the same, to first order.
            return self.setting.friction * self.pressure_at(self.shift + self.ends[0]);
        }
        self.found.shear.iter().fold(0.0, |most, shear| most.max(shear.abs()))
    }

    /// Everything that is reported of the contact.
    pub(crate) fn contact_result(&self) -> ContactResult {
        let (setting, found) = (self.setting, self.found);
        let load = &setting.problem.load;
        let about = load.about[0];
        let points = self.operator.points();
        let moment = if setting.disc.whole {
            points.iter().zip(&found.nodal_force).map(|(p, force)| (p.position[0] - about) * force).sum()
        } else {
            setting.copies() * found.force[1] * (setting.disc.middle - about)
        };
        let both = |end: f64| if setting.revolved() { vec![0.0, end] } else { vec![self.shift - end, self.shift + end] };
        let sheared = setting.shear != 0.0;
        ContactResult {
            status: (&found.status).into(),
            force: Some(setting.copies() * found.force[1]),
            moment: Some(moment).filter(|_| !setting.revolved()),
            approach: Some(-self.rigid_motion()[1]),
            tilt: load.tilt.map(|_| 0.0),
            ends: both(self.ends[self.ends.len() - 1]),
            p_max: Some(self.operator.maximum(&found.pressure)),
            edge_exponents: Vec::new(),
            stick_ends: if sheared { self.stick_ends() } else { Vec::new() },
            q_max: Some(self.largest_shear()).filter(|_| sheared),
            twist: None,
            uniqueness: None,
            complementarity: Some(found.complementarity),
            iterations: Some(found.iterations),
        }
    }
}
