#include "picture/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "io/describe.hpp"
#include "io/new_file.hpp"
#include "picture/box_layer.hpp"
#include "picture/canvas.hpp"
#include "picture/cloud_layer.hpp"
#include "picture/grasp_layer.hpp"
#include "picture/quadric_layer.hpp"

namespace quadrille {
namespace {

/// Resolution of the cloud's image relative to the picture's; a camera hardly has more pixels.
constexpr double kGroundScale = 0.5;
constexpr double kText = 15.0, kPad = 5.0, kLine = 22.0, kMargin = 14.0, kLegendTop = 34.0;
/// Width of the legend's columns.
constexpr double kColumn = 420.0;
const Color kBackground(0.09f, 0.1f, 0.12f), kPaper(0.04f, 0.045f, 0.055f),
    kWhite(0.95f, 0.95f, 0.95f), kAlarm(1.0f, 0.3f, 0.25f);

const Color& color_of(std::size_t index) {
  static const std::array<Color, 8> kColors = {
      Color(1.0f, 0.55f, 0.1f), Color(0.2f, 0.75f, 1.0f),  Color(1.0f, 0.35f, 0.75f),
      Color(0.95f, 0.9f, 0.2f), Color(0.55f, 0.5f, 1.0f),  Color(0.3f, 0.95f, 0.75f),
      Color(1.0f, 0.35f, 0.3f), Color(0.75f, 0.95f, 0.4f),
  };
  return kColors[index % kColors.size()];
}

/// Returns the subject of a view from above or from the side: the curved surfaces and the boxes.
ViewSubject subject_of(const PictureContent& content) {
  const DetectionResult& result = content.result;
  ViewSubject subject;
  for (const Detection& d : result.detections) {
    if (!d.X_CQ.matrix().allFinite() || d.extent_Q.isEmpty()) continue;
    if (d.type == QuadricType::kPlane) {
      subject.planes_C.emplace_back(d.X_CQ.linear().col(2), d.inliers);
    }
    if (!is_flat(d.type)) subject.box_C.extend(d.extent_Q.transformed(d.X_CQ));
  }
  for (const Box& box : result.boxes) {
    const Eigen::AlignedBox3d box_B(-0.5 * box.size, 0.5 * box.size);
    subject.box_C.extend(box_B.transformed(box.X_CB));
  }
  if (content.plan != nullptr && content.gripper != nullptr) {
    subject.more_C = hand_points(*content.plan, *content.gripper);
  }
  return subject;
}

std::vector<Eigen::Vector2d> ends_in_view(const Strokes& strokes, const View& view) {
  std::vector<Eigen::Vector2d> ends;
  for (const Segment& segment : strokes.segments) {
    if (view.holds(segment.from)) ends.push_back(segment.from);
  }
  return ends;
}

/// Puts a picture together, layer by layer.
class Composer {
 public:
  Composer(const View& view, const CloudImage& cloud, const View& ground_view)
      : layout_{view, Image(ground_view.width, ground_view.height, kBackground), {}, {}},
        depth_(cloud.depth),
        ground_view_(ground_view),
        lines_(view.width, view.height),
        bodies_(view.width, view.height) {
    draw_cloud(cloud, ground_view, &layout_.ground);
  }

  void add(const Detection& detection, const Color& color) {
    tint_quadric(detection, color, depth_, ground_view_, &layout_.ground);
    const QuadricSketch drawn = sketch_quadric(detection, color, layout_.view);
    if (drawn.covered.empty()) return;
    for (const Eigen::Vector2d& p : drawn.covered) bodies_.mark(p, 0.5 * drawn.step);
    add(drawn.sketch, {fmt::format("{} {:.2f}", io::name_of(detection), detection.score),
                       io::short_label(detection),
                       color,
                       {}});
  }

  void add(const Box& box, const Color& color) {
    const Sketch sketch = sketch_box(box, color, layout_.view);
    if (sketch.strokes.empty()) return;
    const Eigen::Vector3d size = 1000.0 * box.size;
    add(sketch,
        {fmt::format("{} box {:.2f}", box.id, box.score),
         fmt::format("{} box {:.0f} x {:.0f} x {:.0f} mm", box.id, size.x(), size.y(), size.z()),
         color,
         {}});
  }

  void add(const GraspPlan& plan, const Gripper& gripper) {
    const Sketch sketch = sketch_grasps(plan, gripper, layout_.view);
    mark(sketch);
    layout_.sketch.add(sketch);
  }

  /// Returns the layout with the labels, which are placed last because their places depend on
  /// everything else.
  PictureLayout finish() && {
    const Eigen::Vector2d size(layout_.view.width, layout_.view.height);
    const auto places = place_labels(wanted_, size, lines_, bodies_);
    for (std::size_t n = 0; n < places.size(); ++n) layout_.labels[n].place = places[n];
    return std::move(layout_);
  }

 private:
  void mark(const Sketch& sketch) {
    for (const Strokes& strokes : sketch.strokes) lines_.mark(strokes);
    for (const Disc& disc : sketch.discs) lines_.mark(disc.center, disc.radius);
  }

  /// Adds an object with a label; the last of the sketch's strokes are its rim.
  void add(const Sketch& sketch, Label label) {
    mark(sketch);
    layout_.sketch.add(sketch);
    wanted_.push_back({{Canvas::measure(label.text, kText) + 2 * kPad, kLine},
                       ends_in_view(sketch.strokes.back(), layout_.view)});
    layout_.labels.push_back(std::move(label));
  }

