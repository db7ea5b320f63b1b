#include "mesh/surface_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace quadrille {
namespace {

/// Splits a cell into six tetrahedra around its diagonal from corner 0 to 7; those of neighbouring
/// cells fit together. The bits of a corner's number are its x, y and z.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {
    {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};

/// Meshes a surface by marching tetrahedra over a box.
class Mesher {
 public:
  Mesher(const Quadric& Q, const Eigen::AlignedBox3d& box, int cells)
      : Q_(Q), box_(box), cells_(cells), values_(corner_count()) {
    for (int k = 0; k <= cells_; ++k) {
      for (int j = 0; j <= cells_; ++j) {
        for (int i = 0; i <= cells_; ++i) values_[index(i, j, k)] = Q_.value(corner(i, j, k));
      }
    }
  }

  Mesh run() {
    for (int k = 0; k < cells_; ++k) {
      for (int j = 0; j < cells_; ++j) {
        for (int i = 0; i < cells_; ++i) visit_cell(i, j, k);
      }
    }
    return std::move(mesh_);
  }

 private:
  std::size_t corner_count() const {
    const auto side = static_cast<std::size_t>(cells_) + 1;
    return side * side * side;
  }
  std::uint32_t index(int i, int j, int k) const {
    return static_cast<std::uint32_t>((k * (cells_ + 1) + j) * (cells_ + 1) + i);
  }
  Eigen::Vector3d corner(int i, int j, int k) const {
    return box_.min() + Eigen::Vector3d(i, j, k).cwiseProduct(box_.sizes()) / cells_;
  }
  Eigen::Vector3d corner(std::uint32_t n) const {
    const auto side = static_cast<std::uint32_t>(cells_) + 1;
    return corner(static_cast<int>(n % side), static_cast<int>(n / side % side),
                  static_cast<int>(n / side / side));
  }

  void visit_cell(int i, int j, int k) {
    std::array<std::uint32_t, 8> corners;
    int below = 0;
    for (int c = 0; c < 8; ++c) {
      corners[c] = index(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2));
      below += values_[corners[c]] < 0.0 ? 1 : 0;
    }
    if (below == 0 || below == 8) return;
    for (const auto& t : kTetrahedra) {
      visit_tetrahedron({corners[t[0]], corners[t[1]], corners[t[2]], corners[t[3]]});
    }
  }

  void visit_tetrahedron(std::array<std::uint32_t, 4> t) {
    const auto middle =
        std::partition(t.begin(), t.end(), [&](std::uint32_t n) { return values_[n] < 0.0; });
    const auto below = middle - t.begin();
    if (below == 1) add(vertex(t[0], t[1]), vertex(t[0], t[2]), vertex(t[0], t[3]));
    if (below == 3) add(vertex(t[3], t[0]), vertex(t[3], t[1]), vertex(t[3], t[2]));
    if (below != 2) return;
    const std::uint32_t a = vertex(t[0], t[2]), b = vertex(t[0], t[3]), c = vertex(t[1], t[3]),
                        d = vertex(t[1], t[2]);
    add(a, b, c);
    add(a, c, d);
  }

  void add(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Eigen::Vector3d p = mesh_.vertices[a].cast<double>(),
                          q = mesh_.vertices[b].cast<double>(),
                          r = mesh_.vertices[c].cast<double>();
    const bool outward = (q - p).cross(r - p).dot(Q_.gradient((p + q + r) / 3.0)) >= 0.0;
    mesh_.triangles.push_back(outward ? std::array{a, b, c} : std::array{a, c, b});
  }

  /// Returns the vertex at which the surface crosses an edge; it is made once for all tetrahedra
  /// that share the edge.
  std::uint32_t vertex(std::uint32_t from, std::uint32_t to) {
    if (from > to) std::swap(from, to);
    const std::uint64_t key = std::uint64_t{from} << 32 | to;
    const auto [at, is_new] =
        made_.try_emplace(key, static_cast<std::uint32_t>(mesh_.vertices.size()));
    if (is_new) {
      const Eigen::Vector3d p = corner(from), q = corner(to);
      mesh_.vertices.push_back((p + crossing_between(Q_, p, q) * (q - p)).cast<float>());
    }
    return at->second;
  }

  Quadric Q_;
  Eigen::AlignedBox3d box_;
  int cells_;
  std::vector<double> values_;
  std::unordered_map<std::uint64_t, std::uint32_t> made_;
  Mesh mesh_;
};

/// Adds the edges that belong to only one triangle.
void add_rims(Mesh* mesh) {
  std::map<std::array<std::uint32_t, 2>, int> uses;
  for (const auto& t : mesh->triangles) {
    for (int i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i], b = t[(i + 1) % 3];
      ++uses[{std::min(a, b), std::max(a, b)}];
    }
  }
  for (const auto& [edge, count] : uses) {
    if (count == 1) mesh->rims.push_back(edge);
  }
}

/// Returns the extent, grown a little because the surface touches it from inside.
Eigen::AlignedBox3d grown_extent(const Detection& detection) {
  Eigen::AlignedBox3d box = detection.extent_Q;
  const double slack = 0.01 * box.sizes().maxCoeff() + std::min(detection.rms, 0.003);
  box.min().array() -= slack;
  box.max().array() += slack;
  return box;
}

}  // namespace

double crossing_between(const Quadric& Q, const Eigen::Vector3d& p, const Eigen::Vector3d& q) {
  const auto [first, second] = Q.crossings(p, q - p);
  return std::clamp(std::abs(first - 0.5) < std::abs(second - 0.5) ? first : second, 0.0, 1.0);
}

Mesh mesh_of(const Detection& detection, int cells) {
  const bool finite = detection.Q_C.matrix().allFinite() && detection.X_CQ.matrix().allFinite() &&
                      detection.extent_Q.min().allFinite() && detection.extent_Q.max().allFinite();
  if (!finite || detection.extent_Q.isEmpty()) return {};
  const Quadric Q_Q = detection.Q_C.transformed(detection.X_CQ.inverse());
  Mesh mesh = Mesher(Q_Q, grown_extent(detection), cells).run();
  add_rims(&mesh);
  return mesh;
}

Mesh mesh_of_outline(std::vector<Eigen::Vector2d> points) {
  const auto before = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::sort(points.begin(), points.end(), before);
  std::vector<Eigen::Vector2d> hull;
  const auto turns_left = [&](const Eigen::Vector2d& p) {
    const Eigen::Vector2d u = hull.back() - hull[hull.size() - 2], v = p - hull.back();
    return u.x() * v.y() - u.y() * v.x() > 0.0;
  };
  // Andrew's monotone chain finds the lower side first, then goes back along the upper one.
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const Eigen::Vector2d& p : points) {
      while (hull.size() >= start + 2 && !turns_left(p)) hull.pop_back();
      hull.push_back(p);
    }
    if (!hull.empty()) hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  if (hull.size() < 3) return {};
  Mesh mesh;
  const auto count = static_cast<std::uint32_t>(hull.size());
  for (std::uint32_t i = 0; i < count; ++i) {
    mesh.vertices.push_back(
        {static_cast<float>(hull[i].x()), static_cast<float>(hull[i].y()), 0.0f});
    mesh.rims.push_back({i, (i + 1) % count});
    if (i >= 2) mesh.triangles.push_back({0, i - 1, i});
  }
  return mesh;
}

}  // namespace quadrille
