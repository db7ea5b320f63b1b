// Brings together what the server tells and what the user asks for.
import { isPlane } from "./colours.js";
import { byId } from "./dom.js";
import { Labels } from "./labels.js";
import { readLink, writeLink } from "./link.js";
import { unpack } from "./pack.js";
import { fillDetail, fillHealth, fillList, fillSource, fillSwitches } from "./panel.js";
import { Timeline } from "./timeline.js";
import { World } from "./world.js";

const kMaxScenes = 8;

const view = readLink(location.hash);
const scenes = new Map();
const labels = new Labels(byId("labels"), byId("leaders"));
const world = new World(byId("canvas"), choose, (drawn) => { labels.arrange(drawn); keepLink(); });
let session = null, scene = null, timeline = null, wanted = null;

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

/// Shows the scene anew: after a click, or with other data.
function refresh() {
  document.documentElement.dataset.theme = isDark() ? "dark" : "light";
  fillSwitches(view, refresh);
  if (!scene) return;
  fillSource(scene, session);
  fillList(scene, view, choose);
  fillDetail(scene, view, chooseGrasp);
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

function take(data) {
  scene = data;
  if (!scene.objects.some((object) => object.id === view.chosen)) view.chosen = null;
  if (!world.controls && view.camera) world.place(...view.camera);
  refresh();
  notice("");
}

async function fetchScene(path) {
  const answer = await fetch(path);
  if (!answer.ok) throw new Error((await answer.text()).trim());
  return unpack(await answer.arrayBuffer());
}

/// The scene of one cloud of the log, the last few from memory.
async function sceneOf(frame) {
  if (!scenes.has(frame)) {
    scenes.set(frame, fetchScene(`/api/frames/${frame}`));
    if (scenes.size > kMaxScenes) scenes.delete(scenes.keys().next().value);
  }
  try {
    return await scenes.get(frame);
  } catch (error) {
    scenes.delete(frame);
    throw error;
  }
}

async function go(frame) {
  wanted = frame;
  const slow = setTimeout(() => notice(`working on cloud ${frame + 1} …`), 250);
  try {
    const data = await sceneOf(frame);
    // Somebody scrubbed on meanwhile.
    if (wanted !== frame) return;
    view.frame = frame;
    take(data);
    timeline.show(frame, scene.objects.filter((object) => !isPlane(object)).length);
    document.body.dataset.frame = frame;
  } catch (error) {
    notice(error.message);
  } finally {
    clearTimeout(slow);
  }
}

/// Fetches the newest scene when the server tells of one; while one is fetched others are passed over.
function listen() {
  let shown = 0, busy = false;
  const events = new EventSource("/api/events");
  const follow = async (version) => {
    if (busy || version === shown) return;
    busy = true;
    try {
      take(await fetchScene("/api/newest"));
      shown = version;
      document.body.dataset.version = version;
    } catch (error) {
      notice(error.message);
    }
    busy = false;
  };
  events.onmessage = (event) => {
    const news = JSON.parse(event.data);
    fillHealth(news.status);
    if (news.version === 0) notice("no quadrics and no clouds have come yet; is the detector running?");
    else follow(news.version);
  };
  events.onerror = () => notice("the connection to quadrille view is lost; it is tried again");
}

function nextObject() {
  const things = scene.objects.filter((object) => !isPlane(object));
  if (things.length === 0) return;
  const at = things.findIndex((object) => object.id === view.chosen);
  choose(things[(at + 1) % things.length].id);
}

function nextGrasp() {
  const count = scene.grasps.filter((grasp) => view.chosen === null || grasp.target === view.chosen).length;
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
    const typing = event.target.id === "scrub" || (event.key === " " && event.target.tagName === "BUTTON");
    if (!act || typing || event.ctrlKey || event.metaKey || event.altKey || !scene) return;
    event.preventDefault();
    act();
  });
  byId("theme").addEventListener("click", switchTheme);
  prefersDark.addEventListener("change", refresh);
}

async function start() {
  watchKeys();
  refresh();
  session = await (await fetch("/api/session")).json();
  if (session.mode !== "log") return listen();
  timeline = new Timeline(session.frames, go);
  await go(Math.min(view.frame, session.frames.length - 1));
}

start().catch((error) => notice(error.message));
