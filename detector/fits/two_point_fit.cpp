#include "fits/two_point_fit.hpp"

#include <Eigen/Geometry>
#include <array>

#include "fit/monomials.hpp"
#include "variants/web.hpp"

namespace quadrille {
namespace {

std::optional<Eigen::Matrix4d> solve(const OrientedPointsd& points) {
  const auto web = make_web({points.at(0), points.at(1)}, 0.0);
  if (!web) return std::nullopt;
  // The planes wₖ(x) = e × dₖ · (x − x₁) are not normalised, so that w₃(x₄) = −w₄(x₃) holds to the
  // last bit: if both are small, the summands nearly cancel.
  const Eigen::Vector3d x1 = points.points.col(0), e = points.points.col(1) - points.points.col(0);
  std::array<Eigen::Vector4d, 3> w;
  std::array<double, 3> f, triple;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Eigen::Vector3d x = points.points.col(k + 2), across = e.cross(x - x1);
    const Eigen::Vector3d next = points.points.col((k + 1) % 3 + 2);
    w[k] << across, -across.dot(x1);
    f[k] = x.homogeneous().dot(web->Q0 * x.homogeneous());
    triple[k] = across.dot(next - x1);  // wₖ(xₖ₊₁)
    if (triple[k] == 0.0) return std::nullopt;
  }
  Eigen::Matrix4d Q = web->Q0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3, last = (k + 2) % 3;
    Q += f[k] / (triple[k] * triple[last]) * symmetric_product(w[next], w[last]);
  }
  return Q;
}

}  // namespace

std::optional<MinimalFit> fit_two_points(const OrientedPointsd& points) {
  if (points.size() < 5) return std::nullopt;
  const auto normalised = normalise(points.first(5), 5, Spread::kSpace);
  if (!normalised) return std::nullopt;
  return fit_with_error(*normalised, 2, solve);
}

}  // namespace quadrille
