//! Displacement and stress inside the bodies, by back substitution at the reported level; done only if an output asks for it.

use contact::ContactPoint;
use hpfem::{Body, Field, InterfaceState, Kinematics, Stress, TraceLoad};

use crate::body_field::{BodyField, CellField, FieldFrame};
use crate::fault::Fault;
use crate::fe::bodies::{BodyParts, Level};
use crate::fe::ends::Setting;
use crate::fe::operators::paired;
use crate::fe::stage::Stage;
use crate::fe::template::{Cut, meshes};
use crate::solution::Solution;

/// What a stage leaves behind for the fields: the discretisation it reports, and the states of its bodies there.
pub(super) struct Reported {
    pub(super) level: Level,
    /// Ends of contact that the meshes are cut at, from -1 to 1 on the surface.
    pub(super) ends: Vec<f64>,
    /// The moments, the reported one first.
    pub(super) moments: Vec<Moment>,
}

/// Both bodies at a moment.
pub(super) struct Moment {
    pub(super) time_s: f64,
    pub(super) name: &'static str,
    pub(super) states: [InterfaceState; 2],
    /// Pressure at the contact points, for the twist.
    pub(super) pressure: Vec<f64>,
}

/// Recovers the moments of a stage on its bodies, made again at the reported level.
pub(super) fn recover(stage: Stage<'_>, reported: &Reported, solution: &mut Solution) -> Result<(), Fault> {
    let mut effort = Solution::default();
    let parts = stage.parts(reported.level, Cut::Ends(&reported.ends), &mut effort)?;
    let bodies = parts.reduce(&mut effort)?;
    let points = paired([&bodies[0].interface, &bodies[1].interface])?.points();
    let mut frames = Vec::new();
    for moment in &reported.moments {
        let mut frame = frame(moment, &bodies, &mut effort)?;
        if stage.problem.plan.runs("torsion") {
            twist(stage, reported, moment, &points, &mut frame, &mut effort)?;
        }
        frames.push(frame);
    }
    solution.fields = frames;
    solution.counters.factorisations += effort.counters.factorisations;
    solution.counters.back_substitutions += effort.counters.back_substitutions;
    Ok(())
}

/// The same of a half-disc on its flat side, with element nodes on the ends of contact; the whole scene, when half of it was computed.
pub(super) fn recover_ends(
    setting: &Setting<'_>,
    reported: &Reported,
    nodes: &[f64],
    solution: &mut Solution,
) -> Result<(), Fault> {
    let mut effort = Solution::default();
    let parts = setting.parts(reported.level, nodes, &mut effort)?;
    let bodies = parts.reduce(&mut effort)?;
    for moment in &reported.moments {
        let mut frame = frame(moment, &bodies, &mut effort)?;
        if setting.copies() > 1.0 {
            frame.bodies = frame.bodies.map(|body| body.mirrored(setting.couple.middle));
        }
        solution.fields.push(frame);
    }
    solution.counters.factorisations += effort.counters.factorisations;
    solution.counters.back_substitutions += effort.counters.back_substitutions;
    Ok(())
}

/// Both bodies at a moment, without twist.
fn frame(moment: &Moment, bodies: &[Body<'_>; 2], effort: &mut Solution) -> Result<FieldFrame, Fault> {
    effort.counters.back_substitutions += bodies.len();
    let body = |number: usize| -> Result<BodyField, Fault> {
        let field = field(&bodies[number], &moment.states[number])?;
        let revolved = bodies[number].interface.kinematics.is_revolved();
        let cells = (0..field.cells()).map(|cell| on_grid(&field, cell)).collect();
        Ok(BodyField { cells, revolved, twisted: false })
    };
    Ok(FieldFrame { time_s: moment.time_s, moment: moment.name, bodies: [body(0)?, body(1)?] })
}

fn field<'a>(body: &Body<'a>, state: &InterfaceState) -> Result<Field<'a>, Fault> {
    body.field(state).map_err(|error| Fault::at("output.fields", "no-field", error.to_string(), "write output.fields = false"))
}

/// The grid of a cell of given degree in its own coordinates.
fn grid(degree: usize) -> impl Iterator<Item = [f64; 2]> {
    let at = move |i: usize| 2.0 * i as f64 / degree as f64 - 1.0;
    (0..(degree + 1) * (degree + 1)).map(move |k| [at(k % (degree + 1)), at(k / (degree + 1))])
}

fn on_grid(field: &Field<'_>, cell: usize) -> CellField {
    let degree = field.degree(cell);
    let mut values = CellField { degree, ..CellField::default() };
    for [xi, eta] in grid(degree) {
        let state = field.at(cell, xi, eta);
        values.position.push(field.position(cell, xi, eta));
        values.displacement.push([state.displacement[0], 0.0, state.displacement[1]]);
        values.stress.push(Stress::new(state.stress, [0.0; 2]));
    }
    values
}

/// Adds the twist about the axis under the friction `mu p`: a scalar problem of its own on the same meshes.
fn twist(
    stage: Stage<'_>,
    reported: &Reported,
    moment: &Moment,
    points: &[ContactPoint],
    frame: &mut FieldFrame,
    effort: &mut Solution,
) -> Result<(), Fault> {
    let level = reported.level;
    let meshes = meshes(stage.scene(), stage.extent, level.layers, Cut::Ends(&reported.ends))?;
    for (number, mesh) in meshes.into_iter().enumerate() {
        let parts = BodyParts::new(stage.scene(), number == 0, mesh, level, Kinematics::Torsion)?;
        let body = parts.reduce(["body1", "body2"][number])?;
        let operator = &body.interface;
        let mut load = TraceLoad { unknowns: vec![0.0; operator.trace.unknowns], ..TraceLoad::default() };
        let sign = if number == 0 { 1.0 } else { -1.0 };
        for (point, pressure) in points.iter().zip(&moment.pressure) {
            let around = stage.surface_point(point.position, point.normal, 0.0).drag.y;
            operator.trace.add_force(&mut load, point.place, [sign * around * stage.friction() * pressure * point.weight, 0.0]);
        }
        let factors = operator.factors(&[]);
        let unknowns = operator.solve_one(&operator.right_hand_side(&load, &factors));
        let field = field(&body, &InterfaceState { unknowns, factors, load })?;
        effort.counters.factorisations += 1;
        effort.counters.back_substitutions += 1;
        for (cell, values) in frame.bodies[number].cells.iter_mut().enumerate() {
            for (row, [xi, eta]) in grid(values.degree).enumerate() {
                let state = field.at(cell, xi, eta);
                values.displacement[row][1] = state.displacement[0];
                values.stress[row].xy = state.stress[0];
                values.stress[row].yz = state.stress[1];
            }
        }
        frame.bodies[number].twisted = true;
    }
    Ok(())
}
