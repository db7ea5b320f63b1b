#include "cloud/viewpoint_check.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>

#include "base/quantile.hpp"
#include "cloud/some_points.hpp"
#include "quadrille/detector/cloud_checks.hpp"

namespace quadrille {
namespace {

using Points = std::vector<Eigen::Vector3d>;

// Least length of the mean of unit rays. It is (1 + cos a) / 2 for rays that fill a cone of half
// angle a; with less, they fill more than a half space.
constexpr double kMinMeanRay = 0.3;
// Largest share of points that are nearer than kNearest: strays. If half of them are, the whole
// cloud is probably too small.
constexpr double kMaxNearShare = 0.01, kTooSmall = 0.5;
// Smaller planes are faces of things, whose other sides they hide in any fused cloud [m].
constexpr double kMinPlane = 0.15;
// No depth camera sees larger planes, and the cells of a claimed one could exhaust the memory [m].
constexpr double kMaxPlane = 100.0;
// Points nearer to a plane than kOwn belong to it; points farther from it than kAbout do not lie
// around it [m].
constexpr double kOwn = 0.015, kAbout = 0.3;
// Edge of the cells that record where on a plane points were seen [m].
constexpr double kPlaneCell = 0.04;
// Largest share of the points around a plane that it may hide.
constexpr double kMaxHidden = 0.6;

// The angle between neighbouring pixels is a tear if it is this many times the typical one; lenses
// change it less. The share of tears is allowed because viewpoints may be a few centimetres off.
constexpr double kTorn = 1.6, kMaxTorn = 0.02;
// Least cosine between a pixel's ray and the middle of the image that is used to correct its size.
constexpr double kMinAhead = 0.3;

/// Rays from the viewpoint to finite points spread evenly over the cloud.
Points rays_of(const CloudView& cloud) {
  Points rays = some_of(cloud.points);
  for (Eigen::Vector3d& ray : rays) ray -= cloud.viewpoint;
  return rays;
}

std::string percent(double share) {
  return std::to_string(static_cast<int>(std::lround(100.0 * share))) + " %";
}

/// Angles between neighbouring pixels in a row, each corrected to the middle of the image: a pixel
/// at tangents (u, v) is smaller by √(1 + v²) / (1 + u² + v²).
std::vector<double> pixel_angles(const CloudView& cloud) {
  std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>> pairs;
  Eigen::Vector3d ahead = Eigen::Vector3d::Zero(), along = Eigen::Vector3d::Zero();
  const std::size_t stride = step_over(cloud.points.size());
  for (std::size_t i = 0; i + 1 < cloud.points.size(); i += stride) {
    if ((i + 1) % static_cast<std::size_t>(cloud.width) == 0) continue;
    const Eigen::Vector3d a = (cloud.points[i].cast<double>() - cloud.viewpoint).normalized();
    const Eigen::Vector3d b = (cloud.points[i + 1].cast<double>() - cloud.viewpoint).normalized();
    if (!a.allFinite() || !b.allFinite()) continue;
    pairs.emplace_back(a, b);
    ahead += a;
    along += b - a;
  }
  ahead.normalize();
  const Eigen::Vector3d across = ahead.cross(along).normalized();
  std::vector<double> angles;
  for (const auto& [a, b] : pairs) {
    const double cosine = std::max(kMinAhead, a.dot(ahead)), v = a.dot(across) / cosine;
    const double shrunk = cosine * cosine * std::sqrt(1.0 + v * v);
    angles.push_back(std::atan2(a.cross(b).norm(), a.dot(b)) / shrunk);
  }
  return angles;
}

/// Describes the defect if neighbouring pixels of an organised cloud lie in very different
/// directions; empty if they do not. Seen from the sensor's position, the angle between two pixels
/// is the same whatever their depths.
std::string torn_image(const CloudView& cloud) {
  if (!cloud.organised()) return "";
  std::vector<double> angles = pixel_angles(cloud);
  if (angles.size() < kMinPoints) return "";
  const double usual = quantile(angles, 0.5);
  const auto torn = std::count_if(angles.begin(), angles.end(),
                                  [&](double angle) { return angle > kTorn * usual; });
  const double share = static_cast<double>(torn) / static_cast<double>(angles.size());
  return share > kMaxTorn ? percent(share) + " of neighbouring pixels lie far apart" : "";
}

/// The part of a plane in which points were seen, as a grid of cells.
class SeenPlane {
 public:
  /// @param eye_C  the viewpoint [m]
  SeenPlane(const Detection& plane, const Eigen::Vector3d& eye_C, const Points& rays_C)
      : X_PC_(plane.X_CQ.inverse()),
        eye_(X_PC_ * eye_C),
        low_(plane.extent_Q.min().head<2>()),
        width_(static_cast<int>(plane.extent_Q.sizes().x() / kPlaneCell) + 1),
        height_(static_cast<int>(plane.extent_Q.sizes().y() / kPlaneCell) + 1),
        seen_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), 0) {
    points_.reserve(rays_C.size());
    for (const Eigen::Vector3d& ray : rays_C) {
      points_.push_back(eye_ + X_PC_.linear() * ray);
      const Eigen::Vector3d& p = points_.back();
      const int cell = cell_at(p.head<2>());
      if (cell >= 0 && std::abs(p.z()) < kOwn) seen_[static_cast<std::size_t>(cell)] = 1;
    }
  }

