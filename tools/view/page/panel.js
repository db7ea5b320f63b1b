// The panel: the switches, the list of objects, and the grasps and refusals of a chosen object.
import { isPlane, objectColour, scoreColour } from "./colours.js";
import { byId, element, words } from "./dom.js";
import { graspsOf } from "./grasps_of.js";
import { kColours, kLayers } from "./link.js";
import { isUnseen, lastSeen, viewsOf } from "./sighting.js";

const kMaxRows = 20;
const mm = (metres) => (1000 * metres).toFixed(0);

/// The layers that few scenes have.
const kRare = {
  robot: (scene) => scene.robot.length > 0,
  obstacles: (scene) => scene.obstacles.length > 0,
  camera: (scene) => scene.camera.pose || scene.camera.path.length > 0,
  looks: (scene) => scene.looks.length > 0,
};

/// Makes the buttons for colours and layers, without those for what the scene does not have. change
/// is called after each click.
export function fillSwitches(view, change, scene = null) {
  const colours = kColours.filter((colour) => colour !== "own" || (scene && scene.points.colours));
  const layers = kLayers.filter((layer) => !kRare[layer] || (scene && kRare[layer](scene)));
  const shown = colours.includes(view.colour) ? view.colour : "object";
  byId("colours").replaceChildren(...colours.map((colour) => element("button", {
    text: colour === "own" ? "by own colour" : `by ${colour}`, role: "radio", "aria-checked": String(shown === colour), id: `colour-${colour}`,
    onclick: () => { view.colour = colour; change(); } })));
  byId("layers").replaceChildren(...layers.map((layer) => element("button", {
    text: layer, "aria-pressed": String(view.layers[layer]), id: `layer-${layer}`,
    onclick: () => { view.layers[layer] = !view.layers[layer]; change(); } })));
}

const nameOf = (path) => path.split("/").pop();

/// A scene without a cloud has a warning that says why.
const countPoints = ({ positions, total }) => (total ? `${positions.length / 3} of ${total} points` : "no cloud is shown");

export function fillSource(scene, session) {
  const time = scene.utime ? ` · ${(scene.utime / 1e6).toFixed(3)} s` : "";
  const times = Object.entries(scene.timings).map(([stage, ms]) => `${words(stage.replace(/_ms$/, ""))} ${ms.toFixed(0)} ms`);
  byId("source").replaceChildren(
    element("span", { text: `${session.mode === "live" ? "live" : nameOf(session.name)}${scene.frame && ` · frame ${scene.frame}`}${time}` }),
    element("br"),
    element("span", { text: [countPoints(scene.points), ...times].join(" · ") }),
    ...scene.notes.map((note) => element("div", { text: note })),
    ...[session.warning || [], scene.warnings].flat().map((warning) => element("div", { class: "warning", text: warning })));
}

const isPlanned = (scene, object) => Boolean(object && object.rejected) || Boolean(scene.gripper_name);

function countOf(scene, object, count) {
  if (count === 0) return isPlanned(scene, object) ? "no grasp" : "not planned";
  return count === 1 ? "1 grasp" : `${count} grasps`;
}

export function fillList(scene, view, choose) {
  const rows = [[], []];
  for (const object of scene.objects) {
    const count = graspsOf(scene, object.id).length;
    const dot = element("span", { class: "dot" });
    dot.style.background = objectColour(object);
    const facts = object.lines.slice(0, 2).concat(isUnseen(object) ? `seen ${lastSeen(object)}` : []);
    const side = isPlane(object) ? "" : countOf(scene, object, count);
    rows[isPlane(object) ? 1 : 0].push(element("button", {
      class: isUnseen(object) ? "item unseen" : "item", "aria-pressed": String(object.id === view.chosen), "data-object": object.id,
      onclick: () => choose(object.id === view.chosen ? null : object.id) }, [
      dot,
      element("span", { text: `${object.id} ${words(object.type)}` }, [
        element("small", { text: facts.join(", ") })]),
      element("span", { class: count ? "side" : "side none", text: side })]));
  }
  const none = element("p", { text: "No object was found in this cloud." });
  byId("list").replaceChildren(element("h2", { text: `Objects (${rows[0].length})` }),
    ...(rows[0].length ? rows[0] : [none]));
  byId("planes").hidden = rows[1].length === 0;
  byId("planes-title").textContent = `Planes (${rows[1].length})`;
  byId("planes-list").replaceChildren(...rows[1]);
}

/// Shows the details of the chosen object. askParts(object) makes the controls that ask for more
/// grasps of it.
export function fillDetail(scene, view, chooseGrasp, askParts) {
  const object = scene.objects.find((candidate) => candidate.id === view.chosen);
  const grasps = graspsOf(scene, object ? object.id : null);
  const parts = object ? factsOf(object) : looksOf(scene);
  if (!object || !isPlane(object)) {
    parts.push(element("h2", { text: object ? `Grasps of ${object.id} (${grasps.length})` : `All grasps (${grasps.length})` }));
    if (object) parts.push(...askParts(object));
    for (const warning of (object && object.answered) || []) parts.push(element("div", { class: "warning", text: warning }));
    parts.push(grasps.length ? graspTable(grasps, view, chooseGrasp)
      : element("p", { text: isPlanned(scene, object) ? "No grasp was found." : "No grasps were planned here." }));
    parts.push(...remediesOf(object, scene));
    parts.push(...refusals(object ? object.rejected : scene.rejected, object));
  }
  byId("detail").replaceChildren(...parts);
}

