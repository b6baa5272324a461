// The curves of a result, drawn by uPlot: one chart a quantity, which stays while its numbers change.

import uPlot from "./uplot.js";
import { make } from "./dom.js";
import { shown } from "./quantity.js";

const HEIGHT = 240;
/** More points than this are a line. */
const MARKED = 60;
const COLOURS = ["--curve-1", "--curve-2", "--curve-3", "--curve-4"];

const colour = name => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** All charts of a place. */
export class Charts {
  constructor(root) {
    Object.assign(this, { root, charts: new Map(), pinned: new Map() });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.charts.forEach(chart => chart.rebuild()));
  }

  /** Shows `[{ file, chart }]` of a scene with a title; the others wait as they are, or go if the answer is whole. */
  show(curves, whole, title = "") {
    for (const { file, chart } of curves) {
      if (!this.charts.has(file)) {
        const made = new Chart(file);
        this.charts.set(file, made);
        this.root.append(made.figure);
      }
      this.charts.get(file).show({ ...chart, title: without(chart.title, title) }, this.pinned.get(file));
    }
    for (const [file, chart] of this.charts) {
      const there = curves.some(curve => curve.file === file);
      chart.figure.classList.toggle("old", !there);
      if (whole && !there) {
        chart.figure.remove();
        this.charts.delete(file);
      }
    }
  }

  /** Keeps curves to compare with, or none. */
  pin(curves) {
    this.pinned = new Map(curves.map(({ file, chart }) => [file, chart]));
    this.charts.forEach((chart, file) => chart.show(chart.chart, this.pinned.get(file)));
  }
}

/** One chart. */
export class Chart {
  constructor(name) {
    this.title = make("figcaption", {});
    this.plot = make("div", { class: "plot", role: "img" });
    this.note = make("p", { class: "note", hidden: true });
    this.figure = make("figure", { class: "chart" }, this.title, this.plot, this.note);
    this.figure.dataset.chart = name;
    new ResizeObserver(() => {
      const width = this.plot.clientWidth;
      if (this.drawn && width && width !== this.drawn.width) this.drawn.setSize({ width, height: HEIGHT });
    }).observe(this.plot);
  }

  show(chart, pinned) {
    Object.assign(this, { chart, pinned });
    const series = [...chart.series, ...(pinned?.series ?? []).filter(one => !one.dashed).map(one => ({ ...one, name: `pinned${one.name ? `: ${one.name}` : ""}`, pinned: true }))];
    const data = joined(series, chart);
    this.title.textContent = chart.title;
    this.note.hidden = !chart.note;
    this.note.textContent = chart.note ?? "";
    this.plot.setAttribute("aria-label", described(chart));
    const kind = JSON.stringify([chart.x_label, chart.y_label, chart.log_x, chart.log_y, series.map(one => [one.name, one.dashed, one.marks])]);
    if (this.drawn && kind === this.kind) {
      this.drawn.setData(data);
    } else {
      this.kind = kind;
      this.draw(series, data);
    }
  }

  rebuild() {
    this.kind = "";
    this.show(this.chart, this.pinned);
  }

  draw(series, data) {
    this.drawn?.destroy();
    const width = this.plot.clientWidth || 400;
    this.drawn = new uPlot(this.options(series, width), data, this.plot);
  }

