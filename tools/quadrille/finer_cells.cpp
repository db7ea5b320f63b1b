#include "quadrille/finer_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "quadrille/detector/detector.hpp"

namespace quadrille {
namespace {

// Cells of this size find things of 2 cm, and take up to twice the time of the default ones [m].
constexpr double kFineCell = 0.002;

constexpr const char* kPage = "detector/TUNING.md";

}  // namespace

bool has_only_planes(const DetectionResult& result) {
  const bool is_curved = std::any_of(result.detections.begin(), result.detections.end(),
                                     [](const Detection& d) { return !is_flat(d.type); });
  const bool has_lump = std::any_of(result.bodies.begin(), result.bodies.end(),
                                    [](const SceneBody& b) { return b.kind == BodyKind::kLump; });
  return !result.detections.empty() && !is_curved && !has_lump && result.boxes.empty();
}

std::vector<Remedy> try_finer_cells(std::span<const PointCloud> views, DetectorOptions options,
                                    const std::function<GraspPlan(DetectionResult)>& plan) {
  SamplingOptions& sampling = options.sampling;
  if (sampling.cell <= kFineCell || sampling.relative_cell > 0.0) return {};
  sampling.cell = kFineCell;
  const GraspPlan planned = plan(detect_views(views, options));
  if (planned.grasps.empty()) return {};
  return {{0, fmt::format("sampling.cell = {} (in --config FILE)", kFineCell),
           static_cast<int>(planned.grasps.size()), planned.grasps.front().score}};
}

std::string hint_at_finer_cells(const std::vector<Remedy>& remedies, bool advised) {
  const char* const fact = "only planes were found";
  if (!advised) {
    return fmt::format(
        "  {}; --advise tries a smaller sampling.cell, which shows smaller things (see {})\n", fact,
        kPage);
  }
  if (remedies.empty()) {
    return fmt::format("  {}, and a smaller sampling.cell gives no grasp; see {}\n", fact, kPage);
  }
  const Remedy& remedy = remedies.front();
  return fmt::format("  {}, but {} gives {} grasp{}, the best with a score of {:.2f}; see {}\n",
                     fact, remedy.change, remedy.grasps, remedy.grasps == 1 ? "" : "s",
                     remedy.score, kPage);
}

}  // namespace quadrille
