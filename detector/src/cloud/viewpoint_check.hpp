#pragma once

#include <string>
#include <vector>

#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"

namespace quadrille {

/// How to mend a wrong viewpoint: of the first view, and of further ones, which options are not
/// about.
inline constexpr const char* kNameViewpoint =
    "name where the sensor stood (--viewpoint or --camera-pose)";
inline constexpr const char* kFurtherViewpoint =
    "say in its file where the sensor stood (comment viewpoint X Y Z in a .ply, VIEWPOINT in a "
    ".pcd)";

/// Does what contradict_viewpoint() does for a cloud whose points are known to be in range.
/// @param remedy  the end of the sentence
std::string contradict_viewpoint_in_range(const CloudView& cloud,
                                          const std::vector<Detection>& detections,
                                          const std::string& remedy);

}  // namespace quadrille
