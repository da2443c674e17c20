// Pictures that zoom: the curves of each SVG, read back from its paths, in uPlot. Without scripts, and on paper, the SVG itself
// is seen.
"use strict";

/// From pixels of the picture back to the quantities of an axis that is written as "linear LOW HIGH BEGIN END".
function scaleOf(words) {
  const [kind, ...numbers] = words.split(" ");
  const [low, high, begin, end] = numbers.map(Number);
  const log = kind === "logarithmic";
  const value = (pixel) => {
    const share = (pixel - begin) / (end - begin);
    return log ? low * Math.pow(high / low, share) : low + (high - low) * share;
  };
  return { low, high, log, value };
}

/// Runs of points; a gap where the curve is interrupted.
function pointsOf(path, x, y) {
  const xs = [], ys = [];
  for (const run of path.getAttribute("d").split("M").slice(1)) {
    if (xs.length > 0) { xs.push(xs[xs.length - 1]); ys.push(null); }
    for (const place of run.split("L")) {
      const [px, py] = place.trim().split(" ").map(Number);
      xs.push(x.value(px)); ys.push(y.value(py));
    }
  }
  return [xs, ys];
}

/// uPlot wants rising, distinct abscissas.
function rising([xs, ys]) {
  const outX = [], outY = [];
  xs.forEach((x, i) => {
    if (outX.length > 0 && x <= outX[outX.length - 1]) { if (ys[i] !== null) outY[outY.length - 1] = ys[i]; return; }
    outX.push(x); outY.push(ys[i]);
  });
  return [outX, outY];
}

/// With the decimal sign of the page, whatever the browser's language is.
function written(value, digits) {
  return Number(value.toPrecision(digits))
    .toLocaleString(document.documentElement.lang, { useGrouping: false, maximumFractionDigits: 20 });
}
const shown = (value) => value === null || value === undefined ? "–" : written(value, 4);
const values = (u, ticks) => ticks.map((value) => value === null ? "" : written(value, 6));

function chartOf(panel, width, sync, words) {
  const x = scaleOf(panel.dataset.x), y = scaleOf(panel.dataset.y);
  const curves = [...panel.querySelectorAll("path.curve")].filter((path) => !path.classList.contains("bar"));
  const joined = uPlot.join(curves.map((path) => rising(pointsOf(path, x, y))));
  const ink = getComputedStyle(document.body).color;
  const grid = { stroke: getComputedStyle(document.body).getPropertyValue("--line"), width: 1 };
  const series = curves.map((path) => {
    const style = getComputedStyle(path);
    const dash = style.strokeDasharray;
    return {
      label: path.querySelector("title").textContent, stroke: style.stroke, width: parseFloat(style.strokeWidth),
      dash: dash === "none" ? undefined : dash.split(",").map(parseFloat), spanGaps: true,
      points: { show: path.classList.contains("measured") }, value: (u, value) => shown(value),
    };
  });
  return new uPlot({
    width, height: Number(panel.dataset.height) + 60, cursor: { sync: { key: sync } },
    // Scales that do not snap to decades or round numbers.
    scales: { x: { time: false, distr: x.log ? 3 : 1, min: x.low, max: x.high, range: (u, low, high) => [low, high] },
              y: { min: y.low, max: y.high, range: () => [y.low, y.high] } },
    axes: [{ label: panel.dataset.xLabel, stroke: ink, grid, ticks: grid, values },
           { label: panel.dataset.yLabel, stroke: ink, grid, ticks: grid, size: 64, values }],
    series: [{ label: panel.dataset.xLabel, value: (u, value) => shown(value) }, ...series],
    hooks: { setScale: [(u, key) => { if (key === "x" && words.follow) words.follow(u); }] },
  }, joined, document.createElement("div"));
}

/// The charts of a figure, with their bar of buttons and their keys.
function zoomBox(figure, number, words) {
  const panels = [...figure.querySelectorAll("g.panel")];
  const box = document.createElement("div");
  box.className = "zoom";
  const state = {};
  const width = Math.min(800, figure.clientWidth || 800);
  const charts = panels.map((panel) => chartOf(panel, width, "figure" + number, state));
  const full = panels.map((panel) => { const { low, high } = scaleOf(panel.dataset.x); return [low, high]; });
  // Panels with one horizontal axis show one range.
  const shared = (a, b) => panels[a].dataset.x === panels[b].dataset.x;
  state.follow = (from) => {
    const index = charts.indexOf(from);
    const { min, max } = from.scales.x;
    charts.forEach((chart, i) => {
      const differs = chart.scales.x.min !== min || chart.scales.x.max !== max;
      if (i !== index && index >= 0 && differs && shared(i, index)) chart.setScale("x", { min, max });
    });
  };
  const move = (change) => charts.forEach((chart, i) => {
    if (panels.findIndex((_, k) => shared(k, i)) !== i) return;
    const log = panels[i].dataset.x.startsWith("log");
    const to = log ? Math.log : (v) => v, from = log ? Math.exp : (v) => v;
    const low = to(chart.scales.x.min), high = to(chart.scales.x.max), span = high - low;
    const [a, b] = change === "reset" ? full[i].map(to) : [low + span * change[0], high + span * change[1]];
    const min = from(Math.max(a, to(full[i][0]))), max = from(Math.min(b, to(full[i][1])));
    if (min < max) chart.setScale("x", { min, max });
  });
  const actions = { "+": [0.15, -0.15], "-": [-0.2143, 0.2143], ArrowLeft: [-0.2, -0.2], ArrowRight: [0.2, 0.2], 0: "reset" };
  const bar = document.createElement("div");
  bar.className = "zoom-bar";
  [["+", "+", words.closer], ["−", "-", words.farther], ["←", "ArrowLeft", words.left], ["→", "ArrowRight", words.right], ["0", "0", words.all]]
    .forEach(([sign, key, label]) => {
      const button = document.createElement("button");
      button.type = "button"; button.textContent = sign; button.title = label; button.setAttribute("aria-label", label);
      button.addEventListener("click", () => move(actions[key]));
      bar.append(button);
    });
  box.tabIndex = 0;
  box.setAttribute("role", "group");
  box.setAttribute("aria-label", figure.querySelector("svg > title").textContent + ": " + words.keys);
  box.addEventListener("keydown", (event) => {
    if (!(event.key in actions) || event.ctrlKey || event.altKey || event.metaKey) return;
    move(actions[event.key]);
    event.preventDefault();
  });
  box.append(bar, ...charts.map((chart) => chart.root));
  box.charts = charts;
  return box;
}

/// A button below the picture puts the charts in its place; they are made when they are first wanted.
function zoomFigure(figure, number, words) {
  if (figure.querySelector("g.panel") === null) return;
  const button = document.createElement("button");
  button.type = "button";
  button.textContent = words.zoom;
  button.className = "zoom-button";
  button.setAttribute("aria-pressed", "false");
  let box = null;
  button.addEventListener("click", () => {
    if (box === null) {
      box = zoomBox(figure, number, words);
      button.before(box);
    }
    const zooms = figure.classList.toggle("zooms");
    button.setAttribute("aria-pressed", String(zooms));
    if (zooms) box.focus();
  });
  figure.append(button);
}

function zoomAll(words) {
  document.querySelectorAll("figure").forEach((figure, number) => {
    // Where something is unforeseen, the picture stays.
    try { zoomFigure(figure, number, words); } catch (error) { console.error(error); }
  });
}
