//! Common break points of two bodies of which at least one is given by its cells.

use scene::Fault;

use crate::cells::{Cells, add_singular};
use crate::coarse::Coarse;
use crate::couple::Couple;
use crate::cuts::READ;
use crate::extent::{Cut, Extent};
use crate::rows::{crowded, crowded_edges};
use crate::template::{coarse, contact_cuts};

/// Most rounds until the break points settle: a cut may come back to the contact elsewhere and ask for another.
const ROUNDS: usize = 20;

/// The coarse meshes of both bodies, of given cells or a template each: cut at the break points of both on the contact surface and at further
/// `breaks`, graded towards the same points there.
pub(crate) fn matched(
    couple: &Couple,
    given: &[Option<Cells>; 2],
    extent: Extent,
    cut: Cut<'_>,
    breaks: &[f64],
) -> Result<[Coarse; 2], Fault> {
    let mut matching = Matching::new(couple, given, extent, cut)?;
    matching.apart.extend(breaks);
    for _ in 0..ROUNDS {
        let cuts = contact_cuts(couple, extent, cut, &matching.breaks());
        if !matching.cut_at(&cuts)? {
            continue;
        }
        let mut meshes = matching.meshes(&cuts)?;
        matching.share_graded(&mut meshes);
        if !matching.part_crowded(&meshes)? {
            return Ok(meshes);
        }
    }
    Err(unmatched())
}

/// Two bodies on the way to common break points.
struct Matching<'a> {
    couple: &'a Couple,
    extent: Extent,
    cut: Cut<'a>,
    /// Coordinates of the ends of contact.
    ends: Vec<f64>,
    /// Cells of the bodies given by them; none of a template.
    cells: [Option<Cells>; 2],
    /// Coordinates of cuts that keep two points to grade towards apart in a template.
    apart: Vec<f64>,
}

impl<'a> Matching<'a> {
    /// The given cells with vertices drawn onto the ends of contact.
    fn new(couple: &'a Couple, given: &[Option<Cells>; 2], extent: Extent, cut: Cut<'a>) -> Result<Matching<'a>, Fault> {
        let mut cells = given.clone();
        let [from, to] = extent.ends();
        let ends: Vec<f64> = cut.ends().iter().map(|t| from + 0.5 * (1.0 + t) * (to - from)).collect();
        cells.iter_mut().flatten().for_each(|cells| ends.iter().for_each(|end| cells.draw(*end)));
        if cut == Cut::Shifted {
            cells.iter_mut().flatten().try_for_each(Cells::halve)?;
        }
        Ok(Matching { couple, extent, cut, ends, cells, apart: Vec::new() })
    }

    /// The bodies that are given by cells.
    fn given(&self) -> impl Iterator<Item = &Cells> {
        self.cells.iter().flatten()
    }

    /// Break points on the contact surface that the given cells have, and those that a template needs.
    fn breaks(&self) -> Vec<f64> {
        self.given().flat_map(Cells::breaks).chain(self.apart.iter().copied()).collect()
    }

    /// Cuts the given cells; false if a cut came back to the contact surface elsewhere.
    fn cut_at(&mut self, cuts: &[f64]) -> Result<bool, Fault> {
        self.cells.iter_mut().flatten().try_for_each(|cells| cells.cut(cuts))?;
        let near = READ * (cuts[cuts.len() - 1] - cuts[0]);
        let known = |place: &f64| cuts.iter().any(|c| (c - place).abs() <= near);
        Ok(self.given().all(|cells| cells.breaks().iter().all(known)))
    }

    /// The coarse meshes, each with the points towards which it is graded for its own sake.
    fn meshes(&self, cuts: &[f64]) -> Result<[Coarse; 2], Fault> {
        let one = |number: usize| match &self.cells[number] {
            Some(cells) => {
                let free = self.ends.iter().filter_map(|end| cells.point_at(*end)).collect();
                Ok(Coarse { mesh: cells.mesh.clone(), singular: cells.singular.clone(), ledges: [0.0; 2], free })
            }
            None => coarse(self.couple, number, self.extent, cuts, self.cut),
        };
        Ok([one(0)?, one(1)?])
    }

    /// Points of the contact surface that need layers in one body get them in both, for common break points.
    fn share_graded(&self, meshes: &mut [Coarse; 2]) {
        let own = |(body, coarse): (usize, &Coarse)| coarse.singular.iter().map(|x| self.on_both(body, *x)).collect::<Vec<_>>();
        let both: Vec<[[f64; 2]; 2]> = meshes.iter().enumerate().flat_map(own).collect();
        let touches =
            |(cells, x): (&Option<Cells>, &[f64; 2])| cells.as_ref().is_some_and(|cells| cells.coordinate(*x).is_some());
        let touching = |points: &&[[f64; 2]; 2]| self.cells.iter().zip(points.iter()).any(touches);
        for points in both.iter().filter(touching) {
            for (Coarse { mesh, singular, .. }, x) in meshes.iter_mut().zip(points) {
                add_singular(mesh, singular, *x);
            }
        }
        // A template that faces the cells lies on the same surface.
        let count = self.ends.len();
        let Some(body) = meshes.iter().position(|coarse| coarse.free.len() == count) else { return };
        let free: Vec<[[f64; 2]; 2]> = meshes[body].free.iter().map(|x| self.on_both(body, *x)).collect();
        for (other, coarse) in meshes.iter_mut().enumerate().filter(|(_, coarse)| coarse.free.len() != count) {
            coarse.free = free.iter().map(|points| points[other]).collect();
        }
    }

    /// A point of a body's contact surface, and what it faces, body 1's first.
    fn on_both(&self, body: usize, x: [f64; 2]) -> [[f64; 2]; 2] {
        let faced = self.extent.facing(body, x);
        if body == 0 { [x, faced] } else { [faced, x] }
    }

    /// Asks for cuts in each body with cells that touch two points to grade towards; false if there is none.
    fn part_crowded(&mut self, meshes: &[Coarse; 2]) -> Result<bool, Fault> {
        let mut again = false;
        for (number, coarse) in meshes.iter().enumerate() {
            let graded: Vec<[f64; 2]> = coarse.singular.iter().chain(&coarse.free).copied().collect();
            if let Some(cells) = &mut self.cells[number] {
                let edges = crowded_edges(&coarse.mesh, &graded);
                if !edges.is_empty() {
                    again = true;
                    coarse.singular.iter().for_each(|x| cells.grade_towards(*x));
                    cells.part(&edges)?;
                }
                continue;
            }
            let Some((cell, corners)) = crowded(&coarse.mesh, &graded) else { continue };
            again = true;
            let corner = |k: usize| coarse.mesh.vertices[coarse.mesh.cells[cell].corners[k]];
            let place = |k: usize| self.cells[1 - number].as_ref()?.coordinate(self.extent.facing(number, corner(k)));
            let [Some(a), Some(b)] = corners.map(place) else { return Err(unmatched()) };
            self.apart.push(0.5 * (a + b));
        }
        Ok(again)
    }
}

fn unmatched() -> Fault {
    let message = "the cells of the two bodies cannot be given common points on the contact surface";
    let remedy = "let rows of cells run straight through the bodies from their contact edges";
    Fault::at("contact.edges", "not-available", message, remedy)
}
