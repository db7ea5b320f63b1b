#pragma once

#include <optional>
#include <vector>

#include "boxes/direction_index.hpp"
#include "boxes/face.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// The box of one, two or three faces that belong together, completed with faces that are sought in
/// the cloud; nullopt if they make none. Its id stays unset.
/// @param planes  all detected planes except the faces
std::optional<Box> box_of_faces(const std::vector<const Face*>& faces,
                                const std::vector<const Detection*>& planes,
                                const DirectionIndex& sight);

/// The box of an upright face if no other face of it can be found; nullopt if there is none. Its id
/// stays unset.
/// @param planes  all detected planes except that of the face
std::optional<Box> box_of_upright_face(const Face& face,
                                       const std::vector<const Detection*>& planes,
                                       const DirectionIndex& sight);

}  // namespace quadrille
