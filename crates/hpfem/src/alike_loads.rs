//! Loads inside cells of one shape: their interior is condensed once for all of them.
//!
//! A cell that goes over into the first of its class by a turn `R` and a symmetry of the reference square takes its modes with it,
//! `N_i(-x) = (-1)^i N_i(x)`. Its loads `f` are there the loads `R^T f`, a further column, and what is left of them on the boundary comes back by `R`.

use crate::assembly::Assembly;
use crate::basis::LocalModes;
use crate::cell_heat::eliminate;
use crate::cell_matrix::map_cells;
use crate::congruence::{Class, Congruence, Turn};
use crate::element::Workspace;
use crate::error::Error;
use crate::on_boundary::OnBoundary;
use crate::point_load::Rows;
use crate::volume_load::InnerLoad;
use faer::{MatMut, MatRef};

/// Cells of one shape whose loads are there at once.
const AT_ONCE: usize = 64;

/// Corners of the reference square.
const CORNERS: [[f64; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

/// Cells of one class.
struct Alike<'a> {
    class: &'a Class,
    cells: &'a [(usize, &'a Turn)],
}

/// A member of a class: its modes, and those of the first cell that they are, `(there, here, sign)`.
struct Member {
    local: LocalModes,
    modes: Vec<(usize, usize, f64)>,
}

