// Puts the page together: what is chosen on the left decides what is seen in the middle and listed on the right.

import { channels, colourOfIndex, colourOfResidual } from "./colours.js";
import { doubtsText, radiusText, readData, short, typeNames, verdictColours } from "./data.js";
import { CurveTable, make, showRun } from "./panels.js";
import { View } from "./scene.js";

const byId = id => document.getElementById(id);
const data = readData(byId("wireframe-data"));
const unit = data.unit;

const state = {
  selected: null,
  hovered: null,
  hiddenTypes: new Set(),
  shown: []
};

document.title = `${data.title} – wireframe`;
byId("title").textContent = data.title;
const hasCloud = data.number_of_points > 0; // which only the tool always has
byId("subtitle").textContent = `${data.curves.length} curves, `
  + (hasCloud ? `${data.number_of_points.toLocaleString("en")} points, ` : "")
  + `r = ${short(data.sampling_distance)} ${unit}`;
byId("cloud-settings").hidden = !hasCloud;

const view = makeView();
const table = new CurveTable(byId("curves"), byId("curves-note"), unit, {
  onSelect: curve => select(curve, true),
  onHover: curve => hover(curve)
});

function makeView() {
  try {
    return new View(byId("canvas"), byId("axes"), data);
  }
  catch (error) {
    const failure = byId("failure");
    failure.hidden = false;
    failure.textContent = "This browser shows no 3D graphics (WebGL 2); the table has the curves all the same. "
      + `(${error.message})`;
    return null;
  }
}

// layers --------------------------------------------------------------------------------------------

function addLayer(name, title, count, isVisible) {
  const label = make("label", undefined, "layer");
  const box = make("input");
  box.type = "checkbox";
  box.id = `layer-${name}`;
  box.checked = isVisible;
  box.addEventListener("change", () => view?.setVisible(name, box.checked));
  label.append(box, title, make("span", count.toLocaleString("en"), "count"));
  byId("layers").append(label);
}

if (hasCloud)
  addLayer("cloud", "Cloud", data.cloud.samples.length / 4, true);
for (const layer of data.layers)
  addLayer(layer.name, layer.title, layer.count, false);
addLayer("vertices", "Vertices", data.vertices.length / 3, true);
addLayer("curves", "Curves", data.curves.length, true);

// curves: colours and filters ------------------------------------------------------------------------

const measure = () => byId("filter-measure").value;
const largest = name => data.curves.reduce((most, curve) => Math.max(most, curve[name]), 0);

// The slider is finer where most residuals are.
function filterLimit() {
  const share = byId("filter").value / 1000;
  return largest(measure()) * share * share;
}

function isShown(curve) {
  const slider = byId("filter");
  if (state.hiddenTypes.has(curve.type))
    return false;
  const verdict = byId("filter-verdict").value;
  if (verdict !== "all" && (verdict === "doubtful") !== curve.doubts.length > 0)
    return false;
  if (byId("filter-side").value === "above")
    return slider.value === slider.min || curve[measure()] >= filterLimit();
  return slider.value === slider.max || curve[measure()] <= filterLimit();
}

function colourOf(curve) {
  const choice = byId("curve-colour").value;
  if (choice === "residual")
    return colourOfResidual(curve[measure()] / (largest(measure()) || 1));
  if (choice === "verdict")
    return channels(verdictColours[curve.doubts.length > 0 ? "doubtful" : "clear"]);
  return choice === "index" ? colourOfIndex(curve.index) : channels(data.type_colours[curve.type]);
}

function updateCurves() {
  state.shown = data.curves.filter(isShown);
  byId("filter-value").textContent = `${short(filterLimit(), 3)} ${unit}`;
  byId("filter-count").textContent = `${state.shown.length} of ${data.curves.length} shown`;
  if (!state.shown.includes(state.selected))
    state.selected = null;
  if (!state.shown.includes(state.hovered))
    hover(null);
  view?.showCurves(state.shown, colourOf);
  table.show(state.shown);
  updateMarks();
}

for (const type of Object.keys(typeNames)) {
  const count = data.curves.filter(curve => curve.type === type).length;
  if (count === 0)
    continue;
  const label = make("label", undefined, "type");
  const box = make("input");
  box.type = "checkbox";
  box.id = `type-${type}`;
  box.checked = true;
  box.addEventListener("change", () => {
    state.hiddenTypes[box.checked ? "delete" : "add"](type);
    updateCurves();
  });
  const swatch = make("span", undefined, "swatch");
  swatch.style.background = data.type_colours[type];
  label.append(box, swatch, typeNames[type], make("span", String(count), "count"));
  byId("types").append(label);
}

const doubtfulCurves = data.curves.filter(curve => curve.doubts.length > 0).length;
byId("verdict-count").textContent = `${doubtfulCurves} of ${data.curves.length} doubtful`;

for (const id of ["curve-colour", "filter-verdict", "filter-measure", "filter"])
  byId(id).addEventListener("input", updateCurves);
byId("filter-side").addEventListener("input", () => {
  // at that end of the slider, all curves are shown
  byId("filter").value = byId("filter-side").value === "above" ? 0 : 1000;
  updateCurves();
});
byId("line-width").addEventListener("input", event => view?.setLineWidth(Number(event.target.value)));

