// SPDX-License-Identifier: GPL-3.0-or-later
// Draws how even points became over iterations of Voronoi regions, from the data beside each figure.
"use strict";

(() => {
  const { FONT, shown } = charts;

  // Iterations are counted from 0, and most happens in the first: logarithmic, but for 0 to 1.
  const TICKS = [0, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 1e4, 1e5, 1e6];

  function panels(data) {
    const deviations = {
      title: "standard deviation / mean",
      lines: [{ label: "distances between neighbours", values: data.distances },
        { label: "areas of regions", values: data.areas }],
      rules: [],
    };
    const energy = {
      title: "energy / that of hexagons",
      lines: [{ label: "all regions", values: data.energy }],
      rules: [{ y: 1, text: "regular hexagons" }],
    };
    if (data.innerEnergy) energy.lines.push({ label: "regions not at the border", values: data.innerEnergy });
    return [deviations, energy];
  }

  function rows(panel, iterations) {
    return panel.lines.flatMap((line, index) => line.values.map((y, i) => (
      { line: index, label: line.label, colour: charts.colour(index), x: iterations[i], y })));
  }

  // From zero, where a curve comes near to it; else close about the curves and what they are measured by.
  function span(panel) {
    const values = panel.lines.flatMap((line) => line.values).concat(panel.rules.map((r) => r.y));
    const low = Math.min(...values), high = Math.max(...values);
    if (panel.rules.length === 0) return [0, 1.05 * high || 1];
    const room = 0.12 * (high - low) || 0.1;
    return [low - room, high + 0.4 * room];
  }

  const marks = (look) => [
    ...charts.rule("rules", look),
    { type: "group", from: { facet: { name: "curve", data: "curves", groupby: "line" } }, marks: [
      { type: "line", from: { data: "curve" }, interactive: false, encode: { update: {
        x: { scale: "x", field: "x" }, y: { scale: "y", field: "y" }, stroke: { field: "colour" },
        strokeWidth: { value: 1.8 } } } }] },
    { type: "symbol", from: { data: "curves" }, interactive: false, encode: { update: {
      x: { scale: "x", field: "x" }, y: { scale: "y", field: "y" }, size: { value: 12 }, fill: { field: "colour" } } } },
    { type: "symbol", name: "hits", from: { data: "curves" }, encode: { update: {
      x: { scale: "x", field: "x" }, y: { scale: "y", field: "y" }, size: { value: 200 }, fill: { field: "colour" },
      fillOpacity: { value: 0 }, tooltip: { signal: "datum" } } } },
  ];

  function specification(panel, iterations, width, look) {
    const last = iterations[iterations.length - 1];
    return {
      autosize: { type: "fit", contains: "padding" }, padding: 4, background: look.paper, width, height: 260,
      data: [{ name: "curves", values: rows(panel, iterations) }, { name: "rules", values: panel.rules }],
      scales: [
        { name: "x", type: "symlog", constant: 1, domain: [0, last], range: "width", nice: false },
        { name: "y", type: "linear", domain: span(panel), range: "height", nice: false, zero: false },
        { name: "colour", type: "ordinal", domain: panel.lines.map((l) => l.label), range: panel.lines.map((l, i) => charts.colour(i)) },
      ],
      axes: [
        { ...charts.axisLook(look), orient: "bottom", scale: "x", title: "iterations", values: TICKS.filter((t) => t <= last),
          labelFlush: true, format: "d" },
        { ...charts.axisLook(look), orient: "left", scale: "y", title: panel.title, tickCount: 6 },
      ],
      legends: [{
        stroke: "colour", symbolType: "stroke", symbolStrokeWidth: 2.4, symbolSize: 300, orient: "top",
        direction: width < 420 ? "vertical" : "horizontal", labelFont: FONT, labelFontSize: 12, labelLimit: 400,
        labelColor: look.ink }],
      marks: marks(look),
    };
  }

  const described = (value) => [value.label,
    `after ${value.x} ${value.x === 1 ? "iteration" : "iterations"}: ${shown(value.y)}`];

  for (const figure of document.querySelectorAll("figure.voronoi")) {
    const data = JSON.parse(figure.querySelector(".voronoi-data").textContent);
    const shownPanels = panels(data);
    figure.querySelectorAll(".panel").forEach((box, index) => {
      let view = null;
      charts.whenever(box, (width, look) => {
        if (view) view.finalize();
        const runtime = vega.parse(specification(shownPanels[index], data.iteration, width, look));
        view = new vega.View(runtime, { renderer: "svg", container: charts.stage(box), hover: false })
          .tooltip(charts.tooltip(box, described));
        view.runAsync().catch((error) => console.error(error));
      });
    });
  }
})();
