// What the page holds: the JSON that extract_wireframe wrote into it, with arrays in base64.

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i)
    bytes[i] = text.charCodeAt(i);
  return bytes;
}

// All positions are stored relative to the middle of the cloud and its size, so that no digits are lost far from the
// origin.
export function readData(element) {
  const data = JSON.parse(element.textContent);
  element.textContent = ""; // it is large, and no longer needed
  data.cloud.samples = new Uint16Array(bytesOf(data.cloud.samples).buffer);
  for (const layer of data.layers) {
    layer.positions = new Float32Array(bytesOf(layer.positions).buffer);
    layer.colours = bytesOf(layer.colours);
    layer.edges = new Uint32Array(bytesOf(layer.edges).buffer);
    layer.edgeColours = bytesOf(layer.edge_colours);
  }
  data.vertices = new Float32Array(bytesOf(data.vertices).buffer);
  data.curvePoints = new Float32Array(bytesOf(data.curve_points).buffer);
  return data;
}

// a length in the unit of the cloud, with as many digits as a reader wants
export function short(value, digits = 4) {
  if (value === null || value === undefined)
    return "";
  if (value === 0)
    return "0";
  const size = Math.abs(value);
  if (size >= 1e6 || size < 1e-3)
    return value.toExponential(digits - 2).replace("e+", "e");
  return String(Number(value.toPrecision(digits)));
}

export const typeNames = {
  line: "line",
  circle: "circle",
  arc: "arc",
  ellipse: "ellipse",
  elliptic_arc: "elliptic arc",
  bspline: "B-spline"
};

export const doubtNames = {
  free_end: "free end",
  short: "short",
  little_support: "little support",
  misfit: "misfit",
  no_fold: "no fold",
  beside_another: "beside another",
  uncertain_type: "uncertain type"
};

// the colours of curves that are doubtful, and of those that are not
export const verdictColours = { doubtful: "#d1242f", clear: "#5a6472" };

export function doubtsText(curve) {
  return curve.doubts.map(name => doubtNames[name]).join(", ");
}

export function radiusText(curve) {
  if (!curve.radii)
    return "";
  const [major, minor] = curve.radii;
  return major === minor ? short(major) : short(major) + " / " + short(minor);
}