  options(series, width) {
    const { chart } = this;
    const axis = label => ({ label, labelSize: 20, labelFont: "12px system-ui", font: "12px system-ui", stroke: colour("--soft"), grid: { stroke: colour("--grid"), width: 1 }, ticks: { stroke: colour("--grid"), width: 1, size: 4 } });
    const across = (plot, ticks) => labels(ticks, chart.log_x ? (plot.width - 90) / 48 : Infinity);
    const up = (_, ticks) => labels(ticks, chart.log_y ? (HEIGHT - 60) / 20 : Infinity);
    const whole = !chart.log_x && series.every(one => one.x.every(Number.isInteger));
    const read = (_, value) => (value === null || value === undefined ? "" : shown(value));
    const lines = series.map((one, number) => ({
      label: one.name || chart.y_label.replace(/ \(.*/, ""),
      stroke: one.pinned ? colour("--soft") : colour(COLOURS[number % COLOURS.length]),
      width: one.pinned ? 1.5 : 2,
      dash: one.dashed || one.pinned ? [6, 5] : undefined,
      points: { show: one.marks && one.x.length <= MARKED, size: 6 },
      spanGaps: true,
      value: read,
    }));
    return {
      width,
      height: HEIGHT,
      scales: {
        x: { time: false, distr: chart.log_x ? 3 : 1 },
        y: { distr: chart.log_y ? 3 : 1, range: (_, low, high) => this.reach(low, high) },
      },
      axes: [{ ...axis(chart.x_label), values: across, size: 34, incrs: whole ? [1, 2, 5, 10] : undefined }, { ...axis(chart.y_label), values: up, size: 58 }],
      series: [{ label: chart.x_label.replace(/;.*/, ""), value: read }, ...lines],
      legend: { live: true },
      cursor: { drag: { x: true, y: false }, points: { size: 7 } },
      hooks: { drawClear: [plot => zones(plot, this.chart.zones ?? [])] },
    };
  }

  /** The y axis: from zero where nothing is below. */
  reach(low, high) {
    const { chart } = this;
    if (!(high >= low)) return [0, 1];
    if (chart.log_y) return [10 ** Math.floor(Math.log10(low)), 10 ** Math.ceil(Math.log10(high * 1.0001))];
    const top = chart.top ?? high;
    if (chart.from_zero && low >= 0) return [0, top > 0 ? 1.06 * top : 1];
    const room = 0.06 * (top - low) || 0.1 * Math.abs(top) || 1;
    return [low - room, top + room];
  }
}

/** The title of a chart without that of its scene before it. */
function without(title, scene) {
  return title.startsWith(`${scene}: `) ? title.slice(scene.length + 2) : title;
}

/** Labels of ticks, as many as there is room for: uPlot leaves out no decades where one of three had it. */
function labels(ticks, room) {
  const every = Math.max(1, Math.ceil(ticks.filter(tick => tick !== null).length / room));
  let place = -1;
  return ticks.map(tick => {
    if (tick === null) return "";
    place += 1;
    return place % every ? "" : shown(tick);
  });
}

/** Columns with one abscissa for all series. */
function joined(series, { log_x, log_y }) {
  const clean = ys => (log_y ? ys.map(y => (y > 0 ? y : null)) : ys);
  const table = one => {
    const order = one.x.map((x, row) => [x, clean(one.y)[row]]).filter(([x]) => x !== null && !(log_x && x <= 0));
    if (order.some(([x], row) => row > 0 && x < order[row - 1][0])) order.sort((a, b) => a[0] - b[0]);
    return [order.map(([x]) => x), order.map(([, y]) => y)];
  };
  const tables = series.map(one => table(one));
  const same = tables.every(([xs]) => xs.length === tables[0][0].length && xs.every((x, row) => x === tables[0][0][row]));
  if (same) return [tables[0]?.[0] ?? [], ...tables.map(([, ys]) => ys)];
  return uPlot.join(tables);
}

/** Named parts of the abscissa. */
function zones(plot, all) {
  const { ctx, bbox } = plot;
  for (const { from, to, name } of all) {
    const [left, right] = [from, to].map(x => plot.valToPos(x, "x", true));
    ctx.save();
    ctx.fillStyle = colour("--zone");
    ctx.fillRect(left, bbox.top, right - left, bbox.height);
    ctx.fillStyle = colour("--soft");
    ctx.font = `${12 * devicePixelRatio}px system-ui`;
    ctx.textAlign = "center";
    ctx.fillText(name, (left + right) / 2, bbox.top + bbox.height - 6);
    ctx.restore();
  }
}

/** A chart in words. */
function described(chart) {
  const says = chart.series.map(({ name, x, y }) => {
    let best = -1;
    y.forEach((value, row) => { if (value !== null && (best < 0 || value > y[best])) best = row; });
    return best < 0 ? name : `${name || chart.y_label}: at most ${shown(y[best])} at ${shown(x[best])}`;
  });
  return `${chart.title}; ${chart.y_label} over ${chart.x_label}. ${says.join(". ")}`;
}
