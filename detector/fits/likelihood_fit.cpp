#include "fits/likelihood_fit.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "fits/projection.hpp"
#include "fits/refine_quadric.hpp"
#include "fits/start_quadric.hpp"

namespace quadrille {
namespace {

// Least noise of a coordinate and of a normal in the unit ball, which keeps exact data solvable.
constexpr double kMinNoise = 1e-6;

/// The nearest point of the surface to a data point.
struct Foot {
  Eigen::Vector3d y, normal;
  /// Shape operator ∂normal/∂y as a 3x3 matrix, which is zero along the normal.
  Eigen::Matrix3d shape;
  double slope, distance;
};

std::optional<Foot> find_foot(const Quadric& Q, const Eigen::Vector3d& x) {
  auto y = project_nearby(Q, x);
  if (!y) y = project(Q, x);
  if (!y) return std::nullopt;
  const Eigen::Vector3d g = Q.gradient(*y);
  Foot foot{*y, g.normalized(), Eigen::Matrix3d::Zero(), g.norm(), 0.0};
  if (!(foot.slope > 1e-9)) return std::nullopt;
  const Eigen::Matrix3d P = Eigen::Matrix3d::Identity() - foot.normal * foot.normal.transpose();
  foot.shape = 2.0 / foot.slope * P * Q.matrix().topLeftCorner<3, 3>() * P;
  foot.distance = (x - *y).dot(foot.normal);
  return foot;
}

struct Noise {
  double point2, normal2;
  double points_per_normal;
};

/// The expected bias of a point's distance, and the weight matrix of its normal, for a given noise.
struct Weights {
  double bias;
  Eigen::Matrix3d normal;
};

Weights weigh(const Foot& foot, const Noise& noise) {
  // The foot deviates from the true point by about σ; its effect on S itself is of second order.
  const double bend2 = noise.point2 * foot.shape.squaredNorm();
  const Eigen::Matrix3d covariance = (noise.normal2 + bend2 * bend2) * Eigen::Matrix3d::Identity() +
                                     noise.point2 * foot.shape * foot.shape;
  // The bias is a term of a series that diverges when the noise reaches the radius of curvature, so
  // it is limited.
  const double limit = std::sqrt(noise.point2);
  const double bias = std::clamp(0.5 * noise.point2 * foot.shape.trace(), -limit, limit);
  // A deviation along the normal is of second order and carries no information.
  const Eigen::Matrix3d P = Eigen::Matrix3d::Identity() - foot.normal * foot.normal.transpose();
  return {bias, P * covariance.inverse() * P / noise.points_per_normal};
}

/// ∂normal/∂q at the foot, 3x10: (1 + d S) ∂n/∂q = P (∇vᵀ − H n vᵀ / |∇f|) / |∇f|.
Eigen::Matrix<double, 3, 10> normal_derivative(const Foot& foot, const Quadric& Q,
                                               const Vector10d& v) {
  const Eigen::Matrix3d P = Eigen::Matrix3d::Identity() - foot.normal * foot.normal.transpose();
  const Eigen::Vector3d bend = 2.0 / foot.slope * Q.matrix().topLeftCorner<3, 3>() * foot.normal;
  const Eigen::Matrix<double, 3, 10> direct =
      P * (monomial_gradients(foot.y) - bend * v.transpose()) / foot.slope;
  const Eigen::Matrix3d M = Eigen::Matrix3d::Identity() + foot.distance * foot.shape;
  return M.partialPivLu().solve(direct);
}

std::optional<NormalEquations> residuals(const OrientedPointsd& points,
                                         const std::vector<Weights>& weights, const Noise& noise,
                                         const Quadric& Q) {
  NormalEquations sums;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const auto foot = find_foot(Q, points.points.col(i));
    if (!foot) return std::nullopt;
    const Vector10d v = monomials(foot->y);
    sums.add(v / foot->slope, foot->distance - weights[i].bias, 1.0 / noise.point2);
    const Eigen::Vector3d r = foot->normal - points.normals.col(i);
    const auto J = normal_derivative(*foot, Q, v);
    const Eigen::Matrix3d& W = weights[i].normal;
    sums.JTJ += J.transpose() * W * J;
    sums.JTr += J.transpose() * W * r;
    sums.cost += r.dot(W * r);
  }
  return sums;
}

/// The feet of all points; nullopt if one of them has none.
std::optional<std::vector<Foot>> feet_of(const OrientedPointsd& points, const Quadric& Q) {
  std::vector<Foot> feet;
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const auto foot = find_foot(Q, points.points.col(i));
    if (!foot) return std::nullopt;
    feet.push_back(*foot);
  }
  return feet;
}

Noise estimate(const OrientedPointsd& points, const std::vector<Foot>& feet, const Noise& before) {
  const double count = static_cast<double>(points.size());
  double distance = 0.0, angle = 0.0, weight = 0.0;
  for (const Foot& foot : feet) distance += foot.distance * foot.distance;
  // Nine degrees of freedom are fitted to three residuals per point, which takes three points.
  const double freedom = std::max(1.0, count - 3.0);
  const double point2 = std::max(kMinNoise * kMinNoise, distance / freedom);
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const double spread = point2 * feet[i].shape.squaredNorm();
    const double excess = (feet[i].normal - points.normals.col(i)).squaredNorm() - spread;
    // The weight is the inverse variance of the excess under the noise of the previous round.
    const double w = 1.0 / std::pow(2.0 * before.normal2 + spread, 2);
    angle += w * excess;
    weight += 2.0 * w;
  }
  return {point2, std::max(kMinNoise * kMinNoise, angle / weight), before.points_per_normal};
}

}  // namespace

std::optional<LikelihoodFit> solve_likelihood(const OrientedPointsd& points,
                                              const LikelihoodFitOptions& options) {
  const auto normalised = normalise(points, 4, Spread::kSpace);
  if (!normalised) return std::nullopt;
  const OrientedPointsd& data = normalised->data;
  const auto start = start_quadric(data);
  if (!start) return std::nullopt;
  Quadric Q = oriented(*start, data);
  Noise noise{1.0, 1.0, options.points_per_normal};
  for (int round = 0; round < options.rounds; ++round) {
    const auto feet = feet_of(data, Q);
    if (!feet) break;
    noise = estimate(data, *feet, noise);
    std::vector<Weights> weights;
    for (const Foot& foot : *feet) weights.push_back(weigh(foot, noise));
    const auto next = refine_quadric(
        Q, [&](const Quadric& at) { return residuals(data, weights, noise, at); },
        options.iterations);
    if (!next) break;
    Q = *next;
  }
  const auto back = normalised->undo(Q);
  if (!back) return std::nullopt;
  return LikelihoodFit{*back, normalised->local.scale * std::sqrt(noise.point2),
                       std::sqrt(noise.normal2)};
}

std::optional<Quadric> fit_likelihood(const OrientedPointsd& points,
                                      const LikelihoodFitOptions& options) {
  const auto fit = solve_likelihood(points, options);
  if (!fit) return std::nullopt;
  return fit->Q;
}

}  // namespace quadrille
