// Wear in time: pressure and gap at the steps of a run, with a slider and a button to play.

import { Chart } from "./charts.js";
import { find } from "./dom.js";
import { shown } from "./quantity.js";

/** Time a run takes to play (ms). */
const SECONDS = 6000;

export class Play {
  constructor() {
    this.charts = { pressure: new Chart("run-pressure"), gap: new Chart("run-gap") };
    find("run-charts").append(this.charts.pressure.figure, this.charts.gap.figure);
    this.slider = find("step");
    this.button = find("play");
    this.slider.addEventListener("input", () => this.draw());
    this.button.addEventListener("click", () => (this.timer ? this.stop() : this.play()));
  }

  /** Shows a run, or nothing. */
  show(run) {
    this.stop();
    this.run = run;
    find("run-part").hidden = !run;
    if (!run) return;
    this.slider.max = run.time_s.length - 1;
    this.slider.value = this.slider.max;
    this.draw();
  }

  draw() {
    const { run } = this;
    const step = Number(this.slider.value);
    const moment = `step ${run.step[step]}, ${shown(run.time_s[step])} s`;
    find("moment").textContent = moment;
    this.slider.setAttribute("aria-valuetext", moment);
    const plot = (name, label, axis) => ({
      title: name, x_label: "s (mm)", y_label: label, from_zero: true, log_x: false, log_y: false, top: axis.top, note: axis.note, zones: [],
      series: [
        { name: "now", dashed: false, marks: false, x: run.x, y: run[name][step] },
        { name: "start", dashed: true, marks: false, x: run.x, y: run[name][0] },
      ],
    });
    this.charts.pressure.show(plot("pressure", "pressure (MPa)", run.pressure_axis));
    this.charts.gap.show(plot("gap", "gap above its lowest (\u00b5m)", run.gap_axis));
  }

  play() {
    const last = Number(this.slider.max);
    if (Number(this.slider.value) === last) this.slider.value = 0;
    this.button.textContent = "Pause";
    this.timer = setInterval(() => {
      this.slider.value = Number(this.slider.value) + 1;
      this.draw();
      if (Number(this.slider.value) === last) this.stop();
    }, SECONDS / (last + 1));
  }

  stop() {
    clearInterval(this.timer);
    this.timer = null;
    this.button.textContent = "Play";
  }
}
