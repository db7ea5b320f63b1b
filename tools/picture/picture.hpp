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

/// The content of a picture. Plan and gripper are either both given or both left out.
struct PictureContent {
  const std::string& title;
  const PointCloud& cloud;
  const DetectionResult& result;
  const GraspPlan* plan = nullptr;
  const Gripper* gripper = nullptr;
};

struct PictureOptions {
  /// Width of the picture [pixels]; the height follows from the cloud and the legend.
  int width = 1280;
  ViewSide side = ViewSide::kCamera;
};

/// The name of a surface or box, and its line in the legend.
struct Label {
  std::string text, line;
  Color color = Color::Ones();
  /// Place of the label; nullopt if there is no room, and then only the legend has it.
  std::optional<LabelPlace> place;
};

/// A picture before it is drawn.
struct PictureLayout {
  View view;
  /// The cloud, shaded and tinted, at a lower resolution than the picture.
  Image ground;
  Sketch sketch;
  std::vector<Label> labels;
};

/// Lays out the cloud in grey, and over it the outlines of quadrics and boxes in colour with their
/// names beside them, and the best grasps.
PictureLayout lay_out(const PictureContent& content, const PictureOptions& options = {});

/// Draws a picture with a legend of sizes below it, as PNG, SVG or PDF depending on the file's
/// extension. In the latter two, everything except the cloud is lines and text.
/// @throws io::FileError if the file cannot be written
/// @throws std::invalid_argument if the extension is another one
void write_picture(const std::string& path, const PictureContent& content,
                   const PictureOptions& options = {});

/// Returns true if the path has the extension of a picture.
bool is_picture_path(const std::string& path);

}  // namespace quadrille
