//! Shoes on a pin and on a roller: the built-in surface of a pinned shoe and closed forms are the truth, reactions balance, faults are named.

use wearshape::{BrakeResult, Document, Problem, Profile, Sense, Solution, Status, builtin};

use crate::common::{read, scene, solved};

const SHOE: &str = "pinned-shoe-elastic";
/// The pin of that scene (mm), and the force of its actuator (N).
const PIN: [f64; 2] = [-88.331, -32.150];
const FORCE: f64 = 2500.0;

fn brake(solution: &Solution) -> &BrakeResult {
    assert_eq!(solution.status, Status::Ok, "{:?}", solution.reason);
    solution.brake.as_ref().unwrap()
}

/// A point by its radius and its angle from the z axis.
fn polar(radius: f64, degrees: f64) -> [f64; 2] {
    [radius * degrees.to_radians().sin(), radius * degrees.to_radians().cos()]
}

fn close(value: f64, wanted: f64, relative: f64) {
    assert!((value - wanted).abs() <= relative * wanted.abs(), "{value} for {wanted}");
}

/// Lever of the actuator about the pin: a pressure on the tip from radius 104 to 84 at 110 deg, across it.
fn arm() -> f64 {
    let [outer, inner] = [polar(104.0, 110.0), polar(84.0, 110.0)];
    let middle = [0, 1].map(|k| 0.5 * (outer[k] + inner[k]) - PIN[k]);
    // Towards larger angles from the z axis.
    let push = [110.0_f64.to_radians().cos(), -110.0_f64.to_radians().sin()];
    (middle[0] * push[1] - middle[1] * push[0]).abs()
}

/// The built-in surface with the geometry of the elastic shoe; its drum turns the other way, since its lining lies clockwise of the pin.
fn surface(settings: &[&str]) -> Solution {
    let (distance, pin) = (PIN[0].hypot(PIN[1]), PIN[0].atan2(PIN[1]).to_degrees() + 360.0);
    let shape = format!(
        "surface.pinned-shoe={{radius=110,width=40,pin_distance={distance},from=\"{} deg\",to=\"{} deg\",arm={}}}",
        pin - 235.0,
        pin - 125.0,
        arm()
    );
    let own = [shape.as_str(), "contact.friction=0.38", "load.force=2500", "wear={k=1e-8,a=1,b=1}", "sliding.omega=80"];
    solved(&scene("pinned-shoe", &[&own, settings].concat()))
}

#[test]
fn the_pressure_of_the_elastic_shoe_is_that_of_the_pinned_surface() {
    for (b, omega) in [("1", "80"), ("1", "-80"), ("0.5", "80"), ("2", "80"), ("2", "-80")] {
        let mirrored = -omega.parse::<f64>().unwrap();
        let own = [format!("wear={{k=1e-8,a=1,b={b}}}"), format!("sliding.omega={mirrored}"), "tasks=[pressure]".to_string()];
        let problem = scene(SHOE, &own.each_ref().map(String::as_str));
        let shoe = solved(&problem);
        let truth = surface(&[&format!("wear.b={b}"), &format!("sliding.omega={omega}")]);
        let (p, q) = (shoe.pressure.as_ref().unwrap(), truth.pressure.as_ref().unwrap());
        for (ours, theirs) in [(p.p_max, q.p_max), (p.p_mean, q.p_mean), (p.moment, q.moment), (p.normal_force, q.normal_force)] {
            close(ours.unwrap(), theirs.unwrap(), 1e-10);
        }
        close(brake(&shoe).torque.unwrap(), q.torque.unwrap().abs(), 1e-10);
        close(brake(&shoe).moment.unwrap(), FORCE * arm(), 1e-12);
        // p ~ sin^(1/b) of the angle from the pin.
        let pin = PIN[0].atan2(PIN[1]) + std::f64::consts::TAU;
        let curve = shoe.curve.as_ref().unwrap();
        let scale = |row: usize| {
            let angle = pin - problem.angle(curve.s[row]).unwrap();
            curve.pressure[row] / angle.sin().powf(1.0 / b.parse::<f64>().unwrap())
        };
        (0..curve.s.len()).for_each(|row| close(scale(row), scale(200), 1e-11));
    }
}

