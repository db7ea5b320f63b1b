#include "lab/experiments/section.hpp"

#include <array>
#include <optional>

#include "mesh/surface_mesh.hpp"

namespace quadrille::experiments {
namespace {

using Eigen::Vector2d;

std::optional<Vector2d> crossing(const Quadric& Q, const SectionPlane& plane, const Vector2d& from,
                                 const Vector2d& to) {
  const Eigen::Vector3d p = plane.at(from.x(), from.y()), q = plane.at(to.x(), to.y());
  if ((Q.value(p) < 0.0) == (Q.value(q) < 0.0)) return std::nullopt;
  return from + crossing_between(Q, p, q) * (to - from);
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
