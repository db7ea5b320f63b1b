#include "bodies/support.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/convex_hull.hpp"
#include "boxes/face.hpp"

namespace quadrille {

bool Support::is_below(const Eigen::Vector3d& p_C) const {
  // A share of the size: things at the rim of what was seen of a table stand on it too.
  constexpr double kBeside = 0.1;
  const Eigen::Vector2d margin = kBeside * bounds_Q.sizes();
  const Eigen::AlignedBox2d around(bounds_Q.min() - margin, bounds_Q.max() + margin);
  const Eigen::Vector3d p_Q = X_QC * p_C;
  return height(p_C) > 0.0 && around.contains(Eigen::Vector2d(p_Q.head<2>()));
}

double Support::inside(const Eigen::Vector3d& p_C, std::size_t view) const {
  const std::vector<Eigen::Vector2d>& outline_Q = outlines_Q[view];
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (outline_Q.size() < 3) return -kInfinity;
  const Eigen::Vector2d p_Q = (X_QC * p_C).head<2>();
  double least = kInfinity;
  for (std::size_t k = 0; k < outline_Q.size(); ++k) {
    const Eigen::Vector2d side = outline_Q[(k + 1) % outline_Q.size()] - outline_Q[k];
    const Eigen::Vector2d inwards = Eigen::Vector2d(-side.y(), side.x()).normalized();
    least = std::min(least, inwards.dot(p_Q - outline_Q[k]));
  }
  return least;
}

std::vector<Support> supports_of(const std::vector<Detection>& detections,
                                 const std::vector<int>& parts, const PlacesOnPlanes& places_C) {
  std::vector<const Detection*> planes;
  for (const Detection& d : detections) {
    const bool is_part = std::find(parts.begin(), parts.end(), d.id) != parts.end();
    if (d.type == QuadricType::kPlane && !is_part) planes.push_back(&d);
  }
  std::stable_sort(planes.begin(), planes.end(),
                   [](const Detection* a, const Detection* b) { return a->inliers > b->inliers; });
  std::vector<Support> supports;
  for (const Detection* plane : planes) {
    Support support;
    support.id = plane->id;
    support.n_C = outward_normal(*plane);
    support.offset = support.n_C.dot(plane->X_CQ.translation());
    support.X_QC = plane->X_CQ.inverse();
    support.bounds_Q = {plane->extent_Q.min().head<2>(), plane->extent_Q.max().head<2>()};
    if (const auto places = places_C.find(plane->id); places != places_C.end()) {
      for (const std::vector<Eigen::Vector3d>& of_view : places->second) {
        std::vector<Eigen::Vector2d> places_Q;
        places_Q.reserve(of_view.size());
        for (const Eigen::Vector3d& p : of_view) {
          places_Q.emplace_back((support.X_QC * p).head<2>());
        }
        support.outlines_Q.push_back(convex_hull(std::move(places_Q)));
      }
    }
    supports.push_back(support);
  }
  return supports;
}

const Support* support_below(const std::vector<Support>& supports, const Eigen::Vector3d& p_C) {
  const Support* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const Support& support : supports) {
    if (!support.is_below(p_C) || support.height(p_C) >= least) continue;
    least = support.height(p_C);
    nearest = &support;
  }
  return nearest;
}

std::optional<int> standing_on(const std::vector<Support>& supports,
                               std::span<const Eigen::Vector3d> places_C) {
  if (places_C.empty()) return std::nullopt;
  Eigen::Vector3d middle_C = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : places_C) middle_C += p / static_cast<double>(places_C.size());
  std::optional<int> nearest;
  double least = kMaxFootGap;
  for (const Support& support : supports) {
    if (!support.is_below(middle_C)) continue;
    double lowest = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector3d& p : places_C) lowest = std::min(lowest, support.height(p));
    if (std::abs(lowest) > least) continue;
    least = std::abs(lowest);
    nearest = support.id;
  }
  return nearest;
}

}  // namespace quadrille
