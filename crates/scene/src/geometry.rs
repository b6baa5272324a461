//! Geometry of bodies and of bare surfaces as the scene writes it.

use std::collections::BTreeMap;
use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::material::Material;
use crate::point_shape::PointShape;
use crate::units::{Angle, Length, Scale};

/// A body's shape; x to the right (r in axisymmetry), z up.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum Geometry {
    /// Block above a drum, arc below, flat on top. Edges inner, left, right, top.
    ShoeBlock(ShoeBlock),
    /// Full ring. Edges inner, outer.
    Ring(Ring),
    /// Rectangle. Edges left, right, bottom, top.
    Rectangle(Rectangle),
    /// Ring between two vertical lines. Edges inner, outer, left, right; line centre at x = 0.
    RingSegment(RingSegment),
    /// Lower half of a disc, or of a ball in axisymmetry. Edges arc, top; line centre at x = 0.
    HalfDisc(HalfDisc),
    /// Quadrilateral cells between named curves.
    Blocks(Blocks),
    /// A gmsh file; edges are its physical groups.
    Mesh(MeshFile),
}

impl Geometry {
    /// The key of its template.
    pub fn name(&self) -> &'static str {
        match self {
            Geometry::ShoeBlock(_) => "shoe-block",
            Geometry::Ring(_) => "ring",
            Geometry::Rectangle(_) => "rectangle",
            Geometry::RingSegment(_) => "ring-segment",
            Geometry::HalfDisc(_) => "half-disc",
            Geometry::Blocks(_) => "blocks",
            Geometry::Mesh(_) => "mesh",
        }
    }

    /// The quadrilaterals between named curves; none of another geometry.
    pub fn blocks(&self) -> Option<&Blocks> {
        if let Geometry::Blocks(blocks) = self { Some(blocks) } else { None }
    }

    /// The gmsh file; none of another geometry.
    pub fn mesh(&self) -> Option<&MeshFile> {
        if let Geometry::Mesh(file) = self { Some(file) } else { None }
    }

    /// The materials of cells by name; none of a template.
    pub fn materials(&self) -> Option<&BTreeMap<String, Material>> {
        self.blocks().map(|blocks| &blocks.materials).or_else(|| self.mesh().map(|file| &file.materials))
    }

    /// The same, to be changed.
    pub fn materials_mut(&mut self) -> Option<&mut BTreeMap<String, Material>> {
        if let Geometry::Blocks(blocks) = self {
            return Some(&mut blocks.materials);
        }
        if let Geometry::Mesh(file) = self { Some(&mut file.materials) } else { None }
    }
}

/// Block above a drum.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ShoeBlock {
    /// Radius of the arc about the origin (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub radius: Length,
    /// The arc reaches from minus to plus this angle from the z axis.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub half_angle: Angle,
    /// Height z of the flat top (mm).
    pub top: Length,
}

/// Full ring.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Ring {
    /// Inner radius (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub inner: Length,
    /// Outer radius (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub outer: Length,
    /// Centre [x, z]. Default the origin.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre: Option<[Length; 2]>,
}

/// Rectangle.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Rectangle {
    /// From and to along x (mm).
    pub x: [Length; 2],
    /// From and to along z (mm).
    pub z: [Length; 2],
}

/// Upper part of a ring about the origin, cut by two vertical lines.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct RingSegment {
    /// Inner radius (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub inner: Length,
    /// Outer radius (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub outer: Length,
    /// The cuts x = from and x = to (mm).
    pub x: [Length; 2],
}

/// Lower half of a disc.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct HalfDisc {
    /// Radius (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub radius: Length,
    /// Centre [x, z]; the cut is horizontal through it.
    pub centre: [Length; 2],
}

/// Quadrilateral cells between named curves.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Blocks {
    /// Named points: [x, z], or { radius, angle } about a centre.
    pub points: BTreeMap<String, PointShape>,
    /// Named curves between points.
    pub curves: BTreeMap<String, CurveShape>,
    /// Named cells.
    pub cells: BTreeMap<String, CellShape>,
    /// Named edges, each a list of curves.
    pub edges: BTreeMap<String, Vec<String>>,
    /// Named materials of cells.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub materials: BTreeMap<String, Material>,
}

