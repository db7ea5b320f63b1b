// How well remembered views show an object.

// A camera that moves loses sight of a thing for a cloud or two; only longer absences are shown [s].
const kRecent = 1;

/// How much of its colour an object keeps that no recent view shows.
export const kPale = 0.35;

/// Returns true if no recent view shows the object.
export const isUnseen = (object) => object.unseen > kRecent;

/// Returns how long ago the newest view of an object was taken; empty if this cloud shows it.
export const lastSeen = (object) => (object.unseen > 0 ? `${object.unseen.toFixed(1)} s ago` : "");

/// Lists the facts on an object's views, if several views show it, or the newest does not.
export function viewsOf(object) {
  const facts = [];
  if (object.views > 1 || object.unseen > 0) facts.push(["views", object.views]);
  if (object.unseen > 0) facts.push(["last seen", lastSeen(object)]);
  return facts;
}
