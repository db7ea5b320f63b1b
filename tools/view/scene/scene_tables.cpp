#include "view/scene/scene_tables.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/describe.hpp"
#include "quadrille/detector/setting.hpp"

namespace quadrille::view {
namespace {

/// Number of grasps of one cloud in a table; people would not look at more.
constexpr std::size_t kMaxGrasps = 20;

std::string place(const Eigen::Vector3d& p) {
  return fmt::format("{:.3f} {:.3f} {:.3f}", p.x(), p.y(), p.z());
}

std::string spaced(std::string_view word) {
  std::string name(word);
  std::replace(name.begin(), name.end(), '_', ' ');
  return name;
}

}  // namespace

ReportTable objects_table() {
  return {"Objects", {"cloud", "id", "type", "certain", "size", "position, m"}, {}};
}

ReportTable grasps_table() {
  return {"Best grasps",
          {"cloud", "grasp", "of", "kind", "score", "width, mm", "clearance, mm", "friction",
           "position, m", "tried"},
          {}};
}

void add_rows(const Scene& scene, ReportTable* objects, ReportTable* grasps) {
  for (const Detection& d : scene.detections) {
    objects->rows.push_back({scene.name, fmt::format("{}", d.id), spaced(to_string(d.type)),
                             fmt::format("{:.2f}", d.score), spaced(io::describe_dimensions(d)),
                             place(d.X_CQ.translation())});
  }
  for (const Box& box : scene.boxes) {
    objects->rows.push_back({scene.name, fmt::format("{}", box.id), "box",
                             fmt::format("{:.2f}", box.score), io::describe_box(box),
                             place(box.X_CB.translation())});
  }
  for (const SceneBody& lump : scene.lumps) {
    objects->rows.push_back({scene.name, fmt::format("{}", lump.id), "lump", "",
                             io::describe_lump(lump), place(lump.X_CB.translation())});
  }
  for (std::size_t n = 0; n < std::min(scene.grasps.size(), kMaxGrasps); ++n) {
    const Grasp& g = scene.grasps[n];
    grasps->rows.push_back({scene.name, fmt::format("{}", n + 1), fmt::format("{}", g.target),
                            std::string(to_string(g.kind)), fmt::format("{:.2f}", g.score),
                            fmt::format("{:.1f}", 1000.0 * g.width),
                            fmt::format("{:.1f}", 1000.0 * g.clearance),
                            fmt::format("{:.2f}", g.friction_needed), place(g.X_CG.translation()),
                            n < scene.outcomes.size() ? scene.outcomes[n] : ""});
  }
}

}  // namespace quadrille::view
