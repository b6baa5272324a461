// Numbers with units as a scene has them: `200`, `"30 deg"`. What the user typed is kept; a unit is changed only on request.

/** Units of each dimension with their factor to the base unit, which comes first and which a bare number has. */
export const UNITS = {
  length: { mm: 1, um: 1e-3, cm: 10, m: 1e3, in: 25.4 },
  force: { N: 1, kN: 1e3, MN: 1e6 },
  pressure: { MPa: 1, GPa: 1e3, kPa: 1e-3, bar: 0.1 },
  angle: { rad: 1, deg: Math.PI / 180, mrad: 1e-3 },
  speed: { "mm/s": 1, "m/s": 1e3, "m/min": 1e3 / 60, "km/h": 1e6 / 3600 },
  "angular speed": { "rad/s": 1, rpm: Math.PI / 30, "deg/s": Math.PI / 180 },
  time: { s: 1, min: 60, h: 3600 },
  moment: { "N mm": 1, "N m": 1e3, "kN m": 1e6 },
  volume: { "mm^3": 1, "cm^3": 1e3 },
  frequency: { Hz: 1, "1/min": 1 / 60 },
  "wear factor": { "": 1, "mm^3/(N mm)": 1, "mm^3/(N m)": 1e-3, "m^3/(N m)": 1e6 },
};

const NUMBER = /^\s*([-+]?(?:\d[\d_]*\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*((?:(?:1\/|[^\s\d.,]).*?)?)\s*$/;
/** A number as TOML takes it; one that begins with its point is mended by `plain`. */
const STRICT = /^[-+]?(?:0|[1-9](?:_?\d)*)?(?:\.\d(?:_?\d)*)?(?:[eE][-+]?\d(?:_?\d)*)?$/;

/** A value of a scene as TOML, taken apart: number as written, its value, unit ("" for none). None for what is no number. */
export function parse(toml) {
  const quoted = /^"(.*)"$|^'(.*)'$/.exec(toml.trim());
  const found = NUMBER.exec(quoted ? quoted[1] ?? quoted[2] : toml);
  if (!found || (!quoted && found[2])) return null;
  const value = Number(found[1].replaceAll("_", ""));
  return Number.isFinite(value) ? { number: found[1], value, unit: found[2] } : null;
}

/** What is wrong with a number that was typed, with or without a unit; nothing where TOML takes it. */
export function slip(typed) {
  const found = NUMBER.exec(typed);
  if (/\d,\d/.test(typed)) return "write a decimal point, no comma";
  if (!found) return "no number";
  if (!Number.isFinite(Number(found[1].replaceAll("_", "")))) return "too large";
  return STRICT.test(found[1]) ? "" : `no number: write ${short(Number(found[1].replaceAll("_", "")))}`;
}

/** A number that was typed as it is written into a scene. */
export function plain(number) {
  return number.replaceAll("_", "").replace(/^\+/, "").replace(/^(-?)\./, "$10.");
}

/** TOML of a number and a unit. */
export function toml(number, unit) {
  return unit ? JSON.stringify(`${number} ${unit}`) : String(number);
}

/** Factor of a unit to the base unit of a dimension; none for an unknown one. */
export function factor(dimension, unit) {
  return unit === "" ? 1 : UNITS[dimension]?.[unit];
}

/** A number in so many digits, as short as it can be written. */
export function short(value, digits = 12) {
  return String(Number(value.toPrecision(digits)));
}

/** A number for reading: four digits, a true minus. */
export function shown(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return "\u2013";
  const size = Math.abs(value);
  const text = value !== 0 && (size >= 1e6 || size < 1e-3) ? value.toExponential(digits - 1).replace(/\.?0*e\+?/, "e") : short(value, digits);
  return minus(text);
}

/** A text for reading with a true minus before its numbers; other hyphens stay. */
export function minus(text) {
  return text.replace(/(^|[\s(,]|\de)-(?=\d)/g, "$1\u2212");
}

const SHARES = { friction: [0, 1], poisson: [0, 0.49], share: [0.05, 0.95], spread: [0, 0.9] };
const EXPONENTS = ["a", "b", "q"];
const WIDE = ["force", "wear factor", "speed", "angular speed", "pressure", "moment", "time"];

/** Where a slider goes for a value: `{ low, high, log }`, or none where it has nothing to hold on to. */
export function reach(name, dimension, value) {
  if (SHARES[name]) return { low: SHARES[name][0], high: Math.max(SHARES[name][1], value), log: false };
  if (EXPONENTS.includes(name)) return { low: 0.25, high: Math.max(3, 1.5 * value), log: false };
  if (value === 0) return null;
  const size = Math.abs(value);
  if (WIDE.includes(dimension)) return { low: size / 10, high: size * 10, log: true, sign: Math.sign(value) };
  return { low: 0.3 * size, high: 1.7 * size, log: false, sign: Math.sign(value) };
}

const STEPS = 200;

/** Place of a value on a slider, 0 to 200. */
export function place({ low, high, log }, value) {
  const size = Math.min(high, Math.max(low, Math.abs(value)));
  const share = log ? Math.log(size / low) / Math.log(high / low) : (size - low) / (high - low);
  return Math.round(STEPS * share);
}

/** The value at a place of a slider, in round numbers. */
export function at({ low, high, log, sign }, place) {
  const share = place / STEPS;
  if (log) return (sign ?? 1) * Number((low * (high / low) ** share).toPrecision(3));
  const step = 10 ** Math.floor(Math.log10((high - low) / 20)) / 10;
  const raw = low + share * (high - low);
  return (sign ?? 1) * Number((Math.round(raw / step) * step).toPrecision(6));
}
