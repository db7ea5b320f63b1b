// Which grasps belong to an object.

/// Returns the grasps of the object with an id, or all if that is null. A plan lists the grasps of
/// all parts of a body under the id of the body, unless the planner was asked about the part.
export function graspsOf(scene, id) {
  if (id === null) return scene.grasps;
  const of = (target) => scene.grasps.filter((grasp) => grasp.target === target);
  const own = of(id);
  const object = scene.objects.find((candidate) => candidate.id === id);
  return own.length || !object || object.part_of === undefined ? own : of(object.part_of);
}
