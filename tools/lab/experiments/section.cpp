#include "lab/experiments/section.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace quadrille::experiments {
namespace {

using Eigen::Vector2d;

/// Returns the root between two points of opposite signs. Along a line a quadric is a parabola,
/// which the value in the middle determines.
double root_between(double first, double middle, double last) {
  const double a = 2.0 * (first + last - 2.0 * middle), b = last - first - a;
  // This form avoids cancellation; exactly one of the two roots lies in between.
  const double q = -0.5 * (b + std::copysign(std::sqrt(std::max(0.0, b * b - 4 * a * first)), b));
  const double other = q != 0.0 ? first / q : 0.0;
  if (a == 0.0 || (other >= 0.0 && other <= 1.0)) return other;
  return q / a;
}

std::optional<Vector2d> crossing(const Quadric& Q, const SectionPlane& plane, const Vector2d& from,
                                 const Vector2d& to) {
  const auto value = [&](const Vector2d& p) { return Q.value(plane.at(p.x(), p.y())); };
  const double first = value(from), last = value(to);
  if ((first < 0.0) == (last < 0.0)) return std::nullopt;
  return from + root_between(first, value(0.5 * (from + to)), last) * (to - from);
}

}  // namespace

std::vector<std::pair<double, double>> section(const Quadric& Q, const SectionPlane& plane,
                                               double half, int cells) {
  std::vector<std::pair<double, double>> ends;
  const double step = 2.0 * half / cells;
  for (int i = 0; i < cells; ++i) {
    for (int j = 0; j < cells; ++j) {
      const Vector2d low(-half + i * step, -half + j * step);
      const std::array<Vector2d, 4> corners = {low, low + Vector2d(step, 0),
                                               low + Vector2d(step, step), low + Vector2d(0, step)};
      std::vector<Vector2d> hits;
      for (std::size_t k = 0; k < 4; ++k) {
        if (const auto hit = crossing(Q, plane, corners[k], corners[(k + 1) % 4])) {
          hits.push_back(*hit);
        }
      }
      // There are two hits, or four near a saddle.
      for (std::size_t k = 0; k + 1 < hits.size(); k += 2) {
        for (const Vector2d& p : {hits[k], hits[k + 1]}) ends.emplace_back(p.x(), p.y());
      }
    }
  }
  return ends;
}

}  // namespace quadrille::experiments
