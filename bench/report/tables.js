// SPDX-License-Identifier: GPL-3.0-or-later
// Sorts the tables of the page by the column whose heading is chosen; and opens what is folded where it is printed.
"use strict";

(() => {
  const collator = new Intl.Collator("en", { numeric: true });

  // A number where the cell has one; a cell without one ("never") comes after all that have.
  const valueOf = (row, column) => {
    const cell = row.cells[column];
    if (cell.dataset.v !== undefined) return Number(cell.dataset.v);
    return cell.tagName === "TH" ? cell.textContent : null;
  };

  function compare(a, b) {
    if (a === null || b === null) return (a === null) - (b === null);
    return typeof a === "number" ? a - b : collator.compare(a, b);
  }

  function sort(table, heading, column) {
    const descending = heading.getAttribute("aria-sort") === "ascending";
    for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    heading.setAttribute("aria-sort", descending ? "descending" : "ascending");
    const rows = [...table.tBodies[0].rows].map((row) => [valueOf(row, column), row]);
    rows.sort(([a], [b]) => (a === null || b === null || !descending ? compare(a, b) : compare(b, a)));
    table.tBodies[0].append(...rows.map(([, row]) => row));
  }

  for (const table of document.querySelectorAll("table.sortable"))
    [...table.tHead.rows[0].cells].forEach((heading, column) => {
      if (![...table.tBodies[0].rows].some((row) => valueOf(row, column) !== null)) return;
      const button = document.createElement("button");
      button.type = "button";
      button.append(...heading.childNodes);
      button.addEventListener("click", () => sort(table, heading, column));
      heading.append(button);
    });

  addEventListener("beforeprint", () => {
    for (const folded of document.querySelectorAll("details:not([open])")) {
      folded.open = true;
      folded.classList.add("opened-to-print");
    }
  });
  addEventListener("afterprint", () => {
    for (const opened of document.querySelectorAll("details.opened-to-print")) {
      opened.open = false;
      opened.classList.remove("opened-to-print");
    }
  });
})();
