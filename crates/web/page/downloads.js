// The files of an answer, handed to the browser.

import { find, make } from "./dom.js";

const TYPES = { toml: "application/toml", csv: "text/csv", json: "application/json", svg: "image/svg+xml", html: "text/html", dxf: "image/vnd.dxf" };

const SAYS = {
  "report.html": "the whole report as one page", "contact.csv": "every contact point", "history.csv": "the steps in time", "profile.dxf": "the shape as a drawing",
  "profile.csv": "the shape as points", "profile-spline.csv": "the shape as cubic pieces", "summary.json": "every result with its unit",
  "scene.resolved.toml": "the scene with every default", "plots/scene.svg": "the drawing of the scene", "plots/curves.json": "the curves as numbers", "groove.csv": "the groove in body 2",
};

/** Fills the menu when it opens; `files()` promises name and content of each, `scene()` gives name and text of the scene. */
export function downloads(files, scene) {
  const menu = find("downloads");
  const list = find("files");
  const fill = async () => {
    const { name, text } = scene();
    const own = entry(`${name}.toml`, "the scene as it stands here", text, name);
    list.replaceChildren(own);
    const all = await files();
    const order = [...Object.keys(SAYS), ...Object.keys(all)];
    const names = [...new Set(order)].filter(file => file in all);
    list.replaceChildren(own, ...names.map(file => entry(file, SAYS[file] ?? "", all[file], name)));
  };
  menu.addEventListener("toggle", () => { if (menu.open) fill(); });
  menu.addEventListener("keydown", event => { if (event.key === "Escape") { menu.open = false; menu.querySelector("summary").focus(); } });
  document.addEventListener("click", event => { if (!menu.contains(event.target)) menu.open = false; });
}

function entry(file, says, content, scene) {
  const button = make("button", { type: "button", class: "plain" }, file);
  button.addEventListener("click", () => save(file.includes(".toml") && says.includes("here") ? file : `${scene}-${file.split("/").at(-1)}`, content));
  return make("li", {}, button, " ", make("span", { class: "with" }, says));
}

function save(name, content) {
  const type = TYPES[name.split(".").at(-1)] ?? "text/plain";
  const address = URL.createObjectURL(new Blob([content], { type }));
  const link = make("a", { href: address, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}
