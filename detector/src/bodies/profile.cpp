#include "bodies/profile.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "fit/coaxial_fit.hpp"
#include "surfaces/uncertainty.hpp"

namespace quadrille {
namespace {

// Step of the parameters for derivatives, in local coordinates of about unit size.
constexpr double kStep = 1e-6;

/// Signed first-order distance of a place from the surface of a canonical matrix, positive outside.
double distance_at(const Eigen::Matrix4d& D, const Place& place) {
  const Eigen::Vector4d x(place.radius, 0.0, place.height, 1.0), h = D * x;
  return (D(0, 0) < 0.0 ? -0.5 : 0.5) * x.dot(h) / h.head<3>().norm();
}

}  // namespace

bool is_turned(const LastFit& fit) {
  const Family family = fit.surface.fit.family;
  return fit.points.size() > 0 && (family == Family::kSphere || has_one_axis(family));
}

Eigen::Vector3d own_axis(const Surface& surface) { return surface.fit.posed.X.linear().col(2); }

double height_in(const Surface& surface, const Eigen::Vector3d& p_C,
                 const Eigen::Vector3d& axis_C) {
  const Eigen::Vector3d p = (p_C - surface.local.centre) / surface.local.scale;
  return axis_C.dot(p - surface.fit.posed.X.translation());
}

std::optional<double> radius_at(const Eigen::Matrix4d& D, double z) {
  const double square = -(D(2, 2) * z * z + 2.0 * D(2, 3) * z + D(3, 3)) / D(0, 0);
  if (!(square > 0.0)) return std::nullopt;
  return std::sqrt(square);
}

MeanDistance mean_distance(const Surface& surface, const std::vector<Place>& places,
                           const Eigen::Vector3d& axis_C) {
  const FamilyFit& fit = surface.fit;
  const Eigen::Index size = surface.information.JtJ.rows();
  const auto mean = [&](const PosedQuadric& at) -> Eigen::VectorXd {
    // The place moves along the axis against the surface.
    const double along = (at.X.translation() - fit.posed.X.translation()).dot(axis_C);
    double sum = 0.0;
    for (const Place& place : places) {
      sum += distance_at(at.D, {place.radius, place.height - along});
    }
    return Eigen::VectorXd::Constant(
        1, surface.local.scale * sum / static_cast<double>(places.size()));
  };
  return {mean(fit.posed)[0],
          derivative(fit.posed, fit.family, Eigen::VectorXd::Constant(size, kStep), mean).row(0)};
}

Eigen::MatrixXd parameter_covariance(const Surface& surface) {
  const auto I =
      Eigen::MatrixXd::Identity(surface.information.JtJ.rows(), surface.information.JtJ.cols());
  return surface.fit.points * variance_of_mean(surface) * surface.information.JtJ.ldlt().solve(I);
}

Eigen::VectorXd offset_step(const Surface& surface) {
  return -surface.information.JtJ.ldlt().solve(surface.information.Jt1);
}

std::optional<Eigen::MatrixXd> parameter_covariance(int a, int b,
                                                    std::span<const CommonAxis> axes) {
  for (const CommonAxis& axis : axes) {
    const auto at = [&](int k) { return std::find(axis.members.begin(), axis.members.end(), k); };
    if (at(a) == axis.members.end() || at(b) == axis.members.end()) continue;
    return axis.covariance.between(static_cast<std::size_t>(at(a) - axis.members.begin()),
                                   static_cast<std::size_t>(at(b) - axis.members.begin()));
  }
  return std::nullopt;
}

}  // namespace quadrille
