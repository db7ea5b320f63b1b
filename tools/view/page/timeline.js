// The timeline of a log's clouds: step, play and scrub, with a mark for the number of objects in
// each cloud.
import { byId } from "./dom.js";

const kMinDelay = 60, kMaxDelay = 1000;

export class Timeline {
  /// go is called with the number of a cloud and resolves to whether it is shown. names are the
  /// names of clouds that do not come from a log, and so have no order in time.
  constructor(utimes, go, names) {
    this.utimes = utimes;
    this.names = names;
    this.go = go;
    this.frame = 0;
    this.wanted = 0;
    this.playing = false;
    this.found = new Map();
    byId("timeline").hidden = utimes.length < 2 && Boolean(names);
    this.scrub = byId("scrub");
    this.scrub.max = utimes.length - 1;
    this.scrub.addEventListener("input", () => { this.stop(); this.go(Number(this.scrub.value)); });
    byId("back").addEventListener("click", () => this.step(-1));
    byId("forward").addEventListener("click", () => this.step(1));
    byId("play").addEventListener("click", () => this.toggle());
    this.drawMarks();
  }

  show(frame, found) {
    this.frame = this.wanted = frame;
    this.found.set(frame, found);
    this.scrub.value = frame;
    const seconds = (this.utimes[frame] - this.utimes[0]) / 1e6;
    const what = this.names ? this.names[frame] : `${seconds.toFixed(2)} s`;
    byId("time").textContent = `cloud ${frame + 1} of ${this.utimes.length} · ${what}`;
    this.drawMarks();
  }

  /// Draws a bar for each cloud, as high as its number of objects; grey if the cloud was not shown
  /// yet.
  drawMarks() {
    const marks = byId("marks"), count = this.utimes.length, most = Math.max(1, ...this.found.values());
    const width = Math.min(0.8, count / 80);
    marks.setAttribute("viewBox", `0 0 ${count} 16`);
    marks.setAttribute("preserveAspectRatio", "none");
    marks.replaceChildren(...this.utimes.slice(0, 2000).map((_, i) => {
      const known = this.found.has(i), height = known ? 3 + 13 * this.found.get(i) / most : 3;
      const bar = document.createElementNS("http://www.w3.org/2000/svg", "rect");
      for (const [name, value] of Object.entries({ x: i + 0.5 - width / 2, y: 16 - height, width, height })) bar.setAttribute(name, value);
      if (known) bar.setAttribute("class", "known");
      return bar;
    }));
  }

  step(by) {
    this.stop();
    this.wanted = Math.min(Math.max(this.wanted + by, 0), this.utimes.length - 1);
    return this.go(this.wanted);
  }

  toggle() {
    if (this.playing) return this.stop();
    this.playing = true;
    byId("play").textContent = "❚❚";
    this.play();
  }

  stop() {
    this.playing = false;
    byId("play").textContent = "▶";
  }

  /// Plays at the log's own pace, or as fast as scenes come.
  async play() {
    while (this.playing) {
      const next = (this.frame + 1) % this.utimes.length;
      const delay = (this.utimes[next] - this.utimes[this.frame]) / 1000;
      const wait = this.names ? kMaxDelay : Math.min(Math.max(delay, kMinDelay), kMaxDelay);
      const [shown] = await Promise.all([this.go(next), new Promise((done) => setTimeout(done, wait))]);
      if (!shown) this.stop();
    }
  }
}
