#include "boxes/around_face.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "base/quantile.hpp"
#include "boxes/bend.hpp"
#include "boxes/box_ends.hpp"

namespace quadrille {
namespace {

// Only the middle of an edge is looked at, this share of its length, since corners may be rounded.
constexpr double kMiddle = 0.8;
// Least share of the points beside an edge that lie behind the face if nothing touches the face.
constexpr double kMinFree = 0.7;
// Points beside an edge that lie within this depth may belong to the edge itself [m]: with a
// rounding of this radius the face of a box would be far from flat.
constexpr double kEdgeDepth = 2.0 * kRounding;
// A surface goes on if its points within that depth reach farther outward than this [m], and are at
// least this share of the points beside the edge.
constexpr double kMaxOutward = 1.5 * kRounding;
constexpr double kMinOnward = 0.3;
// Fewer points may be mixed from two surfaces.
constexpr std::size_t kMinPoints = 8;
// Shares of points that are left out as strays.
constexpr double kStrays = 0.1, kFewStrays = 0.05;
// Least share of an edge past which something was seen.
constexpr double kMinCovered = 0.5;

double outward(const LoneEdge& edge, const Eigen::Vector3d& p_A) {
  return edge.upper ? p_A[edge.axis] : -p_A[edge.axis];
}

}  // namespace

AroundFace::AroundFace(const BoxDraft& draft, const std::array<std::array<double, 2>, 2>& edges)
    : draft_(draft),
      face_(*draft.faces.front()),
      edges_(edges),
      eye_A_(draft.R_CA.transpose() * draft.sight->eye()) {
  Eigen::AlignedBox3d box_A = draft.reach_A;
  const double depth = std::min(0.5 * kMaxSide, box_A.sizes().tail<2>().maxCoeff());
  box_A.min()[0] = box_A.max()[0] - depth;
  const auto points_C = draft.sight->points_towards(draft.corners_C(box_A), kAround);
  for (const SeenThrough& seen : look_through(face_, points_C, *draft.sight)) {
    points_.push_back(
        {draft.R_CA.transpose() * seen.p_C, draft.R_CA.transpose() * seen.on_C, -seen.height});
  }
}

double AroundFace::along(const LoneEdge& edge, const Eigen::Vector3d& place_A) const {
  const int across = 3 - edge.axis;
  const double low = -edges_[across - 1][0], high = edges_[across - 1][1];
  return 0.5 + (place_A[across] - 0.5 * (low + high)) / (kMiddle * (high - low));
}

bool AroundFace::is_turned_to_eye(const LoneEdge& edge) const {
  const double distance = (draft_.sight->eye() - face_.middle_C).norm();
  return outward(edge, eye_A_) - edge.at > kMinCosine * distance;
}

BesideEdge AroundFace::beside(const LoneEdge& edge) const {
  std::size_t all = 0, behind = 0;
  std::vector<double> near, on_side;
  for (const Point& point : points_) {
    const double beyond = outward(edge, point.on_A) - edge.at;
    const double at = along(edge, point.on_A);
    if (!(beyond > 0.0 && at >= 0.0 && at < 1.0)) continue;
    const double out = outward(edge, point.p_A) - edge.at;
    const bool is_behind = point.depth > face_.tolerance();
    if (beyond < kAround) {
      ++all;
      behind += is_behind;
      if (is_behind && point.depth < kEdgeDepth && out < kEdgeDepth) near.push_back(out);
    }
    const bool deep = point.depth > kRounding && point.depth < kRounding + kEdgeDepth;
    if (deep && std::abs(out) < kEdgeDepth) on_side.push_back(out);
  }
  BesideEdge found;
  found.faces_eye = is_turned_to_eye(edge);
  found.free = static_cast<double>(behind) > kMinFree * static_cast<double>(all);
  found.goes_on = near.size() >= kMinPoints &&
                  static_cast<double>(near.size()) > kMinOnward * static_cast<double>(all) &&
                  quantile(near, 1.0 - kStrays) > kMaxOutward;
  if (!found.faces_eye || on_side.size() < kMinPoints) return found;
  found.side = median(on_side);
  for (double& out : on_side) out -= *found.side;
  found.spread = robust_std(on_side);
  return found;
}

std::optional<DepthPastEdge> AroundFace::depth_past(const LoneEdge& edge) const {
  if (!is_turned_to_eye(edge)) return std::nullopt;
  const Eigen::Vector3d u_C = draft_.R_CA.col(3 - edge.axis);
  const double width = kGapPitches * face_.pitch_along(u_C, *draft_.sight);
  const auto& ends = edges_[2 - edge.axis];
  const double length = kMiddle * (ends[0] + ends[1]);
  if (!(width > 0.0 && length > 0.0)) return std::nullopt;
  const auto count = static_cast<std::size_t>(1.0 + length / width);
  std::vector<double> least(count, std::numeric_limits<double>::infinity()), on_side;
  const double eye_out = outward(edge, eye_A_), eye_depth = -face_.height(draft_.sight->eye());
  for (const Point& point : points_) {
    const double out = outward(edge, point.p_A);
    const double at = along(edge, point.p_A);
    const bool level = std::abs(out - edge.at) < face_.tolerance();
    if (level && point.depth > face_.tolerance() && at >= 0.0 && at < 1.0) {
      on_side.push_back(point.depth);
    }
    const bool past = outward(edge, point.on_A) > edge.at && out < edge.at - face_.tolerance();
    if (!past || point.depth < kEdgeDepth) continue;
    const double part = (edge.at - eye_out) / (out - eye_out);
    const double bin =
        static_cast<double>(count) * along(edge, eye_A_ + part * (point.p_A - eye_A_));
    if (!(bin >= 0.0 && bin < static_cast<double>(count))) continue;
    double& depth = least[static_cast<std::size_t>(bin)];
    depth = std::min(depth, eye_depth + part * (point.depth - eye_depth));
  }
  DepthPastEdge found;
  found.bound = quantile(least, kMinCovered);
  if (!std::isfinite(found.bound)) return std::nullopt;
  const double pitch = face_.pitch_along(draft_.R_CA.col(edge.axis), *draft_.sight);
  found.unsure = pitch * -eye_depth / (eye_out - edge.at);
  std::erase_if(on_side, [&](double depth) { return depth > found.bound + face_.tolerance(); });
  if (on_side.size() >= kMinPoints) found.seen = quantile(on_side, 1.0 - kFewStrays);
  return found;
}

double AroundFace::turn() const {
  std::vector<Eigen::Vector3d> on_face_C;
  for (const Point& point : points_) {
    if (std::abs(point.depth) > face_.tolerance()) continue;
    const double u = along({1, 0, 0.0}, point.on_A), v = along({2, 0, 0.0}, point.on_A);
    if (u >= 0.0 && u < 1.0 && v >= 0.0 && v < 1.0) on_face_C.push_back(draft_.R_CA * point.p_A);
  }
  return bend_of(face_, on_face_C).turn;
}

}  // namespace quadrille
