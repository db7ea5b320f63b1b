#include "fits/scatter.hpp"

#include "fit/closed_form/taubin.hpp"

namespace quadrille {

Scatter::Scatter(const OrientedPointsd& points)
    : values(scatter_of_values(points)), gradients(scatter_of_gradients(values)) {
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const Vector10d g =
        monomial_gradients(points.points.col(i)).transpose() * points.normals.col(i);
    along += g * g.transpose();
    alignment += g;
  }
  const double count = static_cast<double>(points.size());
  values /= count, gradients /= count, along /= count, alignment /= count;
}

}  // namespace quadrille
