//! The kept boundary: its path, its groups and the numbers of its unknowns.

use crate::boundary::path;
use crate::error::Error;
use crate::mesh::Mesh;
use crate::space::Space;

/// What is kept of a body: the unknowns of a boundary along its path, then the free motions of the rigid edge.
pub(crate) struct Kept {
    /// Edges of each kept boundary along its path, and whether each is walked against its own direction.
    pub(crate) walks: Vec<Vec<(usize, bool)>>,
    /// Groups whose unknowns are kept, in order.
    pub(crate) groups: Vec<usize>,
    /// First kept unknown of each group of the space; `None` for those that are eliminated.
    pub(crate) start: Vec<Option<usize>>,
    /// Number of kept unknowns.
    pub(crate) unknowns: usize,
}

impl Kept {
    /// What is kept with the boundaries of those names; the rigid edge alone without one.
    pub(crate) fn new(mesh: &Mesh, space: &Space, names: &[String]) -> Result<Kept, Error> {
        let walks = names.iter().map(|name| path(mesh, name)).collect::<Result<Vec<_>, _>>()?;
        let groups = kept_groups(mesh, space, &walks);
        let mut start = vec![None; space.size.len()];
        let mut unknowns = 0;
        for g in &groups {
            start[*g] = Some(unknowns);
            unknowns += space.size[*g];
        }
        Ok(Kept { walks, groups, start, unknowns })
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

/// Groups whose unknowns are kept: those of the paths in order, each once, then the rigid edge.
fn kept_groups(mesh: &Mesh, space: &Space, walks: &[Vec<(usize, bool)>]) -> Vec<usize> {
    let mut groups = Vec::new();
    let mut known = vec![false; space.size.len()];
    let mut push = |g: usize| {
        if space.size[g] > 0 && !std::mem::replace(&mut known[g], true) {
            groups.push(g);
        }
    };
    for walk in walks {
        for (i, (edge, against)) in walk.iter().enumerate() {
            let [a, b] = mesh.edges[*edge].vertices;
            let (from, to) = if *against { (b, a) } else { (a, b) };
            if i == 0 {
                push(from);
            }
            push(mesh.vertices.len() + edge);
            push(to);
        }
    }
    space.frame.iter().for_each(|(g, _)| push(*g));
    groups
}
