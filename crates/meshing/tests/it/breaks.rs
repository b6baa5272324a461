//! Both bodies have the same break points on the contact surface, whatever gives them and wherever it is cut.

use hpfem::Mesh;
use meshing::{Body, CONTACT, Couple, Cut, Extent, HalfDiscOnFlat, LOAD, Strip, meshes};
use scene::LoadKind;

use crate::common::{DISC, DRUM, PLATE, PUNCH, SEGMENT, SHOE, SHOE_CELLS, UNDER_DISC, body, breaks, couple, extent, two_cells};

/// Share of the surface within which break points are common.
const NEAR: f64 = 1e-10;

fn near(extent: Extent) -> f64 {
    let [from, to] = extent.ends();
    NEAR * (to - from)
}

/// The common break points; fails where the bodies have others.
fn common(couple: &Couple, extent: Extent, meshes: &[Mesh; 2]) -> Vec<f64> {
    let [first, second] = meshes.each_ref().map(|mesh| breaks(couple, extent, mesh));
    assert_eq!(first.len(), second.len(), "{first:?}\n{second:?}");
    for (a, b) in first.iter().zip(&second) {
        assert!((a - b).abs() <= near(extent), "{a} and {b}");
    }
    // One edge between two break points, in both: the surface is covered once.
    for mesh in meshes {
        assert_eq!(mesh.boundary(CONTACT).unwrap().len() + 1, first.len());
    }
    let [from, to] = extent.ends();
    assert!((first[0] - from).abs() <= near(extent) && (first[first.len() - 1] - to).abs() <= near(extent));
    first
}

/// Layers on both sides of a place of which the smallest cell is next to it.
fn is_graded(places: &[f64], place: f64) -> bool {
    let lengths: Vec<f64> = places.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let shortest = |i: usize, j: Option<&f64>| j.is_none_or(|further| lengths[i] < 0.5 * further);
    let Some(at) = places.iter().position(|x| (x - place).abs() < 1e-9) else { return false };
    let right = at >= lengths.len() || shortest(at, lengths.get(at + 1));
    let left = at == 0 || shortest(at - 1, at.checked_sub(2).and_then(|i| lengths.get(i)));
    left && right
}

/// Plain, shifted, and cut at ends of contact: far from the ends of the surface, one next to it, and as many as a wavy surface has, with no other break point
/// between some of them.
fn agree(couple: &Couple) {
    let extent = extent(couple);
    let [from, to] = extent.ends();
    let of = |layers: usize, cut: Cut<'_>| common(couple, extent, &meshes(couple, extent, layers, cut).unwrap());
    let coarse = of(0, Cut::Plain);
    assert!(coarse.len() >= 3);
    let plain = of(4, Cut::Plain);
    assert_eq!(plain.len(), coarse.len() + 2 * 4, "four layers at both ends of the surface");
    assert!(is_graded(&plain, from) && is_graded(&plain, to));
    let known = |places: &[f64], x: f64| places.iter().any(|known| (known - x).abs() <= near(extent));
    let shifted = of(0, Cut::Shifted);
    assert!(shifted.iter().any(|x| !known(&coarse, *x)), "another mesh: {shifted:?}");
    // Next to the end of the surface cells are about as small as their distance from it, before any layers.
    let close = of(0, Cut::Ends(&[0.99]));
    let [.., before, place, _, _] = close[..] else { unreachable!() };
    assert!((to - place - 0.005 * (to - from)).abs() <= near(extent) && place - before < 6.0 * (to - place), "{close:?}");
    for ends in [[-0.3, 0.55].as_slice(), &[0.2], &[-0.4, 0.99], &[-0.978, -0.928, -0.216, 0.221, 0.349, 0.387]] {
        let cut = of(4, Cut::Ends(ends));
        for t in ends {
            let place = from + 0.5 * (1.0 + t) * (to - from);
            assert!(known(&cut, place), "no break point at {place} of {ends:?}: {cut:?}");
            assert!(is_graded(&cut, place), "no layers around {place}: {cut:?}");
        }
    }
}

fn drum() -> Body {
    body("body2", DRUM, "outer", "inner = ['x', 'z']")
}

