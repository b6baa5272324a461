// The form beside the text: fields for the numbers and words that the scene says. It keeps nothing of its own; each change is an edit of the text.

import { make } from "./dom.js";
import { UNITS, at, factor, parse, place, plain, reach, short, slip, toml } from "./quantity.js";
import { CHOICES, GROUPS, TASKS, leaf, words } from "./words.js";

/** Numbers that would be more than this in one part stand behind a line to open. */
const MANY = 9;

/** Keys that words may stand for in place of a number. */
const WORDS = /^wear\.until$|(^|\.)gap$/;
const isWord = typed => /^\s*[A-Za-z]/.test(typed);

const RADII = ["radius", "inner", "outer"];

/** Fields for a list of written values; `edit([[key, toml], ..])` is called for each change. */
export class Form {
  constructor(root, materials, edit) {
    Object.assign(this, { root, materials, edit, keys: "", fields: [], open: new Map() });
  }

  /** Shows the values; `fresh` makes new sliders around them. */
  show(written, fresh) {
    const kinds = written.map(({ key, text }) => `${key}:${parse(text) ? "n" : text}`).join("\n");
    if (fresh || kinds !== this.keys) {
      const focus = document.activeElement?.id;
      this.build(written, fresh);
      this.keys = kinds;
      if (focus && this.root.contains(document.getElementById(focus))) document.getElementById(focus).focus();
    }
    const values = new Map(written.map(({ key, text }) => [key, text]));
    this.fields.forEach(field => field.update(values));
  }

  build(written, fresh) {
    const before = fresh ? new Map() : new Map(this.fields.map(field => [field.keys[0], field.range]));
    this.fields = [];
    this.done = new Set();
    const parts = GROUPS.map(([title, keys]) => this.part(title, written.filter(({ key }) => keys.test(key)), written, before));
    this.root.replaceChildren(...parts.filter(part => part !== null));
  }

  part(title, written, all, before) {
    const rows = [];
    if (title === "Wanted") rows.push(...this.wanted(all));
    const materials = new Set();
    const numbers = [];
    for (const value of written) {
      const table = materialOf(value);
      if (table && !materials.has(table)) {
        materials.add(table);
        rows.push(this.add(materialField(this, table, all)));
      }
      const parsed = parse(value.text);
      if (parsed && !this.done.has(value.key) && !isOrigin(value, parsed) && !value.key.startsWith("accuracy")) {
        const linked = partners(value, parsed, all);
        linked.forEach(({ key }) => this.done.add(key));
        const field = numberField(this, [{ ...value, sign: 1 }, ...linked], parsed, before.get(value.key));
        numbers.push(this.add(field));
      } else if (CHOICES[value.key] && value.key !== "optimum.functional" && title !== "Wanted") {
        rows.push(this.add(choiceField(this, value.key)));
      } else if (value.text === "true" || value.text === "false") {
        rows.push(this.add(switchField(this, value.key)));
      } else if (value.key === "wear.until" && !parsed) {
        rows.push(this.add(wordField(this, value.key)));
      }
    }
    if (numbers.length > MANY) {
      const inner = make("details", { open: this.open.get(title) ?? false }, make("summary", {}, `${numbers.length} numbers`), ...numbers);
      inner.addEventListener("toggle", () => this.open.set(title, inner.open));
      rows.push(inner);
    } else {
      rows.push(...numbers);
    }
    if (!rows.length) return null;
    return make("fieldset", {}, make("legend", {}, title), ...rows);
  }

  wanted(all) {
    const has = key => all.some(value => value.key === key);
    const fields = [tasksField(this)];
    if (all.some(({ key }) => key.startsWith("wear.")) || has("optimum.functional")) fields.push(choiceField(this, "optimum.functional", "steady"));
    if (has("kinematics")) fields.push(choiceField(this, "kinematics"));
    if (!all.some(({ key }) => key.startsWith("mesh."))) fields.push(choiceField(this, "accuracy", "1e-6"));
    return fields.map(field => this.add(field));
  }

