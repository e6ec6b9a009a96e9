// The colours of the page. Those of the cloud and of the types of curves come with the data: they are the ones of the
// pictures and the other formats.

// of residuals, from small to large
const residualStops = ["#2a9d5c", "#d6c02c", "#e07a1f", "#c2182b"];

export function channels(colour) {
  const number = parseInt(colour.slice(1), 16);
  return [(number >> 16) / 255, ((number >> 8) & 255) / 255, (number & 255) / 255];
}

function mixed(stops, share) {
  const position = Math.min(Math.max(share, 0), 1) * (stops.length - 1);
  const first = Math.min(Math.floor(position), stops.length - 2);
  const a = channels(stops[first]), b = channels(stops[first + 1]);
  return a.map((value, i) => value + (position - first) * (b[i] - value));
}

export function colourOfResidual(share) {
  return mixed(residualStops, share);
}

// neighbouring indices get colours far apart
export function colourOfIndex(index) {
  const hue = (index * 0.6180339887498949) % 1 * 6;
  const strength = Math.floor(index / 3) % 2 === 0 ? 0.82 : 0.58;
  return [0, 2, 4].map(peak => {
    const away = Math.min(Math.abs(hue - peak), 6 - Math.abs(hue - peak));
    return strength * Math.min(Math.max(2 - away, 0.08), 1);
  });
}
