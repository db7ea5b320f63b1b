#pragma once

#include <optional>
#include <vector>

#include "boxes/direction_index.hpp"
#include "boxes/face.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// The largest face in a patch, with its plane refitted; nullopt if there are too few points.
/// @param sigma  noise of the points along the patch's normal [m]
std::optional<Face> face_at(const FacePatch& patch, double sigma, const DirectionIndex& sight);

/// The face at a side of a seed, nullopt if it bends more than worn boxes do.
std::optional<Face> unbent_face_at(const FlatPatch& flat, const DirectionIndex& sight);

/// The largest face in a patch, which has grown as far as its plane explains points; nullopt if
/// there is none, or if it bends. It has only as many of its points as tell so.
std::optional<Face> draft_face(const FlatPatch& flat, const DirectionIndex& sight);

/// The face that grows from a draft when all points are looked at; nullopt as for a draft.
std::optional<Face> finished_face(const Face& draft, const DirectionIndex& sight);

/// The faces of a detected plane, the largest first. One plane may hold faces of several boxes of
/// the same height.
std::vector<Face> faces_of(const Detection& plane, const DirectionIndex& sight);

}  // namespace quadrille
