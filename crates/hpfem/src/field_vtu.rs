//! A displacement field as a file for VTK and ParaView.

use crate::cell_grid::CellGrid;
use crate::error::Error;
use crate::field::Field;
use crate::kinematics::Kinematics;
use crate::stress::Stress;
use crate::vtu::{Vtu, VtuArray, VtuKind};

/// Highest degree of a Lagrange cell that VTK draws.
const HIGHEST: usize = 10;

impl Field {
    /// The field as a file: every cell one curved Lagrange cell of its own degree, at most 10, the highest that VTK draws; up to there the
    /// displacement is exact, and what is no polynomial of that degree, exact arcs and stresses, is interpolated. Points belong to one
    /// cell each, so that stresses may jump. Coordinates are (x, 0, z) or (r, 0, z), the second axis being out of plane or around.
    ///
    /// Point arrays: `displacement` (3 components), `stress` (6: xx, yy, zz, xy, yz, xz with y out of plane or around), `von_mises`; cell arrays:
    /// `degree` and `material`. Of a potential, `potential` and `flux` (3). More may be added before the file is written with [`Vtu::text`].
    ///
    /// # Errors
    /// Those of [`Field::at`].
    pub fn vtu(&self) -> Result<Vtu, Error> {
        let (torsion, conduction) = (self.kinematics == Kinematics::Torsion, self.kinematics.is_conduction());
        let mut vtu = Vtu { vectors: "displacement".into(), scalars: "von_mises".into(), ..Vtu::default() };
        let (mut points, mut displacements, mut stresses, mut equivalent) = (vec![], vec![], vec![], vec![]);
        for (number, cell) in self.mesh().cells.iter().enumerate() {
            let grid = CellGrid { degree: self.degree(number).min(HIGHEST), triangle: cell.is_triangle() };
            let first = points.len() / 3;
            let kind = if grid.triangle { VtuKind::LagrangeTriangle } else { VtuKind::LagrangeQuadrilateral };
            vtu.cells.push((kind, grid.lagrange().into_iter().map(|node| first + node).collect()));
            for [xi, eta] in grid.reference() {
                let ([x, z], state) = (self.position(number, xi, eta), self.at(number, xi, eta)?);
                let ([u, w], [a, b, ..]) = (state.displacement, state.stress);
                points.extend([x, 0.0, z]);
                displacements.extend(if torsion { [0.0, u, 0.0] } else { [u, 0.0, w] });
                let s = if torsion { Stress::new([0.0; 4], [a, b]) } else { Stress::new(state.stress, [0.0; 2]) };
                let scalar = [a, b, 0.0, 0.0, 0.0, 0.0];
                stresses.extend(if conduction { scalar } else { [s.xx, s.yy, s.zz, s.xy, s.yz, s.xz] });
                equivalent.push(s.von_mises());
            }
        }
        vtu.points = VtuArray::new("position", 3, points);
        if conduction {
            let potential = displacements.chunks(3).map(|u| u[0]).collect();
            let flux = stresses.chunks(6).flat_map(|s| [-s[0], 0.0, -s[1]]).collect();
            (vtu.vectors, vtu.scalars) = ("flux".into(), "potential".into());
            vtu.point_arrays = vec![VtuArray::new("potential", 1, potential), VtuArray::new("flux", 3, flux)];
            return Ok(self.with_cells(vtu));
        }
        let arrays = [("displacement", 3, displacements), ("stress", 6, stresses), ("von_mises", 1, equivalent)];
        vtu.point_arrays = arrays.into_iter().map(|(name, components, values)| VtuArray::new(name, components, values)).collect();
        Ok(self.with_cells(vtu))
    }

    /// The file with the arrays of cells.
    fn with_cells(&self, mut vtu: Vtu) -> Vtu {
        let degrees = (0..self.cells()).map(|cell| self.degree(cell) as f64).collect();
        let materials = self.mesh().cells.iter().map(|cell| cell.material as f64).collect();
        vtu.cell_arrays = vec![VtuArray::new("degree", 1, degrees), VtuArray::new("material", 1, materials)];
        vtu
    }
}
