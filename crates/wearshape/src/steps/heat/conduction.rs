//! Steady conduction in one body, on the mesh and degree of its displacement: what carries heat through its edges, and how much.

use hpfem::{
    Body, BodyProblem, Direction, EdgeTraction, Field, Foundation, InterfaceState, Kinematics, LoadCase, Material, Mesh, Support,
};
use meshing::CONTACT;
use scene::Fault;

use crate::heat::{Carried, Heat};
use crate::parts::BodyParts;
use crate::stage::Stage;

/// Gauss points of an integral over an edge: exact for the highest degree on straight edges and arcs.
const POINTS: usize = 16;

/// The load case of everything that flows without friction.
const STILL: &str = "still";

/// A body reduced to its contact surface as a problem of temperature.
pub(crate) struct Conduction {
    /// The reduced body; its load case is what flows without friction.
    pub body: Body,
    /// Names of the edges that are held at a temperature, one a support.
    held: Vec<String>,
    /// Edges with convection.
    films: Vec<Film>,
    /// Edges with a flux: name and heat into the body (mW).
    fluxes: Vec<(String, f64)>,
}

/// An edge with convection.
struct Film {
    name: String,
    boundary: String,
    /// Coefficient of heat transfer (mW/(mm^2 K)) and temperature of the surroundings (degC).
    film: f64,
    ambient: f64,
}

impl Conduction {
    /// Body 1 (0) or body 2 (1) of a stage on the cells of its displacement.
    pub(crate) fn new(stage: Stage<'_>, heat: &Heat, number: usize, parts: &BodyParts) -> Result<Conduction, Fault> {
        let body = &stage.couple.bodies[number];
        let kinematics = kinematics(stage.couple.kinematics);
        let failed = |error: hpfem::Error| {
            let (message, remedy) = match error {
                hpfem::Error::HeldTwice { place, value, known, .. } => (
                    format!("two edges that meet at {place} are held at {known} and at {value} degC"),
                    "hold one of them, and let the other one be cooled by convection",
                ),
                other => (other.to_string(), "check the materials and edges of the body"),
            };
            Fault::at(format!("{}.heat", body.key), "no-temperature", message, remedy)
        };
        let (mut mesh, degrees) = (Mesh::clone(parts.mesh()), parts.degrees().to_vec());
        let conductor = |material: &scene::Material| Material::conductor(material.conductivity.map_or(0.0, |k| k.0));
        let materials = body.materials.iter().map(conductor).collect::<Result<_, _>>().map_err(failed)?;
        let (mut supports, mut foundations) = (Vec::new(), Vec::new());
        let mut still = LoadCase::new(STILL);
        let (mut held, mut films, mut fluxes) = (Vec::new(), Vec::new(), Vec::new());
        for (edge, carried) in &heat.edges[number] {
            let named = format!("{}.{edge}", body.key);
            let Some(boundary) = outside_contact(&mut mesh, edge, *carried).map_err(failed)? else { continue };
            match *carried {
                Carried::Held(temperature) => {
                    supports.push(Support::moved(&boundary, Direction::First, temperature));
                    held.push(named);
                }
                Carried::Convection(film, ambient) => {
                    foundations.push(Foundation::new(&boundary, film, 0.0));
                    still = still.with(EdgeTraction::new(&boundary, move |_| [film * ambient, 0.0]));
                    films.push(Film { name: named, boundary, film, ambient });
                }
                Carried::Flux(flux) => {
                    still = still.with(EdgeTraction::new(&boundary, move |_| [flux, 0.0]));
                    fluxes.push((named, integral(&mesh, &boundary, kinematics, |_, _| Ok(flux)).map_err(failed)?));
                }
            }
        }
        let problem = BodyProblem {
            degrees,
            materials,
            supports,
            foundations,
            load_cases: vec![still],
            ..BodyProblem::new(mesh, 1, kinematics).keep(CONTACT)
        };
        let body = Body::of_temperature(problem, stage.clock()).map_err(failed)?;
        Ok(Conduction { body, held, films, fluxes })
    }

