// Colours of objects, depths, normals and scores, as [r, g, b] from 0 to 1.

const kPalette = ["#1f9e89", "#e8743b", "#5b7fe0", "#c94f8f", "#d9a514", "#6aa84f", "#9467bd", "#17a2c4",
  "#b5533c", "#7a8f1f", "#e377c2", "#4c6f8f"];
const kViridis = [[0.267, 0.005, 0.329], [0.254, 0.265, 0.53], [0.164, 0.471, 0.558], [0.135, 0.659, 0.518],
  [0.478, 0.821, 0.318], [0.993, 0.906, 0.144]];
const kScores = [[0.84, 0.19, 0.15], [0.96, 0.69, 0.18], [0.18, 0.68, 0.35]];

export const rgbOf = (hex) => [1, 3, 5].map((i) => parseInt(hex.slice(i, i + 2), 16) / 255);

function between(map, t) {
  const at = Math.min(Math.max(t, 0), 1) * (map.length - 1), i = Math.min(Math.floor(at), map.length - 2);
  return map[i].map((value, k) => value + (at - i) * (map[i + 1][k] - value));
}

export const depthColour = (t) => between(kViridis, 1 - t);
export const scoreColour = (score) => between(kScores, score);

/// Gives each object a colour. A surface with a track has the same colour in all clouds.
export function colourObjects(objects) {
  let untracked = 0;
  for (const object of objects) {
    if (isPlane(object)) object.colour = "#8a97a5";
    else object.colour = kPalette[(object.track > 0 ? object.track : untracked++) % kPalette.length];
  }
}

export const objectColour = (object) => object.colour;

export const isPlane = (object) => object.kind === "quadric" && object.type === "plane";
