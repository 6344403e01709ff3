// SPDX-License-Identifier: GPL-3.0-or-later
// A script of the test's own, in a copy of the page: it looks, chooses every axis, hides a line, points at one, sorts,
// saves, and checks what an accessibility audit would. What it found is the page's title, which --dump-dom shows.
const wait = (ms) => new Promise((done) => setTimeout(done, ms));
const all = (selector, from = document) => [...from.querySelectorAll(selector)];
const lines = () => all(".chart .mark-line path").length;

async function point(hit) {
  const box = hit.getBoundingClientRect();
  for (const kind of ["mouseover", "mousemove", "pointerover", "pointermove"])
    hit.dispatchEvent(new MouseEvent(kind, { bubbles: true, clientX: box.x + box.width / 2,
                                             clientY: box.y + box.height / 2 }));
  await wait(50);
}

// ── What everybody must be able to find out ──

const textOf = (ids) => ids.split(" ").map((id) => document.getElementById(id)?.textContent ?? "").join(" ");
const nameOf = (element) => (
  element.getAttribute("aria-labelledby") ? textOf(element.getAttribute("aria-labelledby"))
    : element.getAttribute("aria-label") ?? element.closest("label")?.textContent ?? element.textContent).trim();

function nameless() {
  return all("button, input, a, summary, [role=img], [role=region], [role=group], section > h2, nav, svg.lines")
    .filter((e) => nameOf(e) === "").map((e) => `${e.tagName}.${e.className}`);
}

// Of an audit's luminance and contrast (WCAG 2.1). Colours are "rgb(…)" or "rgba(…)", "color(srgb …)" of none here.
const channels = (colour) => colour.match(/[\d.]+/g).map(Number);
const luminance = ([r, g, b]) => [r, g, b].map((c) => c / 255)
  .map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4))
  .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
function contrast(a, b) {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
}

function background(element) {
  for (let e = element; e; e = e.parentElement) {
    const [r, g, b, alpha = 1] = channels(getComputedStyle(e).backgroundColor);
    if (alpha === 1) return [r, g, b];
  }
  return [255, 255, 255];
}

// Elements with text of their own that is seen, too faint for those who see little. Pictures of plates have a scale of
// colours, no text in them; their labels stand on a paper of their own.
function faint() {
  const found = [];
  for (const element of all("body *")) {
    if (![...element.childNodes].some((n) => n.nodeType === 3 && n.textContent.trim() !== "")) continue;
    if (element.closest("script, style, svg.plate, title, desc") || element.getClientRects().length === 0) continue;
    const style = getComputedStyle(element);
    const ink = channels(element.closest("svg") ? style.fill : style.color);
    const ratio = contrast(ink.slice(0, 3), background(element));
    if (ratio < 4.5) found.push(`${element.tagName}.${element.className.baseVal ?? element.className} ${ratio.toFixed(2)}`);
  }
  return [...new Set(found)];
}

// Every chart has its figures as a table; every table its heads and its caption, or a name.
function untold() {
  const charts = all("figure.race, figure.lone").filter((f) => f.querySelectorAll("table").length === 0
    || !f.querySelector(".still svg > title") || !f.querySelector(".still svg > desc"));
  const tables = all("table").filter((t) => !t.querySelector("thead th[scope=col]")
    || (nameOf(t.closest("[role=region]") ?? t) === "" && !t.caption));
  return [...charts.map((f) => f.id), ...tables.map((t) => `table.${t.className}`)];
}

// Headings go down by one level at most, and ids are used once.
function disorder() {
  const found = [];
  let level = 0;
  for (const heading of all("h1, h2, h3, h4, h5, h6")) {
    const here = Number(heading.tagName[1]);
    if (here > level + 1) found.push(`${heading.tagName} ${heading.textContent}`);
    level = here;
  }
  const ids = all("[id]").map((e) => e.id);
  return found.concat(ids.filter((id, i) => ids.indexOf(id) !== i).map((id) => `twice #${id}`));
}