  add(field) {
    this.fields.push(field);
    return field.node;
  }
}

/** Whether a number only says that a centre is the origin. */
function isOrigin({ key }, { value }) {
  return value === 0 && /\.centre\.\d$/.test(key);
}

/** The table of a material that a value belongs to, or names. */
function materialOf({ key }) {
  const own = /^(.*\.material|.*\.materials\.[^.]+)\.(young|poisson)$/.exec(key);
  if (own) return own[1];
  return /^body[12]\.material$|\.materials\.[^.]+$/.test(key) ? key : null;
}

/** Other values that are the same length or angle and move with it: `[{ key, text, sign }]`. */
function partners(value, parsed, all) {
  const { name, dimension } = leaf(value.key);
  const size = base(parsed, dimension);
  if (!(size && /^(body[12]\.geometry|surface)\./.test(value.key)) || (dimension !== "length" && dimension !== "angle")) return [];
  const [body, kind] = [value.key.split(".")[0], family(value.key, name)];
  return all.flatMap(other => {
    if (other.key === value.key) return [];
    const theirs = parse(other.text);
    const { name: word, dimension: measure } = leaf(other.key);
    const inside = /^(body[12]\.geometry|surface)\./.test(other.key) || /^load\.about\.1$/.test(other.key);
    if (!theirs || !inside || measure !== dimension || family(other.key, word) !== kind) return [];
    const across = kind === "radius" || kind === "z";
    if (!across && other.key.split(".")[0] !== body) return [];
    const size2 = base(theirs, dimension);
    const same = Math.abs(Math.abs(size2) - Math.abs(size)) <= 1e-9 * Math.abs(size);
    if (!same || (across && size2 !== size && kind === "radius")) return [];
    return [{ ...other, sign: Math.sign(size2) === Math.sign(size) ? 1 : -1 }];
  });
}

/** What may be one and the same number: radii, heights, widths, angles. */
function family(key, name) {
  // The middle of a half-disc stands its radius above its lowest point.
  if (RADII.includes(name) || /\.half-disc\.centre\.1$/.test(key)) return "radius";
  const index = /\.(\d)$/.exec(key)?.[1];
  if (name === "z" || (["about", "point", "centre"].includes(name) && index === "1")) return "z";
  if (name === "x" || (["point", "centre"].includes(name) && index === "0")) return "x";
  return name;
}

function base({ value, unit }, dimension) {
  return value * (factor(dimension, unit) ?? NaN);
}