/// One curve of `blocks`.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum CurveShape {
    /// Straight between two points.
    Line([String; 2]),
    /// Circular arc between two points.
    Arc(ArcShape),
    /// Smooth curve between two points through further places.
    Spline(SplineShape),
}

/// A circular arc.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct ArcShape {
    /// First and last point.
    pub ends: [String; 2],
    /// Centre [x, z]. Default the origin.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub centre: Option<[Length; 2]>,
}

/// A smooth curve: the polynomial through its places by chord length.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct SplineShape {
    /// First and last point.
    pub ends: [String; 2],
    /// Places [x, z] between them, in order; 1 to 7.
    pub through: Vec<[Length; 2]>,
}

/// One cell of `blocks`.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct CellShape {
    /// Its four curves in order around it.
    pub curves: [String; 4],
    /// Name of its material; default the body's own.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub material: Option<String>,
}

/// A gmsh file.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct MeshFile {
    /// Path, relative to the scene.
    pub file: String,
    /// SHA-256 of the file, to be sure that it is the one meant.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub sha256: Option<String>,
    /// What the coordinates of the file are multiplied by, or their unit: "m" for a mesh in metres. Default 1.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub scale: Option<Scale>,
    /// Rotation about the origin after that, anti-clockwise: from +x towards +z. Default 0.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rotate: Option<Angle>,
    /// Shift [x, z] after that (mm). Default [0, 0].
    #[serde(rename = "move", skip_serializing_if = "Option::is_none")]
    pub shift: Option<[Length; 2]>,
    /// Materials by physical group of cells; default the body's own.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub materials: BTreeMap<String, Material>,
    /// The bytes of the file, once it is read.
    #[serde(skip)]
    pub content: Option<Arc<[u8]>>,
}

/// A contact surface without bodies.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum SurfaceShape {
    /// Sector of an annulus on a disc that turns about the origin.
    DiscPad(DiscPad),
    /// Shoe that turns about a fixed pin inside a drum.
    PinnedShoe(PinnedShoe),
    /// Shoe on a pivot, pressed on a drum.
    PivotedShoe(PivotedShoe),
    /// Rectangle on a plane, with two moments.
    RectangularPunch(RectangularPunch),
    /// Ellipse on a plane, with two moments.
    EllipticPunch(EllipticPunch),
    /// Arc of a bearing shell on a turning shaft.
    JournalArc(JournalArc),
}

/// Sector of an annulus.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct DiscPad {
    /// Inner radius (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub inner: Length,
    /// Outer radius (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub outer: Length,
    /// The sector reaches from minus to plus this angle from the x axis.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub half_angle: Angle,
}

/// Shoe about a pin inside a drum. Angles are measured at the drum's centre from the direction of the pin.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PinnedShoe {
    /// Inner radius of the drum (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub radius: Length,
    /// Width of the lining along y (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub width: Length,
    /// Distance of the pin from the drum's centre (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub pin_distance: Length,
    /// Where the lining begins.
    pub from: Angle,
    /// Where the lining ends.
    pub to: Angle,
    /// Lever arm of the actuating force about the pin (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub arm: Length,
}

/// Shoe on a pivot.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct PivotedShoe {
    /// Radius of the drum about the origin (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub radius: Length,
    /// The lining reaches from minus to plus this angle from the z axis.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub half_angle: Angle,
    /// Width of the lining along y (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub width: Length,
    /// Height of the pivot above the drum's centre (mm). Default: where friction has no moment for b = 1,
    /// 4 R sin(a0) / (2 a0 + sin(2 a0)).
    #[serde(skip_serializing_if = "Option::is_none")]
    pub pivot: Option<Length>,
}

/// Rectangle on a plane.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct RectangularPunch {
    /// From and to along x (mm).
    pub x: [Length; 2],
    /// From and to along y (mm).
    pub y: [Length; 2],
}

/// Ellipse about the origin.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct EllipticPunch {
    /// Half axes along x and y (mm).
    pub half_axes: [Length; 2],
}

/// Arc of a bearing shell.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct JournalArc {
    /// Radius of the shaft about the origin (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub radius: Length,
    /// The shell reaches from minus to plus this angle from the z axis.
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub half_angle: Angle,
    /// Width along y (mm).
    #[cfg_attr(feature = "schema", schemars(extend("exclusiveMinimum" = 0)))]
    pub width: Length,
}