#[test]
fn wear_of_very_stiff_bodies_ends_at_the_pressure_of_the_pinned_surface() {
    let stiff =
        ["body1.geometry.blocks.materials.lining={young=1e6,poisson=0.25}", "tasks=[wear]", "mesh.degree=6", "mesh.layers=4"];
    let shoe = solved(&scene(SHOE, &stiff));
    let truth = surface(&[]);
    assert_eq!(shoe.status, Status::Ok, "{:?}", shoe.reason);
    let (own, exact) = (brake(&shoe), truth.pressure.as_ref().unwrap());
    close(own.torque.unwrap(), exact.torque.unwrap().abs(), 1e-3);
    let largest = shoe.profile.as_ref().unwrap().pressure.iter().copied().fold(0.0, f64::max);
    close(largest, exact.p_max.unwrap(), 2e-2);
}

#[test]
fn the_reaction_of_the_pin_balances_contact_and_actuator() {
    for settings in [&["tasks=[contact]"][..], &["tasks=[shape]"], &["tasks=[wear]", "wear.until=1"]] {
        let fixed = ["mesh.degree=6", "mesh.layers=4"];
        let solution = solved(&scene(SHOE, &[settings, &fixed].concat()));
        let by_balance = brake(&solution).support_force;
        let (_, by_body) = solution.reactions.iter().find(|(edge, _)| edge == "body1.seat").unwrap();
        let [x, z, moment] = [by_body.x.unwrap(), by_body.z.unwrap(), by_body.moment.unwrap()];
        let size = x.hypot(z);
        assert!((x - by_balance.x).hypot(z - by_balance.z) < 1e-8 * size, "{settings:?}: {x} {z} and {by_balance:?}");
        // The pin turns freely: no moment about it.
        let about = moment - (PIN[0] * z - PIN[1] * x);
        assert!(about.abs() < 1e-7 * size * 110.0, "{settings:?}: {about} of {moment}");
    }
}

#[test]
fn a_moment_about_the_pin_is_the_actuator_of_that_moment() {
    let moment = format!("load={{moment={}}}", -FORCE * arm());
    let by_moment = solved(&scene(SHOE, &[&moment, "tasks=[contact]", "mesh.degree=6", "mesh.layers=4", "contact.friction=0"]));
    let by_force = solved(&scene(SHOE, &["tasks=[contact]", "mesh.degree=6", "mesh.layers=4", "contact.friction=0"]));
    let (a, b) = (brake(&by_moment), brake(&by_force));
    close(a.moment.unwrap(), b.moment.unwrap(), 1e-12);
    close(a.pressure_moment.unwrap(), b.pressure_moment.unwrap(), 1e-9);
    assert!(a.actuator.is_none() && a.brake_factor.is_none());
    // What acts on the edge that turns is the pin's force and the moment.
    let (_, reaction) = by_moment.reactions.iter().find(|(edge, _)| edge == "body1.seat").unwrap();
    let about = reaction.moment.unwrap() - (PIN[0] * reaction.z.unwrap() - PIN[1] * reaction.x.unwrap());
    close(about, -FORCE * arm(), 1e-8);
}

#[test]
fn a_pin_far_away_is_the_guide() {
    let fixed = ["mesh.degree=6", "mesh.layers=6", "tasks=[shape]"];
    let guided = solved(&scene("translating-punch", &[&fixed[..], &["load.tilt=0"]].concat()));
    let gap = |profile: &Profile| profile.gap.clone();
    let straight = gap(guided.curve.as_ref().unwrap());
    let largest = straight.iter().copied().fold(0.0, f64::max);
    let off = |distance: f64| {
        let pinned = format!("body1.support={{top={{pin=[{distance},100]}}}}");
        let load = format!("load={{moment={}}}", 1000.0 * distance);
        let turned = solved(&scene("translating-punch", &[&fixed[..], &[&pinned, &load]].concat()));
        assert_eq!(turned.status, Status::Ok, "{:?}", turned.reason);
        let own = gap(turned.curve.as_ref().unwrap());
        // A shape is one up to the free motion, and these differ by 1/distance.
        own.iter().zip(&straight).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest
    };
    let (near, far) = (off(1e4), off(1e6));
    assert!(far < 1e-3 && far < 0.02 * near, "{near} {far}");
}

#[test]
fn reversing_the_drum_swaps_leading_and_trailing() {
    let fixed = ["tasks=[pressure]"];
    let leading = solved(&scene(SHOE, &fixed));
    let trailing = solved(&scene(SHOE, &[&fixed[..], &["sliding.omega=80"]].concat()));
    let (a, b) = (brake(&leading), brake(&trailing));
    assert_eq!([a.shoe, b.shoe], [Sense::Leading, Sense::Trailing]);
    assert!(a.brake_factor.unwrap() > 2.0 * b.brake_factor.unwrap());
    assert!(a.friction_moment.unwrap() > 0.0 && b.friction_moment.unwrap() < 0.0 && b.locks_at_friction.is_none());
    // M_n - M_f = F a of the one, M_n + M_f = F a of the other, both in the ratio of the same pressure.
    let ratio = |x: &BrakeResult| x.friction_moment.unwrap() / x.pressure_moment.unwrap();
    close(ratio(a), -ratio(b), 1e-11);
    close(a.lock_reserve.unwrap(), 1.0 / ratio(a), 1e-12);
}

