//! Files of VTK and ParaView for cells and the values on them: `*.vtu`, an unstructured grid with its arrays inline as base64.

use crate::error::Error;
use base64::Engine;

/// A cell of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VtuKind {
    /// Flat, three points.
    Triangle,
    /// Flat, four points.
    Quadrilateral,
    /// Curved, of any degree `p`: `(p + 1)(p + 2) / 2` points in the order of [`CellGrid::lagrange`](crate::CellGrid::lagrange).
    LagrangeTriangle,
    /// Curved, of any degree `p`: `(p + 1)^2` points in the same order.
    LagrangeQuadrilateral,
}

/// Named values.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VtuArray {
    /// Name; what is not ASCII is written as UTF-8.
    pub name: String,
    /// Number of components: 1 for scalars, 3 for vectors, 6 for symmetric tensors (xx, yy, zz, xy, yz, xz).
    pub components: usize,
    /// The values, `points x components` or `cells x components`, in any unit.
    pub values: Vec<f64>,
}

/// The content of a file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Vtu {
    /// Positions of the points, three components.
    pub points: VtuArray,
    /// Cells by their points.
    pub cells: Vec<(VtuKind, Vec<usize>)>,
    /// Values at the points.
    pub point_arrays: Vec<VtuArray>,
    /// Values of the cells.
    pub cell_arrays: Vec<VtuArray>,
    /// Name of the point array that is the displacement of the grid when it is shown deformed; none if empty.
    pub vectors: String,
    /// Name of the point array that is shown first; none if empty.
    pub scalars: String,
}

impl VtuKind {
    /// VTK's number of the kind.
    pub fn number(self) -> u8 {
        match self {
            VtuKind::Triangle => 5,
            VtuKind::Quadrilateral => 9,
            VtuKind::LagrangeTriangle => 69,
            VtuKind::LagrangeQuadrilateral => 70,
        }
    }

    /// Whether a cell can have this number of points.
    fn takes(self, points: usize) -> bool {
        match self {
            VtuKind::Triangle => points == 3,
            VtuKind::Quadrilateral => points == 4,
            VtuKind::LagrangeTriangle => (1..=points).any(|p| (p + 1) * (p + 2) / 2 == points),
            VtuKind::LagrangeQuadrilateral => points >= 4 && points.isqrt().pow(2) == points,
        }
    }
}

impl VtuArray {
    /// An array of the given name, number of components and values.
    pub fn new(name: impl Into<String>, components: usize, values: Vec<f64>) -> VtuArray {
        VtuArray { name: name.into(), components, values }
    }

    fn check(&self, rows: usize) -> Result<(), Error> {
        if self.components > 0 && self.values.len() == rows * self.components {
            return Ok(());
        }
        let what = format!("values of \"{}\"", self.name);
        Err(Error::Count { what, given: self.values.len(), expected: rows * self.components.max(1) })
    }

    fn text(&self) -> String {
        let bytes: Vec<u8> = self.values.iter().flat_map(|value| value.to_le_bytes()).collect();
        array("Float64", &self.name, self.components, &bytes)
    }
}

impl Vtu {
    /// The file, the same bytes for the same content.
    ///
    /// VTK draws Lagrange cells up to degree 10; higher ones are written all the same.
    ///
    /// # Errors
    /// [`Error::Count`] for arrays whose length is not that of the points or cells times their components, and for cells with a number of points that
    /// their kind cannot have; [`Error::Beyond`] for cells with points that there are not.
    pub fn text(&self) -> Result<String, Error> {
        let points = self.points.values.len() / 3;
        self.check(points)?;
        let mut out = format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
             <UnstructuredGrid>\n<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{}\">\n",
            self.cells.len()
        );
        let shown = [("Vectors", &self.vectors), ("Scalars", &self.scalars)].into_iter().filter(|(_, name)| !name.is_empty());
        let shown: String = shown.map(|(role, name)| format!(" {role}=\"{}\"", escaped(name))).collect();
        out += &format!("<PointData{shown}>\n");
        self.point_arrays.iter().for_each(|array| out += &array.text());
        out += "</PointData>\n<CellData>\n";
        self.cell_arrays.iter().for_each(|array| out += &array.text());
        out += "</CellData>\n<Points>\n";
        out += &self.points.text();
        out += "</Points>\n<Cells>\n";
        let bytes =
            |values: &mut dyn Iterator<Item = usize>| values.flat_map(|value| (value as i64).to_le_bytes()).collect::<Vec<u8>>();
        let mut end = 0;
        let mut ends = self.cells.iter().map(|(_, nodes)| {
            end += nodes.len();
            end
        });
        let types: Vec<u8> = self.cells.iter().map(|(kind, _)| kind.number()).collect();
        let mut nodes = self.cells.iter().flat_map(|(_, nodes)| nodes.iter().copied());
        out += &array("Int64", "connectivity", 1, &bytes(&mut nodes));
        out += &array("Int64", "offsets", 1, &bytes(&mut ends));
        out += &array("UInt8", "types", 1, &types);
        Ok(out + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")
    }

    fn check(&self, points: usize) -> Result<(), Error> {
        if self.points.components != 3 {
            let what = "components of positions".into();
            return Err(Error::Count { what, given: self.points.components, expected: 3 });
        }
        self.points.check(points)?;
        self.point_arrays.iter().try_for_each(|array| array.check(points))?;
        self.cell_arrays.iter().try_for_each(|array| array.check(self.cells.len()))?;
        for (number, (kind, nodes)) in self.cells.iter().enumerate() {
            if let Some(node) = nodes.iter().find(|node| **node >= points) {
                return Err(Error::Beyond { by: format!("cell {number}"), what: "point", index: *node, count: points });
            }
            if !kind.takes(nodes.len()) {
                let expected = if matches!(kind, VtuKind::Triangle | VtuKind::LagrangeTriangle) { 3 } else { 4 };
                return Err(Error::Count { what: format!("points of cell {number}"), given: nodes.len(), expected });
            }
        }
        Ok(())
    }
}

/// An array in VTK's inline binary form: the number of bytes, then the bytes, as one base64 text.
fn array(kind: &str, name: &str, components: usize, bytes: &[u8]) -> String {
    let mut data = (bytes.len() as u64).to_le_bytes().to_vec();
    data.extend_from_slice(bytes);
    let text = base64::engine::general_purpose::STANDARD.encode(&data);
    let name = escaped(name);
    format!(
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"binary\">{text}</DataArray>\n"
    )
}

fn escaped(name: &str) -> String {
    name.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
