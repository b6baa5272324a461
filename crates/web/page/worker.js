// The solver's thread: reads the scene, finds the pressure at once, then a coarse answer, then the wanted one. Between two of them it looks
// whether another scene came meanwhile.

import { start } from "./engine.js";

/** One level, without its proof: right to some thousandths in a tenth of the time. */
const COARSE = ["mesh={ degree = 4, layers = 4 }", "check=false"];
/** Below so many seconds for the whole answer a coarse one first would only be in the way. */
const QUICK = 0.06;

let ask = null;
let job = null;
let busy = false;
const wishes = [];
const seconds = new Map();

onmessage = async ({ data }) => {
  if (data.module) {
    ask = await start(data.module, (share, words) => postMessage({ progress: share, words, id: job?.id }));
  } else if (data.files) {
    wishes.push(data.files);
  } else {
    job = data;
  }
  if (ask && !busy) work();
};

/** Lets messages in. */
const look = () => new Promise(done => {
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = () => { port1.close(); done(); };
  port2.postMessage(null);
});

async function work() {
  busy = true;
  while (job || wishes.length) {
    if (job) {
      const now = job;
      job = null;
      await solve(now).catch(error => postMessage({ id: now.id, broken: String(error.message || error) }));
    } else {
      postMessage({ wish: wishes.shift(), ...ask({ ask: "files" }) });
    }
    await look();
  }
  busy = false;
}

async function solve({ id, name, text }) {
  const send = (phase, answer) => postMessage({ id, phase, ...answer });
  const checked = ask({ ask: "check", name, text });
  send("check", checked);
  if (checked.fault) return;
  const runs = word => checked.stages.some(stage => stage.name === word && stage.ran);
  const bodies = runs("mesh");
  const phases = [];
  if (bodies && runs("optimal pressure") && !runs("force of the approach")) phases.push(["pressure", ["tasks=[pressure]"]]);
  if (bodies && checked.adaptive && (seconds.get(name) ?? 1) > QUICK) phases.push(["coarse", COARSE]);
  phases.push(["fine", []]);
  for (const [phase, settings] of phases) {
    await look();
    if (job) return;
    const answer = ask({ ask: "solve", name, text, settings, coarse: phase !== "fine" });
    // What a part of the work refuses, the whole of it may not.
    if (answer.fault && phase !== "fine") continue;
    if (phase === "fine" && !answer.fault) seconds.set(name, answer.seconds);
    send(phase, answer);
  }
}
