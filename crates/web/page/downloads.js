// The files of an answer, handed to the browser.

import { find, make } from "./dom.js";

const TYPES = { toml: "application/toml", csv: "text/csv", json: "application/json", svg: "image/svg+xml", html: "text/html", dxf: "image/vnd.dxf" };

const SAYS = {
  "report.html": "the whole report as one page", "contact.csv": "every contact point", "history.csv": "the steps in time", "profile.dxf": "the shape as a drawing",
  "profile.csv": "the shape as points", "profile-spline.csv": "the shape as cubic pieces", "summary.json": "every result with its unit",
  "scene.resolved.toml": "the scene with every default", "plots/scene.svg": "the drawing of the scene", "plots/curves.json": "the curves as numbers", "groove.csv": "the groove in body 2",
};

/**
 * Fills the menu when it opens; `files()` promises the name of the scene that they answer and the content of each, `scene()` gives name and text of the
 * scene as it stands. What is returned fills a menu that is open again.
 */
export function downloads(files, scene) {
  const menu = find("downloads");
  const list = find("files");
  let last = 0;
  const fill = async () => {
    last += 1;
    const now = last;
    const { name, text } = scene();
    const focus = list.contains(document.activeElement) ? document.activeElement.textContent : null;
    const own = entry(`${name}.toml`, "the scene as it stands here", text, `${name}.toml`);
    list.replaceChildren(own);
    const answer = await files();
    // The menu was filled again meanwhile.
    if (now !== last) return;
    const order = [...Object.keys(SAYS), ...Object.keys(answer.files)];
    const names = [...new Set(order)].filter(file => file in answer.files);
    const rest = names.map(file => entry(file, SAYS[file] ?? "", answer.files[file], `${answer.name}-${file.split("/").at(-1)}`));
    list.append(...(rest.length ? rest : [make("li", { class: "with" }, "More files come with the answer to this scene.")]));
    if (focus && document.activeElement === document.body) [...list.querySelectorAll("button")].find(button => button.textContent === focus)?.focus();
  };
  const again = () => { if (menu.open) fill(); };
  menu.addEventListener("toggle", again);
  menu.addEventListener("keydown", event => { if (event.key === "Escape") { menu.open = false; menu.querySelector("summary").focus(); } });
  document.addEventListener("click", event => { if (!menu.contains(event.target)) menu.open = false; });
  return again;
}

function entry(file, says, content, name) {
  const button = make("button", { type: "button", class: "plain" }, file);
  button.addEventListener("click", () => save(name, content));
  return make("li", {}, button, " ", make("span", { class: "with" }, says));
}

function save(name, content) {
  const type = TYPES[name.split(".").at(-1)] ?? "text/plain";
  const address = URL.createObjectURL(new Blob([content], { type }));
  const link = make("a", { href: address, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 1000);
}
