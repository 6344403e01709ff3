// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the race of each problem from the data beside it, in the place of the still picture.
"use strict";

(() => {
  const { FONT, digits, shown } = charts;
  const SMALLEST_GAP = 1e-9;  // below, a gap is rounding
  const LARGEST = 1e150;  // beyond, the room about a curve overflows
  const SAVED_WIDTH = 860;
  const LABEL_SPACING = 13.5, WIDEST_LABEL = 190, LEAD = 16;

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

  // Labels in a column: each as near as can be to where it belongs, none on another. (chart/end_labels.cpp)
  function placed(wanted, low, high) {
    const order = wanted.map((_, i) => i).sort((a, b) => wanted[a] - wanted[b] || a - b);
    const spacing = Math.min(LABEL_SPACING, (high - low) / Math.max(1, wanted.length - 1));
    const stacks = [];
    order.forEach((index, rank) => {
      stacks.push([wanted[index] - rank * spacing]);
      const mean = (stack) => stack.reduce((a, b) => a + b, 0) / stack.length;
      while (stacks.length > 1 && mean(stacks[stacks.length - 2]) >= mean(stacks[stacks.length - 1]))
        stacks.splice(-2, 2, stacks[stacks.length - 2].concat(stacks[stacks.length - 1]));
    });
    const most = high - spacing * (wanted.length - 1), places = [];
    let rank = 0;
    for (const stack of stacks) {
      const at = Math.min(most, Math.max(low, stack.reduce((a, b) => a + b, 0) / stack.length));
      for (let i = 0; i < stack.length; ++i, ++rank) places[order[rank]] = at + rank * spacing;
    }
    return places;
  }

  // What the vertical axis can show, from what the curves hold.
  function heights(data) {
    const factor = data.errorPerQuality ?? 1;
    const list = {
      error: {
        title: data.title,
        of: (quality) => quality * factor,
        floor: 1e-16,
        rule: data.best !== undefined && data.best * factor > 1e-150 ? Math.min(LARGEST, data.best * factor) : null,
      },
    };
    if (data.best !== undefined && data.start !== undefined && data.start > data.best)
      list.gap = {
        title: data.gapTitle,
        of: (quality) => (quality - data.best) / (data.start - data.best),
        floor: SMALLEST_GAP,
        rule: null,
      };
    return list;
  }

  function points(data, axis, height, hidden, dark) {
    const rows = [];
    const at = (quality) => Math.min(LARGEST, Math.max(height.floor, height.of(quality)));
    data.series.forEach((series, index) => {
      if (hidden.has(index)) return;
      const curve = series[axis];
      const { lower = curve.median, upper = curve.median } = curve;
      curve.x.forEach((x, i) => rows.push({
        series: index, label: series.label, colour: dark ? series.dark : series.colour, dash: series.dash, x,
        lower: at(lower[i]), median: at(curve.median[i]), upper: at(upper[i]),
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

  function axis(orient, scale, title, values, look) {
    const horizontal = orient === "bottom";
    return {
      ...charts.axisLook(look), orient, scale, title, values: { signal: values }, labelFlush: horizontal,
      encode: { labels: { update: {
        text: { signal: horizontal ? "xText(datum.value, xUnit)" : "tickText(datum.value)" } } } },
    };
  }

  const line = (y, extra) => ({
    x: { scale: "x", field: "x" }, y: { scale: "y", field: y }, ...extra,
  });

  const strong = "hovered === null || hovered === datum.series";
  const faded = (weak) => [{ test: strong, value: 1 }, { value: weak }];

  function marks(look) {
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
        strokeOpacity: faded(0.25),
      }) },
    };
    const targets = {
      type: "symbol", name: "hits", clip: true, from: { data: "curves" },
      encode: { update: {
        x: { scale: "x", field: "x" }, y: { scale: "y", field: "median" }, size: { value: 160 },
        fill: { field: "colour" }, fillOpacity: { value: 0 }, tooltip: { signal: "datum" },
      } },
    };
    return [curves(band), curves(median), ...ends(look), ...charts.rule("best", look), targets];
  }

  // Where a line ends early it goes on thin and dotted to its name.
  function ends(look) {
    const stroke = { stroke: { field: "colour" }, strokeOpacity: faded(0.25) };
    const rule = (encode) => ({
      type: "rule", from: { data: "ends" }, interactive: false, encode: { update: { ...stroke, ...encode } } });
    return [
      rule({ x: { field: "from" }, x2: { signal: "width" }, y: { field: "y" }, strokeDash: { value: [1, 3] } }),
      rule({ x: { signal: "width" }, x2: { signal: `width + ${LEAD}` }, y: { field: "y" }, y2: { field: "place" },
        strokeWidth: { value: 0.8 } }),
      { type: "text", from: { data: "ends" }, interactive: false, encode: { update: {
        x: { signal: `width + ${LEAD + 4}` }, y: { field: "place" }, baseline: { value: "middle" },
        text: { field: "label" }, limit: { value: WIDEST_LABEL }, fill: { value: look.ink }, fontSize: { value: 11 },
        font: { value: FONT }, fillOpacity: faded(0.4) } } },
    ];
  }

  const measure = (() => {
    const context = document.createElement("canvas").getContext("2d");
    context.font = `11px ${FONT}`;
    return (text) => Math.min(WIDEST_LABEL, context.measureText(text).width);
  })();

  // Names stand beside the plot where there is room for them.
  const named = (width) => width >= 620;

  function specification(data, width, look) {
    const room = named(width) ? LEAD + 8 + Math.max(0, ...data.series.map((s) => measure(s.label))) : 0;
    return {
      autosize: { type: "fit", contains: "padding" }, padding: { left: 4, top: 6, bottom: 4, right: 4 + room },
      background: look.paper, description: data.name, width,
      height: Math.max(width < 500 ? 300 : 420, named(width) ? 50 + LABEL_SPACING * data.series.length : 0),
      signals: [
        { name: "xTitle", value: "" }, { name: "yTitle", value: "" },
        { name: "xDomain", value: [1, 10] }, { name: "yDomain", value: [1, 10] },
        { name: "xTicks", value: [] }, { name: "yTicks", value: [] }, { name: "xUnit", value: "" },
        { name: "hovered", value: null, on: [
          { events: "@hits:pointerover, @hits:pointermove", update: "datum.series" },
          { events: "@hits:pointerout", update: "null" },
          { events: "pointerdown[!event.item || !event.item.datum]", update: "null" }] },
      ],
      data: [{ name: "curves", values: [] }, { name: "best", values: [] }, { name: "ends", values: [] }],
      scales: [
        { name: "x", type: "log", domain: { signal: "xDomain" }, range: "width", nice: false },
        { name: "y", type: "log", domain: { signal: "yDomain" }, range: "height", nice: false },
      ],
      axes: [
        axis("bottom", "x", { signal: "xTitle" }, "xTicks", look),
        axis("left", "y", { signal: "yTitle" }, "yTicks", look)],
      marks: marks(look),
    };
  }

  const described = (state) => (value) => {
    const where = state.axis === "seconds" ? timeText(value.x) : `${shown(value.x)} ${state.unit}`;
    return [value.label, `after ${where}: ${shown(value.median)}`,
      `quartiles ${shown(value.lower)} to ${shown(value.upper)}`];
  };

  function keyButton(series, toggle) {
    const button = document.createElement("button");
    button.type = "button";
    button.setAttribute("aria-pressed", true);
    button.innerHTML = `<svg width="30" height="8" aria-hidden="true"><line x1="0" x2="30" y1="4" y2="4"
      stroke-width="2.4" stroke-dasharray="${series.dash.join(" ")}"/></svg>`;
    button.firstChild.style.setProperty("--light", series.colour);
    button.firstChild.style.setProperty("--dark", series.dark);
    button.append(series.baseline ? `${series.label} (baseline)` : series.label);
    button.addEventListener("click", () => button.setAttribute("aria-pressed", toggle()));
    return button;
  }

  // A file that the page itself holds.
  function download(blob, name) {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  }

  function offerSaving(box, save) {
    for (const format of ["svg", "png"]) {
      const button = document.createElement("button");
      button.type = "button";
      button.textContent = `Save as ${format.toUpperCase()}`;
      button.addEventListener("click", () => save(format).catch((error) => console.error(error)));
      box.append(button);
    }
  }

  // A picture that stands in the page is a file already: its own colours are for white paper.
  async function saveStill(figure, format) {
    const svg = figure.querySelector("svg.lines").cloneNode(true), { width, height } = svg.viewBox.baseVal;
    svg.setAttribute("width", width);
    svg.setAttribute("height", height);
    const text = new XMLSerializer().serializeToString(svg);
    const name = figure.querySelector("figcaption").textContent.trim().replace(/[^\w-]+/g, "-");
    if (format === "svg") return download(new Blob([text], { type: "image/svg+xml" }), `${name}.svg`);
    const picture = new Image(), canvas = document.createElement("canvas");
    picture.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
    await picture.decode();
    [canvas.width, canvas.height] = [2 * width, 2 * height];
    canvas.getContext("2d").drawImage(picture, 0, 0, canvas.width, canvas.height);
    canvas.toBlob((blob) => download(blob, `${name}.png`), "image/png");
  }

  class Race {
    constructor(figure) {
      this.figure = figure;
      this.box = figure.querySelector(".chart");
      this.data = JSON.parse(figure.querySelector(".race-data").textContent);
      this.heights = heights(this.data);
      this.hidden = new Set();
      this.state = { axis: this.data.axes[0].name, unit: this.data.axes[0].name, height: "error" };
      figure.classList.add("drawn");
      this.connect();
      charts.whenever(this.box, (width, look) => this.build(width, look));
    }

    connect() {
      const keys = this.figure.querySelector(".keys");
      this.data.series.forEach((series, index) => {
        const button = keyButton(series, () => {
          if (!this.hidden.delete(index)) this.hidden.add(index);
          this.show();
          return !this.hidden.has(index);
        });
        for (const [event, value] of [["focus", index], ["pointerenter", index], ["blur", null], ["pointerleave", null]])
          button.addEventListener(event, () => this.view.signal("hovered", value).runAsync());
        keys.append(button);
      });
      for (const name of ["axis", "height"])
        for (const input of this.figure.querySelectorAll(`input[data-${name}]`)) {
          if (name === "height" && !this.heights[input.dataset.height]) input.disabled = true;
          input.addEventListener("change", () => { this.state[name] = input.dataset[name]; this.show(); });
        }
      offerSaving(this.figure.querySelector(".save"), (format) => this.save(format));
    }

    build(width, look) {
      if (this.view) this.view.finalize();
      this.width = width;
      this.look = look;
      const runtime = vega.parse(specification(this.data, width, look));
      this.view = new vega.View(runtime, { renderer: "svg", container: charts.stage(this.box), hover: false })
        .tooltip(charts.tooltip(this.box, described(this.state)));
      this.show();
    }

    show() {
      this.state.unit = this.data.axes.find((a) => a.name === this.state.axis).title;
      const height = this.heights[this.state.height];
      this.box.setAttribute("aria-label", `${this.data.name.replace(/: .*/, "")}: ${height.title} against ${
        this.state.axis === "seconds" ? "time" : this.state.unit}`);
      this.fill(this.view, this.width, this.look).catch((error) => console.error(error));
    }

    // The places of names need the plot's size, which is known once it is drawn.
    async fill(view, width, look) {
      const height = this.heights[this.state.height];
      const rows = points(this.data, this.state.axis, height, this.hidden, look.dark);
      const levels = rows.flatMap((r) => [r.lower, r.upper]);
      // With room for its label below it, where no curve goes.
      const { rule } = height;
      if (rule !== null) levels.push(rule, rule * Math.pow(rule / Math.max(rule, ...levels), 0.05));
      const name = this.data.provisional ? "best of these trials" : "best known";
      const best = height.rule === null ? [] : [{ y: height.rule, text: `${name}: ${shown(height.rule)}` }];
      const across = padded(extent(rows.map((r) => r.x))), up = padded(extent(levels));
      view.signal("xTitle", this.state.axis === "seconds" ? "time" : this.state.unit).signal("yTitle", height.title)
        .signal("xDomain", across).signal("xTicks", ticks(across, Math.max(3, width / 80)))
        .signal("yDomain", up).signal("yTicks", ticks(up, 9)).signal("xUnit", this.state.axis)
        .signal("hovered", null).data("curves", rows).data("best", best).data("ends", []);
      await view.runAsync();
      if (!named(width)) return;
      view.data("ends", this.ends(view, rows));
      await view.runAsync();
    }

    ends(view, rows) {
      const last = new Map(rows.map((row) => [row.series, row]));
      const x = view.scale("x"), y = view.scale("y"), list = [...last.values()];
      const places = placed(list.map((row) => y(row.median)), 4, view.height() - 4);
      return list.map((row, i) => ({
        series: row.series, label: row.label, colour: row.colour, from: x(row.x), y: y(row.median), place: places[i] }));
    }

    // As it is shown, on white paper.
    async save(format) {
      const view = new vega.View(vega.parse(specification(this.data, SAVED_WIDTH, charts.PAPER)), { renderer: "none" });
      await this.fill(view, SAVED_WIDTH, charts.PAPER);
      const what = this.figure.id.startsWith("unseen") ? "unseen" : this.state.height;
      const name = `${this.data.name.replace(/: .*/, "")}-${what}-${this.state.axis}`.replace(/[^\w-]+/g, "-");
      if (format === "svg")
        download(new Blob([await view.toSVG()], { type: "image/svg+xml" }), `${name}.svg`);
      else
        (await view.toCanvas(2)).toBlob((blob) => download(blob, `${name}.png`), "image/png");
      view.finalize();
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

  for (const figure of document.querySelectorAll("figure.lone")) {
    const box = document.createElement("div");
    box.className = "save";
    offerSaving(box, (format) => saveStill(figure, format));
    figure.querySelector("svg.lines").parentElement.after(box);
  }
})();
