// What an answer says beside its curves: the verdict, the first numbers, notes, tables.

import { find, make, picture } from "./dom.js";
import { minus, shown } from "./quantity.js";

const STATUS = { ok: "", "accuracy-missed": "The accuracy asked for was not reached.", "not-converged": "The computation did not arrive.", refused: "The scene has no answer.", interrupted: "" };

/** The drawing of the scene. */
export function drawing(svg) {
  const place = find("drawing");
  if (place.dataset.svg === svg) return;
  place.dataset.svg = "";
  place.replaceChildren(picture(svg));
}

/** The verdict in words. */
export function verdict(summary) {
  const place = find("verdict");
  const words = minus(summary.verdict.charAt(0).toUpperCase() + summary.verdict.slice(1));
  if (place.textContent !== words) place.textContent = words;
  place.classList.toggle("bad", Boolean(STATUS[summary.status]));
}

/** The first numbers, beside those of a pinned answer: `[[words, number, unit], ..]`. */
export function glance(rows, pinned) {
  const before = new Map((pinned ?? []).map(([words, number]) => [words, number]));
  const cells = rows.map(([words, number, unit]) => {
    const value = make("data", { value: String(number) }, `${shown(number)} ${unit}`);
    const old = before.get(words);
    const change = old === undefined ? null : make("span", { class: "change" }, compared(number, old));
    return make("div", {}, make("dt", {}, words), make("dd", {}, value, change));
  });
  find("glance").replaceChildren(...cells);
}

function compared(number, old) {
  if (number === old) return "as pinned";
  const percent = (100 * (number - old)) / Math.abs(old);
  return old === 0 ? `pinned ${shown(old)}` : `${percent > 0 ? "+" : ""}${shown(percent, 3)} % (${shown(old)})`;
}

/** The sections of the page on notes, by code. */
export function sections(page) {
  return Object.fromEntries(page.split("\n## ").slice(1).map(section => {
    const end = section.indexOf("\n");
    return [section.slice(0, end), section.slice(end).trim()];
  }));
}

/** Notes on the scene and its answer, each with what stands behind it. */
export function notes(all, unused, pages) {
  const open = new Set([...find("notes").querySelectorAll("details[open]")].map(node => node.dataset.code));
  const items = all.map(({ code, message }) => {
    const node = make("details", { open: open.has(code) }, make("summary", {}, make("strong", {}, code), ` ${message}`), ...paragraphs(pages[code] ?? ""));
    node.dataset.code = code;
    return node;
  });
  if (unused?.length) items.push(make("p", {}, `Keys of the scene that were not used: ${unused.join(", ")}`));
  find("notes").replaceChildren(...items);
  find("notes-part").hidden = items.length === 0;
}

/** Paragraphs of a section, with its words of code. */
function paragraphs(text) {
  return text.split("\n\n").filter(Boolean).map(paragraph => {
    const parts = paragraph.replaceAll("\n", " ").split("`");
    return make("p", {}, ...parts.map((part, number) => (number % 2 ? make("code", {}, part) : part)));
  });
}

/** All numbers of the answer in tables; the module made them, and escaped every text. */
export function tables(html) {
  const open = new Set([...find("tables").querySelectorAll("details[open] > summary")].map(node => node.textContent));
  const read = new DOMParser().parseFromString(html, "text/html");
  const texts = read.createNodeIterator(read.body, NodeFilter.SHOW_TEXT);
  for (let node = texts.nextNode(); node; node = texts.nextNode()) node.data = readable(node.data);
  const parts = [];
  for (const node of [...read.body.children]) {
    if (node.localName === "h2") parts.push(make("details", { open: open.has(node.textContent) || node.textContent === "Tolerance" }, make("summary", {}, node.textContent)));
    else parts.at(-1)?.append(document.adoptNode(node));
  }
  find("tables").replaceChildren(...parts);
}

/** A text of a table: a true minus, and three digits of what an error may be. */
function readable(text) {
  return minus(text).replace(/\u00b1([\d.]+(?:e[-\u2212]?\d+)?)/g, (_, number) => `\u00b1${shown(Number(number.replace("\u2212", "-")), 3)}`);
}

/** Stages that were left out and why, of a scene that was read. */
export function stages(all) {
  const rows = all.map(({ name, ran, because }) => make("tr", {}, make("td", {}, name), make("td", {}, ran ? "yes" : "left out"), make("td", {}, because)));
  find("stages").replaceChildren(...rows);
}
