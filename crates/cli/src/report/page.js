"use strict";
// Draws each chart of the page with hover and zoom; without script the static pictures stay.
(function () {
  const NS = "http://www.w3.org/2000/svg";
  const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#888888"];
  const W = 720, H = 400, L = 76, R = 16, T = 14, B = 52;
  const charts = JSON.parse(document.getElementById("charts").textContent);

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
    const text = size >= 1e6 || size < 1e-4 ? value.toExponential(4) : String(Number(value.toPrecision(6)));
    return text.replace("-", "\u2212");
  }
  function range(values) {
    let low = Infinity, high = -Infinity;
    for (const v of values) if (v !== null) { if (v < low) low = v; if (v > high) high = v; }
    if (!(high >= low)) { low = 0; high = 1; }
    if (high - low <= 1e-9 * Math.max(Math.abs(high), Math.abs(low))) { const half = high === 0 ? 1 : 0.1 * Math.abs(high); low -= half; high += half; }
    return [low, high];
  }

  function draw(figure, chart) {
    const xs = [].concat(...chart.series.map(s => s.x)), ys = [].concat(...chart.series.map(s => s.y));
    const fullX = range(xs);
    let view = fullX.slice();
    const old = figure.querySelector("svg");
    const svg = make("svg", { viewBox: `0 0 ${W} ${H}`, role: "img", "aria-label": chart.title }, figure);
    if (old) old.remove();

    function render() {
      svg.replaceChildren();
      const seen = [];
      for (const s of chart.series) s.x.forEach((x, i) => { if (x >= view[0] && x <= view[1]) seen.push(s.y[i]); });
      let [low, high] = range(seen.length ? seen : ys);
      if (chart.from_zero && low >= 0 && view[0] === fullX[0] && view[1] === fullX[1]) low = 0;
      const yTicks = ticks(low, high, 6), step = yTicks.length > 1 ? yTicks[1] - yTicks[0] : 1;
      low = Math.floor(low / step + 1e-9) * step; high = Math.ceil(high / step - 1e-9) * step;
      const px = x => L + (x - view[0]) / (view[1] - view[0]) * (W - L - R);
      const py = y => H - B - (y - low) / (high - low) * (H - T - B);
      for (const t of ticks(view[0], view[1], 7)) {
        make("path", { class: "grid", d: `M${px(t)} ${T}V${H - B}` }, svg);
        make("text", { class: "axis", x: px(t), y: H - B + 18, "text-anchor": "middle" }, svg, show(Number(t.toPrecision(12))));
      }
      for (const t of ticks(low, high, 6)) {
        make("path", { class: "grid", d: `M${L} ${py(t)}H${W - R}` }, svg);
        make("text", { class: "axis", x: L - 8, y: py(t) + 4, "text-anchor": "end" }, svg, show(Number(t.toPrecision(12))));
      }
      make("path", { class: "frame", d: `M${L} ${T}V${H - B}H${W - R}` }, svg);
      make("text", { class: "axis", x: (L + W - R) / 2, y: H - 12, "text-anchor": "middle" }, svg, chart.x_label);
      make("text", { class: "axis", transform: `translate(16 ${(T + H - B) / 2}) rotate(-90)`, "text-anchor": "middle" }, svg, chart.y_label);
      chart.series.forEach((s, n) => {
        let d = "", pen = false;
        s.x.forEach((x, i) => {
          if (s.y[i] === null || x < view[0] || x > view[1]) { pen = false; return; }
          d += (pen ? "L" : "M") + px(x).toFixed(2) + " " + py(s.y[i]).toFixed(2); pen = true;
        });
        make("path", { d, fill: "none", stroke: COLOURS[n % 7], "stroke-width": 2, "stroke-linejoin": "round", "stroke-dasharray": s.dashed ? "7 5" : "none" }, svg);
        if (s.name) {
          make("path", { d: `M${L + 14} ${T + 14 + 18 * n}h24`, stroke: COLOURS[n % 7], "stroke-width": 2, "stroke-dasharray": s.dashed ? "7 5" : "none" }, svg);
          make("text", { class: "tip", x: L + 44, y: T + 18 + 18 * n }, svg, s.name);
        }
      });
      const over = make("g", {}, svg);
      const inverse = event => {
        const box = svg.getBoundingClientRect();
        const at = (event.clientX - box.left) / box.width * W;
        return view[0] + (at - L) / (W - L - R) * (view[1] - view[0]);
      };
      svg.onpointermove = event => {
        over.replaceChildren();
        const x = inverse(event);
        if (x < view[0] || x > view[1]) return;
        const rows = [];
        chart.series.forEach((s, n) => {
          let best = -1;
          s.x.forEach((v, i) => { if (s.y[i] !== null && (best < 0 || Math.abs(v - x) < Math.abs(s.x[best] - x))) best = i; });
          if (best >= 0) rows.push([s, n, best]);
        });
        if (!rows.length) return;
        const at = px(rows[0][0].x[rows[0][2]]);
        make("path", { class: "cross", d: `M${at} ${T}V${H - B}` }, over);
        const lines = rows.map(([s, n, i]) => `${s.name ? s.name + ": " : ""}${show(s.y[i])} at ${show(s.x[i])}`);
        rows.forEach(([s, n, i]) => make("circle", { cx: px(s.x[i]), cy: py(s.y[i]), r: 4, fill: COLOURS[n % 7] }, over));
        const width = 16 + 7.6 * Math.max(...lines.map(l => l.length)), left = Math.min(at + 10, W - R - width);
        make("rect", { class: "tipbox", x: left, y: T + 4, width, height: 10 + 18 * lines.length }, over);
        lines.forEach((line, i) => make("text", { class: "tip", x: left + 8, y: T + 21 + 18 * i }, over, line));
      };
      svg.onpointerleave = () => over.replaceChildren();
      svg.onwheel = event => {
        event.preventDefault();
        const x = inverse(event), factor = event.deltaY < 0 ? 0.8 : 1.25;
        const next = [Math.max(fullX[0], x + (view[0] - x) * factor), Math.min(fullX[1], x + (view[1] - x) * factor)];
        if (next[1] - next[0] > 1e-9 * (fullX[1] - fullX[0])) { view = next; render(); }
      };
      svg.ondblclick = () => { view = fullX.slice(); render(); };
    }
    render();
  }
  document.querySelectorAll("figure[data-chart]").forEach(figure => draw(figure, charts[Number(figure.dataset.chart)]));
})();
