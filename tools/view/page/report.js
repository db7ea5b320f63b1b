// What a report holds beside its scenes: tables, pictures and settings.
import { byId, element } from "./dom.js";

const isNumber = (text) => /^[-+]?[\d.]+ ?(%|mm|ms|°)?$/.test(text);

export function fillReport(session) {
  const parts = [element("h1", { text: session.name })];
  for (const { title, columns, rows } of session.tables) {
    parts.push(element("h2", { text: title }), element("table", { class: "report" }, [
      element("tr", {}, columns.map((text) => element("th", { text }))),
      ...rows.map((row) => element("tr", {}, row.map((text) =>
        element("td", { text, class: isNumber(text) ? "number" : "" }))))]));
  }
  for (const note of session.notes) parts.push(element("p", { class: "warning", text: note }));
  parts.push(element("h2", { text: "Made by" }), element("pre", { text: session.command }));
  parts.push(element("details", {}, [element("summary", { text: "Settings" }), element("pre", { text: session.settings })]));
  byId("tables").replaceChildren(...parts);
  byId("tables").hidden = false;
  document.body.classList.add("report");
  document.title = session.name;
}
