// SPDX-License-Identifier: GPL-3.0-or-later
// What all charts of the page share: colours, numbers, the look of an axis, the box that shows figures at the pointer.
"use strict";

const charts = (() => {
  // Okabe and Ito's colours without yellow, told apart by those who don't see red and green.
  const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00", "#7a6a00"];
  const FONT = "sans-serif";

  const digits = new Intl.NumberFormat("en", { maximumSignificantDigits: 4, useGrouping: true });
  const shown = (x) => (x !== 0 && (Math.abs(x) < 1e-4 || Math.abs(x) >= 1e7) ? x.toExponential(2) : digits.format(x));

  const AXIS = {
    grid: true, gridColor: "#e6e9ed", domainColor: "#9aa2ac", tickColor: "#9aa2ac", labelColor: "#444b54",
    titleColor: "#444b54", titleFontWeight: 400, labelFontSize: 11, titleFontSize: 12, labelFont: FONT, titleFont: FONT,
    labelOverlap: true,
  };

  // A dashed horizontal line with a note below it, one for every {y, text} of the data.
  const rule = (data) => [
    { type: "rule", from: { data }, interactive: false, encode: { update: {
      x: { value: 0 }, x2: { signal: "width" }, y: { scale: "y", field: "y" },
      stroke: { value: "#555" }, strokeDash: { value: [2, 3] } } } },
    { type: "text", from: { data }, interactive: false, encode: { update: {
      x: { value: 0 }, dx: { value: 5 }, y: { scale: "y", field: "y" }, dy: { value: 4 }, baseline: { value: "top" },
      text: { field: "text" }, fill: { value: "#444" }, fontSize: { value: 11 }, font: { value: FONT } } } },
  ];

  // For View.tooltip: a box inside `box` beside the pointer; `describe(value)` gives its title and its lines.
  function tooltip(box, describe) {
    const tip = document.createElement("div");
    tip.className = "tip";
    tip.hidden = true;
    box.append(tip);
    return (_handler, event, _item, value) => {
      tip.hidden = !value;
      if (!value) return;
      const [title, ...lines] = describe(value);
      const name = document.createElement("b");
      name.textContent = title;
      tip.replaceChildren(name, ...lines.flatMap((text, i) => (i ? [document.createElement("br"), text] : [text])));
      const frame = box.getBoundingClientRect();
      const left = event.clientX - frame.left, top = event.clientY - frame.top;
      tip.style.left = `${Math.max(0, Math.min(left + 14, frame.width - tip.offsetWidth))}px`;
      const below = top + 16, above = Math.max(0, top - tip.offsetHeight - 10);
      tip.style.top = `${below + tip.offsetHeight > frame.height ? above : below}px`;
    };
  }

  // Calls build() once, and again whenever the box has another width: only then a chart must be made anew.
  function whenever(box, build) {
    let width = -1;
    const rebuild = () => {
      if (Math.abs(box.clientWidth - width) < 1) return;
      width = box.clientWidth;
      build(width);
    };
    new ResizeObserver(rebuild).observe(box);
    rebuild();
  }

  function stage(box) {
    const element = document.createElement("div");
    box.replaceChildren(element);
    return element;
  }

  return { COLOURS, FONT, AXIS, digits, shown, rule, tooltip, whenever, stage };
})();
