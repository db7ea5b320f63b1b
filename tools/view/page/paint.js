// Colours the points of a cloud by the object that they lie on, by depth, by normal, or with their
// own colours.
import { depthColour, isPlane, objectColour, rgbOf } from "./colours.js";
import { normalsOf } from "./normals.js";

/// @return red, green and blue of each point, from 0 to 1
export function coloursOf(scene, by, dark) {
  const { positions } = scene.points;
  if (by === "normal") return normalsOf(positions, scene.viewpoint).map((value) => 0.5 + 0.5 * value);
  if (by === "own" && scene.points.colours) return Float32Array.from(scene.points.colours, (value) => value / 255);
  const paint = by === "depth" ? byDepth(scene) : byObject(scene, dark);
  const colours = new Float32Array(positions.length);
  for (let i = 0; i < positions.length / 3; ++i) colours.set(paint(i), 3 * i);
  return colours;
}

function byObject({ objects, points }, dark) {
  const none = dark ? [0.4, 0.46, 0.53] : [0.58, 0.63, 0.68], plane = dark ? [0.33, 0.39, 0.46] : [0.7, 0.74, 0.78];
  const boxOf = new Map();
  for (const object of objects) for (const face of object.faces || []) boxOf.set(face, object);
  const colours = objects.map((object) => {
    const shown = boxOf.get(object.id) || object;
    return isPlane(shown) ? plane : rgbOf(objectColour(shown));
  });
  return (i) => (points.owners[i] ? colours[points.owners[i] - 1] : none);
}

/// Colours points by depth. The range of colours leaves out the few points that lie very near or
/// very far.
function byDepth({ points, viewpoint }) {
  const { positions } = points, [x, y, z] = viewpoint;
  const depths = new Float32Array(positions.length / 3);
  for (let i = 0; i < depths.length; ++i) {
    depths[i] = Math.hypot(positions[3 * i] - x, positions[3 * i + 1] - y, positions[3 * i + 2] - z);
  }
  const sorted = depths.slice().sort();
  const near = sorted[Math.floor(0.02 * sorted.length)], far = sorted[Math.floor(0.95 * sorted.length)];
  return (i) => depthColour((depths[i] - near) / Math.max(far - near, 1e-6));
}
