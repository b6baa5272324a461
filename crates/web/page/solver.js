// The page's side of the solver's thread: the last scene counts. A thread that is busy with an older one for too long is ended, and a new one begun.

/** How long a thread may finish what it is at (ms), once there is a newer scene. */
const PATIENCE = 250;

export class Solver {
  /** `heard` gets every message about the scene given last. */
  constructor(module, heard) {
    Object.assign(this, { module, heard, id: 0, idle: true, timer: null, wishes: new Map() });
    this.begin();
  }

  begin() {
    this.worker?.terminate();
    this.worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    this.worker.onmessage = ({ data }) => this.hear(data);
    this.worker.onerror = event => { event.preventDefault(); this.heard({ id: this.id, broken: event.message || "the solver could not be loaded" }); };
    this.worker.postMessage({ module: this.module });
    [...this.wishes.keys()].forEach(wish => this.worker.postMessage({ files: wish }));
  }

  /** Ends a thread that is at an older scene still, after a while. */
  wait() {
    this.timer ??= setTimeout(() => {
      this.timer = null;
      this.begin();
      this.worker.postMessage(this.job);
    }, PATIENCE);
  }

  /** The thread shows that it hears. */
  heeds() {
    clearTimeout(this.timer);
    this.timer = null;
  }

  hear(data) {
    if (data.wish !== undefined) {
      this.wishes.get(data.wish)?.(data.files);
      this.wishes.delete(data.wish);
      return;
    }
    if (data.phase === "check" || data.id === this.id) this.heeds();
    if (data.id !== this.id) {
      if (data.phase === "check") this.wait();
      return;
    }
    if (data.broken) this.begin();
    if (data.phase === "fine" || data.fault || data.broken) this.idle = true;
    this.heard(data);
  }

  /** Solves a scene in place of all before. */
  solve(name, text) {
    this.id += 1;
    this.job = { id: this.id, name, text };
    this.worker.postMessage(this.job);
    if (!this.idle) this.wait();
    this.idle = false;
  }

  /** The files of the answer, once it is there. */
  files() {
    const wish = `${this.id}-${this.wishes.size}-${Math.round(performance.now())}`;
    return new Promise(done => {
      this.wishes.set(wish, done);
      this.worker.postMessage({ files: wish });
    });
  }
}
