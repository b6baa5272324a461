//! Bodies: kinematics, thickness, material, geometry, supports, contact edges.

use std::sync::Arc;

use scene::{Component, Contact, Fault, Gap, Geometry, Kinematics, Length, Material, Scene, did_you_mean};

use crate::couple::Body;
use crate::given::{Files, given, outside};
use crate::setup::{missing, positive};

/// Checks both bodies and the contact, and fills in their defaults. None of a surface alone.
pub(super) fn resolve(scene: &mut Scene, files: Files<'_>) -> Result<Option<(hpfem::Kinematics, [Body; 2])>, Fault> {
    friction(scene)?;
    if scene.surface.is_some() {
        return Ok(None);
    }
    let axisymmetric = match scene.kinematics {
        Some(kinematics) => kinematics == Kinematics::Axisymmetric,
        None => {
            let why = "two bodies need their kinematics";
            return Err(missing("kinematics", why, "kinematics = \"plane-stress\""));
        }
    };
    if !axisymmetric {
        let Some(thickness) = scene.thickness else {
            return Err(missing("thickness", "plane bodies need a thickness", "thickness = 10"));
        };
        positive("thickness", thickness.0, "thickness", " mm")?;
    }
    let names = ["body1", "body2"];
    let mut bodies = Vec::new();
    for (name, body) in names.iter().zip([&mut scene.body1, &mut scene.body2]) {
        let Some(body) = body else {
            let why = "a scene has two bodies, or a `surface` alone";
            return Err(missing(name, why, &format!("{name}.geometry.rectangle = {{ x = [-30, 30], z = [0, 100] }}")));
        };
        bodies.push(one_body(name, body, axisymmetric, files)?);
    }
    contact_edges(scene, &mut bodies, files)?;
    let thickness = scene.thickness.map_or(1.0, |thickness| thickness.0);
    let kinematics = match scene.kinematics {
        Some(Kinematics::PlaneStrain) => hpfem::Kinematics::PlaneStrain { thickness },
        Some(Kinematics::Axisymmetric) => hpfem::Kinematics::Axisymmetric,
        _ => hpfem::Kinematics::PlaneStress { thickness },
    };
    Ok(<[Body; 2]>::try_from(bodies).ok().map(|bodies| (kinematics, bodies)))
}

fn friction(scene: &mut Scene) -> Result<(), Fault> {
    let contact = scene.contact.get_or_insert(Contact { edges: None, friction: None, shear: None, gap: None });
    let friction = *contact.friction.get_or_insert(0.0);
    if !friction.is_finite() || friction < 0.0 {
        let message = format!("negative friction: contact.friction = {friction}");
        let remedy = "give a coefficient of friction of 0 or more; the sense of sliding is the sign of `sliding`";
        return Err(Fault::at("contact.friction", "wrong-value", message, remedy));
    }
    contact.shear.get_or_insert(true);
    Ok(())
}

fn one_body(name: &'static str, body: &mut scene::Body, axisymmetric: bool, files: Files<'_>) -> Result<Body, Fault> {
    geometry(name, &mut body.geometry, axisymmetric)?;
    match body.material {
        Some(material) => check_material(&format!("{name}.material"), material)?,
        None => {
            let own = match &body.geometry {
                Geometry::Blocks(blocks) => blocks.cells.values().all(|cell| cell.material.is_some()),
                // The groups of the file say below whether one is missing.
                Geometry::Mesh(mesh) => !mesh.materials.is_empty(),
                _ => false,
            };
            if !own {
                let example = format!("{name}.material = {{ young = \"210 GPa\", poisson = 0.3 }}");
                return Err(missing(&format!("{name}.material"), "every body needs one", &example));
            }
        }
    }
    let given = given(name, body, files)?;
    if let Some(given) = &given {
        on_axis_side(name, &given.mesh, axisymmetric)?;
    }
    let (cells, materials) = match given {
        Some(given) => (Some(Arc::new(given.mesh)), given.materials),
        None => (None, body.material.into_iter().collect()),
    };
    let (geometry, supports) = (body.geometry.clone(), body.support.clone());
    let typed = Body { key: name, geometry, cells, materials, supports, contact: String::new() };
    let edges = edge_names(&typed, true);
    for (edge, components) in &body.support {
        let key = format!("{name}.support.{edge}");
        known_edge(&key, edge, &edges)?;
        if components.is_empty() {
            let message = format!("{key} holds nothing");
            return Err(Fault::at(key, "wrong-value", message, "write the components held, as in [\"x\", \"z\"]"));
        }
        if components.contains(&Component::Phi) && !axisymmetric {
            let message = format!("{key}: \"phi\" is a component of axisymmetric bodies");
            return Err(Fault::at(key, "wrong-value", message, "write \"x\" or \"z\" here"));
        }
    }
    Ok(typed)
}

