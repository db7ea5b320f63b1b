#include "experiments/scene_score.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace quadrille::experiments {
namespace {

constexpr double kCover = 0.6, kPure = 0.5;
/// cos 20°.
constexpr double kLeastCosine = 0.9396926;
/// Fewer points are no surface to match.
constexpr int kLeastPoints = 40;
// Points of a surface and about it that are looked at, at most.
constexpr std::size_t kMostOwn = 1000, kMostNear = 3000;

std::vector<int> thinned(const std::vector<int>& all, std::size_t most) {
  std::vector<int> some;
  const std::size_t step = (all.size() + most - 1) / most;
  for (std::size_t i = 0; i < all.size(); i += step) some.push_back(all[i]);
  return some;
}

KnownSurface known_surface(const scene::Scene& made, const scene::Surface& surface,
                           const Eigen::Isometry3d& X_CS, int id, double factor) {
  KnownSurface known;
  known.id = id;
  known.curved = surface.curved;
  known.pixels = made.ideal.visible[static_cast<std::size_t>(id)];
  const double noise = scene::depth_noise(factor, X_CS.translation().z());
  const double size = surface.box_S.sizes().maxCoeff();
  known.tolerance = std::max(2.0 * noise, std::min(0.02 * size, 0.01));
  const Eigen::Array3d flush = 0.5 * surface.box_S.sizes().array();
  const Eigen::Array3d half = (1.2 * flush).max(flush + 3.0 * known.tolerance);
  const Eigen::Isometry3d X_SC = X_CS.inverse();
  for (std::size_t i = 0; i < made.view.points.size(); ++i) {
    const bool own = made.view.labels[i] == id;
    const Eigen::Vector3d p_S = X_SC * made.view.points[i].cast<double>();
    if (own) known.own.push_back(static_cast<int>(i));
    if (own || ((p_S - surface.box_S.center()).array().abs() <= half).all()) {
      known.near.push_back(static_cast<int>(i));
    }
  }
  known.own = thinned(known.own, kMostOwn), known.near = thinned(known.near, kMostNear);
  return known;
}

bool lies_on(const scene::View& view, int i, const Quadric& Q, double tolerance) {
  const Eigen::Vector3d x = view.points[i].cast<double>(), g = Q.gradient(x);
  // Strays have no normal, and compare as false.
  return std::abs(Q.distance(x)) <= tolerance &&
         std::abs(g.dot(view.normals[i].cast<double>())) >= kLeastCosine * g.norm();
}

/// Share of the surface's points on the quadric; 0 if most of what lies on it is foreign.
double coverage(const scene::View& view, const KnownSurface& known, const Quadric& Q) {
  const auto on = [&](int i) { return lies_on(view, i, Q, known.tolerance); };
  const double share = static_cast<double>(std::count_if(known.own.begin(), known.own.end(), on)) /
                       static_cast<double>(known.own.size());
  if (share < kCover) return 0.0;
  const int label = view.labels[known.own.front()];
  int all = 0, own = 0;
  for (const int i : known.near) {
    if (!on(i)) continue;
    ++all;
    own += view.labels[i] == label;
  }
  return own >= kPure * all ? share : 0.0;
}

}  // namespace

PointCloud cloud_of(const scene::Scene& made) {
  PointCloud cloud;
  cloud.points = made.view.points;
  cloud.read = cloud.points.size();
  return cloud;
}

SceneScore& SceneScore::operator+=(const SceneScore& other) {
  known += other.known, found += other.found;
  detected += other.detected, right += other.right;
  return *this;
}

SceneTruth::SceneTruth(const scene::Scene& made, double noise) : view_(made.view) {
  int id = 0;
  for (const scene::Body& body : made.layout.bodies) {
    for (std::size_t part = 0; part < body.surfaces.size(); ++part, ++id) {
      const Eigen::Isometry3d X_CS = made.layout.X_CW * body.X_WB * body.X_BS[part];
      KnownSurface known = known_surface(made, body.surfaces[part], X_CS, id, noise);
      if (static_cast<int>(known.own.size()) >= kLeastPoints) surfaces_.push_back(std::move(known));
    }
  }
}

std::vector<int> SceneTruth::matches(const DetectionResult& result) const {
  std::vector<char> taken(surfaces_.size(), 0);
  std::vector<int> ids;
  for (const Detection& detection : result.detections) {
    std::size_t best = 0;
    double most = 0.0;
    for (std::size_t k = 0; k < surfaces_.size(); ++k) {
      const bool free = !taken[k] && surfaces_[k].curved == (detection.type != QuadricType::kPlane);
      const double share = free ? coverage(view_, surfaces_[k], detection.Q_C) : 0.0;
      if (share > most) most = share, best = k;
    }
    ids.push_back(most > 0.0 ? surfaces_[best].id : -1);
    if (most > 0.0) taken[best] = 1;
  }
  return ids;
}

SceneScore SceneTruth::score(const DetectionResult& result) const {
  const std::vector<int> ids = matches(result);
  SceneScore sum;
  for (std::size_t d = 0; d < ids.size(); ++d) {
    if (result.detections[d].type == QuadricType::kPlane) continue;
    ++sum.detected;
    sum.right += ids[d] >= 0;
  }
  for (const KnownSurface& known : surfaces_) {
    if (!known.curved || known.pixels < kLeastPixels) continue;
    ++sum.known;
    sum.found += std::count(ids.begin(), ids.end(), known.id) > 0;
  }
  return sum;
}

}  // namespace quadrille::experiments
