// Converts objects and voxels to the geometry of three.js.
/* global THREE */
import { poseMatrix } from "./hand.js";

/// Returns true for boxes and lumps, which are shown as the boxes around them.
export const isBox = (object) => object.kind === "box" || object.kind === "lump";

/// Returns the corners of an object's extent.
export function cornersOf(object) {
  const X = poseMatrix(object.pose);
  const half = isBox(object) ? object.size.map((side) => side / 2) : null;
  const low = half ? half.map((h) => -h) : object.extent ? object.extent.min : [0, 0, 0];
  const high = half || (object.extent ? object.extent.max : [0, 0, 0]);
  const corners = [];
  for (let c = 0; c < 8; ++c) {
    const p = [0, 1, 2].map((i) => (c >> i & 1 ? high[i] : low[i]));
    corners.push(new THREE.Vector3(...p).applyMatrix4(X));
  }
  return corners;
}

/// Returns the clipped surface of a quadric; null if it is empty.
export function meshGeometry(mesh) {
  if (!mesh || mesh.triangles.length === 0) return null;
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(mesh.vertices, 3));
  geometry.setIndex(new THREE.BufferAttribute(mesh.triangles, 1));
  geometry.computeVertexNormals();
  return geometry;
}

/// Returns a layer of voxels as small cubes; null if it is empty.
export function voxelMesh(voxels, layer, color, opacity) {
  const cells = voxels[layer], count = cells.length / 3, { edge, corner } = voxels;
  if (count === 0) return null;
  const material = new THREE.MeshLambertMaterial({ color, transparent: true, opacity, depthWrite: layer === "occupied" });
  const mesh = new THREE.InstancedMesh(new THREE.BoxBufferGeometry(0.92 * edge, 0.92 * edge, 0.92 * edge), material, count);
  const X = new THREE.Matrix4();
  for (let i = 0; i < count; ++i) {
    X.makeTranslation(...[0, 1, 2].map((axis) => corner[axis] + (cells[3 * i + axis] + 0.5) * edge));
    mesh.setMatrixAt(i, X);
  }
  mesh.frustumCulled = false;
  return mesh;
}
