// node tube.mjs tube.wasm DEGREE: what the module computes, to the digits that the native example prints.
import { readFileSync } from "node:fs";

const [file, degree] = process.argv.slice(2);
const { instance } = await WebAssembly.instantiate(readFileSync(file), {});
const u = instance.exports.bore_displacement(Number(degree));
console.log(`degree ${degree}: u_r = ${u.toFixed(12)} (${u})`);
