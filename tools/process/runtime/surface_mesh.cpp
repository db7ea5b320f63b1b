#include "process/runtime/surface_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace quadrille {
namespace {

/// Marches through the grid of a box, with the quadric's values at its points.
class Marcher {
 public:
  Marcher(const Quadric& Q, const Eigen::AlignedBox3d& box, int cells) : Q_(Q), box_(box) {
    const Eigen::Vector3d sizes = box.sizes();
    for (int i = 0; i < 3; ++i) {
      const double share = sizes[i] / std::max(sizes.maxCoeff(), 1e-12);
      cells_[i] = std::max(1, static_cast<int>(std::ceil(share * cells)));
    }
    for (int n = 0; n < count_points(); ++n) values_.push_back(Q.value(point(n)));
  }

  TriangleMesh march() {
    // The six tetrahedra lie around the diagonal from corner 0 to corner 7; the bits of a corner's
    // number are x y z.
    constexpr int kTetrahedra[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7},
                                       {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
    for (int z = 0; z < cells_[2]; ++z) {
      for (int y = 0; y < cells_[1]; ++y) {
        for (int x = 0; x < cells_[0]; ++x) {
          for (const auto& corners : kTetrahedra) {
            std::array<int, 4> points{};
            for (int i = 0; i < 4; ++i) {
              const int c = corners[i];
              points[i] = number(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2));
            }
            cut(points);
          }
        }
      }
    }
    return std::move(mesh_);
  }

 private:
  int number(int x, int y, int z) const { return (z * (cells_[1] + 1) + y) * (cells_[0] + 1) + x; }
  int count_points() const { return number(cells_[0], cells_[1], cells_[2]) + 1; }

  Eigen::Vector3d point(int n) const {
    const int x = n % (cells_[0] + 1), rest = n / (cells_[0] + 1);
    const Eigen::Array3d share(double(x) / cells_[0], double(rest % (cells_[1] + 1)) / cells_[1],
                               double(rest / (cells_[1] + 1)) / cells_[2]);
    return box_.min().array() + share * box_.sizes().array();
  }

  /// Adds the triangles in which the surface cuts a tetrahedron.
  void cut(const std::array<int, 4>& points) {
    std::vector<int> inside, outside;
    for (const int p : points) (values_[p] < 0.0 ? inside : outside).push_back(p);
    if (inside.size() == 1 || outside.size() == 1) {
      const std::vector<int>& others = inside.size() == 1 ? outside : inside;
      const int apex = inside.size() == 1 ? inside[0] : outside[0];
      add(vertex(apex, others[0]), vertex(apex, others[1]), vertex(apex, others[2]));
    } else if (inside.size() == 2) {
      const int a = vertex(inside[0], outside[0]), b = vertex(inside[0], outside[1]);
      const int c = vertex(inside[1], outside[1]), d = vertex(inside[1], outside[0]);
      add(a, b, c);
      add(a, c, d);
    }
  }

  /// Returns the vertex at which the surface crosses an edge.
  int vertex(int a, int b) {
    const auto [entry, is_new] =
        vertices_.try_emplace(std::minmax(a, b), static_cast<int>(mesh_.vertices.size()));
    if (!is_new) return entry->second;
    // Along a line, f is a parabola c + bt + at², which its values at the ends and in the middle
    // determine.
    const Eigen::Vector3d from = point(a), to = point(b);
    const double f0 = values_[a], f1 = values_[b], middle = Q_.value(0.5 * (from + to));
    const double square = 2.0 * (f0 + f1 - 2.0 * middle), slope = f1 - f0 - square;
    const double root = std::sqrt(std::max(0.0, slope * slope - 4.0 * square * f0));
    const double s = -0.5 * (slope + std::copysign(root, slope));
    // Exactly one of the two roots lies between the ends.
    double t = f0 / s;
    if (!(t >= 0.0 && t <= 1.0)) t = s / square;
    mesh_.vertices.push_back(from + std::clamp(t, 0.0, 1.0) * (to - from));
    return entry->second;
  }

  void add(int a, int b, int c) {
    const auto& v = mesh_.vertices;
    const Eigen::Vector3d normal = (v[b] - v[a]).cross(v[c] - v[a]);
    const bool turned = normal.dot(Q_.gradient((v[a] + v[b] + v[c]) / 3.0)) < 0.0;
    mesh_.triangles.push_back(turned ? std::array{a, c, b} : std::array{a, b, c});
  }

  const Quadric& Q_;
  Eigen::AlignedBox3d box_;
  std::array<int, 3> cells_{};
  std::vector<double> values_;
  std::map<std::pair<int, int>, int> vertices_;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh mesh_in_box(const Quadric& Q, const Eigen::AlignedBox3d& box, int cells) {
  if (box.isEmpty() || !Q.matrix().allFinite()) return {};
  return Marcher(Q, box, cells).march();
}

}  // namespace quadrille