#[test]
fn a_shoe_locks_itself_at_the_friction_that_is_told() {
    let told = brake(&solved(&scene(SHOE, &["tasks=[pressure]"]))).locks_at_friction.unwrap();
    let at = |share: f64, task: &str| {
        let settings = [format!("contact.friction={}", share * told), format!("tasks=[{task}]"), "mesh.degree=5".into()];
        solved(&scene(SHOE, &settings.each_ref().map(String::as_str)))
    };
    let near = at(0.999, "pressure");
    close(brake(&near).lock_reserve.unwrap(), 1.0 / 0.999, 1e-9);
    // The elastic shoe leans more on its heel than the worn one, and locks later.
    for (task, share) in [("pressure", 1.01), ("contact", 2.0)] {
        let beyond = at(share, task);
        let reason = beyond.reason.clone().unwrap_or_default();
        assert_eq!(beyond.status, Status::Refused, "{task}: {reason}");
        assert!(reason.contains("jammed") || reason.contains("self-locking"), "{task}: {reason}");
        assert!(beyond.brake.is_none(), "{task}: {:?}", beyond.brake);
    }
}

/// Shigley's example 16-2 with bodies: r 150, width 32, mu 0.32, pin distance 122.654, 0 to 126 deg from the pin, 1 MPa at most.
#[test]
fn shigleys_internal_shoe_has_its_pressure_and_torque_with_bodies() {
    let (r, width, mu, pin, to) = (150.0, 32.0, 0.32, 122.654, 126.0_f64.to_radians());
    // M_n and M_f of p = sin(theta), and the torque.
    let (half, sine) = (0.5 * to - 0.25 * (2.0 * to).sin(), to.sin());
    let normal = width * r * pin * half;
    let friction = mu * width * r * (r * (1.0 - to.cos()) - 0.5 * pin * sine * sine);
    let torque = mu * width * r * r * (1.0 - to.cos());
    let at = |radius: f64, angle: f64| format!("{{ radius = {radius}, angle = \"{angle} deg\" }}");
    let [x, z] = polar(pin, 243.0);
    let text = format!(
        "units = 'N-mm'\nkinematics = 'plane-stress'\nthickness = {width}\ntasks = ['pressure', 'shape']\nmesh = {{ degree = 6, layers = 4 }}\n\
         contact = {{ edges = ['face', 'inner'], friction = {mu} }}\nsliding = {{ omega = -10 }}\nload = {{ moment = {} }}\nwear = {{ k = 1e-8 }}\n\
         [body1]\nmaterial = {{ young = 1e6, poisson = 0.3 }}\nsupport = {{ end = {{ pin = [{x}, {z}] }} }}\n\
         [body1.geometry.blocks.points]\na = {}\nb = {}\nc = {}\nd = {}\ne = {}\nf = {}\n\
         [body1.geometry.blocks.curves]\nface.arc = {{ ends = ['a', 'b'] }}\nbond.arc = {{ ends = ['d', 'c'] }}\nback.arc = {{ ends = ['f', 'e'] }}\n\
         r1.line = ['b', 'c']\nl1.line = ['a', 'd']\nr2.line = ['c', 'e']\nl2.line = ['d', 'f']\n\
         [body1.geometry.blocks.cells]\nlining = {{ curves = ['face', 'r1', 'bond', 'l1'] }}\nweb = {{ curves = ['bond', 'r2', 'back', 'l2'] }}\n\
         [body1.geometry.blocks.edges]\nface = ['face']\nend = ['l2']\n\
         [body2]\nmaterial = {{ young = 1e6, poisson = 0.3 }}\ngeometry.ring = {{ inner = {r}, outer = 170 }}\nsupport = {{ outer = ['x', 'z'] }}\n",
        -(normal - friction),
        at(150.0, 243.0),
        at(150.0, 117.0),
        at(140.0, 117.0),
        at(140.0, 243.0),
        at(118.0, 117.0),
        at(118.0, 243.0),
    );
    let solution = solved(&read(&text, &[]));
    let found = brake(&solution);
    close(solution.pressure.as_ref().unwrap().p_max.unwrap(), 1.0, 1e-10);
    // From the nodes of the elastic surface.
    close(found.torque.unwrap(), torque, 1e-7);
    close(found.pressure_moment.unwrap(), normal, 1e-7);
    close(found.friction_moment.unwrap(), friction, 1e-7);
    assert!(solution.shape.as_ref().unwrap().roundtrip_same.unwrap() < 1e-7);
}