function audit() {
  for (const folded of all("details")) folded.open = true;
  const problems = { nameless: nameless(), faint: faint(), untold: untold(), disorder: disorder() };
  const said = Object.entries(problems).filter(([, list]) => list.length > 0)
    .map(([what, list]) => `${what}: ${list.slice(0, 5).join(" | ")}`);
  return said.length === 0 ? "clean" : said.join("; ");
}

// ── What a pointer and a keyboard do ──

async function saved(kind, figure) {
  let blob = null;
  const real = URL.createObjectURL;
  URL.createObjectURL = (given) => { blob = given; return "#"; };
  [...figure.querySelectorAll(".save button")].find((b) => b.textContent.includes(kind)).click();
  for (let i = 0; i < 40 && blob === null; ++i) await wait(50);
  URL.createObjectURL = real;
  return blob !== null && blob.size > 5000;
}

function sorts() {
  const table = document.querySelector("table.sortable");
  const last = (column) => [...table.tBodies[0].rows].map((r) => r.cells[column].dataset.v).filter((v) => v).map(Number);
  const heading = table.tHead.rows[0].cells[1];
  const ascending = (list) => list.every((v, i) => i === 0 || list[i - 1] <= v);
  heading.querySelector("button").click();
  const up = ascending(last(1)) && heading.getAttribute("aria-sort") === "ascending";
  heading.querySelector("button").click();
  return up && ascending(last(1).reverse()) && heading.getAttribute("aria-sort") === "descending";
}

function springs() {
  const tip = document.querySelector(".plate-figure > .tip");
  const picture = [...document.querySelectorAll("[data-system] svg")].pop();
  picture.querySelector(".spring-hit").dispatchEvent(new PointerEvent("pointerenter"));
  const first = tip.textContent;
  picture.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight" }));
  const told = /^spring \d+–\d+: .* N\/m, .* times that of the start$/;
  const both = told.test(first) && told.test(tip.textContent) && first !== tip.textContent && !tip.hidden;
  picture.dispatchEvent(new PointerEvent("pointerleave"));
  return both && tip.hidden;
}

addEventListener("load", async () => {
  await wait(300);
  const races = all("figure.race").length;
  const drawn = all(".chart").filter((c) => c.querySelectorAll("svg").length === 1).length;
  const before = lines();
  for (const input of all(".controls input")) { input.click(); await wait(50); }
  const chosen = lines();
  document.querySelector(".keys button").click();
  await wait(50);
  const hidden = lines();
  await point(document.querySelector(".chart .mark-symbol path"));
  const tip = document.querySelector(".chart .tip");
  const said = !tip.hidden && /quartiles/.test(tip.textContent);
  const thick = all(".mark-line path[stroke-width=\"3\"]").length;
  const wide = document.documentElement.scrollWidth > document.documentElement.clientWidth ? "wide" : "fits";
  const plates = all(".plates svg").length;
  const panels = all(".panel");
  const filled = panels.filter((p) => p.querySelectorAll("svg").length === 1).length;
  const curves = all(".panel .mark-line path").length;
  let told = false;
  if (filled > 0) {
    await point(panels[0].querySelector(".hits path"));
    told = /after 0 iterations: 0[.]5/.test(panels[0].querySelector(".tip").textContent);
  }
  const sorted = sorts();
  const saves = async (figure) => (figure ? [await saved("SVG", figure), await saved("PNG", figure)].join(" ") : "none");
  const files = await saves(document.querySelector("figure.race")), stills = await saves(document.querySelector("figure.lone"));
  document.title = `PROBE races ${drawn} of ${races}, page ${wide}, plates ${plates}, ` +
    `lines ${before} ${chosen} ${hidden}, tip ${said}, thick ${thick}, ` +
    `panels ${filled} of ${panels.length}, curves ${curves}, told ${told}, springs ${springs()}, sorts ${sorted}, saves ${files}, stills ${stills}, ` +
    `audit ${audit()}`;
});
