use hpfem::*;
use std::time::Instant;
fn main() {
    let (r, a0) = (200.0f64, 30f64.to_radians());
    let mat = [Material::new(210e3, 0.3).unwrap()];
    let kin = Kinematics::PlaneStress { thickness: 10.0 };
    let mu: f64 = std::env::args().nth(1).map_or(0.25, |s| s.parse().unwrap());
    let args: Vec<usize> = std::env::args()
        .skip(2)
        .map(|s| s.parse().unwrap())
        .collect();
    let (p, layers) = (args[0], args[1]);
    let law = |m: &Mesh| -> Vec<usize> {
        m.cells
            .iter()
            .map(|c| {
                (p + 1)
                    .saturating_sub(c.layer * p / layers.max(1))
                    .clamp(2, p)
            })
            .collect()
    };
    let half = std::f64::consts::FRAC_PI_2;
    let t0 = Instant::now();
    // shoe
    let h = r * a0.sin();
    let inner = Curve::Arc {
        centre: [0.0; 2],
        radius: r,
        from: half + a0,
        to: half - a0,
    };
    let top = Curve::Line {
        start: [-h, 300.0],
        end: [h, 300.0],
    };
    let n = |side, name| Named {
        side,
        range: None,
        name,
    };
    let shoe = Mesh::ruled(&Ruled {
        bottom: inner,
        top,
        breaks: &[-1.0, 0.0, 1.0],
        levels: &[0.0, 1.0],
        closed: false,
        material: 0,
        names: &[
            n(Side::Bottom, "inner"),
            n(Side::Top, "top"),
            n(Side::Left, "left"),
            n(Side::Right, "right"),
        ],
    })
    .unwrap();
    let v = [
        shoe.nearest_vertex([-h, r * a0.cos()]),
        shoe.nearest_vertex([h, r * a0.cos()]),
    ];
    let shoe = shoe.refined_towards(&v, 0.15, layers).unwrap();
    // drum: angles from -180 to 180 (alpha), breaks in t = alpha/180
    let b = [
        -1.0,
        -2.0 / 3.0,
        -1.0 / 3.0,
        -1.0 / 6.0,
        0.0,
        1.0 / 6.0,
        1.0 / 3.0,
        2.0 / 3.0,
        1.0,
    ];
    let arc = |radius| Curve::Arc {
        centre: [0.0; 2],
        radius,
        from: half + std::f64::consts::PI,
        to: half - std::f64::consts::PI,
    };
    let drum = Mesh::ruled(&Ruled {
        bottom: arc(100.0),
        top: arc(200.0),
        breaks: &b,
        levels: &[0.0, 1.0],
        closed: true,
        material: 0,
        names: &[
            n(Side::Bottom, "hub"),
            n(Side::Top, "outer"),
            Named {
                side: Side::Top,
                range: Some([-1.0 / 6.0, 1.0 / 6.0]),
                name: "contact",
            },
        ],
    })
    .unwrap();
    let v = [
        drum.nearest_vertex([-h, r * a0.cos()]),
        drum.nearest_vertex([h, r * a0.cos()]),
    ];
    let drum = drum.refined_towards(&v, 0.15, layers).unwrap();
    let t1 = Instant::now();
    let sup = |b: &str, direction| Support {
        boundary: b.into(),
        direction,
        value: 0.0,
    };
    let tl = vec![vec![EdgeTraction {
        boundary: "top".into(),
        traction: Box::new(|_| [0.0, -5.0]),
    }]];
    let s1 = [
        sup("left", Direction::First),
        sup("right", Direction::First),
    ];
    let s2 = [sup("hub", Direction::First), sup("hub", Direction::Second)];
    let b1 = Body::new(BodyProblem {
        mesh: &shoe,
        degrees: law(&shoe),
        space: SpaceKind::Tensor,
        kinematics: kin,
        materials: &mat,
        supports: &s1,
        rigid_edge: None,
        load_cases: &tl,
        kept: Some("inner"),
    })
    .unwrap();
    let b2 = Body::new(BodyProblem {
        mesh: &drum,
        degrees: law(&drum),
        space: SpaceKind::Tensor,
        kinematics: kin,
        materials: &mat,
        supports: &s2,
        rigid_edge: None,
        load_cases: &[],
        kept: Some("contact"),
    })
    .unwrap();
    let t2 = Instant::now();
    let pr = 5.0;
    let solve = |b: &Body, sign: f64, cases: &[f64]| {
        let i = &b.interface;
        let load = i.trace.load(kin, 4, |q| {
            let nn = q.outward.map(|v| -sign * v);
            let tau = [-nn[1], nn[0]];
            [
                sign * pr * (nn[0] + mu * tau[0]),
                sign * pr * (nn[1] + mu * tau[1]),
            ]
        });
        let f = i.factors(cases);
        let rhs = i.right_hand_side(&load, &f);
        let x = i.solve(
            &faer::Mat::from_fn(rhs.len(), 1, |k, _| rhs[k]),
            &i.rigid_modes,
        );
        InterfaceState {
            unknowns: (0..rhs.len()).map(|k| x[(k, 0)]).collect(),
            factors: f,
            load,
        }
    };
    let st1 = solve(&b1, 1.0, &[1.0]);
    let st2 = solve(&b2, -1.0, &[]);
    let t3 = Instant::now();
    let un = |b: &Body, st: &InterfaceState, al: f64| {
        let tr = &b.interface.trace;
        let (e, t) = tr.locate(r * (al + a0));
        let (rows, _) = tr.displacement_row(e, t);
        let u: Vec<f64> = rows
            .iter()
            .map(|r| r.iter().map(|(i, c)| c * st.unknowns[*i]).sum())
            .collect();
        u[0] * al.sin() + u[1] * al.cos()
    };
    let m = |al: f64| un(&b2, &st2, al) - un(&b1, &st1, al);
    let delta = (0..41)
        .map(|k| (-30.0 + 1.5 * k as f64).to_radians())
        .map(|a| m(a) / a.cos())
        .fold(f64::MAX, f64::min);
    for k in 0..5 {
        let a = (-30.0 + 15.0 * k as f64).to_radians();
        print!("{:.9} ", (m(a) - delta * a.cos()) * 1e4);
    }
    println!();
    println!(
        "energies {:.10} {:.10}",
        b1.interface.strain_energy(&st1),
        b2.interface.strain_energy(&st2)
    );
    println!(
        "reactions {:?} {:?} hub {:?}",
        b1.interface.reaction(0, &st1),
        b1.interface.reaction(1, &st1),
        b2.interface.reaction(0, &st2)
    );
    println!("rigid {:?}", b1.interface.rigid_motions);
    println!(
        "cells {} {} unknowns {} {} mesh {:?} bodies {:?} solve {:?}; {:?} {:?}",
        shoe.cells.len(),
        drum.cells.len(),
        b1.effort.unknowns,
        b2.effort.unknowns,
        t1 - t0,
        t2 - t1,
        t3 - t2,
        b1.effort,
        b2.effort
    );
}
