#include "boxes/grouping.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille {
namespace {

// Faces are at right angles within this many standard deviations of the angle between their
// normals. The tolerance is at least kMinTolerance because of sensor waves; beyond kMaxTolerance a
// right angle cannot be told from others [rad].
constexpr double kSigmas = 3.0, kMinTolerance = 0.09, kMaxTolerance = 0.22;
// A face meets another if it ends this near to the other's plane [m]. Edges are rounded, and an
// obliquely seen face lacks its outermost points over this many pitches.
constexpr double kMaxGap = 0.012, kGapPitches = 2.0;
// Least share of the shorter face that lies beside the other one along their common edge.
constexpr double kMinOverlap = 0.6;

/// True if a face ends at the plane of another and lies behind it.
bool ends_at(const Face& face, const Face& other) {
  const auto [low, high] = face.reach(other.n_C);
  const double gap = kMaxGap + other.tolerance() + kGapPitches * face.pitch;
  const double end = high - other.offset;
  return std::abs(end) < gap && high - low > end;
}

bool are_near(const Face& a, const Face& b) {
  return (a.middle_C - b.middle_C).norm() < a.radius + b.radius + kMaxGap;
}

double overlap(const std::pair<double, double>& a, const std::pair<double, double>& b) {
  const double common = std::min(a.second, b.second) - std::max(a.first, b.first);
  return common / std::min(a.second - a.first, b.second - b.first);
}

}  // namespace

bool at_right_angles(const Face& a, const Face& b) {
  const double std = std::hypot(a.normal_std, b.normal_std);
  const double tolerance = std::clamp(kSigmas * std, kMinTolerance, kMaxTolerance);
  return std::abs(a.n_C.dot(b.n_C)) < std::sin(tolerance);
}

bool share_edge(const Face& a, const Face& b) {
  const Eigen::Vector3d edge_C = a.n_C.cross(b.n_C).normalized();
  return ends_at(a, b) && ends_at(b, a) && overlap(a.reach(edge_C), b.reach(edge_C)) > kMinOverlap;
}

std::vector<std::vector<int>> group_faces(const std::vector<Face>& faces) {
  const int size = static_cast<int>(faces.size());
  const auto together = [&](int i, int k) {
    return faces[i].id != faces[k].id && are_near(faces[i], faces[k]) &&
           at_right_angles(faces[i], faces[k]) && share_edge(faces[i], faces[k]);
  };
  std::vector<std::vector<int>> twos, threes;
  for (int i = 0; i < size; ++i) {
    for (int k = i + 1; k < size; ++k) {
      if (together(i, k)) twos.push_back({i, k});
    }
  }
  const auto paired = [&](int i, int k) {
    return std::find(twos.begin(), twos.end(), std::vector{i, k}) != twos.end();
  };
  for (const std::vector<int>& two : twos) {
    for (int k = two[1] + 1; k < size; ++k) {
      if (paired(two[0], k) && paired(two[1], k)) threes.push_back({two[0], two[1], k});
    }
  }
  const auto points = [&](const std::vector<int>& group) {
    std::size_t sum = 0;
    for (const int i : group) sum += faces[i].points_C.size();
    return sum;
  };
  for (std::vector<std::vector<int>>* groups : {&threes, &twos}) {
    std::stable_sort(groups->begin(), groups->end(),
                     [&](const auto& a, const auto& b) { return points(a) > points(b); });
  }
  threes.insert(threes.end(), twos.begin(), twos.end());
  return threes;
}

}  // namespace quadrille
