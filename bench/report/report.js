// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the race of each problem from the data beside it.
"use strict";

(() => {
  const { COLOURS, digits, shown } = charts;
  // For more lines than colours: the same colours, dashed.
  const DASHES = [[], [7, 3], [2, 2], [9, 3, 2, 3]];
  const SMALLEST_GAP = 1e-9;  // below, a gap is rounding
  const LARGEST = 1e150;  // beyond, the room about a curve overflows

  const AXIS_TITLES = {
    seconds: "time",
    evaluations: "evaluations",
    work: "work [equivalent full values]",
  };

  const timeText = (s) => {
    for (const [size, unit] of [[1e-9, "ns"], [1e-6, "µs"], [1e-3, "ms"]])
      if (s < 999.5 * size) return `${Number((s / size).toPrecision(3))} ${unit}`;
    return `${Number(s.toPrecision(3))} s`;
  };

  // Round numbers on a logarithmic axis, as many as there is room for: powers of ten, with 2 and 5, or all between.
  function ticks([low, high], most) {
    const first = Math.floor(Math.log10(low)), last = Math.ceil(Math.log10(high));
    const within = (mantissas, stride) => {
      const list = [];
      for (let power = first; power <= last; power += stride)
        for (const m of mantissas) list.push(Number(`${m}e${power}`));
      return list.filter((t) => low <= t && t <= high);
    };
    for (const mantissas of [[1, 1.5, 2, 2.5, 3, 4, 5, 6, 7, 8, 9], [1, 2, 3, 4, 5, 6, 7, 8, 9], [1, 2, 5]]) {
      const list = within(mantissas, 1);
      if (list.length <= most) return list;
    }
    let stride = 1;
    while (within([1], stride).length > most) ++stride;
    return within([1], stride);
  }

  // The baseline is black; the others take colours in the study's order, whatever is shown.
  function styles(series) {
    let next = 0;
    return series.map((s) => {
      if (s.baseline) return { colour: "#111111", dash: [] };
      const at = next++;
      return { colour: COLOURS[at % COLOURS.length], dash: DASHES[Math.floor(at / COLOURS.length) % DASHES.length] };
    });
  }

  // What the vertical axis can show, from quality.
  function heights(data) {
    const factor = data.errorPerQuality ?? 1;
    const list = {
      error: {
        title: data.title ?? (data.errorPerQuality === undefined ? "quality" : "relative error"),
        of: (quality) => quality * factor,
        floor: 1e-16,
        rule: data.best !== undefined && data.best * factor > 1e-150 ? Math.min(LARGEST, data.best * factor) : null,
      },
    };
    if (data.best !== undefined && data.start !== undefined && data.start > data.best)
      list.gap = {
        title: `gap to ${data.quality}*`,
        of: (quality) => (quality - data.best) / (data.start - data.best),
        floor: SMALLEST_GAP,
        rule: null,
      };
    return list;
  }

  function points(data, look, axis, height, hidden) {
    const rows = [];
    const at = (quality) => Math.min(LARGEST, Math.max(height.floor, height.of(quality)));
    data.series.forEach((series, index) => {
      if (hidden.has(index)) return;
      const curve = series[axis];
      curve.x.forEach((x, i) => rows.push({
        series: index, label: series.label, colour: look[index].colour, dash: look[index].dash, x,
        lower: at(curve.lower[i]), median: at(curve.median[i]), upper: at(curve.upper[i]),
      }));
    });
    return rows;
  }

  function extent(values) {
    let low = Infinity, high = -Infinity;
    for (const v of values) {
      low = Math.min(low, v);
      high = Math.max(high, v);
    }
    return low <= high ? [low, high] : [1, 10];
  }

  // A little room above and below, in the logarithm.
  function padded([low, high]) {
    const room = Math.max(Math.pow(high / low, 0.04), 1.02);
    return [low / room, high * room];
  }

  function axis(orient, scale, title, values) {
    const horizontal = orient === "bottom";
    return {
      ...charts.AXIS, orient, scale, title, values: { signal: values }, labelFlush: horizontal,
      encode: { labels: { update: {
        text: { signal: horizontal ? "xText(datum.value, xUnit)" : "tickText(datum.value)" } } } },
    };
  }

  const line = (y, extra) => ({
    x: { scale: "x", field: "x" }, y: { scale: "y", field: y }, ...extra,
  });

  function marks() {
    const strong = "hovered === null || hovered === datum.series";
    const curves = (...inner) => ({
      type: "group", clip: true, from: { facet: { name: "curve", data: "curves", groupby: "series" } }, marks: inner,
    });
    const band = {
      type: "area", from: { data: "curve" }, interactive: false,
      encode: { update: line("lower", {
        y2: { scale: "y", field: "upper" }, fill: { field: "colour" },
        fillOpacity: [
          { test: "hovered === datum.series", value: 0.28 }, { test: "hovered === null", value: 0.09 }, { value: 0 }],
      }) },
    };
    const median = {
      type: "line", from: { data: "curve" }, interactive: false,
      encode: { update: line("median", {
        stroke: { field: "colour" }, strokeDash: { field: "dash" },
        strokeWidth: [{ test: "hovered === datum.series", value: 3 }, { value: 1.8 }],
        strokeOpacity: [{ test: strong, value: 1 }, { value: 0.25 }],
      }) },
    };
    const targets = {
      type: "symbol", name: "hits", clip: true, from: { data: "curves" },
      encode: { update: {
        x: { scale: "x", field: "x" }, y: { scale: "y", field: "median" }, size: { value: 160 },
        fill: { field: "colour" }, fillOpacity: { value: 0 }, tooltip: { signal: "datum" },
      } },
    };
    return [curves(band), curves(median), ...charts.rule("best"), targets];
  }

  function specification(width, narrow) {
    return {
      autosize: { type: "fit", contains: "padding" }, padding: 4, background: "white",
      width, height: narrow ? 300 : 420,
      signals: [
        { name: "xTitle", value: "" }, { name: "yTitle", value: "" },
        { name: "xDomain", value: [1, 10] }, { name: "yDomain", value: [1, 10] },
        { name: "xTicks", value: [] }, { name: "yTicks", value: [] }, { name: "xUnit", value: "" },
        { name: "hovered", value: null, on: [
          { events: "@hits:pointerover, @hits:pointermove", update: "datum.series" },
          { events: "@hits:pointerout", update: "null" },
          { events: "pointerdown[!event.item || !event.item.datum]", update: "null" }] },
      ],
      data: [{ name: "curves", values: [] }, { name: "best", values: [] }],
      scales: [
        { name: "x", type: "log", domain: { signal: "xDomain" }, range: "width", nice: false },
        { name: "y", type: "log", domain: { signal: "yDomain" }, range: "height", nice: false },
      ],
      axes: [axis("bottom", "x", { signal: "xTitle" }, "xTicks"), axis("left", "y", { signal: "yTitle" }, "yTicks")],
      marks: marks(),
    };
  }

  const described = (state) => (value) => {
    const where = state.axis === "seconds" ? timeText(value.x) : `${shown(value.x)} ${state.axis}`;
    return [value.label, `after ${where}: ${shown(value.median)}`,
      `quartiles ${shown(value.lower)} to ${shown(value.upper)}`];
  };

  function keyButton(series, look, pressed, toggle) {
    const button = document.createElement("button");
    button.type = "button";
    button.setAttribute("aria-pressed", pressed);
    button.innerHTML = `<svg width="30" height="8" aria-hidden="true"><line x1="0" x2="30" y1="4" y2="4"
      stroke-width="2.4" stroke="${look.colour}" stroke-dasharray="${look.dash.join(" ")}"/></svg>`;
    button.append(series.baseline ? `${series.label} (baseline)` : series.label);
    button.addEventListener("click", () => button.setAttribute("aria-pressed", toggle()));
    return button;
  }

  class Race {
    constructor(figure) {
      this.figure = figure;
      this.box = figure.querySelector(".chart");
      this.data = JSON.parse(figure.querySelector(".race-data").textContent);
      this.look = styles(this.data.series);
      this.heights = heights(this.data);
      this.hidden = new Set();
      this.state = { axis: this.data.axes[0], height: "error" };
      this.connect();
      charts.whenever(this.box, (width) => this.build(width));
    }

    connect() {
      const keys = this.figure.querySelector(".keys");
      this.data.series.forEach((series, index) => keys.append(keyButton(series, this.look[index], true, () => {
        if (!this.hidden.delete(index)) this.hidden.add(index);
        this.show();
        return !this.hidden.has(index);
      })));
      for (const name of ["axis", "height"])
        for (const input of this.figure.querySelectorAll(`input[data-${name}]`)) {
          if (name === "height" && !this.heights[input.dataset.height]) input.disabled = true;
          input.addEventListener("change", () => { this.state[name] = input.dataset[name]; this.show(); });
        }
    }

    build(width) {
      this.width = width;
      if (this.view) this.view.finalize();
      const runtime = vega.parse(specification(width, width < 500));
      this.view = new vega.View(runtime, { renderer: "svg", container: charts.stage(this.box), hover: false })
        .tooltip(charts.tooltip(this.box, described(this.state)));
      this.show();
    }

    show() {
      const height = this.heights[this.state.height];
      const rows = points(this.data, this.look, this.state.axis, height, this.hidden);
      const levels = rows.flatMap((r) => [r.lower, r.upper]);
      // With room for its label below it, where no curve goes.
      const { rule } = height;
      if (rule !== null) levels.push(rule * Math.pow(rule / Math.max(rule, ...levels), 0.05));
      const name = this.data.provisional ? "best of these trials" : "best known";
      const best = height.rule === null ? [] : [{ y: height.rule, text: `${name}: ${shown(height.rule)}` }];
      const across = padded(extent(rows.map((r) => r.x))), up = padded(extent(levels));
      this.view.signal("xTitle", AXIS_TITLES[this.state.axis]).signal("yTitle", height.title)
        .signal("xDomain", across).signal("xTicks", ticks(across, Math.max(3, this.width / 80)))
        .signal("yDomain", up).signal("yTicks", ticks(up, 9)).signal("xUnit", this.state.axis)
        .signal("hovered", null).data("curves", rows).data("best", best);
      this.view.runAsync().catch((error) => console.error(error));
    }
  }

  // Powers of ten as such; between them as few digits as tell them apart.
  const tickText = (x) => {
    if (x >= 1e-3 && x < 1e6) return digits.format(x);
    const [mantissa, power] = x.toExponential(6).split("e");
    const front = Number(mantissa) === 1 ? "" : `${Number(mantissa)}×`;
    return front + "10" + [...String(Number(power))].map((c) => (c === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[Number(c)])).join("");
  };
  vega.expressionFunction("tickText", tickText);

  vega.expressionFunction("xText", (x, unit) => (unit === "seconds" ? timeText(x) : tickText(x)));

  for (const figure of document.querySelectorAll("figure.race")) new Race(figure);
})();