function factsOf(object) {
  const facts = object.score === undefined ? [] : [["certain", `${(100 * object.score).toFixed(0)} %`]];
  if (object.part_of !== undefined) facts.push(["part of", object.part_of]);
  if (object.track) facts.push(["track", object.track]);
  for (const line of object.lines) {
    const [, name, value] = line.match(/^(\D*?) (\S*\d.*)$/) || ["", line, ""];
    facts.push([name, value]);
  }
  facts.push(...viewsOf(object));
  if (object.rms !== undefined) facts.push(["points", object.inliers], ["spread", `${(1000 * object.rms).toFixed(2)} mm`],
    ["seen", `${(100 * object.seen).toFixed(0)} %`]);
  const list = element("dl", {}, facts.flatMap(([name, value]) =>
    [element("dt", { text: name }), element("dd", { text: value })]));
  return [element("h2", { text: `${object.id} ${words(object.type)}` }), list];
}

/// Lists the views that would help.
function looksOf({ looks }) {
  if (looks.length === 0) return [];
  return [element("h2", { text: `Proposed views (${looks.length})` }), ...looks.map(({ bodies }) =>
    element("p", { class: "look", text: `look from here: likely helps ${bodies.length === 1 ? "1 body" : `${bodies.length} bodies`}` }))];
}

function graspTable(grasps, view, chooseGrasp) {
  const tried = grasps.some((grasp) => grasp.outcome);
  const head = element("tr", {}, ["kind", "score", "width", "clear", "µ", ...(tried ? ["tried"] : [])].map((text) => element("th", { text })));
  const rows = grasps.slice(0, kMaxRows).map((grasp, i) => {
    const score = element("td", { text: grasp.score.toFixed(2) });
    score.style.color = `rgb(${scoreColour(grasp.score).map((value) => Math.round(210 * value)).join(",")})`;
    return element("tr", { class: "grasp", tabindex: 0, "aria-selected": String(i === view.grasp),
      onclick: () => chooseGrasp(i), onkeydown: (event) => { if (event.key === "Enter") chooseGrasp(i); } }, [
      element("td", { text: view.chosen === null ? `${grasp.kind} ${grasp.target}` : grasp.kind }), score,
      element("td", { text: `${mm(grasp.width)} mm` }), element("td", { text: `${mm(grasp.clearance)} mm` }),
      element("td", { text: grasp.friction_needed.toFixed(2) }),
      ...(tried ? [element("td", { text: words(grasp.outcome || "") })] : [])]);
  });
  const table = element("table", {}, [head, ...rows]);
  if (grasps.length <= kMaxRows) return table;
  return element("div", {}, [table, element("p", { text: `and ${grasps.length - kMaxRows} more` })]);
}

function refusals(rejected, object) {
  if (!rejected || rejected.length === 0) return [];
  const most = Math.max(...rejected.map(({ count }) => count));
  const title = object ? `Why others were refused, those that got furthest first` : `Refused, of all targets`;
  return [element("h2", { text: title }), ...rejected.map(({ reason, count, help }) => {
    const fill = element("i");
    fill.style.width = `${100 * count / most}%`;
    return element("div", { class: "reason" }, [
      element("div", {}, [element("span", { text: words(reason) }), element("span", { text: count })]),
      element("div", { class: "bar" }, [fill]),
      element("p", { text: help })]);
  })];
}

/// Lists the changes of a setting with which an object has grasps; without an object, those with
/// which there is something to grasp at all, which have no target.
function remediesOf(object, scene) {
  const own = scene.remedies.filter((remedy) => remedy.target === (object ? object.id : 0));
  if (own.length === 0) return [];
  return [element("h2", { text: "What gives grasps" }), element("dl", {},
    own.flatMap(({ change, grasps, score }) => [element("dt", { text: change }),
      element("dd", { text: `${grasps === 1 ? "1 grasp" : `${grasps} grasps`}, best score ${score.toFixed(2)}` })]))];
}

/// Shows rate, latency and losses of the processes.
export function fillHealth(status) {
  const parts = [];
  for (const [process, figures] of Object.entries(status)) {
    parts.push(element("h2", { text: process }));
    parts.push(element("dl", {}, (figures.facts || []).flatMap(([name, value]) =>
      [element("dt", { text: name }), element("dd", { text: value })])));
    for (const warning of figures.warnings || []) parts.push(element("div", { class: "warning", text: warning }));
  }
  byId("health").replaceChildren(...parts);
}
