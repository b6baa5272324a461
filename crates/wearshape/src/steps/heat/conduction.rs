//! Steady conduction in one body, on the mesh and degree of its displacement: what carries heat through its edges, and how much.

use hpfem::{
    Body, BodyProblem, Direction, EdgeTraction, Foundation, InterfaceState, Kinematics, LoadCase, Material, Mesh, Support,
};
use meshing::CONTACT;
use scene::Fault;

use crate::heat::{Carried, Heat};
use crate::level::Level;
use crate::stage::Stage;

/// The load case of everything that flows without friction.
const STILL: &str = "still";

/// A body reduced to its contact surface as a problem of temperature.
pub(crate) struct Conduction {
    /// The reduced body; its first load case is what flows without friction.
    pub body: Body,
    /// Names of the edges that are held at a temperature, one a support.
    held: Vec<String>,
    /// Edges with convection: name, load case of its film, and heat (mW) from surroundings to a body at 0 degC.
    films: Vec<(String, usize, f64)>,
    /// Edges with a flux: name and heat into the body (mW).
    fluxes: Vec<(String, f64)>,
}

impl Conduction {
    /// Body 1 (0) or body 2 (1) of a stage on a mesh.
    pub(crate) fn new(stage: Stage<'_>, heat: &Heat, number: usize, mesh: &Mesh, level: Level) -> Result<Conduction, Fault> {
        let body = &stage.couple.bodies[number];
        let kinematics = kinematics(stage.couple.kinematics);
        let failed = |error: hpfem::Error| {
            Fault::at(
                format!("{}.heat", body.key),
                "no-temperature",
                error.to_string(),
                "check the materials and edges of the body",
            )
        };
        let mut mesh = mesh.clone();
        let degrees = mesh.cells.iter().map(|cell| level.degree_in(cell.layer)).collect();
        let conductor = |material: &scene::Material| Material::conductor(material.conductivity.map_or(0.0, |k| k.0));
        let materials = body.materials.iter().map(conductor).collect::<Result<_, _>>().map_err(failed)?;
        let (mut supports, mut foundations) = (Vec::new(), Vec::new());
        let (mut still, mut cases) = (LoadCase::new(STILL), Vec::new());
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
                    cases.push(LoadCase::new(&named).with(EdgeTraction::new(&boundary, move |_| [film, 0.0])));
                    films.push((named, cases.len(), film * ambient * area(&mesh, &boundary, kinematics)));
                }
                Carried::Flux(flux) => {
                    still = still.with(EdgeTraction::new(&boundary, move |_| [flux, 0.0]));
                    fluxes.push((named, flux * area(&mesh, &boundary, kinematics)));
                }
            }
        }
        cases.insert(0, still);
        let problem = BodyProblem {
            degrees,
            materials,
            supports,
            foundations,
            load_cases: cases,
            ..BodyProblem::new(mesh, 1, kinematics).keep(CONTACT)
        };
        let body = Body::timed(problem, stage.clock()).map_err(failed)?;
        Ok(Conduction { body, held, films, fluxes })
    }

    /// Heat that leaves through each edge in a state (mW).
    pub(crate) fn out(&self, state: &InterfaceState) -> Vec<(String, f64)> {
        let operator = &self.body.interface;
        let held = self.held.iter().enumerate().map(|(k, edge)| (edge.clone(), -operator.reaction(k, state)[0]));
        let films = self.films.iter().map(|(edge, case, from)| (edge.clone(), operator.column_work(*case, state) - from));
        let fluxes = self.fluxes.iter().map(|(edge, heat)| (edge.clone(), -heat));
        held.chain(films).chain(fluxes).collect()
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

/// Area of a boundary (mm^2).
fn area(mesh: &Mesh, boundary: &str, kinematics: Kinematics) -> f64 {
    let rule = hpfem::gauss(16);
    let mut area = 0.0;
    for edge in mesh.boundary(boundary).unwrap_or_default() {
        let curve = &mesh.edges[edge].curve;
        for (t, w) in rule.points.iter().zip(&rule.weights) {
            let d = curve.derivative(*t);
            area += w * d[0].hypot(d[1]) * kinematics.measure(curve.point(*t)[0]);
        }
    }
    area
}
