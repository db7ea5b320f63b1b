// What the user asks: how to plan on a log, and grasps of one object from the robot's planner.
import { isPlane } from "./colours.js";
import { byId, element } from "./dom.js";

/// Gripper, unknown space and clearance of a log's plans; change is called after each choice.
export function makeChoices(session, view, change) {
  if (!session.grippers) return;
  const labelled = (text, field) => element("label", {}, [element("span", { text }), field]);
  const choose = (name) => (event) => { view.plan[name] = event.target.value; change(); };
  const menu = (name, options) => element("select", { id: `choice-${name}`, onchange: choose(name) },
    options.map((option) => element("option", { text: option, value: option })));
  byId("choices").replaceChildren(
    labelled("gripper", menu("gripper", session.grippers)),
    labelled("unknown space", menu("unknown", session.policies)),
    labelled("clearance, mm", clearanceField("choice-clearance", view.plan.clearance, choose("clearance"))));
}

/// Shows with what the scene was planned.
export function showChoices(scene, session) {
  if (!session.grippers) return;
  byId("choice-gripper").value = scene.gripper_name;
  byId("choice-unknown").value = scene.unknown;
}

/// The part of an object's detail that asks the planner for grasps on it.
export function askParts(object, session, view, ask) {
  if (session.mode !== "live" || isPlane(object)) return [];
  if (!session.requests) {
    return [element("p", { text: "Grasps can be asked for here after quadrille view --allow-requests." })];
  }
  const clearance = clearanceField("ask-clearance", view.clearance, (event) => { view.clearance = event.target.value; });
  return [element("div", { class: "row" }, [
    element("button", { id: "ask", text: "Plan for this object", onclick: () => ask(object) }),
    element("label", {}, [element("span", { text: "clearance, mm" }), clearance])])];
}

function clearanceField(id, value, onchange) {
  return element("input", { type: "number", min: 0, max: 30, step: 1, id, value: value || 0, onchange });
}

export function questionOf(object, scene, view) {
  const clearance = { clearance: Number(view.clearance) || 0 };
  if (object.track > 0) return { track: object.track, ...clearance };
  return { target: object.id, cloud_utime: scene.utime, ...clearance };
}

const isSame = (object, asked) => (asked.track > 0 ? object.track === asked.track : object.id === asked.id);

/// Puts the planner's answer for one object in the place of what the scene says of that object.
export function addAnswer(scene, asked, answer) {
  const object = scene.objects.find((candidate) => isSame(candidate, asked));
  if (!object) return;
  const grasps = answer.grasps.map((grasp) => ({ ...grasp, target: object.id }));
  scene.grasps = [...grasps, ...scene.grasps.filter((grasp) => grasp.target !== object.id)];
  object.rejected = answer.rejected;
  object.answered = answer.warnings;
  scene.gripper = answer.gripper || scene.gripper;
}