  PictureLayout layout_;
  const std::vector<float>& depth_;
  View ground_view_;
  TakenCells lines_, bodies_;
  std::vector<WantedLabel> wanted_;
};

/// Adds flat detections first, so that the tints of tables do not cover the others.
void add_detections(const DetectionResult& result, Composer* composer) {
  for (const bool flat : {true, false}) {
    std::size_t index = 0;
    for (const Detection& detection : result.detections) {
      if (is_flat(detection.type) != flat) continue;
      composer->add(detection, color_of(flat ? index + 4 : index));
      ++index;
    }
  }
  // Boxes take their colours from the other end of the list than the quadrics.
  for (std::size_t n = 0; n < result.boxes.size(); ++n) {
    composer->add(result.boxes[n], color_of(7 - n % 8));
  }
}

std::string title_of(const PictureContent& content) {
  const auto& detections = content.result.detections;
  const auto flat = std::count_if(detections.begin(), detections.end(),
                                  [](const Detection& d) { return is_flat(d.type); });
  const auto curved = static_cast<std::ptrdiff_t>(detections.size()) - flat;
  return fmt::format("{}   {} points   {} curved, {} flat in {:.1f} ms",
                     std::filesystem::path(content.title).filename().string(),
                     content.result.points_finite, curved, flat, content.result.total_ms);
}

std::string summary_of(const GraspPlan& plan) {
  const std::string count = plan.grasps.empty() ? "no" : std::to_string(plan.grasps.size());
  return fmt::format("{} grasps in {:.0f} ms", count, plan.total_ms);
}

/// Returns the number of columns of the legend in a picture of this width.
int count_columns(int width) { return std::max(1, static_cast<int>(width / kColumn)); }

int legend_height(std::size_t labels, int width) {
  const int columns = count_columns(width);
  const int rows = (static_cast<int>(labels) + columns - 1) / columns;
  return static_cast<int>(kLegendTop + rows * kLine + (rows > 0 ? kPad : 0.0));
}

void draw_legend(const PictureContent& content, const PictureLayout& layout, Canvas* canvas) {
  const double base = layout.view.height + 22.0;
  const std::string title = title_of(content);
  canvas->write(title, {kMargin, base}, kText, kWhite);
  if (content.plan != nullptr) {
    const double left = kMargin + Canvas::measure(title + "   ", kText);
    canvas->write(summary_of(*content.plan), {left, base}, kText,
                  content.plan->grasps.empty() ? kAlarm : kWhite);
  }
  const int columns = count_columns(layout.view.width);
  for (int i = 0; i < static_cast<int>(layout.labels.size()); ++i) {
    const Label& label = layout.labels[static_cast<std::size_t>(i)];
    const Eigen::Vector2d at(kMargin + i % columns * layout.view.width / columns,
                             base + (i / columns + 1) * kLine + 4.0);
    canvas->write(label.line, at, kText, label.color);
  }
}

void draw_labels(const std::vector<Label>& labels, Canvas* canvas) {
  constexpr double kCorner = 4.0;
  for (const Label& label : labels) {
    if (!label.place) continue;
    const LabelPlace& place = *label.place;
    canvas->draw(Strokes{{{place.start(), place.anchor}}, 1.5, label.color, 0.95f});
    canvas->draw(Disc{place.anchor, 3.0, label.color});
    canvas->fill(place.box, kPaper, 0.78f, kCorner);
    canvas->outline(place.box, label.color, 1.0, kCorner);
    canvas->write(label.text, {place.box.min().x() + kPad, place.box.max().y() - 6.0}, kText,
                  label.color);
  }
}

std::optional<Canvas::Format> format_of(const std::string& path) {
  if (path.ends_with(".png")) return Canvas::Format::kPng;
  if (path.ends_with(".svg")) return Canvas::Format::kSvg;
  if (path.ends_with(".pdf")) return Canvas::Format::kPdf;
  return std::nullopt;
}

}  // namespace

PictureLayout lay_out(const PictureContent& content, const PictureOptions& options) {
  const View view = fit_view(content.cloud, options.width, options.side, subject_of(content));
  const View ground_view = view.scaled(kGroundScale);
  const CloudImage cloud = cloud_image(content.cloud, ground_view);
  Composer composer(view, cloud, ground_view);
  add_detections(content.result, &composer);
  if (content.plan != nullptr && content.gripper != nullptr) {
    composer.add(*content.plan, *content.gripper);
  }
  return std::move(composer).finish();
}

void write_picture(const std::string& path, const PictureContent& content,
                   const PictureOptions& options) {
  const auto format = format_of(path);
  if (!format) throw std::invalid_argument(path + ": a picture ends in .png, .svg or .pdf");
  const PictureLayout layout = lay_out(content, options);
  const int height = layout.view.height + legend_height(layout.labels.size(), layout.view.width);
  const Eigen::Vector2d corner(0.0, 0.0), size(layout.view.width, layout.view.height);
  Canvas canvas(*format, layout.view.width, height);
  canvas.fill({corner, Eigen::Vector2d(layout.view.width, height)}, kPaper, 1.0f);
  canvas.clip({corner, size});
  const Eigen::Vector2d ground(layout.ground.width(), layout.ground.height());
  canvas.draw(layout.ground, {corner, ground / kGroundScale});
  for (const Strokes& strokes : layout.sketch.strokes) canvas.draw(strokes);
  for (const Disc& disc : layout.sketch.discs) canvas.draw(disc);
  draw_labels(layout.labels, &canvas);
  canvas.clip_nothing();
  draw_legend(content, layout, &canvas);
  io::write_file(path, canvas.finish());
}

bool is_picture_path(const std::string& path) { return format_of(path).has_value(); }

}  // namespace quadrille
