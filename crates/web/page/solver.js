// The page's side of the solver's two threads: the last scene counts. The quick thread shows what a change does, however long the other is at an older
// scene; the whole one gives the answer with its proof. A thread that is busy with an older scene for too long is ended, and a new one begun.

/** How long a thread may finish what it is at (ms), once there is a newer scene. */
const PATIENCE = 250;

/** One thread; `said` gets every message about the job given last. */
class Thread {
  constructor(module, said) {
    Object.assign(this, { module, said, job: { id: 0 }, idle: true, timer: null, kept: null, wishes: new Map() });
    this.begin();
  }

  begin() {
    this.worker?.terminate();
    this.worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    this.worker.onmessage = ({ data }) => this.hear(data);
    this.worker.onerror = event => { event.preventDefault(); this.said({ id: this.job.id, broken: event.message || "the solver could not be loaded" }); };
    this.worker.postMessage({ module: this.module });
    if (this.kept) this.worker.postMessage({ kept: this.kept });
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
    const begins = data.phase === "check" || data.phase === "whole";
    if (begins || data.id === this.job.id) this.heeds();
    if (data.id !== this.job.id) {
      if (begins) this.wait();
      return;
    }
    if (data.broken) this.begin();
    if (data.phase === "quick" || data.phase === "fine" || data.fault || data.broken) this.idle = true;
    this.said(data);
  }

  /** Takes up a job in place of all before. */
  take(job) {
    this.job = job;
    this.worker.postMessage(job);
    if (!this.idle) this.wait();
    this.idle = false;
  }

  /** Files beside the scene. */
  keep(kept) {
    this.kept = kept;
    this.worker.postMessage({ kept });
  }

  wish(name) {
    return new Promise(done => {
      this.wishes.set(name, done);
      this.worker.postMessage({ files: name });
    });
  }
}

export class Solver {
  /** `heard` gets every message about the scene given last. */
  constructor(module, heard) {
    this.job = { id: 0 };
    /** The job whose whole answer is there. */
    this.answered = null;
    const told = data => { if (data.id === this.job.id) heard(data); };
    this.whole = new Thread(module, data => {
      if (data.phase === "whole") return;
      if (data.id === this.job.id && data.phase === "fine" && !data.fault) this.answered = data.id;
      told(data);
    });
    this.quick = new Thread(module, data => {
      if (data.phase !== "quick") return told(data);
      if (data.id === this.job.id) this.whole.take({ ...this.job, whole: true });
    });
  }

  /** Solves a scene in place of all before. */
  solve(name, text) {
    this.job = { id: this.job.id + 1, name, text };
    this.quick.take(this.job);
  }

  /** Lets go of the last scene: nothing more is heard of it. */
  forget() {
    this.job = { id: this.job.id + 1 };
  }

  /** The files that scenes may name: `[[name, letters]]`, one letter a byte. */
  keep(kept) {
    this.quick.keep(kept);
    this.whole.keep(kept);
  }

  /** The files of the answer to the scene given last, with its name; none before it is there. */
  async files() {
    const { id, name } = this.job;
    const files = this.answered === id ? await this.whole.wish(`${id}-${Math.round(performance.now())}`) : {};
    return { name, files: this.job.id === id ? files : {} };
  }
}
