// Words for the keys of a scene.

const LEAVES = {
  title: ["title"], units: ["units"], kinematics: ["kinematics"], thickness: ["thickness", "length"], accuracy: ["accuracy"], tasks: ["tasks"],
  radius: ["radius", "length"], half_angle: ["half angle", "angle"], top: ["height of the top", "length"], inner: ["inner radius", "length"],
  outer: ["outer radius", "length"], width: ["width", "length"], pin_distance: ["distance of the pin", "length"], from: ["from", "angle"], to: ["to", "angle"],
  arm: ["arm of the force", "length"], pivot: ["pivot", "length"], angle: ["angle", "angle"], clearance: ["radial clearance", "length"],
  roughness: ["roughness", "length"], gap: ["gap", "length"], friction: ["coefficient of friction"], shear: ["shear acts on the bodies"],
  omega: ["angular speed", "angular speed"], speed: ["speed", "speed"], track_radius: ["radius of the track", "length"], share: ["share of the time forward"],
  stroke: ["stroke", "length"], frequency: ["frequency", "frequency"], force: ["force", "force"], direction: ["direction", "angle"],
  approach: ["approach", "length"], moment: ["moment", "moment"], moment_y: ["moment about x", "moment"], tilt: ["tilt", "angle"],
  approach_time: ["worn approach of time", "time"], centre: ["centre", "length"], shear_force: ["shear force", "force"], twist: ["twist", "angle"],
  torque: ["torque", "moment"], about: ["moment about", "length"], edge: ["edge"], as: ["load as"], beta: ["wear factor \u03b2", "wear factor"],
  k: ["wear factor k", "wear factor"], threshold: ["threshold pressure", "pressure"], table: ["table of pressures and wear factors k"], mild: ["mild wear factor", "wear factor"], above: ["severe above", "pressure"], severe: ["severe wear factor", "wear factor"], half: ["pressure of half the factor", "pressure"], a: ["exponent of the speed a"], b: ["exponent of the pressure b"], counterface: ["counter-face"], until: ["until", "time"],
  wearable: ["wearable thickness", "length"], spread: ["spread of the wear factor"], functional: ["functional"], q: ["exponent q"], balance: ["balance"],
  modes: ["modes"], p_max: ["cap of the pressure", "pressure"], young: ["Young\u2019s modulus", "pressure"], poisson: ["Poisson\u2019s ratio"],
  degree: ["degree"], layers: ["layers"], pin: ["pin", "length"], roller: ["roller", "angle"], half_axes: ["half axis", "length"], x: ["x", "length"],
  y: ["y", "length"], z: ["z", "length"], period: ["period", "time"], repeat: ["cycles"], time: ["begins at", "time"], crown: ["crown", "length"],
  amplitude: ["amplitude", "length"], wavelength: ["wavelength", "length"], depth: ["depth", "length"], distance: ["distance", "length"], volume: ["volume", "volume"],
  revolutions: ["revolutions"], density: ["density"], gravity: ["gravity"], fields: ["stress inside"], report: ["report page"], recording: ["recording"], convection: ["convection"], ambient: ["ambient temperature"], temperature: ["temperature"], conductance: ["conductance of the contact"],
  reference: ["temperature without stress"], conductivity: ["conductivity of heat"], expansion: ["thermal expansion"], heat_capacity: ["heat capacity"],
};

const AXES = ["x", "z"];
const PAIRS = { x: ["x from", "x to"], y: ["y from", "y to"], z: ["z from", "z to"], half_axes: ["half axis along x", "half axis along y"] };
const BODIES = ["beta", "k", "a", "b", "threshold"];
const POINTS = ["centre", "about", "pin", "move"];

/** Name of a key without places of lists, and what it measures. */
export function leaf(key) {
  const parts = key.split(".").filter(part => !/^\d+$/.test(part));
  const name = parts.at(-1);
  if (key.includes(".blocks.points.") && !LEAVES[name]) return { name: "point", dimension: "length" };
  return { name, dimension: (LEAVES[name] ?? [])[1] ?? null };
}

/** A key in words. */
export function words(key) {
  const parts = key.split(".");
  const index = /^\d+$/.test(parts.at(-1)) ? Number(parts.pop()) : null;
  const name = parts.at(-1);
  const point = /\.blocks\.points\.([^.]+)/.exec(key);
  if (point) {
    const what = index !== null ? AXES[index] : LEAVES[name]?.[0] ?? name;
    return name === point[1] ? `${what} of ${point[1]}` : `${what}${name === "centre" ? " of the centre" : ""} of ${point[1]}`;
  }
  const material = /\.materials\.([^.]+)\.(young|poisson)/.exec(key);
  if (material) return `${LEAVES[name][0]} of the ${material[1]}`;
  const plain = LEAVES[name]?.[0] ?? name.replaceAll("_", " ").replaceAll("-", " ");
  if (index === null) return plain;
  if (PAIRS[name]) return PAIRS[name][index] ?? plain;
  if (BODIES.includes(name)) return `${plain}, body ${index + 1}`;
  if (POINTS.includes(name)) return `${plain}: ${AXES[index]}`;
  return `${plain} ${index + 1}`;
}

/** Words to choose from, by key. */
export const CHOICES = {
  kinematics: { "plane-stress": "plane stress", "plane-strain": "plane strain", axisymmetric: "axisymmetric" },
  "optimum.functional": { steady: "steady state", "wear-volume": "least wear volume", "friction-power": "least friction power", "wear-power": "least wear power", uniform: "uniform pressure" },
  "optimum.balance": { equilibrium: "equilibrium", paper: "force alone" },
  "optimum.modes": { kinematic: "kinematic", associated: "associated" },
  "load.as": { pressure: "pressure", vertical: "vertical", rigid: "rigid edge", traction: "traction" },
  "wear.counterface": { fresh: "always unworn", congruent: "same points meet", revolving: "revolving" },
  accuracy: { "1e-2": "1 %", "1e-3": "0.1 %", "1e-4": "1e-4", "1e-5": "1e-5", "1e-6": "1e-6" },
};

export const TASKS = { pressure: "wanted pressure", contact: "contact as it is", shape: "shape to machine", wear: "wear in time" };

/** Parts of the form, in their order, with the keys that belong there. */
export const GROUPS = [
  ["Wanted", /^(tasks|optimum|accuracy|mesh|kinematics|thickness)(\.|$)/],
  ["Load", /^(load|schedule)\./],
  ["Contact and sliding", /^(contact|sliding)\./],
  ["Wear", /^wear\./],
  ["Body 1, which gets its shape", /^(body1|surface)\./],
  ["Body 2, its counter-face", /^body2\./],
  ["More", /^(?!(tasks|optimum|accuracy|mesh|kinematics|thickness|load|schedule|contact|sliding|wear|body1|surface|body2|title|units|output|check)(\.|$))/],
];

/** Scenes by the kind of machine element; those that a module has not are left out. */
export const KINDS = [
  ["Brakes", ["drum-brake-block", "drum-brake-ring", "drum-brake-hot", "internal-shoe", "lining-on-back", "pinned-shoe-elastic", "pinned-shoe", "pivoted-shoe", "disc-pad"]],
  ["Punches, pads and clutches", ["translating-punch", "punch-wear", "trapezoidal-punch", "annular-punch", "clutch-hot", "reciprocating-pad", "rectangular-punch", "elliptic-punch"]],
  ["Bearings and joints", ["bushing", "journal", "journal-arc", "knee", "cam"]],
  ["Balls and cylinders", ["hertz-sphere", "hertz-cylinder", "cattaneo-mindlin", "pin-on-disc"]],
];
