// The page: a scene as text is the one state; the form, the drawing and the answer follow from it.

import { Charts } from "./charts.js";
import { find, make } from "./dom.js";
import { downloads } from "./downloads.js";
import { Editor } from "./editor.js";
import { compile, start } from "./engine.js";
import { Files } from "./files.js";
import { Form } from "./form.js";
import * as link from "./link.js";
import { Play } from "./play.js";
import { shown } from "./quantity.js";
import * as results from "./results.js";
import { Solver } from "./solver.js";
import { KINDS } from "./words.js";

const FIRST = "drum-brake-block";
/** Time after the last change until the address follows (ms). */
const REST = 300;

class Page {
  constructor(module, ask, pages) {
    this.ask = ask;
    this.pages = pages;
    this.said = "";
    this.known = ask({ ask: "known" });
    this.charts = new Charts(find("charts"));
    this.play = new Play();
    this.editor = new Editor(text => this.change(text));
    this.form = new Form(find("form"), this.known.materials, edits => this.edit(edits));
    this.solver = new Solver(module, answer => this.hear(answer));
    this.files = new Files(kept => this.keep(kept), (name, text) => this.begin(this.opened(name, text)));
    this.choose();
    this.buttons();
    this.refill = downloads(() => this.solver.files(), () => ({ name: this.name, text: this.text }));
    addEventListener("hashchange", () => { if (location.hash !== this.hash) this.open(location.hash); });
  }

  /** Name of the scene: a built-in one, or the reader's own. */
  get name() {
    return this.scene.name;
  }

  builtin(name) {
    return this.known.scenes.find(scene => scene.name === name);
  }

  choose() {
    const groups = KINDS.map(([kind, names]) => make("optgroup", { label: kind }, ...names.filter(name => this.builtin(name)).map(name => make("option", { value: name }, this.builtin(name).title))));
    const others = this.known.scenes.filter(({ name }) => !KINDS.some(([, names]) => names.includes(name)));
    find("scene").replaceChildren(...groups, ...others.map(({ name, title }) => make("option", { value: name }, title)));
    find("scene").addEventListener("change", ({ target }) => this.begin(this.builtin(target.value) ?? this.own));
  }

  /** A scene of the reader's own, as it comes; the last one can be chosen again. Its name may be that of a built-in one, so that it is no value to choose by. */
  opened(name, text) {
    this.own = { name, title: name, text };
    this.option ??= make("option", { value: "" });
    this.option.textContent = `${name} (your file)`;
    find("scene").append(this.option);
    return this.own;
  }

  buttons() {
    find("pin").addEventListener("click", () => this.pin(this.pinned ? null : this.answer));
    find("reset").addEventListener("click", () => this.begin(this.scene));
  }

  async open(hash) {
    const { name, text, damaged } = await link.read(hash);
    const known = this.builtin(name);
    this.hash = hash;
    const said = damaged ? "The text of the scene in the address is damaged; this is the scene as it comes. " : "";
    const own = name && text && !known ? this.opened(name, text) : null;
    this.begin(known ?? own ?? this.builtin(FIRST), text, said || (name && !known && !own ? `There is no scene ${name}; this is another one. ` : ""));
  }

  /** Begins with a scene, as it comes or with another text; what is `said` first stays in the line of the status until something changes. */
  begin(scene, text = null, said = "") {
    Object.assign(this, { scene, said });
    find("scene").value = scene === this.own ? "" : scene.name;
    this.charts.show([], true);
    this.play.show(null);
    this.editor.text = "";
    this.change(text ?? scene.text, true);
  }

  /** Values at other keys, from the form. */
  edit(edits) {
    const { text, fault } = this.ask({ ask: "edit", text: this.text, edits });
    if (fault) this.editor.complain(fault);
    else this.change(text);
  }

  /** Another text: everything follows. */
  change(text, fresh = false) {
    if (text === this.text && !fresh) return;
    if (!fresh) this.said = "";
    this.asked = performance.now();
    this.text = text;
    this.editor.text = text;
    const { written, fault } = this.ask({ ask: "written", name: this.name, text });
    find("form").inert = Boolean(fault);
    find("reset").disabled = text === this.scene.text;
    if (fault) {
      this.solver.forget();
      this.wrong(fault);
    } else {
      this.written = written;
      this.form.show(written, fresh);
      this.solver.solve(this.name, text);
      const { dataset } = find("status");
      ["check", "pressure", "coarse", "curves", "fine"].forEach(phase => delete dataset[phase]);
      dataset.state = "busy";
      if (this.said) find("status").textContent = this.said;
      document.body.classList.add("busy");
      this.refill();
    }
    clearTimeout(this.timer);
    // A damaged address stays to be mended until there is another scene.
    if (!this.said) this.timer = setTimeout(() => this.address(), REST);
  }

