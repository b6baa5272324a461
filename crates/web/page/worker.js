// A thread of the solver. One of two parts: the quick one reads the scene, finds the pressure at once, then a coarse answer, then the curves as they
// are wanted; the whole one adds the proof, the tolerances and the numbers. Between two answers it looks whether another scene came meanwhile.

import { start } from "./engine.js";

/** One level: right to some thousandths in a tenth of the time. */
const COARSE = ["mesh={ degree = 4, layers = 4 }", "check=false"];
/** The curves of the whole answer, without the proof of them. */
const CURVES = ["check=false"];
/** Below so many seconds for the curves coarse ones first would only be in the way. */
const QUICK = 0.06;

let ask = null;
let job = null;
let kept = null;
let busy = false;
const wishes = [];
const seconds = new Map();

onmessage = async ({ data }) => {
  if (data.module) {
    ask = await start(data.module, (share, words) => postMessage({ progress: share, words, id: job?.id }));
  } else if (data.kept) {
    kept = data.kept;
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
  while (job || kept || wishes.length) {
    if (kept) {
      ask({ ask: "keep", files: kept });
      kept = null;
    } else if (job) {
      const now = job;
      job = null;
      const part = now.whole ? whole : quick;
      await part(now).catch(error => postMessage({ id: now.id, broken: String(error.message || error) }));
    } else {
      postMessage({ wish: wishes.shift(), ...ask({ ask: "files" }) });
    }
    await look();
  }
  busy = false;
}

const solved = ({ name, text }, settings, coarse) => ask({ ask: "solve", name, text, settings, coarse });

async function quick(now) {
  const { id, name, text } = now;
  const send = (phase, answer) => postMessage({ id, phase, ...answer });
  const checked = ask({ ask: "check", name, text });
  send("check", checked);
  if (checked.fault) return;
  for (const [phase, settings] of phases(name, checked)) {
    await look();
    if (job) return;
    const answer = solved(now, settings, true);
    // What a part of the work refuses, the whole of it may not.
    if (answer.fault) continue;
    if (phase === "curves") seconds.set(name, answer.seconds);
    send(phase, answer);
  }
  await look();
  if (!job) send("quick");
}

/** What comes before the whole answer. */
function phases(name, { stages, adaptive }) {
  const runs = word => stages.some(stage => stage.name === word && stage.ran);
  const bodies = runs("mesh");
  const phases = [];
  if (bodies && runs("optimal pressure") && !runs("force of the approach")) phases.push(["pressure", ["tasks=[pressure]"]]);
  // Wear in time has no curves before its end.
  const curves = runs("round trip") && !runs("evolution");
  const slow = !curves || (seconds.get(name) ?? 0) > QUICK;
  if (bodies && adaptive && slow) phases.push(["coarse", COARSE]);
  if (curves) phases.push(["curves", CURVES]);
  return phases;
}

async function whole(now) {
  postMessage({ id: now.id, phase: "whole" });
  postMessage({ id: now.id, phase: "fine", ...solved(now, [], false) });
}