  /// Number of points that do not belong to the plane, and of those that it hides from the
  /// viewpoint.
  struct Counts {
    std::size_t all = 0, hidden = 0;

    double share() const { return static_cast<double>(hidden) / static_cast<double>(all); }
    bool too_many() const { return hidden >= kMinPoints && share() > kMaxHidden; }
  };
  /// Counts only the points around the plane, or all points.
  Counts count(bool about) const {
    Counts counts;
    for (const Eigen::Vector3d& p : points_) {
      if (std::abs(p.z()) < kOwn) continue;
      if (about && (std::abs(p.z()) > kAbout || !near(p.head<2>()))) continue;
      ++counts.all;
      counts.hidden += hides(p);
    }
    return counts;
  }

  /// Distance of the viewpoint from the plane [m].
  double distance() const { return std::abs(eye_.z()); }

 private:
  int cell_at(const Eigen::Vector2d& p) const {
    const Eigen::Vector2d at = (p - low_) / kPlaneCell;
    const bool inside = at.x() >= 0 && at.y() >= 0 && at.x() < width_ && at.y() < height_;
    return inside ? static_cast<int>(at.y()) * width_ + static_cast<int>(at.x()) : -1;
  }
  bool near(const Eigen::Vector2d& p) const {
    const Eigen::Vector2d size(width_ * kPlaneCell, height_ * kPlaneCell), at = p - low_;
    return (at.array() > -kAbout).all() && (at.array() < size.array() + kAbout).all();
  }
  /// True if the line of sight to the point crosses a cell of the plane in which points were seen.
  bool hides(const Eigen::Vector3d& p) const {
    if (p.z() * eye_.z() >= 0.0) return false;
    const double along = eye_.z() / (eye_.z() - p.z());
    const int cell = cell_at((eye_ + along * (p - eye_)).head<2>());
    return cell >= 0 && seen_[static_cast<std::size_t>(cell)];
  }

  Eigen::Isometry3d X_PC_;
  Eigen::Vector3d eye_;
  Eigen::Vector2d low_;
  int width_, height_;
  std::vector<char> seen_;
  Points points_;
};

/// Share of the points that are nearer to the viewpoint than kNearest.
double near_share(const Points& rays) {
  const auto near = std::count_if(rays.begin(), rays.end(),
                                  [](const auto& ray) { return ray.norm() < kNearest; });
  return static_cast<double>(near) / static_cast<double>(rays.size());
}

/// Describes the defect if the viewpoint lies among the points; empty if it does not.
/// @param near  share of the points that are nearer to it than kNearest
std::string among_points(const Points& rays, double near) {
  if (near > kMaxNearShare) return percent(near) + " of the points lie within 20 mm of it";
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& ray : rays) sum += ray.stableNormalized();
  const bool all_round = sum.norm() < kMinMeanRay * static_cast<double>(rays.size());
  return all_round ? "points lie on all sides of it" : "";
}

/// Describes the defect if a plane hides most points around it; empty if none does.
std::string behind_plane(const CloudView& cloud, const Points& rays,
                         const std::vector<Detection>& detections) {
  for (const Detection& d : detections) {
    if (d.type != QuadricType::kPlane) continue;
    // Each by itself: the least of several numbers may leave out one that is NaN.
    const Eigen::Array2d size = d.extent_Q.sizes().head<2>();
    if (!((size > kMinPlane).all() && (size < kMaxPlane).all())) continue;
    const SeenPlane plane(d, cloud.viewpoint, rays);
    // A table seen from below hides the things on it; a wall hides everything behind it.
    const SeenPlane::Counts about = plane.count(true), all = plane.count(false);
    if (!about.too_many() && !all.too_many()) continue;
    const bool table = about.too_many();
    std::array<char, 64> away;
    std::snprintf(away.data(), away.size(), "%.2f m away", plane.distance());
    return percent((table ? about : all).share()) +
           (table ? " of the points about" : " of all beside") + " the plane " + away.data() +
           " lie hidden behind it";
  }
  return "";
}

}  // namespace

std::string contradict_viewpoint(const CloudView& given, const std::vector<Detection>& detections) {
  const RangeCheck range = check_range(given);
  return contradict_viewpoint_in_range(range.kept(given), detections, kNameViewpoint);
}

std::string contradict_viewpoint_in_range(const CloudView& cloud,
                                          const std::vector<Detection>& detections,
                                          const std::string& remedy) {
  if (!cloud.viewpoint.allFinite()) return "the viewpoint of the cloud is not known; " + remedy;
  const Points rays = rays_of(cloud);
  if (rays.size() < kMinPoints) return "";
  const double near = near_share(rays);
  std::string what = among_points(rays, near);
  if (what.empty()) what = torn_image(cloud);
  if (what.empty()) what = behind_plane(cloud, rays, detections);
  if (what.empty()) return "";
  std::array<char, 96> at;
  std::snprintf(at.data(), at.size(), "%.3f, %.3f, %.3f", cloud.viewpoint.x(), cloud.viewpoint.y(),
                cloud.viewpoint.z());
  return "the cloud cannot have been seen from its viewpoint " + std::string(at.data()) + ": " +
         what + "; " +
         (near > kTooSmall ? kTakenForMillimetres + std::string("; otherwise ") : "") + remedy;
}

}  // namespace quadrille
