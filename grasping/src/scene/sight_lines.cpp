#include "scene/sight_lines.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace quadrille {
namespace {

// The hand needs to know the space up to this distance from a body [m]: about a finger's thickness,
// its room, and the length that encloses the body.
constexpr double kNeeded = 0.04;
// Round bodies, and those that are guessed in part, are smaller than the boxes around them. A box
// therefore hides only what lies behind its core, whose sides are this share of the box's.
constexpr double kCore = 0.75;
// Number of unknown voxels of a body that are looked at; more give the same shares.
constexpr std::size_t kVoxels = 250;
// Half the angle that the camera sees [rad].
constexpr double kHalfView = 0.4;

/// The box around a body in its frame, grown by the space that the hand needs.
Eigen::AlignedBox3d needed_box(const SceneBody& body) {
  const Eigen::Vector3d half = (0.5 * body.size).array() + kNeeded;
  return {-half, half};
}

/// The part of the box around a body that hides what lies behind it.
Eigen::AlignedBox3d core_of(const SceneBody& body) {
  const Eigen::Vector3d half = 0.5 * kCore * body.size;
  return {-half, half};
}

/// True if the segment between two points crosses a box.
bool crosses(const Eigen::AlignedBox3d& box, const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  double first = 0.0, last = 1.0;
  for (int k = 0; k < 3; ++k) {
    const double d = b[k] - a[k];
    if (std::abs(d) < 1e-12) {
      if (a[k] < box.min()[k] || a[k] > box.max()[k]) return false;
      continue;
    }
    const double s = (box.min()[k] - a[k]) / d, t = (box.max()[k] - a[k]) / d;
    first = std::max(first, std::min(s, t));
    last = std::min(last, std::max(s, t));
  }
  return first < last;
}

}  // namespace

std::vector<Eigen::Vector3d> SightLines::unknown_about(const SceneBody& body,
                                                       const Eigen::Vector3d& up_C) const {
  const Eigen::Isometry3d X_BC = body.X_CB.inverse();
  const Eigen::AlignedBox3d near_B = needed_box(body), core_B = core_of(body);
  const Eigen::Vector3d reach = body.X_CB.linear().cwiseAbs() * near_B.max();
  const Eigen::Array3d corner = space_.corner().cast<double>().array();
  const auto index = [&](const Eigen::Vector3d& p_C) -> Eigen::Vector3i {
    const Eigen::Array3d x = (p_C / space_.resolution()).array().floor() - corner;
    return x.max(0.0).min(space_.size().cast<double>().array() - 1.0).cast<int>();
  };
  const double foot = -0.5 * (body.X_CB.linear().transpose() * up_C).cwiseAbs().dot(body.size);
  const Eigen::Vector3i low = index(body.X_CB.translation() - reach);
  const Eigen::Vector3i high = index(body.X_CB.translation() + reach);
  std::vector<Eigen::Vector3d> unknown;
  for (int k = low.z(); k <= high.z(); ++k) {
    for (int j = low.y(); j <= high.y(); ++j) {
      for (int i = low.x(); i <= high.x(); ++i) {
        if (space_.at(i, j, k) != Voxel::kUnknown) continue;
        const Eigen::Vector3d p_C = space_.centre(i, j, k), p_B = X_BC * p_C;
        if (!near_B.contains(p_B) || core_B.contains(p_B)) continue;
        if (up_C.dot(p_C - body.X_CB.translation()) < foot + space_.resolution()) continue;
        unknown.push_back(p_C);
      }
    }
  }
  const std::size_t step = unknown.size() / kVoxels + 1;
  std::vector<Eigen::Vector3d> some;
  for (std::size_t n = step / 2; n < unknown.size(); n += step) some.push_back(unknown[n]);
  return some;
}

double SightLines::share(const std::vector<Eigen::Vector3d>& places_C, const Eigen::Vector3d& eye_C,
                         const Eigen::Vector3d& ahead) const {
  const auto seen =
      std::count_if(places_C.begin(), places_C.end(), [&](const Eigen::Vector3d& p_C) {
        return (p_C - eye_C).normalized().dot(ahead) > std::cos(kHalfView) && sees(eye_C, p_C);
      });
  return static_cast<double>(seen) / static_cast<double>(places_C.size());
}

bool SightLines::sees(const Eigen::Vector3d& eye_C, const Eigen::Vector3d& p_C) const {
  for (const SceneBody& body : bodies_) {
    const Eigen::Isometry3d X_BC = body.X_CB.inverse();
    if (crosses(core_of(body), X_BC * p_C, X_BC * eye_C)) return false;
  }
  const Eigen::Vector3d step = space_.resolution() * (eye_C - p_C).normalized();
  const Eigen::AlignedBox3d bounds = space_.bounds();
  // The voxel itself may touch a surface that hides it from elsewhere.
  for (Eigen::Vector3d at = p_C + 2.0 * step; bounds.contains(at); at += step) {
    if (space_.at(at) == Voxel::kOccupied) return false;
  }
  return true;
}

}  // namespace quadrille