/// An axisymmetric body lies at r >= 0.
fn on_axis_side(name: &str, mesh: &hpfem::Mesh, axisymmetric: bool) -> Result<(), Fault> {
    let least = mesh.vertices.iter().map(|x| x[0]).fold(f64::INFINITY, f64::min);
    if !axisymmetric || least >= 0.0 {
        return Ok(());
    }
    let message = format!("an axisymmetric body reaches to r = {least}");
    Err(Fault::at(format!("{name}.geometry"), "degenerate", message, "give it points with x >= 0 only"))
}

fn check_material(key: &str, material: Material) -> Result<(), Fault> {
    positive(&format!("{key}.young"), material.young.0, "Young's modulus", " MPa")?;
    let nu = material.poisson;
    if !(nu > -1.0 && nu < 0.5) {
        let message = format!("Poisson's ratio {nu} is not between -1 and 0.5");
        let remedy = "give a ratio from 0 to 0.49999, as in poisson = 0.3";
        return Err(Fault::at(format!("{key}.poisson"), "wrong-value", message, remedy));
    }
    Ok(())
}

fn interval(key: &str, range: [Length; 2]) -> Result<(), Fault> {
    if range[0].0 < range[1].0 && range[0].0.is_finite() && range[1].0.is_finite() {
        return Ok(());
    }
    let message = format!("{key} = [{}, {}] does not increase", range[0].0, range[1].0);
    Err(Fault::at(key, "degenerate", message, "write [from, to] with from < to"))
}

fn radii(key: &str, inner: Length, outer: Length) -> Result<(), Fault> {
    positive(&format!("{key}.inner"), inner.0, "inner radius", " mm")?;
    if outer.0 > inner.0 && outer.0.is_finite() {
        return Ok(());
    }
    let message = format!("the outer radius {} is not greater than the inner radius {}", outer.0, inner.0);
    Err(Fault::at(format!("{key}.outer"), "degenerate", message, "give outer > inner"))
}

fn geometry(name: &str, geometry: &mut Geometry, axisymmetric: bool) -> Result<(), Fault> {
    let key = format!("{name}.geometry.{}", template(geometry));
    let plane_only = matches!(geometry, Geometry::ShoeBlock(_) | Geometry::Ring(_) | Geometry::RingSegment(_));
    if axisymmetric && plane_only {
        let message = format!("{} is a plane template, the scene is axisymmetric", template(geometry));
        let remedy = "use rectangle, half-disc, blocks or mesh, or kinematics = \"plane-stress\"";
        return Err(Fault::at(key, "wrong-value", message, remedy));
    }
    match geometry {
        Geometry::ShoeBlock(shoe) => {
            positive(&format!("{key}.radius"), shoe.radius.0, "radius", " mm")?;
            let angle = shoe.half_angle.0;
            if !(angle > 0.0 && angle < std::f64::consts::FRAC_PI_2) {
                let message =
                    format!("half angle {} deg: the shoe must close somewhere along its arc and have sides", degrees(angle));
                let remedy = "give a half angle greater than 0 and less than 90 deg";
                return Err(Fault::at(format!("{key}.half_angle"), "degenerate", message, remedy));
            }
            if shoe.top.0 <= shoe.radius.0 || !shoe.top.0.is_finite() {
                let message = format!("the top at z = {} is not above the arc of radius {}", shoe.top.0, shoe.radius.0);
                return Err(Fault::at(format!("{key}.top"), "degenerate", message, "give top > radius"));
            }
        }
        Geometry::Ring(ring) => {
            ring.centre.get_or_insert([Length(0.0), Length(0.0)]);
            radii(&key, ring.inner, ring.outer)?;
        }
        Geometry::RingSegment(segment) => {
            radii(&key, segment.inner, segment.outer)?;
            interval(&format!("{key}.x"), segment.x)?;
            if segment.x.iter().any(|x| x.0.abs() >= segment.inner.0) {
                let message = format!(
                    "the cuts x = {} and {} do not both cross the inner radius {}",
                    segment.x[0].0, segment.x[1].0, segment.inner.0
                );
                return Err(Fault::at(format!("{key}.x"), "degenerate", message, "give |x| < inner"));
            }
        }
        Geometry::Rectangle(rectangle) => {
            interval(&format!("{key}.x"), rectangle.x)?;
            interval(&format!("{key}.z"), rectangle.z)?;
            if axisymmetric && rectangle.x[0].0 < 0.0 {
                let message = format!("an axisymmetric body reaches to r = {}", rectangle.x[0].0);
                return Err(Fault::at(format!("{key}.x"), "degenerate", message, "give x = [from, to] with from >= 0"));
            }
        }
        Geometry::HalfDisc(disc) => {
            positive(&format!("{key}.radius"), disc.radius.0, "radius", " mm")?;
            if axisymmetric && disc.centre[0].0 != 0.0 {
                let message = format!("an axisymmetric half disc has its centre at r = {}", disc.centre[0].0);
                return Err(Fault::at(format!("{key}.centre"), "degenerate", message, "give centre = [0, z]"));
            }
        }
        Geometry::Blocks(blocks) => {
            for (material, values) in &blocks.materials {
                check_material(&format!("{key}.materials.{material}"), *values)?;
            }
        }
        Geometry::Mesh(file) => {
            for (material, values) in &file.materials {
                check_material(&format!("{key}.materials.{material}"), *values)?;
            }
        }
    }
    Ok(())
}

