// Places labels beside the objects, without overlap, each with a line to its object.
import { isPlane, objectColour } from "./colours.js";
import { element, words } from "./dom.js";
import { cornersOf } from "./shapes.js";
import { isUnseen, lastSeen } from "./sighting.js";

const kGap = 10, kMargin = 6;

export class Labels {
  constructor(layer, leaders) {
    this.layer = layer;
    this.leaders = leaders;
    this.labels = [];
  }

  show(scene, view) {
    this.layer.replaceChildren();
    this.labels = [];
    if (!view.layers.labels) return this.leaders.replaceChildren();
    for (const object of scene.objects) {
      if (isPlane(object) && object.id !== view.chosen) continue;
      const track = object.track ? ` · track ${object.track}` : "";
      const lines = object.lines.slice(0, 3).concat(isUnseen(object) ? `seen ${lastSeen(object)}` : []);
      const names = ["label", object.id === view.chosen && "chosen", isUnseen(object) && "unseen"];
      const box = element("div", { class: names.filter(Boolean).join(" ") }, [
        element("b", { text: `${object.id} ${words(object.type)}` }),
        element("span", { text: track }),
        ...lines.map((line) => element("small", { text: line }))]);
      box.style.borderLeftColor = objectColour(object);
      this.layer.append(box);
      this.labels.push({ object, box, corners: cornersOf(object), size: null });
    }
  }

  /// Finds a place for each label, given the current camera.
  arrange(world) {
    const stage = { width: this.layer.clientWidth, height: this.layer.clientHeight };
    const shown = [];
    for (const label of this.labels) {
      label.size = label.size || { width: label.box.offsetWidth, height: label.box.offsetHeight };
      label.outline = outlineOf(label.corners, world);
      const visible = label.outline && overlaps(label.outline, { left: 0, top: 0, right: stage.width, bottom: stage.height });
      label.box.style.visibility = visible ? "visible" : "hidden";
      if (visible) shown.push(label);
    }
    shown.sort((a, b) => a.outline.top - b.outline.top);
    const placed = [], lines = [];
    const hands = [outlineOf(world.handCorners(), world)].filter(Boolean);
    for (const label of shown) {
      const spot = bestSpot(label, [...shown.map((other) => other.outline), ...hands], placed, stage);
      placed.push(spot);
      label.box.style.transform = `translate(${Math.round(spot.left)}px, ${Math.round(spot.top)}px)`;
      lines.push(...leaderOf(label, spot));
    }
    this.leaders.replaceChildren(...lines);
  }
}

function outlineOf(corners, world) {
  const points = corners.map((corner) => world.project(corner)).filter(Boolean);
  if (points.length === 0) return null;
  const xs = points.map((p) => p[0]), ys = points.map((p) => p[1]);
  return { left: Math.min(...xs), right: Math.max(...xs), top: Math.min(...ys), bottom: Math.max(...ys) };
}

const overlaps = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

function common(a, b) {
  const width = Math.min(a.right, b.right) - Math.max(a.left, b.left);
  const height = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
  return width > 0 && height > 0 ? width * height : 0;
}

/// Returns the place around an object that covers least; nearer places are tried first.
function bestSpot(label, things, placed, stage) {
  const { outline, size } = label;
  let best = null;
  for (const away of [kGap, 30, 60, 100, 150, 220]) {
    for (let step = 0; step < 16; ++step) {
      const angle = -Math.PI / 2 + (step % 2 ? -1 : 1) * Math.ceil(step / 2) * Math.PI / 8;
      const x = (outline.left + outline.right) / 2 + Math.cos(angle) * ((outline.right - outline.left + size.width) / 2 + away);
      const y = (outline.top + outline.bottom) / 2 + Math.sin(angle) * ((outline.bottom - outline.top + size.height) / 2 + away);
      const spot = clamp({ left: x - size.width / 2, top: y - size.height / 2 }, size, stage);
      let cost = away + 4 * step;
      for (const other of placed) cost += 20 * common(grown(spot), other);
      for (const thing of things) cost += 0.25 * common(spot, thing);
      if (!best || cost < best.cost) best = { ...spot, cost };
    }
  }
  return best;
}

const grown = (box) => ({ left: box.left - 3, top: box.top - 3, right: box.right + 3, bottom: box.bottom + 3 });

function clamp(spot, size, stage) {
  const left = Math.min(Math.max(spot.left, kMargin), Math.max(stage.width - size.width - kMargin, kMargin));
  const top = Math.min(Math.max(spot.top, kMargin), Math.max(stage.height - size.height - kMargin, kMargin));
  return { left, top, right: left + size.width, bottom: top + size.height };
}

/// Draws the line from the edge of the label towards the object's middle, up to its outline.
function leaderOf(label, spot) {
  const { outline, object } = label;
  const middle = [(outline.left + outline.right) / 2, (outline.top + outline.bottom) / 2];
  const from = [Math.min(Math.max(middle[0], spot.left), spot.right), Math.min(Math.max(middle[1], spot.top), spot.bottom)];
  const to = [from[0] + 0.75 * (middle[0] - from[0]), from[1] + 0.75 * (middle[1] - from[1])];
  const svg = (tag, attributes) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    return made;
  };
  const colour = objectColour(object);
  return [svg("line", { x1: from[0], y1: from[1], x2: to[0], y2: to[1], stroke: colour }),
    svg("circle", { cx: to[0], cy: to[1], r: 3, fill: colour })];
}
