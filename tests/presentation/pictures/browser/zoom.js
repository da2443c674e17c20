// What a reader does to the pictures of a report: the first zooms with its button and its keys, its panels together.
"use strict";

function expect(condition, words, mistakes) {
  if (!condition) mistakes.push(words);
}

/// Scales change behind the current task.
const settled = () => new Promise((resolve) => setTimeout(resolve, 0));

async function run() {
  const mistakes = [];
  const figures = [...document.querySelectorAll("figure")].filter((figure) => figure.querySelector(".zoom-button") !== null);
  expect(figures.length > 0, "no picture zooms", mistakes);
  for (const figure of figures) {
    const name = figure.querySelector("svg > title").textContent;
    figure.querySelector(".zoom-button").click();
    const box = figure.querySelector(".zoom");
    const press = (key) => box.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
    const range = (chart) => [chart.scales.x.min, chart.scales.x.max];
    await settled();
    const before = box.charts.map(range);
    expect(getComputedStyle(figure.querySelector("svg")).display === "none", `${name}: the picture is still there`, mistakes);
    expect(box.charts.length === figure.querySelectorAll("g.panel").length, `${name}: a panel is missing`, mistakes);
    box.charts.forEach((chart, i) => chart.data.slice(1).forEach((ys) => {
      const y = figure.querySelectorAll("g.panel")[i].dataset.y.split(" ").map(Number);
      const values = ys.filter((v) => v !== null && v !== undefined);
      expect(values.length > 1, `${name}: a curve is empty`, mistakes);
      expect(values.every((v) => v >= y[1] - 1e-6 && v <= y[2] + 1e-6), `${name}: a curve leaves its panel`, mistakes);
    }));
    press("+");
    await settled();
    box.charts.forEach((chart, i) => expect(chart.scales.x.min > before[i][0] && chart.scales.x.max < before[i][1],
                                            `${name}: + does not zoom panel ${i}`, mistakes));
    press("ArrowRight");
    press("0");
    await settled();
    box.charts.forEach((chart, i) => expect(Math.abs(chart.scales.x.max / before[i][1] - 1) < 1e-9,
                                            `${name}: 0 does not show everything`, mistakes));
    figure.querySelector(".zoom-button").click();
    expect(getComputedStyle(figure.querySelector("svg")).display !== "none", `${name}: the picture does not come back`, mistakes);
  }
  document.body.innerHTML = "<pre id=\"result\"></pre>";
  document.getElementById("result").textContent = [`zooms: ${figures.length}`, ...mistakes].join("\n");
}

run();