// curves: one of them --------------------------------------------------------------------------------

function updateMarks() {
  table.mark(state.selected, state.hovered);
  view?.showHighlight([...new Set([state.selected, state.hovered])].filter(curve => curve !== null));
}

function select(curve, isZoomed) {
  state.selected = curve;
  if (curve && isZoomed)
    view?.zoomTo(curve);
  if (curve)
    table.scrollTo(curve);
  updateMarks();
}

function hover(curve, x, y) {
  const hint = byId("hint");
  hint.hidden = !curve || x === undefined;
  if (!hint.hidden)
    showHint(hint, curve, x, y);
  if (curve === state.hovered)
    return;
  state.hovered = curve;
  if (curve && x !== undefined)
    table.scrollTo(curve);
  updateMarks();
}

function showHint(hint, curve, x, y) {
  const rows = [["length", `${short(curve.length)} ${unit}`]];
  if (curve.radii)
    rows.push([curve.radii[0] === curve.radii[1] ? "radius" : "radii", `${radiusText(curve)} ${unit}`]);
  rows.push(["rms residual", residualText(curve.rms)], ["largest", residualText(curve.max)],
            ["support", `${curve.support} points`]);
  if (curve.doubts.length > 0)
    rows.push(["doubtful", doubtsText(curve)]);
  const values = make("table");
  for (const cells of rows) {
    const row = values.insertRow();
    for (const cell of cells)
      row.insertCell().textContent = cell;
  }
  hint.replaceChildren(make("b", `Curve ${curve.index}: ${curve.closed ? "closed " : ""}${typeNames[curve.type]}`),
                       values);
  const { clientWidth: width, clientHeight: height } = byId("scene");
  hint.style.left = `${Math.max(0, Math.min(x + 16, width - hint.offsetWidth - 8))}px`;
  hint.style.top = `${Math.max(0, Math.min(y + 16, height - hint.offsetHeight - 8))}px`;
}

function residualText(value) {
  const r = data.sampling_distance;
  return `${short(value, 3)} ${unit}` + (r > 0 ? ` = ${short(value / r, 3)} r` : "");
}

function placeOf(event) {
  const { left, top } = byId("canvas").getBoundingClientRect();
  return [event.clientX - left, event.clientY - top];
}

let pointer = null;
byId("canvas").addEventListener("pointermove", event => {
  if (event.buttons !== 0 || !view)
    return;
  if (pointer === null)
    requestAnimationFrame(() => {
      if (pointer !== null)
        hover(view.curveAt(...pointer), ...pointer);
      pointer = null;
    });
  pointer = placeOf(event);
});
byId("canvas").addEventListener("pointerleave", () => {
  pointer = null;
  hover(null);
});
byId("canvas").addEventListener("dblclick", event => {
  const curve = view?.curveAt(...placeOf(event));
  if (curve)
    select(curve, true);
});
let pressed = null;
byId("canvas").addEventListener("pointerdown", event => {
  hover(null);
  pressed = placeOf(event);
});
byId("canvas").addEventListener("pointerup", event => {
  const place = placeOf(event);
  // a click, not the end of a turn
  if (view && pressed && Math.hypot(place[0] - pressed[0], place[1] - pressed[1]) < 4)
    select(view.curveAt(...place), false);
  pressed = null;
});
window.addEventListener("keydown", event => {
  if (event.key === "Escape")
    select(null, false);
});

// the cloud ------------------------------------------------------------------------------------------

byId("field-scale").style.background = `linear-gradient(to right, ${data.field_colours.join(", ")})`;
byId("point-size").addEventListener("input", event => view?.setPointSize(Number(event.target.value)));
byId("point-share").addEventListener("input", updatePoints);
byId("field-range").addEventListener("input", updateField);

function updatePoints() {
  view?.setPointShare(byId("point-share").value / 100);
  showPointCount();
}

function showPointCount() {
  const wanted = Math.round(byId("point-share").value / 100 * data.cloud.samples.length / 4);
  const drawn = view && !view.isMoving && view.isThinned() ? view.drawnPoints : wanted;
  byId("point-count").textContent =
    `${drawn.toLocaleString("en")} of ${data.number_of_points.toLocaleString("en")} points`
    + (drawn < wanted ? ", as many as this computer draws quickly" : "");
}

function updateField() {
  const share = (byId("field-range").value / 1000) ** 2;
  const text = `${short(share * data.cloud.largest_value, 3)} ${unit}`;
  byId("field-value").textContent = text;
  byId("field-end").textContent = text;
  view?.setFieldRange(share);
}

// the view and the tabs -------------------------------------------------------------------------------

for (const name of ["isometric", "front", "right", "top"]) {
  const button = make("button", name);
  button.id = `view-${name}`;
  button.addEventListener("click", () => view?.look(name));
  byId("views").append(button);
}

for (const name of ["curves", "run"])
  byId(`tab-${name}`).addEventListener("click", () => {
    for (const other of ["curves", "run"]) {
      byId(`tab-${other}`).setAttribute("aria-selected", String(other === name));
      byId(`panel-${other}`).hidden = other !== name;
    }
  });

showRun(byId("panel-run"), data);
if (view)
  view.onRefine = showPointCount;
updatePoints();
updateField();
updateCurves();
window.wireframe = { data, state, view }; // for those who look from the console
