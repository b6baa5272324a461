//! Displacement and stress inside the bodies, as plain numbers on the cells.

use hpfem::{CellGrid, Stress};

/// Both bodies at a moment.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldFrame {
    /// Simulated time; 0 where nothing runs in time.
    pub time: f64,
    /// Goes into the names of the files: "" for what is reported, "start" for the start of a wear run.
    pub moment: &'static str,
    /// Body 1 and body 2.
    pub bodies: [BodyField; 2],
}

/// One body, cell by cell; points are not shared, so that stresses may jump where they do.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct BodyField {
    /// The cells.
    pub cells: Vec<CellField>,
    /// The materials, by the index that cells have.
    pub materials: Vec<scene::Material>,
    /// The body is revolved about the axis: x is r, and y is the direction around the axis.
    pub revolved: bool,
    /// Friction twists the body: the displacement along y and the shears xy and yz are known.
    pub twisted: bool,
}

/// A cell at the points of its grid.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct CellField {
    /// Where the points are.
    pub grid: CellGrid,
    /// Positions (x, z), mm.
    pub position: Vec<[f64; 2]>,
    /// Displacements (x, y, z), mm.
    pub displacement: Vec<[f64; 3]>,
    /// Stresses, MPa.
    pub stress: Vec<Stress>,
    /// Temperatures, degC; empty without heat.
    pub temperature: Vec<f64>,
    /// Index of the material.
    pub material: usize,
    /// Whether a point lies on the contact surface.
    pub touching: Vec<bool>,
}

impl BodyField {
    /// The body with its mirror image about the line x = middle.
    pub fn mirrored(mut self, middle: f64) -> BodyField {
        let images: Vec<CellField> = self.cells.iter().map(|cell| cell.mirrored(middle)).collect();
        self.cells.extend(images);
        self
    }
}

impl CellField {
    /// The cell seen in the mirror x = middle; rows run backwards, so that its corners stay anti-clockwise.
    fn mirrored(&self, middle: f64) -> CellField {
        let order = self.grid.mirror();
        CellField {
            grid: self.grid,
            material: self.material,
            touching: order.iter().map(|k| self.touching.get(*k).copied().unwrap_or(false)).collect(),
            position: order.iter().map(|k| [2.0 * middle - self.position[*k][0], self.position[*k][1]]).collect(),
            displacement: order
                .iter()
                .map(|k| [-self.displacement[*k][0], self.displacement[*k][1], self.displacement[*k][2]])
                .collect(),
            stress: order
                .iter()
                .map(|k| Stress { xy: -self.stress[*k].xy, xz: -self.stress[*k].xz, ..self.stress[*k] })
                .collect(),
            temperature: order.iter().filter_map(|k| self.temperature.get(*k).copied()).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{BodyField, CellField, CellGrid};
    use hpfem::Stress;

    #[test]
    fn the_mirror_image_turns_shear_and_sideways_displacement_and_keeps_the_sense_of_the_corners() {
        let position = vec![[1.0, 0.0], [3.0, 0.0], [1.0, 1.0], [3.0, 1.0]];
        let stress = Stress::new([1.0, 2.0, 3.0, 4.0], [0.0; 2]);
        let grid = CellGrid { degree: 1, triangle: false };
        let cell = CellField {
            grid,
            displacement: vec![[0.1, 0.0, 0.2]; 4],
            stress: vec![stress; 4],
            position,
            touching: vec![true, false, false, false],
            ..CellField::default()
        };
        let whole = BodyField { cells: vec![cell], ..BodyField::default() }.mirrored(0.5);
        let image = &whole.cells[1];
        assert_eq!(image.position, [[-2.0, 0.0], [0.0, 0.0], [-2.0, 1.0], [0.0, 1.0]]);
        assert_eq!(image.touching, [false, true, false, false]);
        assert_eq!(image.displacement[0], [-0.1, 0.0, 0.2]);
        assert_eq!((image.stress[0].xx, image.stress[0].xz, image.stress[0].zz), (1.0, -3.0, 2.0));
    }
}
