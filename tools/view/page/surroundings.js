// Draws what else is in the scene: the robot, obstacles, the camera and its path, proposed views.
/* global THREE */
import { poseMatrix } from "./hand.js";

const kArc = 8;
/// Edges between faces that meet at a smaller angle are not drawn [degrees].
const kEdgeAngle = 30;

/// Returns half the outline of a capsule, from pole to pole, for a lathe.
function capsuleOutline(radius, length) {
  return [-1, 1].flatMap((side) => Array.from({ length: kArc + 1 }, (_, i) => {
    const angle = (side < 0 ? i - kArc : i) / kArc * Math.PI / 2;
    return new THREE.Vector2(Math.max(radius * Math.cos(angle), 0), side * length / 2 + radius * Math.sin(angle));
  }));
}

/// Makes a convex solid of its faces, each given as the number of its corners and their indices.
function convexGeometry({ vertices, faces }) {
  const corners = [];
  for (let at = 0; at < faces.length; at += 1 + faces[at]) {
    const face = faces.slice(at + 1, at + 1 + faces[at]);
    for (let i = 2; i < face.length; ++i) corners.push(...[face[0], face[i - 1], face[i]].flatMap((n) => vertices[n]));
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(corners, 3));
  geometry.computeVertexNormals();
  return geometry;
}

/// Makes the solid of a shape in its own frame, whose z is the shape's axis; that of three.js is y.
const kSolids = {
  sphere: ([r]) => new THREE.SphereBufferGeometry(r, 24, 16),
  ellipsoid: (axes) => new THREE.SphereBufferGeometry(1, 24, 16).scale(...axes),
  cylinder: ([r, l]) => new THREE.CylinderBufferGeometry(r, r, l, 24).rotateX(Math.PI / 2),
  cone: ([r, l]) => new THREE.CylinderBufferGeometry(0, r, l, 24).rotateX(Math.PI / 2),
  capsule: ([r, l]) => new THREE.LatheBufferGeometry(capsuleOutline(r, l), 24).rotateX(Math.PI / 2),
  box: (sides) => new THREE.BoxBufferGeometry(...sides),
};

export function solidsOf(shapes, color) {
  const group = new THREE.Group();
  for (const shape of shapes) {
    const make = kSolids[shape.kind], geometry = make ? make(shape.dimensions) : convexGeometry(shape);
    const mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial(
      { color, side: THREE.DoubleSide, transparent: true, opacity: 0.3, depthWrite: false }));
    const edges = new THREE.EdgesGeometry(geometry, kEdgeAngle);
    if (edges.attributes.position.count) {
      mesh.add(new THREE.LineSegments(edges, new THREE.LineBasicMaterial({ color, transparent: true, opacity: 0.8 })));
    }
    mesh.applyMatrix(poseMatrix(shape.pose));
    group.add(mesh);
  }
  return group;
}

/// Draws a camera as the pyramid that it sees, up to a depth [m], with a mark at its upper edge.
export function frustumOf(pose, depth, color) {
  const [x, y, z] = [0.6 * depth, 0.45 * depth, depth];
  const corners = [[-x, -y, z], [x, -y, z], [x, y, z], [-x, y, z]], top = [0, -1.5 * y, z];
  const lines = [...corners.flatMap((corner, i) => [[0, 0, 0], corner, corner, corners[(i + 1) % 4]]),
    corners[0], top, top, corners[1]];
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.Float32BufferAttribute(lines.flat(), 3));
  const frustum = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color }));
  frustum.applyMatrix(poseMatrix(pose));
  return frustum;
}

/// Draws the path of a camera as a line.
export function pathOf(positions, color) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
  return new THREE.Line(geometry, new THREE.LineBasicMaterial({ color, transparent: true, opacity: 0.7 }));
}
