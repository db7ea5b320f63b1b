// The sources of scenes: the server of this page, or the page itself if it is a report.
import { unpack } from "./pack.js";

const kAnswerTries = 10;

async function checked(answer) {
  if (!answer.ok) throw new Error((await answer.text()).trim());
  return answer;
}

class ServerSource {
  async session() {
    return (await checked(await fetch("/api/session"))).json();
  }

  /// Fetches the scene of a cloud of the log, planned as chosen.
  frame(number, choice) {
    const given = Object.entries(choice).filter(([, value]) => value);
    return this.scene(`/api/frames/${number}?${new URLSearchParams(given)}`);
  }

  newest() { return this.scene("/api/newest"); }

  async scene(path) {
    return unpack(await (await checked(await fetch(path))).arrayBuffer());
  }

  /// Calls onNews with {version, status} from time to time, and onLost when the server cannot be
  /// reached.
  listen(onNews, onLost) {
    const events = new EventSource("/api/events");
    events.onmessage = (event) => onNews(JSON.parse(event.data));
    events.onerror = onLost;
  }

  /// Asks the robot's planner; resolves to its answer.
  async ask(question) {
    const sent = await checked(await fetch("/api/questions", {
      method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(question) }));
    const { number } = await sent.json();
    for (let i = 0; i < kAnswerTries; ++i) {
      const { answer } = await (await checked(await fetch(`/api/questions/${number}`))).json();
      if (answer) return answer;
    }
    throw new Error("the planner does not answer; is quadrille-grasp-planner running?");
  }
}

/// Reads the data from elements of the page: the session as JSON, each scene as base64.
class ReportSource {
  constructor(data) { this.data = data; }

  async session() { return JSON.parse(this.data.textContent); }

  async frame(number) {
    const text = document.getElementById(`scene-${number}`).textContent;
    return unpack(Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)).buffer);
  }
}

export function openSource() {
  const data = document.getElementById("report");
  return data ? new ReportSource(data) : new ServerSource();
}