#[test]
fn shoe_block_on_ring() {
    agree(&couple(body("body1", SHOE, "inner", "left = ['x']"), drum(), "top", LoadKind::Pressure));
}

#[test]
fn rectangle_on_rectangle() {
    let plate = body("body2", PLATE, "top", "bottom = ['x', 'z']");
    agree(&couple(body("body1", PUNCH, "bottom", "left = ['x']"), plate, "top", LoadKind::Rigid));
}

/// A segment also breaks where its strip of load ends, and the drum there with it.
#[test]
fn ring_segment_on_ring() {
    let mut couple = couple(body("body1", SEGMENT, "inner", "left = ['x']"), drum(), "outer", LoadKind::Vertical);
    agree(&couple);
    couple.load.strip = Some(Strip { centre: 10.0, width: 50.0 });
    agree(&couple);
    let [segment, _] = meshes(&couple, extent(&couple), 0, Cut::Plain).unwrap();
    let loaded = segment.boundary(LOAD).unwrap();
    let x: Vec<f64> = loaded.iter().flat_map(|e| segment.edges[*e].vertices).map(|v| segment.vertices[v][0]).collect();
    let ends = x.iter().fold([f64::MAX, f64::MIN], |[a, b], x| [a.min(*x), b.max(*x)]);
    assert!((ends[0] + 15.0).abs() < 1e-9 && (ends[1] - 35.0).abs() < 1e-9, "{ends:?}");
}

/// Cells of the shoe meet at 7 deg: a point that the template of the drum has for their sake only.
#[test]
fn cells_on_ring() {
    let couple = couple(body("body1", SHOE_CELLS, "inner", "left = ['x'], right = ['x']"), drum(), "top", LoadKind::Pressure);
    agree(&couple);
    let extent = extent(&couple);
    let places = common(&couple, extent, &meshes(&couple, extent, 0, Cut::Plain).unwrap());
    assert!(places.iter().any(|x| (x - 7_f64.to_radians()).abs() < 1e-12), "{places:?}");
}

#[test]
fn cells_on_rectangle() {
    let punch = body("body1", &two_cells([-30.0, 3.0, 30.0], [0.0, 100.0]), "bottom", "left = ['x']");
    agree(&couple(punch, body("body2", PLATE, "top", "bottom = ['x', 'z']"), "top", LoadKind::Rigid));
}

#[test]
fn rectangle_on_cells() {
    let plate = body("body2", &two_cells([-70.0, 11.0, 80.0], [-60.0, 0.0]), "top", "bottom = ['x', 'z']");
    let couple = couple(body("body1", PUNCH, "bottom", "left = ['x']"), plate, "top", LoadKind::Rigid);
    agree(&couple);
    let extent = extent(&couple);
    let places = common(&couple, extent, &meshes(&couple, extent, 0, Cut::Plain).unwrap());
    assert!(places.contains(&11.0), "{places:?}");
}

#[test]
fn cells_on_cells() {
    let punch = body("body1", &two_cells([-30.0, 3.0, 30.0], [0.0, 100.0]), "bottom", "left = ['x']");
    let plate = body("body2", &two_cells([-70.0, 11.0, 80.0], [-60.0, 0.0]), "top", "bottom = ['x', 'z']");
    agree(&couple(punch, plate, "top", LoadKind::Rigid));
}

/// A round body faces a flat one across a gap: common are the coordinates x. Layers are not: they divide an arc by its angle.
#[test]
fn half_disc_on_cells() {
    let disc = body("body1", DISC, "arc", "centre = ['x']");
    let cells = body("body2", &two_cells([-56.0, 9.0, 64.0], [-80.0, 0.0]), "top", "bottom = ['x', 'z']");
    let couple = couple(disc, cells, "top", LoadKind::Pressure);
    let extent = Extent::Round { x: [2.0, 6.0], touch: 4.0, radius: 50.0 };
    for (cut, wanted) in [(Cut::Plain, vec![4.0]), (Cut::Ends(&[-0.5, 0.5]), vec![3.0, 5.0])] {
        let places = common(&couple, extent, &meshes(&couple, extent, 0, cut).unwrap());
        for x in wanted {
            assert!(places.iter().any(|place| (place - x).abs() < 1e-9), "{x} is not in {places:?}");
        }
    }
}

