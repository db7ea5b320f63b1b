// Shows what a report holds beside its scenes: tables, pictures and settings.
import { byId, element } from "./dom.js";

const isNumber = (text) => /^[-+]?[\d.]+ ?(%|mm|ms|°)?$/.test(text);

/// Makes a table, leaving out columns without any text.
function tableOf({ columns, rows }) {
  const used = columns.map((_, i) => i).filter((i) => rows.some((row) => row[i]));
  const cell = (text) => element("td", { text, class: isNumber(text) ? "number" : "" });
  return element("table", {}, [
    element("tr", {}, used.map((i) => element("th", { text: columns[i] }))),
    ...rows.map((row) => element("tr", {}, used.map((i) => cell(row[i]))))]);
}

export function fillReport(session) {
  const parts = [element("h1", { text: session.name })];
  for (const note of session.notes) parts.push(element("p", { class: "warning", text: note }));
  for (const table of session.tables) parts.push(element("h2", { text: table.title }), tableOf(table));
  parts.push(element("h2", { text: "Made by" }), element("pre", { text: session.command }));
  parts.push(element("details", {}, [element("summary", { text: "Settings" }), element("pre", { text: session.settings })]));
  byId("tables").replaceChildren(...parts);
  byId("tables").hidden = false;
  document.body.classList.add("report");
  document.title = session.name;
}
