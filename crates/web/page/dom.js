// Elements of the page in a few letters.

/** An element with properties, attributes (names with a hyphen, `for`, `role`, `class`) and children. */
export function make(name, properties = {}, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (key === "class" || key === "for" || key === "role" || key === "list" || key.includes("-")) node.setAttribute(key, value);
    else node[key] = value;
  }
  node.append(...children.filter(child => child !== null));
  return node;
}

/** The element of an id. */
export const find = id => document.getElementById(id);

/** An SVG of ours as an element. */
export function picture(svg) {
  return document.importNode(new DOMParser().parseFromString(svg, "image/svg+xml").documentElement, true);
}