impl Assembly<'_> {
    /// The loads inside cells, by ascending number of these.
    pub(crate) fn inner_loads(&self, cells: &[usize], congruence: &Congruence) -> Result<Vec<OnBoundary>, Error> {
        let mut members = vec![Vec::new(); congruence.classes.len()];
        cells.iter().for_each(|cell| members[congruence.class[*cell]].push((*cell, &congruence.turn[*cell])));
        let classes = congruence.classes.iter().zip(&members);
        let alike: Vec<Alike<'_>> =
            classes.flat_map(|(class, members)| members.chunks(AT_ONCE).map(move |cells| Alike { class, cells })).collect();
        let made = map_cells(alike.len(), |work, k| self.of_alike(&alike[k], work));
        let mut loads = Vec::with_capacity(cells.len());
        for of_class in made {
            loads.extend(of_class?);
        }
        loads.sort_unstable_by_key(|load: &OnBoundary| load.cell);
        Ok(loads)
    }

    /// The loads inside cells of one class.
    fn of_alike(&self, alike: &Alike<'_>, work: &mut Workspace) -> Result<Vec<OnBoundary>, Error> {
        let Alike { class, cells } = *alike;
        if cells.len() == 1 || self.is_triangle(class) {
            let alone = |(cell, _): &(usize, &Turn)| {
                let InnerLoad { boundary, work, .. } = self.inner_load(*cell, work)?;
                Ok(OnBoundary { cell: *cell, boundary, work })
            };
            return cells.iter().map(alone).collect();
        }
        let local = self.class_modes(class);
        let (matrix, ni) = self.condensed(class.first, &local, work)?;
        Ok(self.condensed_loads(cells, &local, (matrix.as_ref(), ni)))
    }

    /// The quadrilaterals of each class that have loads inside; nothing where no cell has any.
    pub(crate) fn loaded<'c>(&self, congruence: &'c Congruence) -> Vec<Vec<(usize, &'c Turn)>> {
        let mut members = Vec::new();
        for (cell, (class, turn)) in congruence.class.iter().zip(&congruence.turn).enumerate() {
            if self.loads.inside(cell) && !self.is_triangle(&congruence.classes[*class]) {
                members.resize(congruence.classes.len(), Vec::new());
                members[*class].push((cell, turn));
            }
        }
        members
    }

    /// The loads inside cells of a class with these modes, whose matrix has its interior condensed.
    pub(crate) fn loads_of(
        &self,
        cells: Option<&Vec<(usize, &Turn)>>,
        local: &LocalModes,
        condensed: (MatRef<'_, f64>, usize),
    ) -> Vec<OnBoundary> {
        let parts = cells.into_iter().flat_map(|cells| cells.chunks(AT_ONCE));
        parts.flat_map(|cells| self.condensed_loads(cells, local, condensed)).collect()
    }

    fn is_triangle(&self, class: &Class) -> bool {
        self.mesh.cells[class.first].is_triangle()
    }

    /// The loads inside cells of a class with these modes, whose matrix has its first `ni` columns factorised.
    fn condensed_loads(
        &self,
        cells: &[(usize, &Turn)],
        local: &LocalModes,
        (matrix, ni): (MatRef<'_, f64>, usize),
    ) -> Vec<OnBoundary> {
        let (components, cases) = (self.space.components, self.loads.cases);
        let rows = Rows { components, local };
        let members: Vec<Member> = cells.iter().map(|(cell, turn)| self.member(*cell, turn, local)).collect();
        let height = components * local.modes;
        let mut loads = vec![0.0; height * cases * cells.len()];
        for ((member, (cell, turn)), columns) in members.iter().zip(cells).zip(loads.chunks_exact_mut(height * cases)) {
            let own = self.load_on_modes(*cell, &member.local);
            let own_rows = Rows { components, local: &member.local };
            let mut there = MatMut::from_column_major_slice_mut(columns, height, cases);
            for (first, here, sign) in &member.modes {
                for case in 0..cases {
                    let f = self.turned(|c| sign * own[(own_rows.row(*here, c), case)], |f| turn.back(f));
                    (0..components).for_each(|c| there[(rows.row(*first, c), case)] = f[c]);
                }
            }
        }
        let loads = eliminate(matrix, ni, &mut loads);
        let of_member = |(k, (member, (cell, turn))): (usize, (&Member, &(usize, &Turn)))| {
            let own = loads.get(.., k * cases..(k + 1) * cases);
            let (y, signs) = (own.get(..ni, ..), member.local.signs());
            let mut boundary = Vec::new();
            for (first, here, sign) in member.modes.iter().filter(|(_, here, _)| *here >= member.local.interior) {
                let (mode, sign) = (here - member.local.interior, sign * signs[*here]);
                for case in 0..cases {
                    let f = self.turned(|c| sign * own[(rows.row(*first, c), case)], |f| turn.there(f));
                    boundary.extend((0..components).map(|c| ((components * mode + c, case), f[c])));
                }
            }
            OnBoundary { cell: *cell, boundary, work: y.transpose() * y }
        };
        members.iter().zip(cells).enumerate().map(of_member).collect()
    }

    /// A cell as a member of the class of a cell with these modes.
    fn member(&self, cell: usize, turn: &Turn, first: &LocalModes) -> Member {
        let local = self.space.local_modes(self.mesh, cell);
        let places = first.position.iter().zip(turn.modes(self.space.cell_degree[cell] + 1));
        let both = places.map(|(there, (place, sign))| (*there, local.position[place], sign));
        let modes = both.filter(|(there, here, _)| *there != usize::MAX && *here != usize::MAX).collect();
        Member { local, modes }
    }

    /// The components of a load, turned where it is a vector.
    fn turned(&self, component: impl Fn(usize) -> f64, turn: impl Fn([f64; 2]) -> [f64; 2]) -> [f64; 2] {
        if self.space.components == 1 { [component(0), 0.0] } else { turn([component(0), component(1)]) }
    }
}

impl Turn {
    /// A vector of the first cell in the member.
    fn there(&self, v: [f64; 2]) -> [f64; 2] {
        self.matrix.map(|row| row[0] * v[0] + row[1] * v[1])
    }

    /// A vector of the member in the first cell.
    fn back(&self, v: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|c| self.matrix[0][c] * v[0] + self.matrix[1][c] * v[1])
    }

    /// For each mode `N_i(xi) N_j(eta)` of the first cell, one of `functions` in each direction, at `i + functions * j`: where the member has it, and its sign
    /// there.
    fn modes(&self, functions: usize) -> Vec<(usize, f64)> {
        let [origin, along_xi, _, along_eta] = self.corner.map(|corner| CORNERS[corner]);
        // Along each direction of the first cell the direction of the member, and whether it runs the other way.
        let direction = |end: [f64; 2]| {
            let along = usize::from(end[0] == origin[0]);
            (along, end[along] < origin[along])
        };
        let [(along, against_xi), (_, against_eta)] = [along_xi, along_eta].map(direction);
        let walked = |i: usize, against: bool| match (i, against) {
            (_, false) => (i, 1.0),
            (0 | 1, true) => (1 - i, 1.0),
            (_, true) => (i, if i.is_multiple_of(2) { 1.0 } else { -1.0 }),
        };
        let mode = |place: usize| {
            let ((i, one), (j, other)) = (walked(place % functions, against_xi), walked(place / functions, against_eta));
            (if along == 0 { i + functions * j } else { j + functions * i }, one * other)
        };
        (0..functions * functions).map(mode).collect()
    }
}
