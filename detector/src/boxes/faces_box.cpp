#include "boxes/faces_box.hpp"

#include <list>
#include <utility>

#include "boxes/box_axes.hpp"
#include "boxes/box_draft.hpp"
#include "boxes/measure_box.hpp"
#include "boxes/missing_face.hpp"

namespace quadrille {
namespace {

/// A box completed with faces that are not among the given ones; nullopt if there are none or they
/// make no box.
/// @param R_CA  axes of the given faces
std::optional<Box> completed_box(std::vector<const Face*> faces, Eigen::Matrix3d R_CA,
                                 const std::vector<const Detection*>& planes,
                                 const DirectionIndex& sight) {
  const std::size_t given = faces.size();
  std::list<Face> missing;  // The list keeps pointers to its elements valid.
  while (faces.size() < 3) {
    std::optional<Face> face = find_missing_face(faces, R_CA, sight);
    if (!face) break;
    faces.push_back(&missing.emplace_back(std::move(*face)));
    R_CA = box_axes(faces);
  }
  if (faces.size() == given) return std::nullopt;
  return measure_box(draft_of(faces, sight), planes);
}

/// The box of which a face is the top, or that is completed with other faces.
std::optional<Box> box_of_one(const std::vector<const Face*>& face,
                              const std::vector<const Detection*>& planes,
                              const DirectionIndex& sight) {
  const BoxDraft draft = draft_of(face, sight);
  if (rectangle_of(draft) != Rectangle::kSharp) return std::nullopt;
  if (auto box = completed_box(face, draft.R_CA, planes, sight)) return box;
  return measure_top(draft, planes);
}

}  // namespace

std::optional<Box> box_of_faces(const std::vector<const Face*>& faces,
                                const std::vector<const Detection*>& planes,
                                const DirectionIndex& sight) {
  if (faces.size() == 1) return box_of_one(faces, planes, sight);
  if (auto box = completed_box(faces, box_axes(faces), planes, sight)) return box;
  return measure_box(draft_of(faces, sight), planes);
}

std::optional<Box> box_of_upright_face(const Face& face,
                                       const std::vector<const Detection*>& planes,
                                       const DirectionIndex& sight) {
  const BoxDraft draft = draft_of({&face}, sight);
  if (rectangle_of(draft) == Rectangle::kNone) return std::nullopt;
  return measure_upright(draft, planes);
}

}  // namespace quadrille
