#include "boxes/grouping.hpp"

#include <algorithm>
#include <cmath>

namespace quadrille {
namespace {

// A face meets another if it ends this near to the other's plane [m]: both of their edges may be
// rounded.
constexpr double kMaxGap = 2.0 * kRounding;

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

}  // namespace

bool at_right_angles(const Face& a, const Face& b) {
  return std::abs(a.n_C.dot(b.n_C)) < std::sin(kMaxSkew);
}

bool share_edge(const Face& a, const Face& b) { return ends_at(a, b) && ends_at(b, a); }

std::vector<std::vector<int>> group_faces(const std::vector<Face>& faces) {
  const int size = static_cast<int>(faces.size());
  const auto together = [&](int i, int k) {
    return are_near(faces[i], faces[k]) && at_right_angles(faces[i], faces[k]) &&
           share_edge(faces[i], faces[k]);
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