  /** Other files beside the scene. */
  keep(kept) {
    this.solver.keep(kept);
    if (this.text !== undefined) this.change(this.text, true);
  }

  async address() {
    const known = this.scene !== this.own && this.scene.text === this.text;
    this.hash = await link.write(this.name, known ? null : this.text);
    history.replaceState(null, "", this.hash);
  }

  wrong(fault) {
    this.editor.complain(fault);
    this.settled("wrong", fault.place ? `Line ${fault.place.line}: ${fault.message}` : fault.message);
    document.body.classList.add("stale");
  }

  settled(state, words) {
    find("status").dataset.state = state;
    find("status").textContent = `${this.said}${words}`;
    find("progress").hidden = true;
    document.body.classList.remove("busy");
    this.refill();
  }

  /** What the solver says of the newest scene. */
  hear(answer) {
    if (answer.broken) return this.settled("wrong", `The solver ended by a fault of its own: ${answer.broken}`);
    if (answer.progress !== undefined) return this.progress(answer);
    if (answer.fault) return this.wrong(answer.fault);
    const took = performance.now() - this.asked;
    find("status").dataset[answer.phase] = took.toFixed(1);
    if (answer.phase === "check") return this.checked(answer);
    this.charts.show(answer.curves, answer.phase === "fine", this.title);
    if (answer.phase === "pressure") return undefined;
    document.body.classList.remove("stale");
    results.verdict(answer.summary);
    results.glance(answer.glance, this.pinned?.glance);
    if (answer.phase === "fine") this.whole(answer, took);
    return undefined;
  }

  checked({ drawing, notes, unused, stages, title }) {
    this.editor.complain(null);
    document.title = `${title} \u2013 wearshape`;
    Object.assign(this, { notes, unused, title });
    results.drawing(drawing);
    results.notes(notes, unused, this.pages);
    results.stages(stages);
  }

  whole(answer, took) {
    this.answer = { ...answer, text: this.text, scene: this.scene, written: this.written };
    this.play.show(answer.running_in);
    results.tables(answer.tables);
    results.notes(answer.summary.lints ?? this.notes, this.unused, this.pages);
    find("pin").disabled = false;
    const error = answer.summary.error?.gap_relative ?? answer.summary.error?.pressure_relative;
    const accuracy = error === undefined ? "" : `, estimated error ${shown(error, 1)}`;
    this.settled("done", `Computed in ${(took / 1000).toFixed(2)} s${accuracy}`);
    if (this.pinned) this.differences();
  }

  progress({ progress, words }) {
    const late = performance.now() - this.asked > 400;
    if (!late) return;
    find("progress").hidden = false;
    find("progress").value = progress;
    if (find("status").dataset.state === "busy") find("status").textContent = `${this.said}${words}`;
  }

  /** Keeps an answer to compare with, or lets it go. */
  pin(answer) {
    this.pinned = answer;
    find("pin").setAttribute("aria-pressed", String(Boolean(answer)));
    find("pin").textContent = answer ? "Unpin" : "Pin to compare";
    find("pinned").hidden = !answer;
    this.charts.pin(answer?.curves ?? []);
    results.glance(this.answer.glance, answer?.glance);
    if (answer) this.differences();
  }

  /** What differs from the pinned scene. */
  differences() {
    const before = new Map(this.pinned.written.map(({ key, text }) => [key, text]));
    const changed = this.written.filter(({ key, text }) => before.get(key) !== text).map(({ key, text }) => `${key} ${before.get(key) ?? "\u2013"} \u2192 ${text}`);
    const other = this.pinned.scene !== this.scene ? [`another scene: ${this.pinned.scene.title}`] : changed;
    find("pinned").textContent = `Dashed grey: pinned. ${other.length ? `Since then ${other.slice(0, 6).join("; ")}` : "Nothing has changed since"}.`;
  }
}

async function main() {
  const notes = fetch(new URL("./notes.md", import.meta.url)).then(answer => (answer.ok ? answer.text() : "")).catch(() => "");
  const module = await compile(new URL("./wearshape.wasm", import.meta.url));
  const page = new Page(module, await start(module), results.sections(await notes));
  await page.open(location.hash);
}

main().catch(error => {
  find("status").dataset.state = "wrong";
  find("status").textContent = `The page could not start: ${error.message}`;
});
