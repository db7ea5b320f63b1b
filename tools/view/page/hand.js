// Draws the gripper as boxes, in the grasp frame G: z along the approach, y along the closing
// direction.
/* global THREE */

const kContactRadius = 0.004, kStem = 0.03;

export function poseMatrix(pose) {
  const [w, x, y, z] = pose.quaternion;
  return new THREE.Matrix4().compose(new THREE.Vector3(...pose.position), new THREE.Quaternion(x, y, z, w),
    new THREE.Vector3(1, 1, 1));
}

function boxBetween(low, high, material) {
  const size = high.map((value, i) => Math.max(value - low[i], 1e-4));
  const mesh = new THREE.Mesh(new THREE.BoxBufferGeometry(...size), material);
  mesh.position.set(...high.map((value, i) => (value + low[i]) / 2));
  return mesh;
}

function outlined(mesh, colour, opacity) {
  const edges = new THREE.LineSegments(new THREE.EdgesGeometry(mesh.geometry),
    new THREE.LineBasicMaterial({ color: colour, transparent: opacity < 1, opacity }));
  mesh.add(edges);
  return mesh;
}

/// Makes palm and two fingers at an opening. `back` is the distance of the palm behind the origin
/// of G; `start` is the distance before the end of the approach at which the boxes begin.
function handParts(gripper, opening, back, tip, start, make) {
  const x = gripper.finger[0] / 2, thick = gripper.finger[1], palm = gripper.palm;
  return [
    make([-x, opening / 2, -back - start], [x, opening / 2 + thick, tip]),
    make([-x, -opening / 2 - thick, -back - start], [x, -opening / 2, tip]),
    make([-palm[0] / 2, -palm[1] / 2, -back - palm[2] - start], [palm[0] / 2, palm[1] / 2, -back]),
  ];
}

/// Draws the closed hand at a grasp, the path swept by its approach, and the opened hand at the
/// start of the approach.
export function handAt(grasp, gripper, dark) {
  const group = new THREE.Group();
  group.applyMatrix(poseMatrix(grasp.X_CG));
  const tip = gripper.finger_front, openTip = tip + grasp.open_reach - grasp.reach;
  const ink = dark ? 0xf4f7fa : 0x1d2a36;
  const solid = new THREE.MeshLambertMaterial({ color: dark ? 0xc3d2df : 0x7d93a8, transparent: true, opacity: 0.62, depthWrite: false });
  const ghost = new THREE.MeshLambertMaterial({ color: 0x3d8bfd, transparent: true, opacity: 0.16, depthWrite: false });
  const sweep = new THREE.MeshBasicMaterial({ color: 0x3d8bfd, transparent: true, opacity: 0.07, depthWrite: false });
  group.add(...handParts(gripper, grasp.width, grasp.reach, tip, 0,
    (low, high) => outlined(boxBetween(low, high, solid), ink, 1)));
  group.add(...handParts(gripper, grasp.preshape, grasp.reach, openTip, grasp.approach,
    (low, high) => boxBetween(low, high, sweep)));
  const before = new THREE.Group();
  before.position.z = -grasp.approach;
  before.add(...handParts(gripper, grasp.preshape, grasp.reach, openTip, 0,
    (low, high) => outlined(boxBetween(low, high, ghost), 0x3d8bfd, 0.8)));
  group.add(before);
  return group;
}

export function contactsOf(grasp) {
  const group = new THREE.Group();
  const material = new THREE.MeshBasicMaterial({ color: grasp.unknown_contact ? 0xf5a623 : 0xe53935 });
  for (const contact of grasp.contacts) {
    const ball = new THREE.Mesh(new THREE.SphereBufferGeometry(kContactRadius, 12, 8), material);
    ball.position.set(...contact);
    group.add(ball);
  }
  return group;
}

/// Draws all grasps as forks of lines: the closing line, two short fingers and a stem.
export function marksOf(grasps, colourOf) {
  const positions = [], colours = [];
  for (const grasp of grasps) {
    const X = poseMatrix(grasp.X_CG), half = grasp.width / 2 + 0.004, back = -0.012;
    const colour = colourOf(grasp);
    const line = (from, to) => {
      for (const p of [from, to]) {
        positions.push(...new THREE.Vector3(...p).applyMatrix4(X).toArray());
        colours.push(...colour);
      }
    };
    line([0, -half, 0], [0, -half, back]);
    line([0, half, 0], [0, half, back]);
    line([0, -half, back], [0, half, back]);
    line([0, 0, back], [0, 0, back - kStem]);
  }
  return { positions, colours };
}
