// The user's questions: how to plan on a log, and which grasps to request from the robot's planner.
import { isPlane } from "./colours.js";
import { byId, element } from "./dom.js";

const kMaxClearance = 30;

/// Makes the controls for gripper, unknown space and clearance of a log's plans; change is called
/// after each choice. Values from a link that this log does not offer are dropped.
export function makeChoices(session, view, change) {
  if (!session.grippers) return;
  if (!session.grippers.includes(view.plan.gripper)) view.plan.gripper = "";
  if (!session.policies.includes(view.plan.unknown)) view.plan.unknown = "";
  if (!(Number(view.plan.clearance) >= 0 && Number(view.plan.clearance) <= kMaxClearance)) view.plan.clearance = "";
  const labelled = (text, field) => element("label", {}, [element("span", { text }), field]);
  const choose = (name) => (event) => { view.plan[name] = event.target.value; change(); };
  const menu = (name, options) => element("select", { id: `choice-${name}`, onchange: choose(name) },
    options.map((option) => element("option", { text: option, value: option })));
  byId("choices").replaceChildren(
    labelled("gripper", menu("gripper", session.grippers)),
    labelled("unknown space", menu("unknown", session.policies)),
    labelled("clearance, mm", clearanceField("choice-clearance", view.plan.clearance, choose("clearance"))));
}

/// Shows the settings with which the scene was planned.
export function showChoices(scene, session) {
  if (!session.grippers) return;
  byId("choice-gripper").value = scene.gripper_name;
  byId("choice-unknown").value = scene.unknown;
}

/// The questions and answers of a page, the latest one for each object.
export class Answers {
  constructor() { this.known = new Map(); }

  /// Returns the key of an object. A surface with a track is the same one in later clouds; others
  /// are known only in their own cloud.
  key(object, scene) { return object.track > 0 ? `track ${object.track}` : `${object.id} of ${scene.utime}`; }

  of(object, scene) { return this.known.get(this.key(object, scene)); }

  /// Asks the source for grasps of an object; change is called when the state of the question
  /// changes.
  async ask(object, scene, view, source, change) {
    const asked = { state: "planning …", utime: scene.utime };
    this.known.set(this.key(object, scene), asked);
    change();
    try {
      asked.answer = await source.ask(questionOf(object, scene, view));
      asked.state = `planned on request, on the cloud of ${(asked.utime / 1e6).toFixed(3)} s`;
    } catch (error) {
      asked.state = error.message;
    }
    change();
  }

  /// Replaces the grasps and refusals of a new scene by the answers for their objects, unless the
  /// planner has by itself planned on a later cloud.
  addTo(scene) {
    for (const object of scene.objects) {
      const asked = this.of(object, scene);
      if (!asked || !asked.answer) continue;
      const replaced = scene.utime > asked.utime && scene.grasps.some((grasp) => grasp.target === object.id);
      if (replaced) this.known.delete(this.key(object, scene));
      else addAnswer(scene, object, asked.answer);
    }
  }
}

function addAnswer(scene, object, answer) {
  const grasps = answer.grasps.map((grasp) => ({ ...grasp, target: object.id }));
  scene.grasps = [...grasps, ...scene.grasps.filter((grasp) => grasp.target !== object.id)];
  object.rejected = answer.rejected;
  scene.remedies = [...scene.remedies.filter((remedy) => remedy.target !== object.id),
    ...answer.remedies.map((remedy) => ({ ...remedy, target: object.id }))];
  scene.looks = answer.looks;
  object.answered = answer.warnings;
  scene.gripper = answer.gripper || scene.gripper;
}

/// Makes the part of an object's details that asks the planner for grasps on it.
export function askParts(object, session, view, asked, ask) {
  if (session.mode !== "live" || isPlane(object)) return [];
  if (!session.requests) {
    return [element("p", { text: "Grasps can be asked for here after quadrille view --allow-requests." })];
  }
  const clearance = clearanceField("ask-clearance", view.clearance, (event) => { view.clearance = event.target.value; });
  const button = element("button", { id: "ask", text: "Plan for this object", onclick: () => ask(object) });
  return [element("div", { class: "row" }, [button,
    element("label", {}, [element("span", { text: "clearance, mm" }), clearance])]),
    element("p", { id: "asked", text: asked ? asked.state : "" })];
}

/// Makes the field for the clearance. The browser refuses anything but a number from 0 to 30, and
/// the last valid value is restored.
function clearanceField(id, value, onchange) {
  const field = element("input", { type: "number", min: 0, max: kMaxClearance, step: 1, id, value: value || 0, required: "" });
  let last = field.value;
  field.addEventListener("change", (event) => {
    if (!field.reportValidity()) { field.value = last; return; }
    last = field.value;
    onchange(event);
  });
  return field;
}

function questionOf(object, scene, view) {
  const clearance = { clearance: Number(view.clearance) || 0 };
  if (object.track > 0) return { track: object.track, ...clearance };
  return { target: object.id, cloud_utime: scene.utime, ...clearance };
}
