#pragma once

#include <optional>
#include <string>
#include <vector>

#include "picture/image.hpp"
#include "picture/label_layout.hpp"
#include "picture/sketch.hpp"
#include "picture/view.hpp"
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

struct PictureOptions {
  /// Of the picture [pixels]; its height follows from the cloud and the legend.
  int width = 1280;
  ViewSide side = ViewSide::kCamera;
};

/// The name of a surface or box, with what the legend says of it.
struct Label {
  std::string text, line;
  Color color = Color::Ones();
  /// None if there is no room for it: the legend has it still.
  std::optional<LabelPlace> place;
};

/// A picture before it is drawn.
struct PictureLayout {
  View view;
  /// The cloud, shaded and tinted, in fewer pixels than the picture has.
  Image ground;
  Sketch sketch;
  std::vector<Label> labels;
};

/// Lays out the cloud in grey, the outlines of quadrics and boxes over it in colour with their
/// names beside them, and the best grasps.
PictureLayout lay_out(const PictureContent& content, const PictureOptions& options = {});

/// Draws that, and below it a legend with the sizes, as PNG, SVG or PDF by the file's ending; in
/// the latter two all but the cloud is lines and text.
/// @throws io::FileError if the file cannot be written
/// @throws std::invalid_argument if it has another ending
void write_picture(const std::string& path, const PictureContent& content,
                   const PictureOptions& options = {});

/// True for endings of pictures.
bool is_picture_path(const std::string& path);

}  // namespace quadrille
