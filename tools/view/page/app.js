// Connects the data from the server with the controls of the user.
import { isPlane } from "./colours.js";
import { byId } from "./dom.js";
import { graspsOf } from "./grasps_of.js";
import { Labels } from "./labels.js";
import { readLink, writeLink } from "./link.js";
import { fillDetail, fillHealth, fillList, fillSource, fillSwitches } from "./panel.js";
import { Answers, askParts, makeChoices, showChoices } from "./questions.js";
import { fillReport } from "./report.js";
import { openSource } from "./source.js";
import { Timeline } from "./timeline.js";
import { World } from "./world.js";

const kMaxScenes = 8;
const kNothing = "no quadrics and no clouds have come yet; is the detector running, and a camera?";

const view = readLink(location.hash);
const source = openSource();
const scenes = new Map();
const labels = new Labels(byId("labels"), byId("leaders"));
const world = new World(byId("canvas"), choose, (drawn) => { labels.arrange(drawn); keepLink(); });
let session = null, scene = null, timeline = null, wanted = null, going = null;
const answers = new Answers();

const prefersDark = matchMedia("(prefers-color-scheme: dark)");
const isDark = () => (view.theme ? view.theme === "dark" : prefersDark.matches);

function notice(text) { byId("notice").textContent = text; }

let linkTimer = 0;
function keepLink() {
  clearTimeout(linkTimer);
  linkTimer = setTimeout(() => {
    if (scene && world.controls) history.replaceState(null, "", writeLink(view, world.placement()));
  }, 300);
}

/// True while a pointer is pressed in the panel. The panel must not be rebuilt then: a button that
/// is replaced between press and release would not be clicked, and a field would lose its text.
let pressed = false;
const panelIsUsed = () => pressed || document.activeElement?.id === "ask-clearance";

function watchPanel() {
  byId("panel").addEventListener("pointerdown", () => { pressed = true; });
  for (const end of ["pointerup", "pointercancel"]) {
    // The timeout runs after the click that a release causes.
    window.addEventListener(end, () => setTimeout(() => { pressed = false; }));
  }
}

/// Keeps the keyboard focus, even though the focused element is rebuilt.
function keepFocus(fill) {
  const { id, dataset } = document.activeElement || document.body;
  fill();
  const same = id ? byId(id) : dataset.object && document.querySelector(`[data-object="${dataset.object}"]`);
  if (same && document.activeElement === document.body) same.focus({ preventScroll: true });
}

function fillPanel() {
  fillSwitches(view, refresh, scene);
  fillSource(scene, session);
  fillList(scene, view, choose);
  showChoices(scene, session);
  fillDetail(scene, view, chooseGrasp, (object) => askParts(object, session, view, answers.of(object, scene), ask));
}

/// Redraws the scene after a click, or with new data. Redrawing the panel for new data can wait
/// until the user has let go of it.
function refresh(canWait = false) {
  document.documentElement.dataset.theme = isDark() ? "dark" : "light";
  if (!scene) return;
  if (!canWait || !panelIsUsed()) keepFocus(fillPanel);
  labels.show(scene, view);
  world.show(scene, view, isDark());
  keepLink();
}

function choose(id) {
  view.chosen = id;
  view.grasp = 0;
  refresh();
}

function chooseGrasp(number) {
  view.grasp = number;
  refresh();
}

/// Plans again on the log, with the user's choice.
function replan() {
  scenes.clear();
  go(view.frame);
}

function ask(object) {
  answers.ask(object, scene, view, source, () => { answers.addTo(scene); refresh(); });
}

function take(data) {
  scene = data;
  answers.addTo(scene);
  if (!scene.objects.some((object) => object.id === view.chosen)) view.chosen = null;
  if (!world.controls && view.camera) world.place(...view.camera);
  view.camera = null;
  refresh(true);
}