/** A number with its unit, and a slider. */
function numberField(form, members, parsed, range) {
  const [{ key }] = members;
  const { name, dimension } = leaf(key);
  const id = `field-${key}`;
  const input = make("input", { id, type: "text", inputMode: "decimal", autocomplete: "off", spellcheck: false, "aria-describedby": `${id}-with` });
  const units = dimension ? unitsOf(dimension, parsed.unit) : [];
  const unit = units.length > 1 ? make("select", { "aria-label": `unit of ${words(key)}` }, ...units.map(word => make("option", { value: word }, word || Object.keys(UNITS[dimension])[0]))) : null;
  const field = { keys: members.map(member => member.key), range: range ?? reach(name, dimension, parsed.value), unit: parsed.unit };
  const slider = field.range ? make("input", { type: "range", min: 0, max: 200, step: 1, "aria-label": `${words(key)}, slider` }) : null;
  const note = make("span", { id: `${id}-with`, class: "with", "aria-live": "polite" });
  const put = (number, word) => {
    const value = Number(number);
    input.value = number;
    mark("");
    form.edit(members.map(member => [member.key, member.sign > 0 && sameUnit(member, field, word) ? toml(number, word) : other(member, value, word)]));
  };
  const other = (member, value, word) => {
    const theirs = parse(member.text).unit === field.unit ? word : parse(member.text).unit;
    return toml(short((member.sign * value * factor(dimension, word)) / factor(dimension, theirs)), theirs);
  };
  input.addEventListener("change", () => {
    const wrong = WORDS.test(key) && isWord(input.value) ? "" : slip(input.value);
    if (wrong) return mark(`${wrong}; the scene keeps ${`${input.dataset.shown} ${field.unit}`.trim()}`);
    const typed = parse(JSON.stringify(input.value));
    const known = typed && (typed.unit === "" || factor(dimension, typed.unit) !== undefined);
    // Words and unknown units go into the text, where they are answered.
    if (!known) return form.edit([[key, JSON.stringify(input.value)]]);
    put(plain(typed.number), typed.unit || (dimension && factor(dimension, field.unit) === undefined ? "" : field.unit));
  });
  unit?.addEventListener("change", () => {
    const from = base(parse(members[0].text), dimension);
    if (Number.isFinite(from)) put(short(from / factor(dimension, unit.value)), unit.value);
  });
  slider?.addEventListener("input", () => put(short(at(field.range, Number(slider.value))), field.unit));
  const also = members.slice(1).map(member => `${words(member.key)}${member.key.split(".")[0] === key.split(".")[0] ? "" : ` (${member.key.split(".")[0].replace("body", "body ")})`}`);
  const mark = wrong => {
    input.setAttribute("aria-invalid", String(Boolean(wrong)));
    note.textContent = wrong || (also.length ? `moves ${also.join(", ")} too` : "");
  };
  mark("");
  field.node = make("div", { class: "field" }, make("label", { for: id }, words(key)), make("span", { class: "value" }, input, unit), slider, note);
  field.update = values => {
    const now = parse(values.get(key) ?? "");
    if (!now) return;
    members.forEach(member => { member.text = values.get(member.key) ?? member.text; });
    if (document.activeElement !== input || input.value === "" || input.dataset.shown !== now.number) {
      input.value = now.number;
      mark("");
    }
    input.dataset.shown = now.number;
    if (unit) offer(unit, now.unit, now.unit || Object.keys(UNITS[dimension])[0]);
    if (now.unit !== field.unit && field.range) field.range = rescaled(field.range, factor(dimension, field.unit) / factor(dimension, now.unit));
    field.unit = now.unit;
    if (unit) unit.value = now.unit;
    if (slider && document.activeElement !== slider) slider.value = place(field.range, now.value);
    slider?.setAttribute("aria-valuetext", `${now.number} ${now.unit}`.trim());
  };
  return field;
}

function sameUnit(member, field, word) {
  const theirs = parse(member.text).unit;
  return theirs === field.unit || theirs === word;
}

function rescaled(range, by) {
  return Number.isFinite(by) ? { ...range, low: range.low * by, high: range.high * by } : range;
}

/** Units to choose from: a bare number is in the base unit, whose name it shows. */
function unitsOf(dimension, written) {
  const all = Object.keys(UNITS[dimension]);
  // A factor without a unit has the one that its exponents give it.
  if (written === "") return dimension === "wear factor" ? [] : ["", ...all.slice(1)];
  return all.includes(written) ? all : [written, ...all];
}

