#include "search/basis.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "fit/monomials.hpp"

namespace quadrille {
namespace {

/// The product b_ij = nᵢ·(x_j − xᵢ).
double b(const std::array<OrientedPoint, 3>& basis, int i, int j) {
  return basis[i].n.dot(basis[j].x - basis[i].x);
}

}  // namespace

double inconsistency(const std::array<OrientedPoint, 3>& basis) {
  const double one_way = b(basis, 0, 1) * b(basis, 1, 2) * b(basis, 2, 0);
  const double other_way = b(basis, 1, 0) * b(basis, 2, 1) * b(basis, 0, 2);
  const double size = std::abs(one_way) + std::abs(other_way);
  return size > 0.0 ? std::abs(one_way - other_way) / size : 0.0;
}

std::optional<Pencil> make_pencil(const std::array<OrientedPoint, 3>& basis,
                                  double min_area_share) {
  const Eigen::Vector3d &x1 = basis[0].x, &x2 = basis[1].x, &x3 = basis[2].x;
  const Eigen::Vector3d cross = (x2 - x1).cross(x3 - x1);
  const double area = cross.norm();
  const double max_square =
      std::max({(x2 - x1).squaredNorm(), (x3 - x2).squaredNorm(), (x1 - x3).squaredNorm()});
  if (!(area > min_area_share * max_square)) return std::nullopt;
  const Eigen::Vector3d m = cross / area;
  // The barycentric coordinate uᵢ is 1 at xᵢ and 0 on the opposite edge.
  const Eigen::Vector3d g1 = m.cross(x3 - x2) / area;
  const Eigen::Vector3d g2 = m.cross(x1 - x3) / area;
  const Eigen::Vector3d g3 = m.cross(x2 - x1) / area;
  const auto affine = [](const Eigen::Vector3d& g, double at, const Eigen::Vector3d& x) {
    return Eigen::Vector4d(g.x(), g.y(), g.z(), at - g.dot(x));
  };
  const std::array<Eigen::Vector4d, 3> u = {affine(g1, 1, x1), affine(g2, 1, x2),
                                            affine(g3, 1, x3)};
  Pencil pencil;
  pencil.plane = affine(m, 0, x1);
  pencil.Q0.setZero();
  Eigen::Vector4d l = Eigen::Vector4d::Zero();
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    // With exact data c_ij = b_ij = b_ji; with noise, the two are averaged.
    pencil.Q0 += 0.5 * (b(basis, i, j) + b(basis, j, i)) * symmetric_product(u[i], u[j]);
    l += basis[i].n.dot(m) * u[i];
  }
  pencil.Q0 += symmetric_product(pencil.plane, l);
  return pencil;
}

}  // namespace quadrille