#[test]
fn rollers_upright_are_guides_along_x_and_inclined_ones_share_the_load() {
    let fixed = ["mesh.degree=6", "mesh.layers=4", "tasks=[pressure,shape]"];
    let digits = |support: &str| {
        let solution = solved(&scene("drum-brake-block", &[&fixed[..], &[support]].concat()));
        let shape = solution.shape.clone().unwrap();
        assert!(shape.roundtrip_same.unwrap() < 1e-7, "{:?}", shape.roundtrip_same);
        (shape.gap_max.unwrap(), solution.pressure.unwrap().p_max.unwrap())
    };
    let guided = digits("body1.support={left=[\"x\"],right=[\"x\"]}");
    let rolled = digits("body1.support={left={roller=\"90 deg\"},right={roller=\"90 deg\"}}");
    close(rolled.0, guided.0, 1e-9);
    close(rolled.1, guided.1, 1e-12);
    // On a flat, down a plane at 60 deg: F sin = N (sin + mu cos), friction dragging up the plane.
    for task in ["pressure", "contact"] {
        let settings = [
            "body1.support={left={roller=\"60 deg\"}}",
            "load={edge=\"top\",as=\"pressure\",force=1000}",
            "mesh.degree=6",
            "mesh.layers=4",
        ];
        let tasks = format!("tasks=[{task}]");
        let solution = solved(&scene("translating-punch", &[&settings[..], &[&tasks]].concat()));
        let found = brake(&solution);
        let (sine, cosine) = 60.0_f64.to_radians().sin_cos();
        let normal = 1000.0 * sine / (sine + 0.25 * cosine);
        close(found.friction_force, 0.25 * normal, 1e-9);
        assert_eq!(found.shoe, Sense::Trailing);
        // The roller carries no force along its plane.
        let carried = found.support_force;
        assert!((carried.x * cosine + carried.z * sine).abs() < 1e-7 * normal, "{carried:?}");
    }
}

#[test]
fn what_holds_is_said() {
    let holding = scene(SHOE, &[]).holding()[0].to_string();
    assert_eq!(holding, "body 1: held by seat: sliding, closing; free: turning about (-88.331, -32.15)");
    let rolled = scene("drum-brake-block", &["body1.support={left={roller=\"60 deg\"}}"]).holding()[0].to_string();
    assert_eq!(rolled, "body 1: held by left: motion across 60 deg, tilt; free: moving along 60 deg");
}

#[test]
fn what_a_pin_does_not_go_with_is_refused_by_name() {
    let load = "load={moment=-400000}";
    let cases: &[(&str, &[&str], &str, &str)] = &[
        (SHOE, &["body1.support={face={pin=[-88,-32]}}"], "body1.support.face", "touches body 2"),
        (SHOE, &["body1.support={nothing={pin=[-88,-32]}}"], "body1.support.nothing", "no edge `nothing`"),
        (SHOE, &["body1.support={a={pin=[-88,-32]}}"], "body1.support.a", "is a point"),
        (SHOE, &["body1.support={seat={pin=[0,-110]}}"], "body1.support.seat.pin", "lies on the contact surface"),
        (SHOE, &["body1.support={seat={pin=[0,-50],roller=0}}"], "body1.support.seat", "not both"),
        (SHOE, &["body1.support={seat={}}"], "body1.support.seat", "holds nothing"),
        (SHOE, &["body1.support={seat={pins=[0,-50]}}"], "body1.support.seat", "unknown key `pins`"),
        (SHOE, &["body1.support={seat={pin=[-88.331,-32.15]},tip=[\"x\"]}"], "body1.support", "cannot move"),
        (SHOE, &["body1.support={seat={pin=[-88,-32]},tip={pin=[88,-32]}}"], "body1.support.tip", "two pins"),
        (SHOE, &["load.as=rigid"], "load.as", "rigid"),
        (SHOE, &["load.moment=-400000"], "load.moment", "both a moment"),
        (SHOE, &["load={edge=\"tip\",moment=-400000}"], "load.edge", "belongs to the force"),
        (SHOE, &["load={moment=400000}"], "load.moment", "away from body 2"),
        (SHOE, &["load={moment=0}"], "load.moment", "nothing presses"),
        (SHOE, &["load.as=traction"], "load.direction", "needs its direction"),
        (SHOE, &["load.as=traction", "load.direction=\"90 deg\""], "load.edge", "away from body 2"),
        (SHOE, &["load.edge=seat"], "load.edge", "no moment about the pin"),
        (SHOE, &["optimum.balance=paper"], "optimum.balance", "paper"),
        (SHOE, &["body2.support={outer={pin=[0,0]}}"], "body2.support.outer", "guides body 1"),
        ("internal-shoe", &["load.as=traction", "load.direction=\"-90 deg\""], "load.as", "traction"),
        ("drum-brake-block", &["body1.support={left={pin=[-100,300]}}", load], "body1.support.left", "meets the contact edge"),
        ("drum-brake-block", &["body1.support={top={roller=\"90 deg\"}}"], "body1.support", "more than one motion"),
        (SHOE, &["body1.support={seat={pin=[-60,-60]}}"], "body1.support", "opens another"),
        (SHOE, &["body1.support={seat={pin=[0,0]}}"], "body1.support", "the middle of the contact"),
        (SHOE, &["body2.geometry.ring={inner=110.1,outer=122}"], "contact.edges", "two radii"),
        ("annular-punch", &["body1.support={top={pin=[0,0]}}"], "body1.support.top", "of revolution"),
        ("hertz-cylinder", &["body1.support={centre={roller=\"90 deg\"}}"], "body1.support", "known before it is meshed"),
    ];
    for (name, settings, key, says) in cases {
        let settings: Vec<String> = settings.iter().map(|setting| setting.to_string()).collect();
        let document = Document::read("scene.toml", builtin(name).unwrap().text, &settings);
        let fault = match document {
            Ok(document) => match Problem::new(&document, &|file| Err(format!("there is no {file}"))) {
                Ok(problem) => problem.available().expect_err(&format!("{settings:?}")),
                Err(fault) => fault,
            },
            Err(fault) => fault,
        };
        assert!(fault.message.contains(says) && !fault.remedy.is_empty(), "{settings:?}: {fault:?}");
        assert!(fault.key.as_deref().is_none_or(|found| found.starts_with(key)), "{settings:?}: {fault:?}");
    }
}

