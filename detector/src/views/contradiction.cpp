#include "views/contradiction.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "views/seen_through.hpp"

namespace quadrille {
namespace {

// Something was put down where so many of nine neighbouring cells show it; fewer are noise.
constexpr int kMinCells = 6;
// Edge of the cubes of which each holds one place [m].
constexpr float kPlaceEdge = 0.04f;
// Whatever was put down is about as deep as the side that is seen of it is wide, and no deeper than
// this [m]: what a hand carries is seldom larger. The fringes that stereo sensors see beside things
// are narrow.
constexpr float kMaxReach = 0.1f;

/// True if a part of the line between two places lies in the box; false if one is not finite.
bool passes_through(const Eigen::AlignedBox3f& box, const Eigen::Vector3f& from,
                    const Eigen::Vector3f& to) {
  const Eigen::Array3f way = (to - from).array();
  float enter = 0.0f, leave = 1.0f;
  for (int axis = 0; axis < 3; ++axis) {
    const float low = box.min()[axis] - from[axis], high = box.max()[axis] - from[axis];
    if (way[axis] == 0.0f) {
      if (low > 0.0f || high < 0.0f) return false;
      continue;
    }
    enter = std::max(enter, std::min(low / way[axis], high / way[axis]));
    leave = std::min(leave, std::max(low / way[axis], high / way[axis]));
  }
  return way.allFinite() && enter <= leave;
}

/// For each marked cell of a view the number of steps to the nearest cell that is not marked, or to
/// the border; 0 for other cells.
std::vector<int> steps_inside(const Mask& marked, const Sight& sight) {
  std::vector<int> steps(marked.size(), 0);
  const auto at = [&](int i, int j) {
    const bool inside = i >= 0 && j >= 0 && i < sight.width && j < sight.height;
    return inside ? steps[static_cast<std::size_t>(j) * sight.width + i] : 0;
  };
  for (std::size_t n = 0; n < steps.size(); ++n) {
    const int i = static_cast<int>(n) % sight.width, j = static_cast<int>(n) / sight.width;
    if (marked[n]) steps[n] = 1 + std::min(at(i - 1, j), at(i, j - 1));
  }
  for (std::size_t n = steps.size(); n-- > 0;) {
    const int i = static_cast<int>(n) % sight.width, j = static_cast<int>(n) / sight.width;
    if (marked[n]) steps[n] = std::min(steps[n], 1 + std::min(at(i + 1, j), at(i, j + 1)));
  }
  return steps;
}

/// Takes the connected piece around a cell out of the marked cells.
std::vector<std::size_t> take_piece(const Sight& sight, std::size_t seed, Mask* marked) {
  std::vector<std::size_t> piece = {seed};
  (*marked)[seed] = 0;
  for (std::size_t k = 0; k < piece.size(); ++k) {
    const int n = static_cast<int>(piece[k]);
    const int u = n % sight.width, v = n / sight.width;
    for (const auto& [i, j] : {std::pair(u - 1, v), {u + 1, v}, {u, v - 1}, {u, v + 1}}) {
      if (i < 0 || j < 0 || i >= sight.width || j >= sight.height) continue;
      const std::size_t next = static_cast<std::size_t>(j) * sight.width + i;
      if (!(*marked)[next]) continue;
      (*marked)[next] = 0;
      piece.push_back(next);
    }
  }
  return piece;
}

/// The places of things that a newer view shows where an older one saw through, some centimetres
/// apart, in the frame of both sights.
std::vector<NewPlace> put_down(const Sight& newer, const Sight& older) {
  const Mask through = cells_seen_through(newer, older);
  const std::vector<int> steps = steps_inside(through, newer);
  Mask marked(through.size(), 0);
  for (int j = 0; j < newer.height; ++j) {
    for (int i = 0; i < newer.width; ++i) {
      const std::size_t cell = static_cast<std::size_t>(j) * newer.width + i;
      marked[cell] = through[cell] && count_marked_about(through, newer, i, j) >= kMinCells;
    }
  }
  std::vector<NewPlace> places;
  std::set<std::tuple<int, int, int>> taken;
  for (std::size_t cell = 0; cell < marked.size(); ++cell) {
    if (!marked[cell]) continue;
    const std::vector<std::size_t> piece = take_piece(newer, cell, &marked);
    float width = 0.0f;
    for (const std::size_t n : piece) {
      width = std::max(width, 2.0f * static_cast<float>(steps[n]) * newer.step / newer.w[n]);
    }
    const float reach = std::min(width, kMaxReach);
    for (const std::size_t n : piece) {
      const int k = static_cast<int>(n);
      const Eigen::Vector3f place = place_of_cell(newer, k % newer.width, k / newer.width);
      const Eigen::Array3i cube = (place.array() / kPlaceEdge).floor().cast<int>();
      if (taken.emplace(cube.x(), cube.y(), cube.z()).second) places.push_back({place, reach});
    }
  }
  return places;
}

/// Calls visit(cell, place) for each cell that saw something, with the place that it shows.
template <class Visit>
void for_each_seen(const Sight& sight, const Visit& visit) {
  for (int j = 0; j < sight.height; ++j) {
    for (int i = 0; i < sight.width; ++i) {
      const std::size_t cell = static_cast<std::size_t>(j) * sight.width + i;
      if (sight.w[cell] > 0.0f) visit(cell, place_of_cell(sight, i, j));
    }
  }
}

}  // namespace

Contradiction::Contradiction(const Sight& older, const Sight& newer)
    : older_(older),
      newer_(newer),
      eye_C_(older.X_VC.inverse().translation()),
      places_C_(put_down(newer, older)),
      through_(cells_seen_through(older, newer)) {}

bool Contradiction::passes_new(const Eigen::Vector3f& p_C) const {
  const Eigen::Vector3f ray = (p_C - eye_C_).normalized();
  const float length = (p_C - eye_C_).norm();
  return std::any_of(places_C_.begin(), places_C_.end(), [&](const NewPlace& place) {
    const Eigen::Vector3f to = place.p_C - eye_C_;
    const float along = std::clamp(to.dot(ray), 0.0f, length);
    return (to - along * ray).squaredNorm() < place.reach * place.reach;
  });
}

Mask Contradiction::seen_through(std::span<const Eigen::Vector3f> points_C) const {
  Mask through = points_seen_through(points_C, older_, through_, newer_);
  const Mask at_border = border_points_seen_through(points_C, older_, through_, newer_);
  for (std::size_t n = 0; n < points_C.size(); ++n) through[n] |= at_border[n];
  return through;
}

void Contradiction::mark_behind_new(std::span<const Eigen::Vector3f> points_C, Mask* marked) const {
  if (places_C_.empty()) return;
  for (std::size_t n = 0; n < points_C.size(); ++n) (*marked)[n] |= passes_new(points_C[n]);
}

Mask Contradiction::of_points(std::span<const Eigen::Vector3f> points_C) const {
  Mask contradicted = seen_through(points_C);
  mark_behind_new(points_C, &contradicted);
  return contradicted;
}

void Contradiction::clear(Sight* older) const {
  if (!places_C_.empty()) {
    for_each_seen(*older, [&](std::size_t cell, const Eigen::Vector3f& place) {
      if (passes_new(place)) older->w[cell] = 0.0f;
    });
  }
  for (std::size_t cell = 0; cell < through_.size(); ++cell) {
    if (through_[cell]) older->w[cell] = 0.0f;
  }
}

Mask ForgottenBox::of_points(std::span<const Eigen::Vector3f> points_C,
                             const Eigen::Vector3d& eye_C) const {
  const Eigen::Vector3f eye_R = X_RC * eye_C.cast<float>();
  Mask forgotten;
  for (const Eigen::Vector3f& p_C : points_C) {
    forgotten.push_back(passes_through(box_R, eye_R, X_RC * p_C));
  }
  return forgotten;
}

void ForgottenBox::clear(Sight* sight) const {
  const Eigen::Vector3f eye_R = X_RC * sight->X_VC.inverse().translation();
  for_each_seen(*sight, [&](std::size_t cell, const Eigen::Vector3f& place) {
    if (passes_through(box_R, eye_R, X_RC * place)) sight->w[cell] = 0.0f;
  });
}

}  // namespace quadrille
