//! Displacement and stress inside the bodies, by back substitution at the reported level; done only if an output asks for it.

use contact::{Pair, Side};
use hpfem::{Body, Cell, CellGrid, Field, InterfaceState, Stress};
use meshing::CONTACT;
use scene::Fault;

use crate::bodies::paired;
use crate::body_field::{BodyField, CellField, FieldFrame};
use crate::effort::Effort;
use crate::ladder::Refusal;
use crate::parts::{BodyParts, Parts};
use crate::path_profile::Inside;
use crate::problem::Problem;
use crate::results::EnergyResult;
use crate::stage::Stage;
use crate::step::Step;
use crate::steps::ends_setting::Setting;
use crate::steps::heat::fields::{Warm, with_known_heat};
use crate::steps::paths::{Sources, along};
use crate::steps::reported::{Moment, Reported};

/// Recovers the moments of a stage on its bodies, made again at the reported level.
pub(crate) fn recover(stage: Stage<'_>, reported: &Reported) -> Result<(Inside, Effort), Fault> {
    let (parts, _) = stage.parts(reported.level, stage.cut(&reported.ends))?;
    let (parts, warm) = Warm::of(stage, reported, parts)?;
    let (bodies, reduction) = parts.reduce(stage.clock())?;
    let mut effort = counts(&reduction);
    effort.counters.factorisations += warm.as_ref().map_or(0, Warm::factorisations);
    let pair = paired([&bodies[0].interface, &bodies[1].interface], stage.meeting())?;
    let mut inside = Inside::default();
    // Lines are told of the reported moment alone, which is the first.
    let all = if on_cells(stage.problem) { reported.moments.len() } else { 1 };
    for (number, moment) in reported.moments.iter().enumerate().take(all) {
        let known = warm.as_ref().map(|_| with_known_heat(stage, &pair, moment));
        let fields = fields(known.as_ref().unwrap_or(moment), &bodies, &mut effort)?;
        let mut twists = None;
        if stage.problem.plan.runs(Step::Torsion) {
            let (found, work) = twist(stage, reported, number, &pair)?;
            effort += work;
            twists = Some(found);
        }
        if number == 0 {
            let sources = Sources { fields: &fields, twists: twists.as_ref(), warm: warm.as_ref(), mirror: None };
            inside.paths = along(&stage.problem.paths, &sources)?;
            inside.energy = warm.as_ref().map(|_| strain_energy(&fields));
        }
        if on_cells(stage.problem) {
            let mut frame = frame(moment, &bodies, &fields)?;
            twists.as_ref().map_or(Ok(()), |twists| fill(&mut frame, twists))?;
            warm.as_ref().map_or(Ok(()), |warm| warm.fill(&mut frame))?;
            inside.frames.push(frame);
        }
    }
    Ok((inside, effort))
}

/// Whether displacement and stress are asked for on all cells.
fn on_cells(problem: &Problem) -> bool {
    problem.scene.output.as_ref().and_then(|output| output.fields).unwrap_or(false)
}

/// The same of a half-disc on its flat side, with element nodes on the ends of contact; the whole scene, when half of it was computed.
pub(crate) fn recover_ends(setting: &Setting<'_>, reported: &Reported, nodes: &[f64]) -> Result<(Inside, Effort), Refusal> {
    let (parts, _) = setting.parts(reported.level, nodes)?;
    let (bodies, reduction) = parts.reduce(setting.options.clock)?;
    let mut effort = counts(&reduction);
    let mut inside = Inside::default();
    for (number, moment) in reported.moments.iter().enumerate() {
        let fields = fields(moment, &bodies, &mut effort)?;
        if number == 0 {
            let sources = Sources { fields: &fields, twists: None, warm: None, mirror: setting.mirror() };
            inside.paths = along(&setting.problem.paths, &sources)?;
        }
        if on_cells(setting.problem) {
            let mut frame = frame(moment, &bodies, &fields)?;
            if let Some(middle) = setting.mirror() {
                frame.bodies = frame.bodies.map(|body| body.mirrored(middle));
            }
            inside.frames.push(frame);
        }
    }
    Ok((inside, effort))
}

/// What of a reduction counts for the fields: their seconds are counted as a whole.
fn counts(reduction: &Effort) -> Effort {
    let mut effort = Effort::default();
    effort.counters.factorisations = reduction.counters.factorisations;
    effort
}

/// Displacement and stress of both bodies at a moment.
fn fields(moment: &Moment, bodies: &[Body; 2], effort: &mut Effort) -> Result<[Field; 2], Fault> {
    effort.counters.back_substitutions += bodies.len();
    Ok([field(&bodies[0], &moment.states[0])?, field(&bodies[1], &moment.states[1])?])
}