/// Turning about a pin does not move the surface on the radius through it: where that radius meets the end of the surface no turning opens the gap
/// there. The answer was a gap of 4e13 mm.
#[test]
fn a_surface_that_ends_on_the_radius_through_its_pin_has_no_shape() {
    let shape = |pin: f64| {
        let points = [("i", 100.0), ("o", 115.0)].map(|(name, radius)| {
            let at = |k: usize| [-28.0, -3.0, 23.0].map(|angle| polar(radius, angle))[k];
            (0..3).map(|k| format!("{name}{k} = {:?}\n", at(k))).collect::<String>()
        });
        let text = format!(
            r#"
units = "N-mm"
kinematics = "plane-stress"
thickness = 10
tasks = ["shape"]
check = false
mesh = {{ degree = 5, layers = 2 }}
contact = {{ edges = ["inner", "outer"], friction = 0.3, gap = 0 }}
sliding = {{ omega = 1.0 }}
load = {{ edge = "top", as = "pressure", force = 1000 }}
wear = {{ k = [1e-6, 0], b = 1 }}
[body1]
material = {{ young = 1e4, poisson = 0.3 }}
support.seat = {{ pin = {:?} }}
[body1.geometry.blocks.points]
{}[body1.geometry.blocks]
curves = {{ i01.arc.ends = ["i0", "i1"], i12.arc.ends = ["i1", "i2"], o01.arc.ends = ["o0", "o1"], o12.arc.ends = ["o1", "o2"], r0.line = ["i0", "o0"], r1.line = ["i1", "o1"], r2.line = ["i2", "o2"] }}
cells = {{ a.curves = ["i01", "r1", "o01", "r0"], b.curves = ["i12", "r2", "o12", "r1"] }}
edges = {{ inner = ["i01", "i12"], seat = ["o01"], top = ["o12"] }}
[body2]
material = {{ young = 1e5, poisson = 0.3 }}
support.inner = ["x", "z"]
geometry.ring = {{ inner = 60, outer = 100 }}
"#,
            polar(121.0, pin),
            points.concat()
        );
        let problem = read(&text, &[]);
        wearshape::solve(&problem, &Default::default(), &Default::default(), &mut |_| std::ops::ControlFlow::Continue(()))
    };
    let fault = shape(-28.0).unwrap_err();
    assert_eq!(fault.code, "no-closing", "{fault:?}");
    let beside = shape(-38.0).unwrap();
    assert_eq!(beside.status, Status::Ok, "{:?}", beside.reason);
    let gap = beside.shape.unwrap().gap_max.unwrap();
    assert!(gap > 0.0 && gap < 1e3, "{gap} um");
}
