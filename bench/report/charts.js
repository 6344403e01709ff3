// SPDX-License-Identifier: GPL-3.0-or-later
// What all charts of the page share: theme, numbers, the look of an axis, the box that shows figures at the pointer.
"use strict";

const charts = (() => {
  const FONT = "system-ui, 'DejaVu Sans', sans-serif";

  // What the page's style sheet says just now: a page may turn dark while it is looked at.
  const variable = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  const DARK = matchMedia("screen and (prefers-color-scheme: dark)");
  const theme = () => ({
    dark: DARK.matches, paper: "transparent", ink: variable("ink"), quiet: variable("quiet"), grid: variable("grid"),
    axis: variable("axis"),
  });
  // Of what is saved: a picture for white paper.
  const PAPER = { dark: false, paper: "#fff", ink: "#1c1f23", quiet: "#444b54", grid: "#e3e6ea", axis: "#9aa2ac" };
  const colour = (index) => variable(`s${index}`);

  const digits = new Intl.NumberFormat("en", { maximumSignificantDigits: 4, useGrouping: true });
  const shown = (x) => (x !== 0 && (Math.abs(x) < 1e-4 || Math.abs(x) >= 1e7) ? x.toExponential(2) : digits.format(x));

  const axisLook = (look) => ({
    grid: true, gridColor: look.grid, domainColor: look.axis, tickColor: look.axis, labelColor: look.quiet,
    titleColor: look.quiet, titleFontWeight: 400, labelFontSize: 11, titleFontSize: 12, labelFont: FONT,
    titleFont: FONT, labelOverlap: true,
  });

  // A dashed horizontal line with a note below it, one for every {y, text} of the data.
  const rule = (data, look) => [
    { type: "rule", from: { data }, interactive: false, encode: { update: {
      x: { value: 0 }, x2: { signal: "width" }, y: { scale: "y", field: "y" },
      stroke: { value: look.quiet }, strokeDash: { value: [2, 3] } } } },
    { type: "text", from: { data }, interactive: false, encode: { update: {
      x: { value: 0 }, dx: { value: 5 }, y: { scale: "y", field: "y" }, dy: { value: 4 }, baseline: { value: "top" },
      text: { field: "text" }, fill: { value: look.quiet }, fontSize: { value: 11 }, font: { value: FONT } } } },
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

  // Calls build(width, theme) once, and again whenever the box has another width or the page another theme: only then a
  // chart must be made anew.
  function whenever(box, build) {
    let width = -1, dark = null;
    const rebuild = () => {
      if (box.clientWidth === 0 || (Math.abs(box.clientWidth - width) < 1 && dark === DARK.matches)) return;
      width = box.clientWidth;
      dark = DARK.matches;
      build(width, theme());
    };
    new ResizeObserver(rebuild).observe(box);
    DARK.addEventListener("change", rebuild);
    rebuild();
  }

  function stage(box) {
    const element = document.createElement("div");
    box.replaceChildren(element);
    return element;
  }

  return { FONT, PAPER, colour, axisLook, digits, shown, rule, tooltip, whenever, stage };
})();
