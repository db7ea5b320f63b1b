// Keeps the current view in the fragment of the address, so that a copied link restores it.

export const kLayers = ["cloud", "quadrics", "boxes", "planes", "labels", "gripper", "candidates", "occupied", "unknown",
  "robot", "obstacles", "camera", "looks"];
export const kColours = ["object", "depth", "normal", "own"];
const kHidden = ["occupied", "unknown"];

export function firstView() {
  const layers = Object.fromEntries(kLayers.map((layer) => [layer, !kHidden.includes(layer)]));
  return { frame: 0, chosen: null, grasp: 0, colour: "object", layers, theme: null, camera: null,
    plan: { gripper: "", unknown: "", clearance: "" } };
}

export function readLink(fragment) {
  const view = firstView();
  const given = new URLSearchParams(fragment.replace(/^#/, ""));
  const whole = (name) => (/^\d{1,9}$/.test(given.get(name) || "") ? Number(given.get(name)) : null);
  view.frame = whole("frame") || 0;
  view.chosen = whole("object");
  view.grasp = whole("grasp") || 0;
  if (kColours.includes(given.get("colour"))) view.colour = given.get("colour");
  if (given.has("layers")) {
    const on = given.get("layers").split(".");
    for (const layer of kLayers) view.layers[layer] = on.includes(layer);
  }
  if (["light", "dark"].includes(given.get("theme"))) view.theme = given.get("theme");
  for (const name of Object.keys(view.plan)) view.plan[name] = (given.get(name) || "").slice(0, 100);
  const numbers = (given.get("camera") || "").split("_").map(Number);
  if (numbers.length === 9 && numbers.every(Number.isFinite)) {
    view.camera = [numbers.slice(0, 3), numbers.slice(3, 6), numbers.slice(6)];
  }
  return view;
}

export function writeLink(view, camera) {
  const given = new URLSearchParams();
  if (view.frame) given.set("frame", view.frame);
  if (view.chosen !== null) given.set("object", view.chosen);
  if (view.grasp) given.set("grasp", view.grasp);
  given.set("colour", view.colour);
  given.set("layers", kLayers.filter((layer) => view.layers[layer]).join("."));
  if (view.theme) given.set("theme", view.theme);
  for (const [name, value] of Object.entries(view.plan)) if (value) given.set(name, value);
  if (camera) given.set("camera", camera.flat().join("_"));
  return "#" + given.toString();
}