/// Of a half-disc's own meshes the nodes are break points of both, and the surface reaches half as far again as the contact.
#[test]
fn half_disc_on_rectangle() {
    let disc = body("body1", DISC, "arc", "centre = ['x']");
    let couple = couple(disc, body("body2", UNDER_DISC, "top", "bottom = ['x', 'z']"), "top", LoadKind::Rigid);
    let on_flat = HalfDiscOnFlat::of(&couple).unwrap().unwrap();
    let extent = Extent::X([4.0 - 1.5 * 1.3, 4.0 + 1.5 * 1.3]);
    let places = common(&couple, extent, &on_flat.meshes(&[0.8, 1.3], 3).unwrap());
    for x in [4.0 - 1.3, 4.0 - 0.8, 4.0, 4.0 + 0.8, 4.0 + 1.3] {
        assert!(places.iter().any(|place| (place - x).abs() < 1e-12), "{x} is not in {places:?}");
    }
}

/// Pieces of the edges of a block under a ball keep their names at every size: round-off in their ends took the support of some or of all of them away.
#[test]
fn a_block_under_a_ball_has_all_of_its_edges_at_every_size() {
    for step in 0..200 {
        let by = 1.0 + 0.0173 * f64::from(step);
        let [radius, width, depth] = [11.2 * by, 17.92 * by, 42.7952 * by];
        let disc =
            body("body1", &format!("half-disc = {{ radius = {radius:?}, centre = [0, {radius:?}] }}"), "arc", "centre = ['x']");
        let flat = format!("rectangle = {{ x = [{:?}, {width:?}], z = [{:?}, 0] }}", -width, -depth);
        let couple = couple(disc, body("body2", &flat, "top", "bottom = ['x', 'z']"), "top", LoadKind::Pressure);
        // The half on one side of the axis of symmetry.
        let [_, block] = HalfDiscOnFlat::of(&couple).unwrap().unwrap().meshes(&[0.03 * radius], 2).unwrap();
        let length = |name: &str| {
            let edges = block.boundary(name).unwrap_or_default();
            edges.iter().map(|e| block.edges[*e].curve.length()).sum::<f64>()
        };
        assert!((length("bottom") - width).abs() < 1e-9 * width, "times {by}: {} of {}", length("bottom"), width);
        assert!((length("right") - depth).abs() < 1e-9 * depth, "times {by}: {} of {depth}", length("right"));
    }
}

/// Wherever contact ends, alone, on both sides or beside another end, there is a mesh with a node there.
#[test]
fn ends_anywhere() {
    let plate = body("body2", PLATE, "top", "bottom = ['x', 'z']");
    let couples = [
        couple(body("body1", SHOE, "inner", "left = ['x']"), drum(), "top", LoadKind::Pressure),
        couple(body("body1", PUNCH, "bottom", "left = ['x']"), plate, "top", LoadKind::Rigid),
        couple(body("body1", SEGMENT, "inner", "left = ['x']"), drum(), "outer", LoadKind::Vertical),
        couple(body("body1", SHOE_CELLS, "inner", "left = ['x'], right = ['x']"), drum(), "top", LoadKind::Pressure),
    ];
    for couple in &couples {
        let extent = extent(couple);
        let [from, to] = extent.ends();
        for t in (0..100).map(|i| -0.9975 + 0.02015 * f64::from(i)) {
            for ends in [vec![t], vec![-t.abs(), t.abs()], vec![t.min(0.31), t.max(0.31)], vec![t.min(-0.77), t.max(-0.77)]] {
                let places = common(couple, extent, &meshes(couple, extent, 4, Cut::Ends(&ends)).unwrap());
                let place = |t: f64| from + 0.5 * (1.0 + t) * (to - from);
                assert!(
                    ends.iter().all(|t| places.iter().any(|x| (x - place(*t)).abs() <= near(extent))),
                    "{ends:?}: {places:?}"
                );
            }
        }
    }
}
