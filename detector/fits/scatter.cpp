#include "fits/scatter.hpp"

namespace quadrille {

Scatter::Scatter(const OrientedPoints& points) {
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Vector10d v = monomials(points.points.col(i));
    const Eigen::Matrix<double, 3, 10> G = monomial_gradients(points.points.col(i));
    const Vector10d g = G.transpose() * points.normals.col(i);
    values += v * v.transpose();
    gradients += G.transpose() * G;
    along += g * g.transpose();
    alignment += g;
  }
  const double count = static_cast<double>(points.size());
  values /= count, gradients /= count, along /= count, alignment /= count;
}

}  // namespace quadrille