/// Strain energies of both bodies, `1/2 int sigma : (eps - eps_th) dV`.
fn strain_energy(fields: &[Field; 2]) -> EnergyResult {
    let [body1, body2] = fields.each_ref().map(|field| Some(field.strain_energy()));
    EnergyResult { body1, body2, ..EnergyResult::default() }
}

/// Both bodies at a moment, without twist.
fn frame(moment: &Moment, bodies: &[Body; 2], fields: &[Field; 2]) -> Result<FieldFrame, Fault> {
    let body = |number: usize| -> Result<BodyField, Fault> {
        let field = &fields[number];
        let revolved = bodies[number].interface.kinematics.is_revolved();
        let mesh = bodies[number].mesh();
        let contact = mesh.boundary(CONTACT).unwrap_or_default();
        let cells = mesh.cells.iter().enumerate().map(|(cell, of)| {
            let values = on_grid(field, cell, of.is_triangle())?;
            let touching = touching(values.grid, of, &contact);
            Ok(CellField { material: of.material, touching, ..values })
        });
        Ok(BodyField { cells: cells.collect::<Result<_, Fault>>()?, materials: Vec::new(), revolved, twisted: false })
    };
    Ok(FieldFrame { time: moment.time, moment: moment.name, bodies: [body(0)?, body(1)?] })
}

/// Which points of a cell lie on edges of the contact surface.
fn touching(grid: CellGrid, cell: &Cell, contact: &[usize]) -> Vec<bool> {
    let sides: Vec<usize> = cell.sides().filter(|(_, edge)| contact.contains(edge)).map(|(local, _)| local).collect();
    let p = grid.degree;
    let on = |side: usize, (i, j): (usize, usize)| match side {
        0 => j == 0,
        1 if grid.triangle => i + j == p,
        1 => i == p,
        2 => j == p,
        _ => i == 0,
    };
    grid.steps().map(|step| sides.iter().any(|side| on(*side, step))).collect()
}

fn field(body: &Body, state: &InterfaceState) -> Result<Field, Fault> {
    body.field(state).map_err(no_field)
}

fn no_field(error: hpfem::Error) -> Fault {
    Fault::at("output.fields", "no-field", error.to_string(), "write output.fields = false")
}

fn on_grid(field: &Field, cell: usize, triangle: bool) -> Result<CellField, Fault> {
    let grid = CellGrid { degree: field.degree(cell), triangle };
    let mut values = CellField { grid, ..CellField::default() };
    for [xi, eta] in grid.reference() {
        let state = field.at(cell, xi, eta).map_err(no_field)?;
        values.position.push(field.position(cell, xi, eta));
        values.displacement.push([state.displacement[0], 0.0, state.displacement[1]]);
        values.stress.push(Stress::new(state.stress, [0.0; 2]));
    }
    Ok(values)
}

/// The twist about the axis under the friction at one of the moments: a scalar problem of its own on the same meshes.
fn twist(stage: Stage<'_>, reported: &Reported, moment: usize, pair: &Pair<'_>) -> Result<([Field; 2], Effort), Fault> {
    let (level, around) = (reported.level, &reported.moments[moment].around);
    let mut effort = Effort::default();
    let meshes = stage.meshes(level.layers, stage.cut(&reported.ends))?;
    let [first, second] = Parts::torsion(stage.couple, meshes, level, stage.meeting())?.parts;
    let mut twisted = |parts: &BodyParts, side| -> Result<Field, Fault> {
        let body = parts.reduce(stage.clock())?;
        effort.counters.factorisations += 1;
        effort.counters.back_substitutions += 1;
        field(&body, &pair.twisted(side, &body.interface, around))
    };
    let fields = [twisted(&first, Side::Shaped)?, twisted(&second, Side::Counter)?];
    Ok((fields, effort))
}

/// Adds a twist to the displacement and stress of both bodies.
fn fill(frame: &mut FieldFrame, twists: &[Field; 2]) -> Result<(), Fault> {
    for (body, field) in frame.bodies.iter_mut().zip(twists) {
        for (cell, values) in body.cells.iter_mut().enumerate() {
            for (row, [xi, eta]) in values.grid.reference().enumerate() {
                let state = field.at(cell, xi, eta).map_err(no_field)?;
                values.displacement[row][1] = state.displacement[0];
                values.stress[row].xy = state.stress[0];
                values.stress[row].yz = state.stress[1];
            }
        }
        body.twisted = true;
    }
    Ok(())
}
