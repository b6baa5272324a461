"use strict";
// Draws each chart of the page with hover and zoom; without script the static pictures stay.
(function () {
  const NS = "http://www.w3.org/2000/svg";
  const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#888888"];
  const W = 720, H = 400, T = 14, B = 52;
  const { charts, run_in } = JSON.parse(document.getElementById("data").textContent);

  function make(name, attributes, parent, text) {
    const node = document.createElementNS(NS, name);
    for (const key in attributes) node.setAttribute(key, attributes[key]);
    if (text !== undefined) node.textContent = text;
    parent.appendChild(node);
    return node;
  }
  function ticks(low, high, count) {
    const raw = (high - low) / count, magnitude = Math.pow(10, Math.floor(Math.log10(raw)));
    const step = [1, 2, 2.5, 5, 10].map(m => m * magnitude).find(s => s >= raw * 0.999);
    const out = [];
    for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) out.push(i * step);
    return out;
  }
  function show(value) {
    if (value === 0) return "0";
    const size = Math.abs(value);
    const text = size >= 1e6 || size < 1e-4 ? value.toExponential(4).replace(/\.?0*e\+?/, "e") : String(Number(value.toPrecision(6)));
    return text.replaceAll("-", "\u2212");
  }
  function range(values) {
    let low = Infinity, high = -Infinity;
    for (const v of values) if (v !== null) { if (v < low) low = v; if (v > high) high = v; }
    if (!(high >= low)) { low = 0; high = 1; }
    if (high - low <= 1e-9 * Math.max(Math.abs(high), Math.abs(low))) { const half = high === 0 ? 1 : 0.1 * Math.abs(high); low -= half; high += half; }
    return [low, high];
  }

  function draw(figure, chart) {
    if (chart.log_x) for (const s of chart.series) { s.y = s.y.filter((_, i) => s.x[i] > 0); s.x = s.x.filter(v => v > 0); }
    const xs = [].concat(...chart.series.map(s => s.x)), ys = [].concat(...chart.series.map(s => s.y));
    const fullX = range(xs);
    let view = fullX.slice(), drag = null;
    const along = chart.log_x ? v => Math.log10(v) : v => v, from = chart.log_x ? v => Math.pow(10, v) : v => v;
    const up = chart.log_y ? v => (v === null || v <= 0 ? null : Math.log10(v)) : v => v;
    const back = chart.log_y ? v => Math.pow(10, v) : v => v;
    const old = figure.querySelector("svg");
    const svg = make("svg", { viewBox: `0 0 ${W} ${H}`, role: "img", "aria-label": chart.title }, figure);
    if (old) old.remove();
    let L = 76, R = 16;

    // Width of the longest of some texts in a class of the page, the size of its letters, and the width of each.
    function measure(texts, name) {
      const text = make("text", { class: name }, svg), widths = texts.map(t => { text.textContent = t; return text.getComputedTextLength(); });
      const size = parseFloat(getComputedStyle(text).fontSize) || 13;
      text.remove();
      return [Math.max(0, ...widths), size, widths];
    }
    // Where the names of curves stand: in a corner that nothing drawn touches, else in rows above the curves, which are let down by `room`.
    function places(shown, px, py, taken) {
      const [longest, size, widths] = measure(shown.map(s => s.name), "tip"), row = 1.4 * size;
      const width = 40 + longest, height = row * shown.length + 0.4 * size;
      const corners = [[W - R - width - 4, T], [L + 6, T], [W - R - width - 4, H - B - height - 4], [L + 6, H - B - height - 4]];
      const drawn = taken.slice();
      for (const s of shown) {
        let last = null;
        s.x.forEach((x, i) => {
          if (up(s.y[i]) === null || x < view[0] || x > view[1]) { last = null; return; }
          const [a, b] = [px(x), py(s.y[i])], count = last ? Math.max(1, Math.ceil(Math.hypot(a - last[0], b - last[1]) / 4)) : 1;
          for (let k = 1; k <= count; k++) drawn.push(last ? [last[0] + (a - last[0]) * k / count, last[1] + (b - last[1]) * k / count] : [a, b]);
          last = [a, b];
        });
      }
      const free = ([left, top]) => !drawn.some(([x, y]) => x > left - 6 && x < left + width + 6 && y > top - 6 && y < top + height + 6);
      const corner = chart.names_in_rows ? undefined : corners.find(free);
      if (corner) return { room: 0, size, at: shown.map((_, n) => [corner[0], corner[1] + row * (n + 1)]) };
      let [x, line] = [L + 6, 1];
      const at = widths.map(wide => {
        if (x > L + 6 && x + 40 + wide > W - R) { x = L + 6; line += 1; }
        x += 52 + wide;
        return [x - 52 - wide, T + row * line - 0.4 * size];
      });
      return { room: row * line + 0.2 * size, size, at };
    }

    function render() {
      svg.replaceChildren();
      const seen = [];
      for (const s of chart.series) s.x.forEach((x, i) => { if (x >= view[0] && x <= view[1]) seen.push(up(s.y[i])); });
      let [low, high] = chart.y_range || range(seen.length ? seen : ys.map(up));
      const whole = view[0] === fullX[0] && view[1] === fullX[1];
      if (chart.top && whole) high = chart.top;
      if (chart.from_zero && low >= 0 && whole) low = 0;
      if (chart.log_y && high - low < 1) high = low + 1;
      const yTicks = ticks(low, high, 6), step = chart.log_y ? Math.max(1, Math.ceil((high - low) / 6)) : yTicks.length > 1 ? yTicks[1] - yTicks[0] : 1;
      low = Math.floor(low / step + 1e-9) * step; high = Math.ceil(high / step - 1e-9) * step;
      const rows = [];
      for (let i = Math.round(low / step); i * step <= high + 1e-9 * step; i++) rows.push(back(Number((i * step).toPrecision(12))));
      const label = value => show(Number(value.toPrecision(12)));
      const [widest, letter] = measure(rows.map(label), "axis");
      L = Math.max(76, widest + 12 + 1.7 * letter);
      const decades = () => {
        const [a, b] = [Math.ceil(Math.log10(view[0]) - 1e-9), Math.floor(Math.log10(view[1]) + 1e-9)];
        const step = Math.max(1, Math.ceil((b - a) / 7));
        return Array.from({ length: Math.max(0, Math.floor((b - a) / step) + 1) }, (_, i) => Math.pow(10, a + i * step));
      };
      const columns = chart.log_x ? decades() : ticks(view[0], view[1], 7), share = x => (along(x) - along(view[0])) / (along(view[1]) - along(view[0]));
      // The last number along x stands within the picture.
      const last = share(columns.at(-1)), [wide] = measure(columns.slice(-1).map(label), "axis");
      R = Math.max(16, last > 0 ? W - L - (W - L - 2 - wide / 2) / last : 0);
      const px = x => L + share(x) * (W - L - R);
      let top = T;
      const py = y => H - B - (Math.min(Math.max(up(y), low), high) - low) / (high - low) * (H - top - B);
      const note = chart.note && whole ? chart.note : "", seen_zones = (chart.zones || []).map(z => [Math.max(view[0], z.from), Math.min(view[1], z.to), z.name]).filter(([a, b]) => b > a);
      const taken = seen_zones.map(([a, b]) => [(px(a) + px(b)) / 2, H - B - 12]).concat(note ? Array.from({ length: 1 + measure([note], "axis")[0] / 10 }, (_, i) => [L + 8 + 10 * i, T + 0.6 * letter]) : []);
      const named = chart.series.length <= 6 && !chart.names_above ? chart.series.filter(s => s.name) : [];
      const names = named.length ? places(named, px, py, taken) : { room: 0 };
      top += names.room;
      for (const [a, b, name] of seen_zones) {
        make("rect", { class: "zone", x: px(a), y: top, width: px(b) - px(a), height: H - top - B }, svg);
        make("text", { class: "axis", x: (px(a) + px(b)) / 2, y: H - B - 8, "text-anchor": "middle" }, svg, name);
      }
      for (const t of columns) {
        make("path", { class: "grid", d: `M${px(t)} ${top}V${H - B}` }, svg);
        make("text", { class: "axis", x: px(t), y: H - B + 8 + 0.8 * letter, "text-anchor": "middle" }, svg, label(t));
      }
      for (const t of rows) {
        make("path", { class: "grid", d: `M${L} ${py(t)}H${W - R}` }, svg);
        make("text", { class: "axis", x: L - 8, y: py(t) + 0.34 * letter, "text-anchor": "end" }, svg, label(t));
      }
      make("path", { class: "frame", d: `M${L} ${top}V${H - B}H${W - R}` }, svg);
      make("text", { class: "axis", x: (L + W - R) / 2, y: H - 8, "text-anchor": "middle" }, svg, chart.x_label);
      make("text", { class: "axis", transform: `translate(16 ${(top + H - B) / 2}) rotate(-90)`, "text-anchor": "middle" }, svg, chart.y_label);
      chart.series.forEach((s, n) => {
        let d = "", pen = false;
        s.x.forEach((x, i) => {
          if (up(s.y[i]) === null || x < view[0] || x > view[1]) { pen = false; return; }
          if (s.marks) make("circle", { cx: px(x), cy: py(s.y[i]), r: 3.5, fill: COLOURS[n % 7] }, svg);
          d += (pen ? "L" : "M") + px(x).toFixed(2) + " " + py(s.y[i]).toFixed(2); pen = true;
        });
        make("path", { d, fill: "none", stroke: COLOURS[n % 7], "stroke-width": 2, "stroke-linejoin": "round", "stroke-dasharray": s.dashed ? "7 5" : "none" }, svg);
        const [x, y] = (names.at || [])[named.indexOf(s)] || [];
        if (x === undefined) return;
        make("path", { d: `M${x} ${y - 0.34 * names.size}h24`, stroke: COLOURS[n % 7], "stroke-width": 2, "stroke-dasharray": s.dashed ? "7 5" : "none" }, svg);
        make("text", { class: "tip", x: x + 30, y }, svg, s.name);
      });
      if (note) make("text", { class: "axis", x: L + 8, y: top + letter }, svg, note);
      const over = make("g", {}, svg);
      const inverse = event => {
        const box = svg.getBoundingClientRect();
        const at = (event.clientX - box.left) / box.width * W;
        return from(along(view[0]) + (at - L) / (W - L - R) * (along(view[1]) - along(view[0])));
      };
      svg.onpointermove = event => {
        over.replaceChildren();
        const x = inverse(event);
        if (drag !== null) {
          const [a, b] = [Math.max(view[0], Math.min(drag, x)), Math.min(view[1], Math.max(drag, x))];
          if (b > a) make("rect", { class: "drag", x: px(a), y: top, width: px(b) - px(a), height: H - top - B }, over);
          return;
        }
        if (x < view[0] || x > view[1]) return;
        const found = [];
        chart.series.forEach((s, n) => {
          let best = -1;
          s.x.forEach((v, i) => { if (s.y[i] !== null && (best < 0 || Math.abs(v - x) < Math.abs(s.x[best] - x))) best = i; });
          if (best >= 0 && up(s.y[best]) !== null) found.push([s, n, best]);
        });
        if (!found.length) return;
        const at = px(found[0][0].x[found[0][2]]);
        make("path", { class: "cross", d: `M${at} ${top}V${H - B}` }, over);
        const lines = found.map(([s, n, i]) => `${s.name ? s.name + ": " : ""}${show(s.y[i])} at ${show(s.x[i])}`);
        found.forEach(([s, n, i]) => make("circle", { cx: px(s.x[i]), cy: py(s.y[i]), r: 4, fill: COLOURS[n % 7] }, over));
        const [longest, size] = measure(lines, "tip"), row = 1.4 * size, width = 16 + longest, left = Math.min(at + 10, W - R - width);
        make("rect", { class: "tipbox", x: left, y: top + 4, width, height: 10 + row * lines.length }, over);
        lines.forEach((line, i) => make("text", { class: "tip", x: left + 8, y: top + 4 + row * (i + 1) }, over, line));
      };
      svg.onpointerleave = () => { drag = null; over.replaceChildren(); };
      // A finger reads and scrolls; a mouse may mark a part to zoom into.
      svg.onpointerdown = event => { if (event.pointerType !== "touch") { event.preventDefault(); drag = inverse(event); } };
      svg.onpointerup = event => {
        const [a, b] = [drag, inverse(event)].sort((p, q) => p - q);
        const marked = drag !== null && along(b) - along(a) > 0.02 * (along(view[1]) - along(view[0]));
        drag = null;
        if (marked) { view = [Math.max(view[0], a), Math.min(view[1], b)]; render(); }
      };
      svg.ondblclick = () => { view = fullX.slice(); render(); };
    }
    render();
    return render;
  }
  function runIn() {
    const slider = document.getElementById("step"), moment = document.getElementById("moment");
    const steps = run_in.time_s.length;
    const panels = [["pressure", "pressure (MPa)"], ["gap", "gap (\u00b5m)"]].map(([key, label]) => {
      // One axis for all steps; what a spike would take from the rest is cut off and said.
      const { top, note } = run_in[key + "_axis"], y_range = [0, top || 1];
      const start = { name: "start", dashed: true, x: run_in.x, y: run_in[key][0] };
      const chart = { title: label, x_label: run_in.x_label, y_label: label, y_range, note, names_in_rows: true, series: [{ name: "now", dashed: false, x: run_in.x, y: run_in[key][0] }, start] };
      return { key, chart, render: draw(document.getElementById("run-in-" + key), chart) };
    });
    function show_step() {
      const k = Number(slider.value);
      for (const panel of panels) { panel.chart.series[0].y = run_in[panel.key][k]; panel.render(); }
      moment.textContent = `step ${run_in.step[k]}, ${show(run_in.time_s[k])} s`;
    }
    slider.max = steps - 1;
    slider.oninput = show_step;
    show_step();
  }
  document.querySelectorAll("figure[data-chart]").forEach(figure => draw(figure, charts[Number(figure.dataset.chart)]));
  if (run_in) runIn();
})();
