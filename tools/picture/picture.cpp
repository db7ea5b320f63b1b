#include "picture/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include "io/describe.hpp"
#include "picture/box_layer.hpp"
#include "picture/cloud_layer.hpp"
#include "picture/grasp_layer.hpp"
#include "picture/quadric_layer.hpp"
#include "picture/text.hpp"
#include "picture/view.hpp"

namespace quadrille {
namespace {

constexpr int kScale = 2, kLegendHeight = 30, kPad = 4, kLine = kTextHeight * kScale + kPad;
const Color kBackground(0.09f, 0.1f, 0.12f), kPaper(0.0f, 0.0f, 0.0f), kWhite(1.0f, 1.0f, 1.0f),
    kAlarm(1.0f, 0.3f, 0.25f);

const Color& color_of(std::size_t index) {
  static const std::array<Color, 8> kColors = {
      Color(1.0f, 0.55f, 0.1f), Color(0.2f, 0.75f, 1.0f),  Color(1.0f, 0.35f, 0.75f),
      Color(0.95f, 0.9f, 0.2f), Color(0.55f, 0.5f, 1.0f),  Color(0.3f, 0.95f, 0.75f),
      Color(1.0f, 0.35f, 0.3f), Color(0.75f, 0.95f, 0.4f),
  };
  return kColors[index % kColors.size()];
}

/// A name with the place that it would like to have, and what the legend says of it.
struct Label {
  std::string text, line;
  Color color;
  Eigen::Vector2i anchor;
};

/// Writes labels above their anchors, moved up or down until none covers another.
void draw_labels(const std::vector<Label>& labels, int height, Image* image) {
  std::vector<Eigen::AlignedBox2i> taken;
  for (const Label& label : labels) {
    const int width = static_cast<int>(label.text.size()) * kTextWidth * kScale + 2 * kPad;
    const int left =
        std::clamp(label.anchor.x() - width / 2, 0, std::max(0, image->width() - width));
    const int wanted = std::clamp(label.anchor.y() - kLine - 6, 0, std::max(0, height - kLine));
    Eigen::AlignedBox2i box;
    for (int step = 0; step < 2 * height / kLine; ++step) {
      const int top = wanted + (step % 2 == 0 ? -1 : 1) * ((step + 1) / 2) * kLine;
      box = {Eigen::Vector2i(left, top), Eigen::Vector2i(left + width, top + kLine - 1)};
      const bool is_free = std::none_of(taken.begin(), taken.end(),
                                        [&](const auto& other) { return box.intersects(other); });
      if (is_free && top >= 0 && top + kLine <= height) break;
    }
    taken.push_back(box);
    // A label that had to move away points back to its quadric.
    if (std::abs(box.min().y() - wanted) > kLine) {
      draw_line(box.center().cast<double>(), label.anchor.cast<double>(), 1.5, label.color, 0.9f,
                image);
    }
    draw_rectangle(box.min().x(), box.min().y(), width, kLine, kPaper, 0.7f, image);
    draw_text(label.text, box.min().x() + kPad, box.min().y() + kPad, kScale, label.color, image);
  }
}

std::string legend_of(const PictureContent& content) {
  const auto& detections = content.result.detections;
  const auto flat = std::count_if(detections.begin(), detections.end(),
                                  [](const Detection& d) { return is_flat(d.type); });
  const auto curved = static_cast<std::ptrdiff_t>(detections.size()) - flat;
  std::string text =
      fmt::format("{}   {} points   {} curved, {} flat in {:.1f} ms",
                  std::filesystem::path(content.title).filename().string(),
                  content.result.points_finite, curved, flat, content.result.total_ms);
  return text + "   ";
}

std::string summary_of(const GraspPlan& plan) {
  const std::string count = plan.grasps.empty() ? "no" : std::to_string(plan.grasps.size());
  return fmt::format("{} grasps in {:.0f} ms", count, plan.total_ms);
}

/// Flat ones first, so that tints of tables do not dull the rest.
std::vector<Label> draw_detections(const DetectionResult& result, const std::vector<float>& depth,
                                   const View& view, Image* image) {
  std::vector<Label> labels;
  for (const bool flat : {true, false}) {
    std::size_t index = 0;
    for (const Detection& detection : result.detections) {
      if (is_flat(detection.type) != flat) continue;
      const Color& color = color_of(flat ? index + 4 : index);
      ++index;
      const auto anchor = draw_quadric(detection, color, depth, view, image);
      if (anchor)
        labels.push_back({fmt::format("{} {:.2f}", io::name_of(detection), detection.score),
                          io::short_label(detection), color, *anchor});
    }
  }
  return labels;
}

std::vector<Label> draw_boxes(const std::vector<Box>& boxes, const View& view, Image* image) {
  std::vector<Label> labels;
  for (std::size_t n = 0; n < boxes.size(); ++n) {
    const Box& box = boxes[n];
    // From the other end of the colours than the quadrics.
    const Color& color = color_of(7 - n % 8);
    if (const auto anchor = draw_box(box, color, view, image)) {
      const Eigen::Vector3d size = 1000.0 * box.size;
      labels.push_back(
          {fmt::format("{} box {:.2f}", box.id, box.score),
           fmt::format("{} box {:.0f} x {:.0f} x {:.0f} mm", box.id, size.x(), size.y(), size.z()),
           color, *anchor});
    }
  }
  return labels;
}

/// Lines of the legend that stand side by side in a picture of that width.
int count_columns(int width) { return std::max(1, width / 620); }

int legend_height(std::size_t labels, int width) {
  const int columns = count_columns(width);
  return kLegendHeight + (static_cast<int>(labels) + columns - 1) / columns * kLine;
}

void draw_legend(const PictureContent& content, const std::vector<Label>& labels, int top,
                 Image* image) {
  draw_rectangle(0, top, image->width(), image->height() - top, kPaper, 1.0f, image);
  const std::string legend = legend_of(content);
  draw_text(legend, 10, top + 8, kScale, kWhite, image);
  if (content.plan != nullptr) {
    const int left = 10 + static_cast<int>(legend.size()) * kTextWidth * kScale;
    draw_text(summary_of(*content.plan), left, top + 8, kScale,
              content.plan->grasps.empty() ? kAlarm : kWhite, image);
  }
  const int columns = count_columns(image->width());
  for (int i = 0; i < static_cast<int>(labels.size()); ++i) {
    const Label& label = labels[static_cast<std::size_t>(i)];
    draw_text(label.line, 10 + i % columns * image->width() / columns,
              top + kLegendHeight + i / columns * kLine, kScale, label.color, image);
  }
}

}  // namespace

Image draw_picture(const PictureContent& content, int width) {
  const View view = fit_view(content.cloud, width);
  const std::vector<float> depth = depth_image(content.cloud, view);
  const auto& detections = content.result.detections;
  const auto curved = static_cast<std::size_t>(std::count_if(
      detections.begin(), detections.end(), [](const Detection& d) { return !is_flat(d.type); }));
  const std::size_t lines = curved + content.result.boxes.size();
  Image image(view.width, view.height + legend_height(lines, view.width), kBackground);
  draw_cloud(depth, view, &image);
  std::vector<Label> labels = draw_detections(content.result, depth, view, &image);
  const std::vector<Label> boxes = draw_boxes(content.result.boxes, view, &image);
  labels.insert(labels.end(), boxes.begin(), boxes.end());
  if (content.plan != nullptr && content.gripper != nullptr) {
    draw_grasps(*content.plan, *content.gripper, view, &image);
  }
  draw_labels(labels, view.height, &image);
  draw_legend(content, labels, view.height, &image);
  return image;
}

}  // namespace quadrille
