// Reads a scene as the server packs it: "QVW1", the length of the JSON, the JSON, and arrays.

import { colourObjects } from "./colours.js";

const kHeadBytes = 8;

export function unpack(buffer) {
  const head = new DataView(buffer);
  if (buffer.byteLength < kHeadBytes || head.getUint32(0) !== 0x51565731) throw new Error("this is no scene");
  const size = head.getUint32(4, true);
  const text = new TextDecoder().decode(new Uint8Array(buffer, kHeadBytes, size));
  const scene = JSON.parse(text);
  const base = kHeadBytes + size;
  const take = (Type, place) => new Type(buffer, base + place.at, place.count);

  scene.points.positions = positionsOf(take(Uint16Array, scene.points), scene.points);
  scene.points.owners = take(Uint8Array, scene.points.owners);
  if (scene.points.colours) scene.points.colours = take(Uint8Array, scene.points.colours);
  for (const object of scene.objects) {
    if (!object.mesh) continue;
    const vertices = object.mesh.vertices;
    object.mesh = {
      vertices: positionsOf(take(Uint16Array, vertices), vertices),
      triangles: take(Uint32Array, object.mesh.triangles),
      rims: take(Uint32Array, object.mesh.rims),
    };
  }
  colourObjects(scene.objects);
  for (const layer of ["occupied", "unknown"]) scene.voxels[layer] = take(Uint16Array, scene.voxels[layer]);
  scene.camera.path = positionsOf(take(Uint16Array, scene.camera.path), scene.camera.path);
  return scene;
}

/// Converts multiples of a step per axis to coordinates.
function positionsOf(steps, place) {
  const positions = new Float32Array(steps.length);
  for (let i = 0; i < steps.length; ++i) positions[i] = place.min[i % 3] + place.step[i % 3] * steps[i];
  return positions;
}
