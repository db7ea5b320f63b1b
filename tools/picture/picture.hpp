#pragma once

#include <string>

#include "picture/image.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/grasping/plan.hpp"

namespace quadrille {

/// What a picture shows. Plan and gripper are left out, or given together.
struct PictureContent {
  const std::string& title;
  const PointCloud& cloud;
  const DetectionResult& result;
  const GraspPlan* plan = nullptr;
  const Gripper* gripper = nullptr;
};

/// Draws the cloud from its viewpoint in grey, the quadrics and boxes over it in colour with
/// their names, the best grasps, and below them a legend with the sizes.
/// @param width  of the picture [pixels]; its height follows from the cloud and the legend
Image draw_picture(const PictureContent& content, int width = 1280);

}  // namespace quadrille