/** A material by name, or its own numbers. */
function materialField(form, table, all) {
  const id = `field-${table}`;
  const select = make("select", { id }, make("option", { value: "" }, "own numbers"), ...form.materials.map(({ name, source, about }) => make("option", { value: name, title: [source, about].filter(Boolean).join("; ") }, name.replaceAll("-", " "))));
  const about = make("span", { class: "with" });
  select.addEventListener("change", () => {
    const before = form.materials.find(({ name }) => name === select.dataset.name);
    const numbers = before ? `{ young = "${before.young_GPa} GPa", poisson = ${before.poisson} }` : '{ young = "210 GPa", poisson = 0.3 }';
    form.edit([[table, select.value ? JSON.stringify(select.value) : numbers]]);
  });
  const label = table.includes(".materials.") ? `material ${table.split(".").at(-1)}` : "material";
  return {
    keys: [table],
    node: make("div", { class: "field" }, make("label", { for: id }, label), select, about),
    update(values) {
      const name = values.get(table)?.replace(/^["']|["']$/g, "") ?? "";
      select.value = name;
      select.dataset.name = name;
      const known = form.materials.find(material => material.name === name);
      about.textContent = known ? `${known.young_GPa} GPa, ${known.poisson}: ${known.source}` : "";
    },
  };
}

/** A word that a list has not yet. */
function offer(select, word, shown = word) {
  if (![...select.options].some(({ value }) => value === word)) select.append(make("option", { value: word }, shown));
}

/** One word of some. */
function choiceField(form, key, none) {
  const id = `field-${key}`;
  const choices = CHOICES[key];
  const select = make("select", { id }, ...Object.entries(choices).map(([value, text]) => make("option", { value }, text)));
  select.addEventListener("change", () => form.edit([[key, key === "accuracy" ? select.value : JSON.stringify(select.value)]]));
  return {
    keys: [key],
    node: make("div", { class: "field" }, make("label", { for: id }, words(key)), select),
    update(values) {
      const written = values.get(key)?.replace(/^["']|["']$/g, "") ?? none;
      const same = Object.keys(choices).find(value => value === written || (key === "accuracy" && Number(value) === Number(written)));
      if (same === undefined && written !== undefined) offer(select, written);
      select.value = same ?? written;
    },
  };
}

/** A switch. */
function switchField(form, key) {
  const input = make("input", { id: `field-${key}`, type: "checkbox" });
  input.addEventListener("change", () => form.edit([[key, String(input.checked)]]));
  return {
    keys: [key],
    node: make("div", { class: "field" }, make("label", { for: input.id }, words(key)), input),
    update: values => { input.checked = values.get(key) === "true"; },
  };
}

/** A word or a number with its unit. */
function wordField(form, key) {
  const input = make("input", { id: `field-${key}`, type: "text", autocomplete: "off", spellcheck: false });
  const note = make("span", { id: `${input.id}-with`, class: "with", "aria-live": "polite" });
  input.setAttribute("aria-describedby", note.id);
  const mark = wrong => {
    input.setAttribute("aria-invalid", String(Boolean(wrong)));
    note.textContent = wrong;
  };
  let shown = "";
  input.addEventListener("change", () => {
    const wrong = isWord(input.value) ? "" : slip(input.value);
    mark(wrong && `${wrong}; the scene keeps ${shown}`);
    if (wrong) return;
    const typed = parse(JSON.stringify(input.value));
    form.edit([[key, typed && !typed.unit ? plain(typed.number) : JSON.stringify(input.value)]]);
  });
  return {
    keys: [key],
    node: make("div", { class: "field" }, make("label", { for: input.id }, words(key)), input, note),
    update(values) {
      shown = (values.get(key) ?? "").replace(/^"|"$/g, "");
      if (document.activeElement === input) return;
      input.value = shown;
      mark("");
    },
  };
}

/** What is asked for. */
function tasksField(form) {
  const boxes = Object.entries(TASKS).map(([task, text]) => {
    const input = make("input", { type: "checkbox", id: `task-${task}`, value: task });
    return { input, node: make("label", { for: input.id }, input, ` ${text}`) };
  });
  const chosen = () => boxes.filter(({ input }) => input.checked).map(({ input }) => input.value);
  boxes.forEach(({ input }) => input.addEventListener("change", () => form.edit([["tasks", JSON.stringify(chosen())]])));
  return {
    keys: ["tasks"],
    node: make("div", { class: "field tasks", role: "group", "aria-label": "tasks" }, make("span", { class: "label" }, "tasks"), make("span", { class: "boxes" }, ...boxes.map(({ node }) => node))),
    update(values) {
      const tasks = [...values].filter(([key]) => key.startsWith("tasks.")).map(([, text]) => text.replace(/["']/g, ""));
      boxes.forEach(({ input }) => { input.checked = tasks.includes(input.value); });
    },
  };
}
