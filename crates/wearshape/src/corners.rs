//! Corners of the gap at the start, under which the pressure is singular: meshes of bodies as given have nodes there.

use meshing::Cut;

use crate::problem::Problem;
use crate::stage::Stage;
use crate::step::Step;

/// Distance of an end of contact from a corner, over half the surface, within which a node on the end serves for both.
const NEAR: f64 = 1e-5;
/// How far a place on a corner is moved, over the distance to the next one.
const ASIDE: f64 = 0.25;

impl Stage<'_> {
    /// Places from -1 to 1 along the surface at which the gap at the start has a corner, where bodies as given touch or wear.
    pub(crate) fn corners(&self) -> Vec<f64> {
        let Problem { plan, gap, .. } = self.problem;
        let asked = plan.runs(Step::Contact) || plan.runs(Step::Evolution);
        let places = self.patch.places().filter(|_| asked && !self.ends_move());
        places.map_or_else(Vec::new, |surface| gap.corners(surface))
    }

    /// The nodes of a cut and those on corners of the gap; none of a gap without, or of cuts that leave them out.
    pub(crate) fn with_corners(&self, cut: Cut<'_>) -> Option<Vec<f64>> {
        let corners = match cut {
            Cut::Plain | Cut::Ends(_) | Cut::Corners(_) => self.corners(),
            Cut::Shifted | Cut::Passed(_) => Vec::new(),
        };
        let apart = |corner: &&f64| cut.ends().iter().all(|end| (end - **corner).abs() > NEAR);
        let mut nodes: Vec<f64> = corners.iter().filter(apart).chain(cut.ends()).copied().collect();
        nodes.sort_unstable_by(f64::total_cmp);
        (!corners.is_empty()).then_some(nodes)
    }

    /// Places along the surface (arc lengths, ascending) of which those on a corner of the gap are moved aside: there the pressure may be infinite, which is none
    /// to compare.
    pub(crate) fn off_corners(&self, mut places: Vec<f64>, length: f64) -> Vec<f64> {
        for corner in self.corners().iter().map(|t| 0.5 * (1.0 + t) * length) {
            let next = places.partition_point(|place| *place < corner);
            for k in next.saturating_sub(1)..(next + 1).min(places.len()) {
                let apart = places.get(k + 1).map_or(0.0, |after| after - places[k]);
                if (places[k] - corner).abs() < ASIDE * apart {
                    places[k] = corner + ASIDE * apart;
                }
            }
        }
        places
    }
}