    /// Heat that leaves through each edge in a state with its temperature field (mW).
    pub(crate) fn out(&self, state: &InterfaceState, field: &Field) -> Result<Vec<(String, f64)>, hpfem::Error> {
        let operator = &self.body.interface;
        let mut out: Vec<(String, f64)> =
            self.held.iter().enumerate().map(|(k, edge)| (edge.clone(), -operator.reaction(k, state)[0])).collect();
        let mesh = field.mesh();
        let cells = mesh.edge_cells();
        for Film { name, boundary, film, ambient } in &self.films {
            let flux = |edge: usize, t: f64| {
                let (cell, side) = cells[edge][0];
                let x = mesh.edges[edge].curve.point(t);
                // The edge may run against its cell.
                let distance = |t: f64| {
                    let [xi, eta] = on_side(side, mesh.cells[cell].is_triangle(), t);
                    let y = field.position(cell, xi, eta);
                    (x[0] - y[0]).hypot(x[1] - y[1])
                };
                let along = if distance(t) <= distance(-t) { t } else { -t };
                let [xi, eta] = on_side(side, mesh.cells[cell].is_triangle(), along);
                Ok(film * (field.at(cell, xi, eta)?.displacement[0] - ambient))
            };
            out.push((name.clone(), integral(mesh, boundary, operator.kinematics, flux)?));
        }
        out.extend(self.fluxes.iter().map(|(edge, heat)| (edge.clone(), -heat)));
        Ok(out)
    }
}

/// Reference coordinates on a side of a cell.
fn on_side(side: usize, triangle: bool, t: f64) -> [f64; 2] {
    match side {
        0 => [t, -1.0],
        1 => [1.0, t],
        2 if !triangle => [t, 1.0],
        _ => [-1.0, t],
    }
}

/// The problem of temperature of bodies with these kinematics.
fn kinematics(elastic: Kinematics) -> Kinematics {
    match elastic.thickness() {
        Some(thickness) => Kinematics::Potential { thickness },
        None => Kinematics::AxisymmetricPotential,
    }
}

/// The part of a named edge that heat is carried through: all of it, or with convection what lies outside the contact; none where that is
/// nothing, or where nothing flows.
fn outside_contact(mesh: &mut Mesh, edge: &str, carried: Carried) -> Result<Option<String>, hpfem::Error> {
    if matches!(carried, Carried::Convection(film, _) if film == 0.0) {
        return Ok(None);
    }
    let all = mesh.boundary(edge)?;
    let contact = mesh.boundary(CONTACT)?;
    let outside: Vec<usize> = all.iter().copied().filter(|e| !contact.contains(e)).collect();
    if outside.is_empty() {
        return Ok(None);
    }
    if outside.len() == all.len() {
        return Ok(Some(edge.to_string()));
    }
    let name = format!("@outside {edge}");
    let tag = mesh.boundaries.len();
    mesh.boundaries.push(name.clone());
    outside.iter().for_each(|e| mesh.edges[*e].tags.push(tag));
    Ok(Some(name))
}

/// Integral of a flux, by edge and parameter, over a boundary.
fn integral(
    mesh: &Mesh,
    boundary: &str,
    kinematics: Kinematics,
    flux: impl Fn(usize, f64) -> Result<f64, hpfem::Error>,
) -> Result<f64, hpfem::Error> {
    let rule = hpfem::gauss(POINTS);
    let mut sum = 0.0;
    for edge in mesh.boundary(boundary)? {
        let curve = &mesh.edges[edge].curve;
        for (t, w) in rule.points.iter().zip(&rule.weights) {
            let d = curve.derivative(*t);
            sum += w * d[0].hypot(d[1]) * kinematics.measure(curve.point(*t)[0]) * flux(edge, *t)?;
        }
    }
    Ok(sum)
}
