// The scene as text, with numbers of lines, and its mistake where it stands.

import { find, make } from "./dom.js";

/** Time without a key until the text is read (ms). */
const PAUSE = 200;

export class Editor {
  /** `changed(text)` is called after typing. */
  constructor(changed) {
    this.area = find("text");
    this.lines = find("lines");
    this.fault = find("fault");
    this.mark = find("mark");
    let timer;
    this.area.addEventListener("input", () => {
      this.number();
      clearTimeout(timer);
      timer = setTimeout(() => changed(this.area.value), PAUSE);
    });
    this.area.addEventListener("scroll", () => this.follow());
  }

  get text() {
    return this.area.value;
  }

  /** Shows another text; the cursor stays at its line. */
  set text(text) {
    if (text === this.area.value) return;
    const { selectionStart, scrollTop } = this.area;
    this.area.value = text;
    if (document.activeElement === this.area) this.area.setSelectionRange(selectionStart, selectionStart);
    this.area.scrollTop = scrollTop;
    this.number();
  }

  number() {
    const count = this.area.value.split("\n").length;
    if (count !== this.count) this.lines.textContent = Array.from({ length: count }, (_, line) => line + 1).join("\n");
    this.count = count;
    this.follow();
  }

  follow() {
    this.lines.scrollTop = this.area.scrollTop;
    this.mark.hidden = !this.wrong?.place;
    if (!this.mark.hidden) {
      const style = getComputedStyle(this.area);
      const top = parseFloat(style.paddingTop) + (this.wrong.place.line - 1) * parseFloat(style.lineHeight) - this.area.scrollTop;
      this.mark.style.top = `${top}px`;
      this.mark.hidden = top < 0 || top > this.area.clientHeight - 8;
    }
  }

  /** Shows what is wrong, or nothing. */
  complain(wrong) {
    this.wrong = wrong;
    this.fault.hidden = !wrong;
    this.area.setAttribute("aria-invalid", String(Boolean(wrong)));
    if (wrong) {
      const { message, remedy, place } = wrong;
      const where = place ? make("button", { type: "button", class: "plain" }, `line ${place.line}, column ${place.column}`) : "";
      if (place) where.addEventListener("click", () => this.go(place));
      const line = place ? make("pre", {}, `${place.text}\n${" ".repeat(place.column - 1)}${"^".repeat(place.length)}`) : "";
      this.fault.replaceChildren(make("p", {}, make("strong", {}, message), " ", where), line, make("p", {}, `Remedy: ${remedy}`));
    } else {
      this.fault.replaceChildren();
    }
    this.follow();
  }

  /** Puts the cursor at a place. */
  go({ line, column, length }) {
    const before = this.area.value.split("\n").slice(0, line - 1).reduce((sum, text) => sum + text.length + 1, 0);
    const start = before + column - 1;
    this.area.focus();
    this.area.setSelectionRange(start, start + length);
    this.area.scrollTop = Math.max(0, (line - 4) * parseFloat(getComputedStyle(this.area).lineHeight));
  }
}
