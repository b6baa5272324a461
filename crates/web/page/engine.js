// The WebAssembly module: a question goes in as an object, its answer comes back as an object.

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** Compiles the module at an address; a server that does not know the type of the file is no hindrance. */
export async function compile(url) {
  const whole = async () => WebAssembly.compile(await (await fetch(url)).arrayBuffer());
  return WebAssembly.compileStreaming(fetch(url)).catch(whole);
}

/** An instance with a memory of its own, as a function; `told(share, words)` hears how far a solve is. */
export async function start(module, told = () => {}) {
  const read = (place, length) => decoder.decode(new Uint8Array(exports.memory.buffer, place, length));
  const page = {
    clock: () => performance.now() / 1000,
    progress: (share, place, length) => told(share, read(place, length)),
  };
  const { exports } = await WebAssembly.instantiate(module, { page });
  return question => {
    const bytes = encoder.encode(JSON.stringify(question));
    const place = exports.room(bytes.length);
    new Uint8Array(exports.memory.buffer, place, bytes.length).set(bytes);
    let length;
    try {
      length = exports.ask();
    } catch (error) {
      const length = exports.last_words();
      const words = read(exports.answer(), length);
      throw new Error(words || error.message);
    }
    return JSON.parse(read(exports.answer(), length));
  };
}