fn degrees(angle: f64) -> f64 {
    angle * 180.0 / std::f64::consts::PI
}

/// The key of a geometry template.
pub(crate) fn template(geometry: &Geometry) -> &'static str {
    match geometry {
        Geometry::ShoeBlock(_) => "shoe-block",
        Geometry::Ring(_) => "ring",
        Geometry::Rectangle(_) => "rectangle",
        Geometry::RingSegment(_) => "ring-segment",
        Geometry::HalfDisc(_) => "half-disc",
        Geometry::Blocks(_) => "blocks",
        Geometry::Mesh(_) => "mesh",
    }
}

/// The named edges of a body, with its inner lines for supports.
pub(super) fn edge_names(body: &Body, lines: bool) -> Vec<String> {
    let names: &[&str] = match &body.geometry {
        Geometry::ShoeBlock(_) => &["inner", "left", "right", "top"],
        Geometry::Ring(_) => &["inner", "outer"],
        Geometry::Rectangle(_) => &["left", "right", "bottom", "top"],
        Geometry::RingSegment(_) if lines => &["inner", "outer", "left", "right", "centre"],
        Geometry::RingSegment(_) => &["inner", "outer", "left", "right"],
        Geometry::HalfDisc(_) if lines => &["arc", "top", "centre"],
        Geometry::HalfDisc(_) => &["arc", "top"],
        Geometry::Blocks(blocks) => return blocks.edges.keys().cloned().collect(),
        Geometry::Mesh(_) => return body.cells.as_ref().map(|mesh| mesh.boundaries.clone()).unwrap_or_default(),
    };
    names.iter().map(|name| name.to_string()).collect()
}

/// Refuses an edge that the body does not have.
pub(super) fn known_edge(key: &str, edge: &str, edges: &[String]) -> Result<(), Fault> {
    if edges.iter().any(|known| known == edge) {
        return Ok(());
    }
    let known: Vec<&str> = edges.iter().map(String::as_str).collect();
    Err(Fault::at(key, "unknown-edge", format!("there is no edge `{edge}` here"), did_you_mean(edge, &known)))
}

fn contact_edges(scene: &mut Scene, bodies: &mut [Body], files: Files<'_>) -> Result<(), Fault> {
    let Some(contact) = &mut scene.contact else {
        return Ok(());
    };
    let Some(edges) = &contact.edges else {
        let why = "the scene must say which edges touch";
        return Err(missing("contact.edges", why, "contact.edges = [\"bottom\", \"top\"]"));
    };
    for (number, body) in bodies.iter().enumerate() {
        known_edge(&format!("contact.edges.{number}"), &edges[number], &edge_names(body, false))?;
    }
    for (body, edge) in bodies.iter_mut().zip(edges) {
        outside(body, edge)?;
        body.contact.clone_from(edge);
    }
    let gap = contact.gap.get_or_insert(Gap::Constant(0.0));
    match gap {
        Gap::Constant(0.0) => {}
        Gap::Constant(value) => {
            let message = format!("contact.gap = {value}: a uniform gap is no shape");
            let remedy = "write 0, or the name of a CSV file with the columns s_mm, gap_um";
            return Err(Fault::at("contact.gap", "wrong-value", message, remedy));
        }
        Gap::File(name) => *gap = crate::profile_file::read(files, name)?,
        Gap::Profile { s, gap } => crate::profile_file::check(s, gap)?,
    }
    Ok(())
}