/// Returns the scene of one cloud of the log; the last few are kept in memory.
async function sceneOf(frame) {
  if (!scenes.has(frame)) {
    scenes.set(frame, source.frame(frame, view.plan));
    if (scenes.size > kMaxScenes) scenes.delete(scenes.keys().next().value);
  }
  try {
    return await scenes.get(frame);
  } catch (error) {
    scenes.delete(frame);
    throw error;
  }
}

/// Shows a cloud of the log. Only one is fetched at a time, followed by the one that was requested
/// last. Resolves to whether the cloud is shown.
async function go(frame) {
  wanted = { frame };
  const mine = wanted;
  while (going) await going;
  if (wanted !== mine) return true;
  going = show(wanted);
  const shown = await going;
  going = null;
  return shown;
}

async function show({ frame }) {
  const slow = setTimeout(() => notice(`working on cloud ${frame + 1} …`), 250);
  try {
    const data = await sceneOf(frame);
    // The clouds of a report have nothing in common, so each gets its own viewpoint.
    if (session.names && scene && view.frame !== frame) world.forgetPlace();
    view.frame = frame;
    take(data);
    notice("");
    timeline.show(frame, scene.objects.filter((object) => !isPlane(object)).length);
    document.body.dataset.frame = frame;
    return true;
  } catch (error) {
    notice(error.message);
    return false;
  } finally {
    clearTimeout(slow);
  }
}

/// Fetches the newest scene when the server announces one; announcements during a fetch are
/// skipped.
function listen() {
  let shown = 0, busy = false;
  const follow = async (version) => {
    if (busy || version === shown) return;
    busy = true;
    try {
      take(await source.newest());
      notice(scene.points.total || scene.objects.length ? "" : scene.warnings[0] || kNothing);
      shown = version;
      document.body.dataset.version = version;
    } catch (error) {
      notice(error.message);
    }
    busy = false;
  };
  source.listen(({ version, status }) => {
    fillHealth(status);
    if (version === 0) notice(kNothing);
    else follow(version);
  }, () => notice("the connection to quadrille view is lost; it is tried again"));
}

function nextObject() {
  const things = scene.objects.filter((object) => !isPlane(object));
  if (things.length === 0) return;
  const at = things.findIndex((object) => object.id === view.chosen);
  choose(things[(at + 1) % things.length].id);
}

function nextGrasp() {
  const count = graspsOf(scene, view.chosen).length;
  if (count) chooseGrasp((view.grasp + 1) % count);
}

function switchTheme() {
  view.theme = isDark() ? "light" : "dark";
  refresh();
}

const kKeys = {
  " ": () => timeline && timeline.toggle(),
  ArrowLeft: () => timeline && timeline.step(-1),
  ArrowRight: () => timeline && timeline.step(1),
  0: () => world.lookFromSensor(),
  v: () => world.lookFrom("top"),
  s: () => world.lookFrom("side"),
  n: nextObject,
  g: nextGrasp,
  t: switchTheme,
  Escape: () => choose(null),
};

function watchKeys() {
  document.addEventListener("keydown", (event) => {
    const act = kKeys[event.key];
    const typing = ["INPUT", "SELECT"].includes(event.target.tagName) || (event.key === " " && event.target.tagName === "BUTTON");
    if (!act || typing || event.ctrlKey || event.metaKey || event.altKey || !scene) return;
    event.preventDefault();
    act();
  });
  byId("theme").addEventListener("click", switchTheme);
  prefersDark.addEventListener("change", () => refresh());
  // The user pasted another link; changes of the address by the page itself cause no such event.
  window.addEventListener("hashchange", () => location.reload());
}

async function start() {
  watchKeys();
  watchPanel();
  fillSwitches(view, refresh);
  refresh();
  session = await source.session();
  makeChoices(session, view, replan);
  if (session.mode === "live") return listen();
  if (session.mode === "report") fillReport(session);
  timeline = new Timeline(session.frames, go, session.names);
  view.frame = Math.max(0, Math.min(view.frame, session.frames.length - 1));
  if (session.frames.length) await go(view.frame);
}

start().catch((error) => notice(error.message));
