#pragma once

#include <vector>

#include "quadrille/detector/detection.hpp"

namespace quadrille {

/// Joins the boxes that several views show of one scene. Of boxes of different views that
/// occupy the same place, the one of which most sides were seen is kept, with the faces of all.
/// @param of_views  the boxes of each view, whose ids begin with the same number
std::vector<Box> join_boxes(std::vector<std::vector<Box>> of_views);

}  // namespace quadrille
