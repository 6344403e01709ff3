// SPDX-License-Identifier: GPL-3.0-or-later
// Tells the stiffness of a spring that is pointed at, or gone to by the arrow keys, in each picture of a system.
"use strict";

(() => {
  const SVG = "http://www.w3.org/2000/svg";

  function line([x1, y1, x2, y2], scale) {
    const made = document.createElementNS(SVG, "line");
    Object.entries({ x1, y1, x2, y2 }).forEach(([name, value]) => made.setAttribute(name, value * scale));
    made.setAttribute("class", "spring-hit");
    return made;
  }

  function connect(svg, index, data, tip) {
    const scale = svg.viewBox.baseVal.width / data.width;
    const hits = data.places.map((place) => line(place, scale));
    let chosen = -1;
    const tell = (spring) => {
      if (chosen >= 0) hits[chosen].classList.remove("chosen");
      chosen = spring;
      tip.hidden = spring < 0;
      if (spring < 0) return;
      hits[spring].classList.add("chosen");
      const [a, b] = data.nodes[spring], here = data.systems[index].stiffness[spring];
      const first = data.systems[0], ratio = here / first.stiffness[spring];
      tip.textContent = `spring ${a}–${b}: ${charts.shown(here)} N/m` +
        (index > 0 ? `, ${charts.shown(ratio)} times that of the ${first.label}` : "");
      const box = hits[spring].getBoundingClientRect(), frame = tip.parentElement.getBoundingClientRect();
      tip.style.left = `${Math.max(0, Math.min(box.x - frame.x + 12, frame.width - tip.offsetWidth))}px`;
      tip.style.top = `${box.bottom - frame.y + 6}px`;
    };
    hits.forEach((hit, spring) => hit.addEventListener("pointerenter", () => tell(spring)));
    svg.addEventListener("pointerleave", () => tell(-1));
    svg.addEventListener("blur", () => tell(-1));
    svg.addEventListener("keydown", (event) => {
      const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
      if (!step) return;
      event.preventDefault();
      tell((Math.max(chosen, step > 0 ? -1 : 0) + step + hits.length) % hits.length);
    });
    svg.tabIndex = 0;
    svg.append(...hits);
  }

  for (const figure of document.querySelectorAll(".plate-figure")) {
    const json = figure.querySelector(".springs-data");
    if (!json) continue;
    const data = JSON.parse(json.textContent);
    const tip = document.createElement("div");
    tip.className = "tip";
    tip.setAttribute("role", "status");
    tip.hidden = true;
    figure.append(tip);
    figure.querySelectorAll(".plates .system").forEach((svg, index) => connect(svg, index, data, tip));
    for (const one of figure.querySelectorAll("[data-system]"))
      for (const svg of one.querySelectorAll("svg")) connect(svg, Number(one.dataset.system), data, tip);
    figure.querySelector(".scripted-springs").hidden = false;
  }
})();
