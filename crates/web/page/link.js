// The state in the address: the name of a scene, and its text where it is not the one that comes with the page.

import { lettered } from "./files.js";

const PART = { name: "scene", text: "toml" };

/** Name and text of an address; the text is none where the scene is as it comes, or where it is `damaged`. */
export async function read(hash) {
  const parts = new URLSearchParams(hash.replace(/^#/, ""));
  const packed = parts.get(PART.text);
  const text = packed === null ? null : await unpacked(packed).catch(() => null);
  return { name: parts.get(PART.name), text, damaged: packed !== null && text === null };
}

/** The address of a scene. */
export async function write(name, text) {
  const parts = new URLSearchParams({ [PART.name]: name });
  if (text !== null) parts.set(PART.text, await packed(text));
  return `#${parts}`;
}

async function through(bytes, stream) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

async function packed(text) {
  const bytes = await through(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
  return btoa(lettered(bytes)).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

async function unpacked(letters) {
  const bytes = Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), letter => letter.charCodeAt(0));
  return new TextDecoder("utf-8", { fatal: true }).decode(await through(bytes, new DecompressionStream("deflate-raw")));
}
