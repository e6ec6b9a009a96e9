// The tables beside the view: the curves, and the run that made them.

import { doubtsText, radiusText, short, typeNames } from "./data.js";

const mostRows = 2000;

// texts are set as such, so that the name of a file is never taken for markup
export function make(tag, text, className) {
  const element = document.createElement(tag);
  if (text !== undefined)
    element.textContent = text;
  if (className)
    element.className = className;
  return element;
}

const columns = [
  { title: "#", value: curve => curve.index, text: curve => String(curve.index) },
  { title: "type", value: curve => typeNames[curve.type], text: curve => typeNames[curve.type] },
  { title: "length", value: curve => curve.length, text: curve => short(curve.length) },
  { title: "radius", value: curve => curve.radii ? curve.radii[0] : -1, text: radiusText },
  { title: "rms", value: curve => curve.rms, text: curve => short(curve.rms, 3) },
  { title: "largest", value: curve => curve.max, text: curve => short(curve.max, 3) },
  { title: "support", value: curve => curve.support, text: curve => String(curve.support) },
  { title: "doubts", value: curve => curve.doubts.length, text: doubtsText }
];

export class CurveTable {
  // the handlers are called with a curve, onHover also with null
  constructor(table, note, unit, { onSelect, onHover }) {
    this.body = table.tBodies[0];
    this.note = note;
    this.unit = unit;
    this.onSelect = onSelect;
    this.onHover = onHover;
    this.column = 0;
    this.isDescending = false;
    this.rows = new Map();
    const row = table.tHead.insertRow();
    this.heads = columns.map((column, i) => {
      const head = make("th", column.title);
      head.addEventListener("click", () => this.sortBy(i));
      row.append(head);
      return head;
    });
  }

  sortBy(column) {
    // numbers that tell how bad a curve is are most wanted from the top
    this.isDescending = this.column === column ? !this.isDescending : column > 1;
    this.column = column;
    this.show(this.curves);
  }

  show(curves) {
    this.curves = curves;
    const { value } = columns[this.column];
    const sign = this.isDescending ? -1 : 1;
    const sorted = [...curves].sort((a, b) =>
      sign * (value(a) < value(b) ? -1 : value(a) > value(b) ? 1 : 0) || a.index - b.index);
    this.heads.forEach((head, i) => {
      if (i === this.column)
        head.setAttribute("aria-sort", this.isDescending ? "descending" : "ascending");
      else
        head.removeAttribute("aria-sort");
    });
    this.rows.clear();
    this.body.replaceChildren(...sorted.slice(0, mostRows).map(curve => this.rowOf(curve)));
    this.note.textContent = (sorted.length > mostRows ? `The first ${mostRows} of ${sorted.length} curves. ` : "")
      + `Lengths are in ${this.unit}.`;
    this.mark(this.selected, this.hovered);
  }

  rowOf(curve) {
    const row = make("tr");
    for (const column of columns)
      row.append(make("td", column.text(curve)));
    row.addEventListener("click", () => this.onSelect(curve));
    row.addEventListener("mouseenter", () => this.onHover(curve));
    row.addEventListener("mouseleave", () => this.onHover(null));
    this.rows.set(curve, row);
    return row;
  }

  mark(selected, hovered) {
    this.selected = selected;
    this.hovered = hovered;
    for (const [curve, row] of this.rows) {
      row.classList.toggle("is-selected", curve === selected);
      row.classList.toggle("is-hovered", curve === hovered);
    }
  }

  scrollTo(curve) {
    this.rows.get(curve)?.scrollIntoView({ block: "nearest" });
  }
}

function tableOf(rows) {
  const table = make("table");
  for (const cells of rows) {
    const row = table.insertRow();
    for (const cell of cells)
      row.insertCell().append(cell);
  }
  return table;
}

export function showRun(panel, data) {
  for (const warning of data.warnings)
    panel.append(make("p", warning, "warning"));
  panel.append(make("h3", "Result"), tableOf(data.summary));

  const sum = data.seconds.reduce((total, stage) => total + stage[1], 0);
  const longest = Math.max(...data.seconds.map(stage => stage[1]), 1e-9);
  panel.append(make("h3", `Seconds: ${sum.toFixed(2)} until this page was written`));
  panel.append(tableOf(data.seconds.map(([name, seconds]) => {
    const bar = make("div", undefined, "bar");
    bar.style.width = `${120 * seconds / longest}px`;
    return [name, seconds.toFixed(2), bar];
  })));

  let group = "";
  for (const parameter of data.parameters) {
    if (parameter.group !== group)
      panel.append(make("h3", group = parameter.group), make("table", undefined, "parameters"));
    const row = panel.lastChild.insertRow();
    row.insertCell().textContent = parameter.name;
    row.insertCell().textContent = parameter.value;
    if (parameter.is_given) {
      row.className = "is-given";
      row.title = "given on the command line";
    }
  }
  panel.append(make("p", `Written by ${data.program}`, "note"));
}
