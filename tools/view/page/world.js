// The scene in three dimensions: what is drawn, from which viewpoint, and what lies under the
// pointer.
/* global THREE */
import { isPlane, objectColour, scoreColour } from "./colours.js";
import { byId } from "./dom.js";
import { graspsOf } from "./grasps_of.js";
import { contactsOf, handAt, marksOf, poseMatrix } from "./hand.js";
import { coloursOf } from "./paint.js";
import { cornersOf, isBox, meshGeometry, voxelMesh } from "./shapes.js";
import { isUnseen, kPale } from "./sighting.js";
import { frustumOf, pathOf, solidsOf } from "./surroundings.js";

const kClickSlack = 5;
const kCameraDepth = 0.06;

/// Makes the renderer; if the browser has no WebGL, makes one that draws nothing and says so.
function makeRenderer(canvas) {
  try {
    return new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
  } catch {
    byId("blind").hidden = false;
    const nothing = () => {};
    return { setPixelRatio: nothing, setSize: nothing, setClearColor: nothing, render: nothing,
      getPixelRatio: () => 1, getSize: (size) => size.set(1, 1) };
  }
}

export class World {
  /// onPick receives the id of the clicked object, or null; onDraw is called after each picture.
  constructor(canvas, onPick, onDraw) {
    this.canvas = canvas;
    this.onDraw = onDraw;
    this.renderer = makeRenderer(canvas);
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio || 1, 2));
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(45, 1, 0.01, 100);
    this.parts = {};
    this.lineMaterials = [];
    this.addLights();
    this.watchPointer(onPick);
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    const loop = () => { requestAnimationFrame(loop); this.drawIfDirty(); };
    requestAnimationFrame(loop);
  }

  addLights() {
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8793a0, 0.75));
    this.lamp = new THREE.DirectionalLight(0xffffff, 0.55);
    this.lamp.position.set(0.4, 0.8, 1);
    this.camera.add(this.lamp);
    this.scene.add(this.camera);
  }

  watchPointer(onPick) {
    let down = null;
    this.canvas.addEventListener("pointerdown", (event) => { down = [event.clientX, event.clientY]; });
    this.canvas.addEventListener("click", (event) => {
      const moved = down && Math.hypot(event.clientX - down[0], event.clientY - down[1]) > kClickSlack;
      if (!moved) onPick(this.pick(event.clientX, event.clientY));
    });
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas.parentElement;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
    for (const material of this.lineMaterials) material.resolution.set(width, height);
    this.dirty = true;
  }

  drawIfDirty() {
    if (!this.dirty) return;
    this.dirty = false;
    this.renderer.render(this.scene, this.camera);
    this.onDraw(this);
  }

  /// Replaces the part with this name by another object.
  put(name, object) {
    const old = this.parts[name];
    if (old) {
      this.scene.remove(old);
      old.traverse((part) => {
        if (part.geometry) part.geometry.dispose();
        if (part.material) part.material.dispose();
      });
    }
    this.parts[name] = object;
    if (object) this.scene.add(object);
    this.dirty = true;
  }

  show(scene, view, dark) {
    this.data = scene;
    this.dark = dark;
    this.renderer.setClearColor(this.paper(), 1);
    if (!this.controls || (this.awaitsThings && this.things().length)) this.lookFromSensor();
    this.putCloud(view);
    this.putObjects(view);
    this.putVoxels(view);
    this.putGrasps(view);
    this.putSurroundings(view);
  }

  /// The colour of the background.
  paper() { return this.dark ? 0x121a22 : 0xffffff; }

  putCloud(view) {
    const { positions } = this.data.points;
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
    geometry.setAttribute("color", new THREE.BufferAttribute(this.paint(view.colour), 3));
    const size = 1.7 * this.renderer.getPixelRatio();
    const cloud = new THREE.Points(geometry,
      new THREE.PointsMaterial({ size, sizeAttenuation: false, vertexColors: THREE.VertexColors }));
    cloud.visible = view.layers.cloud;
    this.put("cloud", cloud);
  }

  /// Returns the colours of the cloud's points, which are computed again only if something has
  /// changed.
  paint(by) {
    const key = [by, this.dark];
    const last = this.painted;
    if (last && last.data === this.data && last.key.join() === key.join()) return last.colours;
    const colours = coloursOf(this.data, by, this.dark);
    this.painted = { data: this.data, key, colours };
    return colours;
  }

  putObjects(view) {
    const group = new THREE.Group();
    this.lineMaterials = [];
    const faces = new Set(this.data.objects.flatMap((object) => object.faces || []));
    for (const object of this.data.objects) {
      const layer = isBox(object) ? "boxes" : isPlane(object) ? "planes" : "quadrics";
      if (!view.layers[layer] || (isPlane(object) && faces.has(object.id))) continue;
      const part = this.objectPart(object, object.id === view.chosen);
      if (!part) continue;
      part.userData.id = object.id;
      part.userData.plane = isPlane(object);
      group.add(part);
    }
    this.put("objects", group);
  }

  objectPart(object, chosen) {
    const part = new THREE.Group();
    part.applyMatrix(poseMatrix(object.pose));
    const geometry = isBox(object) ? new THREE.BoxBufferGeometry(...object.size) : meshGeometry(object.mesh);
    if (!geometry) return null;
    const colour = new THREE.Color(objectColour(object));
    const opacity = (isPlane(object) ? (chosen ? 0.35 : 0.1) : chosen ? 0.75 : 0.42) * (isUnseen(object) ? kPale : 1);
    part.add(new THREE.Mesh(geometry, new THREE.MeshLambertMaterial(
      { color: colour, side: THREE.DoubleSide, transparent: true, opacity, depthWrite: false })));
    part.add(this.rims(object, geometry, colour, isPlane(object) ? 1 : chosen ? 4 : 2.6));
    return part;
  }

  rims(object, geometry, colour, linewidth) {
    const ends = [];
    if (isBox(object)) ends.push(...new THREE.EdgesGeometry(geometry).attributes.position.array);
    else for (const i of object.mesh.rims) ends.push(...object.mesh.vertices.subarray(3 * i, 3 * i + 3));
    const material = this.lineMaterial({ linewidth, transparent: true, opacity: isPlane(object) ? 0.7 : 0.95 });
    // These lines are drawn opaque, whatever their opacity.
    material.color = isUnseen(object) ? colour.clone().lerp(new THREE.Color(this.paper()), 1 - kPale) : colour;
    const lines = new THREE.LineSegmentsGeometry();
    lines.setPositions(ends);
    return new THREE.LineSegments2(lines, material);
  }

  putVoxels(view) {
    for (const [layer, colour, opacity] of [["occupied", 0x5b7083, 0.5], ["unknown", 0xb06ae0, 0.14]]) {
      this.put(layer, view.layers[layer] ? voxelMesh(this.data.voxels, layer, colour, opacity) : null);
    }
  }

  putSurroundings(view) {
    const { robot, obstacles, camera, looks } = this.data;
    this.put("robot", view.layers.robot ? solidsOf(robot, 0x7a89a8) : null);
    this.put("obstacles", view.layers.obstacles ? solidsOf(obstacles, 0xb08968) : null);
    const trail = new THREE.Group();
    if (view.layers.camera) {
      if (camera.path.length) trail.add(pathOf(camera.path, 0x5f8fae));
      if (camera.pose) trail.add(frustumOf(camera.pose, kCameraDepth, 0x5f8fae));
    }
    this.put("camera", trail);
    const views = new THREE.Group();
    if (view.layers.looks) for (const { pose } of looks) views.add(frustumOf(pose, kCameraDepth, 0x4f9d76));
    this.put("looks", views);
  }

  putGrasps(view) {
    const { gripper } = this.data;
    const shown = graspsOf(this.data, view.chosen);
    this.put("marks", view.layers.candidates ? this.marks(shown) : null);
    const grasp = shown[Math.min(view.grasp, shown.length - 1)];
    const hand = new THREE.Group();
    if (view.layers.gripper && grasp) {
      if (gripper) hand.add(handAt(grasp, gripper, this.dark));
      hand.add(contactsOf(grasp));
    }
    this.put("hand", hand);
  }

  /// Returns the corners of the box around the drawn hand and its contacts.
  handCorners() {
    const box = new THREE.Box3().setFromObject(this.parts.hand || new THREE.Group());
    if (box.isEmpty()) return [];
    const { min, max } = box;
    return [0, 1, 2, 3, 4, 5, 6, 7].map((c) => new THREE.Vector3(c & 1 ? max.x : min.x, c & 2 ? max.y : min.y,
      c & 4 ? max.z : min.z));
  }

  marks(grasps) {
    const { positions, colours } = marksOf(grasps, (grasp) => scoreColour(grasp.score));
    const lines = new THREE.LineSegmentsGeometry();
    lines.setPositions(positions);
    lines.setColors(colours);
    return new THREE.LineSegments2(lines, this.lineMaterial({ linewidth: 1.8, vertexColors: THREE.VertexColors }));
  }

  lineMaterial(properties) {
    const material = new THREE.LineMaterial(properties);
    const size = this.renderer.getSize(new THREE.Vector2());
    material.resolution.set(size.x, size.y);
    this.lineMaterials.push(material);
    return material;
  }

  /// Returns the object under the pointer; objects take precedence over the planes on which they
  /// stand.
  pick(x, y) {
    const box = this.canvas.getBoundingClientRect();
    const at = new THREE.Vector2(2 * (x - box.left) / box.width - 1, 1 - 2 * (y - box.top) / box.height);
    const ray = new THREE.Raycaster();
    ray.setFromCamera(at, this.camera);
    const meshes = this.parts.objects ? this.parts.objects.children.map((part) => part.children[0]) : [];
    const hits = ray.intersectObjects(meshes).map((hit) => hit.object.parent.userData);
    const best = hits.find((hit) => !hit.plane) || hits[0];
    return best ? best.id : null;
  }

  things() { return this.data.objects.filter((object) => !isPlane(object)); }

  /// Returns the centre of the objects, and their extent around it.
  focus() {
    const box = new THREE.Box3();
    for (const object of this.things()) {
      for (const corner of cornersOf(object)) box.expandByPoint(corner);
    }
    if (box.isEmpty()) box.setFromArray(this.data.points.positions);
    const sphere = box.getBoundingSphere(new THREE.Sphere());
    return { centre: sphere.center, radius: Math.max(sphere.radius, 0.05) };
  }

  /// Returns the upward direction: the normal of the largest plane that does not face the sensor.
  up(ahead) {
    const planes = this.data.objects.filter(isPlane).sort((a, b) => b.inliers - a.inliers);
    for (const plane of planes.slice(0, 3)) {
      const normal = new THREE.Vector3(0, 0, 1).transformDirection(poseMatrix(plane.pose));
      const facing = -normal.dot(ahead);
      if (facing > 0.05 && facing < 0.93) return normal;
    }
    return Math.abs(ahead.z) > 0.6 ? new THREE.Vector3(0, -1, 0) : new THREE.Vector3(0, 0, 1);
  }

  /// Looks from the sensor's position, slightly to the side so that depth is visible.
  lookFromSensor() {
    this.awaitsThings = this.things().length === 0;
    const { centre, radius } = this.focus();
    const ahead = centre.clone().sub(new THREE.Vector3(...this.data.viewpoint)).normalize();
    if (ahead.lengthSq() < 0.5) ahead.set(0, 0, 1);
    const up = this.up(ahead);
    this.lookAlong(ahead.applyAxisAngle(up, -0.35), centre, radius, up);
  }

  lookFrom(side) {
    const { centre, radius } = this.focus();
    const ahead = centre.clone().sub(new THREE.Vector3(...this.data.viewpoint)).normalize();
    const up = this.up(ahead);
    const level = ahead.clone().addScaledVector(up, -ahead.dot(up)).normalize();
    if (side === "top") return this.lookAlong(up.clone().multiplyScalar(-1).addScaledVector(level, 0.02).normalize(), centre, radius, up);
    return this.lookAlong(level.applyAxisAngle(up, Math.PI / 2), centre, radius, up);
  }

  lookAlong(ahead, centre, radius, up) {
    const distance = 1.12 * radius / Math.tan(THREE.Math.degToRad(this.camera.fov / 2));
    this.place(centre.clone().addScaledVector(ahead, -distance).toArray(), centre.toArray(), up.toArray());
  }

  /// Sets the camera's position, its target and the upward direction.
  place(position, target, up) {
    this.camera.up.set(...up);
    this.camera.position.set(...position);
    const distance = Math.max(new THREE.Vector3(...position).distanceTo(new THREE.Vector3(...target)), 1e-3);
    this.camera.near = distance / 200;
    this.camera.far = distance * 60;
    this.camera.updateProjectionMatrix();
    if (this.controls) this.controls.dispose();
    this.controls = new THREE.OrbitControls(this.camera, this.canvas);
    this.controls.enableKeys = false;
    this.controls.screenSpacePanning = true;
    this.controls.zoomSpeed = 0.8;
    this.controls.target.set(...target);
    this.controls.addEventListener("change", () => { this.dirty = true; });
    this.controls.addEventListener("start", () => { this.awaitsThings = false; });
    this.controls.update();
    this.dirty = true;
  }

  /// Forgets the camera's place, so that the next scene gets a new one.
  forgetPlace() {
    if (this.controls) this.controls.dispose();
    this.controls = null;
  }

  /// Returns the parameters for place(), rounded to a tenth of a millimetre.
  placement() {
    const round = (v) => v.toArray().map((value) => Number(value.toFixed(4)));
    return [round(this.camera.position), round(this.controls.target), round(this.camera.up)];
  }

  /// Returns the position of a point on the stage [pixels]; null behind the camera.
  project(point) {
    const p = point.clone().project(this.camera);
    if (p.z > 1 || p.z < -1) return null;
    const { clientWidth: width, clientHeight: height } = this.canvas;
    return [(p.x + 1) / 2 * width, (1 - p.y) / 2 * height];
  }
}
