// Files beside the scene, meshes and measured profiles: chosen or dropped, kept as long as the page is open and over a reload, sent nowhere.

import { find, make } from "./dom.js";

const STORE = "files";

export class Files {
  /** `changed(files)` gets all files, `[[name, letters]]`, one letter a byte, `opened(name, text)` a scene. */
  constructor(changed, opened) {
    Object.assign(this, { changed, opened, all: new Map(stored()) });
    const choice = find("choice");
    choice.addEventListener("change", () => this.take(choice.files).then(() => { choice.value = ""; }));
    const carries = event => event.dataTransfer?.types.includes("Files");
    addEventListener("dragover", event => { if (carries(event)) { event.preventDefault(); document.body.classList.add("drop"); } });
    addEventListener("dragleave", event => { if (!event.relatedTarget) document.body.classList.remove("drop"); });
    addEventListener("drop", event => {
      if (!carries(event)) return;
      event.preventDefault();
      document.body.classList.remove("drop");
      this.take(event.dataTransfer.files);
    });
    if (this.all.size) this.told();
  }

  async take(list) {
    for (const file of [...list]) {
      const scene = file.name.match(/^(.+)\.toml$/i);
      if (scene) this.opened(scene[1], await file.text());
      else this.all.set(file.name, lettered(new Uint8Array(await file.arrayBuffer())));
    }
    this.told();
  }

  told() {
    const rows = [...this.all].map(([name, letters]) => {
      const away = make("button", { type: "button", class: "plain", "aria-label": `take ${name} away` }, "take away");
      away.addEventListener("click", () => { this.all.delete(name); this.told(); });
      return make("li", {}, make("code", {}, name), make("span", { class: "with" }, ` ${Math.ceil(letters.length / 1000)} kB `), away);
    });
    find("kept").replaceChildren(...rows);
    try {
      sessionStorage.setItem(STORE, JSON.stringify([...this.all]));
    } catch {
      // Larger than a session holds: they last until the page is loaded again.
    }
    this.changed([...this.all]);
  }
}

/** The files of this session. */
function stored() {
  try {
    return JSON.parse(sessionStorage.getItem(STORE)) ?? [];
  } catch {
    return [];
  }
}

/** One letter a byte: what JSON and the store of a session take. */
export function lettered(bytes) {
  const parts = [];
  for (let at = 0; at < bytes.length; at += 32768) parts.push(String.fromCharCode(...bytes.subarray(at, at + 32768)));
  return parts.join("");
}
