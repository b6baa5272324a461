//! The kept boundary: its path, its groups and the numbers of its unknowns.

use crate::boundary::open_path;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::space::Space;

/// What is kept of a body: the unknowns of a boundary along its path, then the free motions of the rigid edge.
pub(crate) struct Kept {
    /// Edges of the kept boundary along its path, and whether each is walked against its own direction.
    pub(crate) walk: Vec<(usize, bool)>,
    /// Groups whose unknowns are kept, in order.
    pub(crate) groups: Vec<usize>,
    /// First kept unknown of each group of the space; `None` for those that are eliminated.
    pub(crate) start: Vec<Option<usize>>,
    /// Number of kept unknowns.
    pub(crate) unknowns: usize,
}

impl Kept {
    /// What is kept with the boundary of that name; the rigid edge alone without one.
    pub(crate) fn new(mesh: &Mesh, space: &Space, name: Option<&str>) -> Result<Kept, Error> {
        let walk = name.map(|name| open_path(mesh, name)).transpose()?.unwrap_or_default();
        let groups = kept_groups(mesh, space, &walk);
        let mut start = vec![None; space.size.len()];
        let mut unknowns = 0;
        for g in &groups {
            start[*g] = Some(unknowns);
            unknowns += space.size[*g];
        }
        Ok(Kept { walk, groups, start, unknowns })
    }

    /// Kept unknowns of the free motions of the rigid edge, `[t_x, t_z, theta]`; `None` if not free.
    pub(crate) fn frame(&self, space: &Space) -> [Option<usize>; 3] {
        let mut frame = [None; 3];
        if let Some((group, rigid)) = &space.frame {
            let mut next = self.start[*group];
            for (slot, _) in frame.iter_mut().zip(rigid.free).filter(|(_, free)| *free) {
                *slot = next;
                next = next.map(|n| n + 1);
            }
        }
        frame
    }
}

/// Groups whose unknowns are kept: those of the path in order, then the rigid edge.
fn kept_groups(mesh: &Mesh, space: &Space, walk: &[(usize, bool)]) -> Vec<usize> {
    let mut groups = Vec::new();
    for (i, (edge, against)) in walk.iter().enumerate() {
        let [a, b] = mesh.edges[*edge].vertices;
        let (from, to) = if *against { (b, a) } else { (a, b) };
        if i == 0 {
            groups.push(from);
        }
        groups.extend([mesh.vertices.len() + edge, to]);
    }
    groups.extend(space.frame.iter().map(|(g, _)| *g));
    groups.retain(|g| space.size[*g] > 0);
    groups
}
