#include "lab/bench/ems.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace quadrille::bench {
namespace {

using scoring::Superquadric;

/// Parameters: ε₁ and ε₂, three semi-axes, a rotation and a translation within frame S.
constexpr int kParameters = 11, kBounded = 5;
using Parameters = Eigen::Matrix<double, kParameters, 1>;

constexpr double kMinExponent = 0.02, kMaxExponent = 2.0;

/// Superquadrics are fitted to points with a mean of 0 and a mean square of 1.
constexpr double kMinAxis = 0.02, kMinSigma = 1e-5;

/// Least gain of the mean logarithm of the likelihood in a round, and by a switch.
constexpr double kRoundGain = 1e-4, kSwitchGain = 1e-3;

/// The signed distance of a point from the surface along the ray from the centre, |x| (1 −
/// 1/gauge).
/// @param derivatives  if not null, becomes the derivatives; 0 at the centre, where there are none
double radial_distance(const Superquadric& S, const Eigen::Vector3d& p_S,
                       Parameters* derivatives = nullptr) {
  if (derivatives != nullptr) derivatives->setZero();
  const scoring::Gauge gauge = S.gauge(p_S);
  if (!(gauge.value > 0.0)) return -S.axes.minCoeff();
  const double length = p_S.norm(), share = 1.0 - 1.0 / gauge.value;
  if (derivatives != nullptr) {
    const double by_gauge = length / (gauge.value * gauge.value);
    const Eigen::Vector3d by_point = by_gauge * gauge.by_point + share / length * p_S;
    derivatives->head<2>() = by_gauge * gauge.by_exponents;
    derivatives->segment<3>(2) = -by_gauge * gauge.by_point.cwiseProduct(p_S).cwiseQuotient(S.axes);
    derivatives->segment<3>(5) = by_point.cross(p_S);
    derivatives->tail<3>() = -by_point;
  }
  return length * share;
}

/// Returns the superquadric after a step of its parameters, within the bounds.
Superquadric stepped(Superquadric S, const Parameters& step, double max_axis) {
  S.exponents = (S.exponents + step.head<2>()).cwiseMax(kMinExponent).cwiseMin(kMaxExponent);
  S.axes = (S.axes + step.segment<3>(2)).cwiseMax(kMinAxis).cwiseMin(max_axis);
  const Eigen::Vector3d turn = step.segment<3>(5);
  Eigen::Isometry3d X(Eigen::Translation3d(step.tail<3>()));
  if (turn.norm() > 0.0) X.rotate(Eigen::AngleAxisd(turn.norm(), turn.normalized()));
  S.X_CS = S.X_CS * X;
  return S;
}

/// Lets y, z and x take the roles of x, y and z, which keeps the extents along them.
Superquadric with_next_axes(const Superquadric& S) {
  Superquadric next = S;
  next.axes << S.axes.y(), S.axes.z(), S.axes.x();
  Eigen::Matrix3d turn;
  turn << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  next.X_CS.linear() *= turn;
  return next;
}

/// Returns a superquadric whose section across z is turned by 45°: a square with ε₂ near 0 is also
/// the square between the axes with ε₂ = 2. Semi-axes grow to √2 of it if ε₂ goes from 0 to 2, and
/// conversely, and stay the same for the circle.
Superquadric with_turned_section(Superquadric S) {
  const double mean = 0.5 * (S.axes.x() + S.axes.y()), from = S.exponents[1];
  constexpr double kGrowth = std::numbers::sqrt2 - 1.0;
  const double factor =
      from < 1.0 ? 1.0 + kGrowth * (1.0 - from) : 1.0 / (1.0 + kGrowth * (from - 1.0));
  S.axes.head<2>().setConstant(factor * mean);
  S.exponents[1] = 2.0 - from;
  S.X_CS.rotate(Eigen::AngleAxisd(0.25 * std::numbers::pi, Eigen::Vector3d::UnitZ()));
  return S;
}

/// Returns the superquadrics of much the same shape but with other parameters.
std::vector<Superquadric> similar_ones(const Superquadric& S) {
  // If the semi-axes differ by more, the turned section is not similar.
  constexpr double kMaxRatio = 1.3;
  std::vector<Superquadric> similar;
  Superquadric next = S;
  next.exponents = S.exponents.cwiseMax(0.1).cwiseMin(1.9);
  const Eigen::Vector2d swapped = next.exponents.reverse();
  for (int k = 0; k < 3; ++k) {
    if (k > 0) {
      // The profile along the old z is now the section across the new one.
      next = with_next_axes(next);
      next.exponents = swapped;
      similar.push_back(next);
    }
    const double ratio = next.axes.x() / next.axes.y();
    if (ratio < kMaxRatio && ratio * kMaxRatio > 1.0) similar.push_back(with_turned_section(next));
  }
  return similar;
}

/// A superquadric with the noise about it, and how likely they make the points.
struct State {
  Superquadric S;
  double variance = 0.0, log_likelihood = 0.0;
};

/// Fits to points with a mean of 0 and a mean square of 1.
class Ems {
 public:
  Ems(const Eigen::Matrix3Xd& points, const EmsOptions& options)
      : points_(points), options_(options), weights_(points.cols()) {
    const Eigen::Vector3d sides = points.rowwise().maxCoeff() - points.rowwise().minCoeff();
    volume_ = sides.prod();
    max_axis_ = options.max_axis * std::sqrt(points.colwise().squaredNorm().maxCoeff());
  }

  /// @param axes, deviations  principal axes of the points, and the standard deviations along them
  EmsFit run(const Eigen::Matrix3d& axes, const Eigen::Vector3d& deviations) {
    Superquadric start;
    start.X_CS.linear() = axes;
    // A sphere's surface has this deviation along each axis.
    start.axes = std::sqrt(3.0) * deviations;
    State best = alternate(start);
    int switches = 0;
    while (switches < options_.max_switches) {
      State likeliest = best;
      for (const Superquadric& S : similar_ones(best.S)) {
        State other = alternate(S);
        if (other.log_likelihood > likeliest.log_likelihood) likeliest = std::move(other);
      }
      if (!gains(best, likeliest, kSwitchGain)) break;
      best = std::move(likeliest);
      ++switches;
    }
    weigh(&best);
    return {best.S, std::sqrt(best.variance), weights_.mean(), switches};
  }

 private:
  struct Normal {
    using Square = Eigen::Matrix<double, kParameters, kParameters>;
    Square A = Square::Zero();
    Parameters b = Parameters::Zero();
  };

  /// Returns true if the mean logarithm of the likelihood of a point grows by more than a gain.
  bool gains(const State& from, const State& to, double gain) const {
    return to.log_likelihood > from.log_likelihood + gain * static_cast<double>(points_.cols());
  }

  /// Alternates between expectation and maximisation from a start, with noise that grants all
  /// points to it.
  State alternate(const Superquadric& start) {
    State state{start, std::pow(volume_, 2.0 / 3.0) / 100.0, 0.0};
    weigh(&state);
    double damping = 1e-2;
    for (int round = 0; round < options_.max_rounds; ++round) {
      const State last = state;
      improve(&state.S, &damping);
      const Eigen::ArrayXd squares = distances(state.S).square();
      state.variance =
          std::max((weights_ * squares).sum() / (3.0 * weights_.sum()), kMinSigma * kMinSigma);
      weigh(&state);
      if (!gains(last, state, kRoundGain)) break;
    }
    return state;
  }

  Eigen::ArrayXd distances(const Superquadric& S) const {
    const Eigen::Isometry3d X_SC = S.X_CS.inverse();
    Eigen::ArrayXd result(points_.cols());
    for (Eigen::Index i = 0; i < points_.cols(); ++i) {
      result[i] = radial_distance(S, X_SC * points_.col(i));
    }
    return result;
  }

  /// Expectation: sets the probability of each point to be an inlier, and the likelihood of all.
  void weigh(State* state) {
    const double uniform = options_.outliers / volume_;
    const double scale =
        (1.0 - options_.outliers) * std::pow(2.0 * std::numbers::pi * state->variance, -1.5);
    const Eigen::ArrayXd normal =
        scale * (-0.5 / state->variance * distances(state->S).square()).exp();
    weights_ = normal / (normal + uniform);
    state->log_likelihood = (normal + uniform).log().sum();
  }

  /// Maximisation: a few Levenberg-Marquardt steps to the least weighted sum of squares.
  void improve(Superquadric* S, double* damping) const {
    constexpr int kSteps = 4;
    double cost = (weights_ * distances(*S).square()).sum();
    Normal normal = normal_equations(*S);
    for (int k = 0; k < kSteps && *damping < 1e6; ++k) {
      const Superquadric next = stepped(*S, step(*S, normal, *damping), max_axis_);
      const double reached = (weights_ * distances(next).square()).sum();
      if (reached < cost) {
        *S = next;
        cost = reached;
        if (k + 1 < kSteps) normal = normal_equations(*S);
        *damping = std::max(1e-9, 0.2 * *damping);
      } else {
        *damping *= 5.0;
      }
    }
    *damping = std::min(*damping, 1e2);
  }

  Normal normal_equations(const Superquadric& S) const {
    Normal normal;
    const Eigen::Isometry3d X_SC = S.X_CS.inverse();
    for (Eigen::Index i = 0; i < points_.cols(); ++i) {
      if (weights_[i] < 1e-6) continue;
      Parameters d;
      const double distance = radial_distance(S, X_SC * points_.col(i), &d);
      normal.A += weights_[i] * d * d.transpose();
      normal.b += weights_[i] * distance * d;
    }
    return normal;
  }

  /// Returns the damped step; a parameter at a bound stays there if it would leave it.
  Parameters step(const Superquadric& S, Normal normal, double damping) const {
    Parameters value = Parameters::Zero();
    value.head<2>() = S.exponents;
    value.segment<3>(2) = S.axes;
    const double ridge = 1e-9 * normal.A.diagonal().maxCoeff();
    normal.A.diagonal() = (1.0 + damping) * normal.A.diagonal().array() + ridge;
    for (int k = 0; k < kBounded; ++k) {
      const double least = k < 2 ? kMinExponent : kMinAxis, most = k < 2 ? kMaxExponent : max_axis_;
      const bool stays = normal.b[k] > 0.0 ? value[k] <= least : value[k] >= most;
      if (!stays) continue;
      normal.A.row(k).setZero();
      normal.A.col(k).setZero();
      normal.A(k, k) = 1.0;
      normal.b[k] = 0.0;
    }
    return -normal.A.ldlt().solve(normal.b);
  }

  const Eigen::Matrix3Xd& points_;
  const EmsOptions& options_;
  /// Volume of the box of all points, and the largest semi-axis.
  double volume_ = 0.0, max_axis_ = 0.0;
  /// Probability of each point to be an inlier.
  Eigen::ArrayXd weights_;
};

Eigen::Matrix3Xd some_of(const std::vector<Eigen::Vector3f>& points, int most) {
  const std::size_t count = std::min(points.size(), static_cast<std::size_t>(most));
  Eigen::Matrix3Xd some(3, static_cast<Eigen::Index>(count));
  for (std::size_t k = 0; k < count; ++k) {
    some.col(static_cast<Eigen::Index>(k)) = points[k * points.size() / count].cast<double>();
  }
  return some;
}

}  // namespace

void EmsOptions::check() const {
  if (!(outliers > 0.0 && outliers < 1.0)) {
    throw std::invalid_argument("outliers must be more than 0 and less than 1");
  }
  if (max_points < kParameters) throw std::invalid_argument("max_points must be 11 or more");
  if (!(max_axis >= 1.0)) throw std::invalid_argument("max_axis must be 1 or more");
  if (max_rounds < 1) throw std::invalid_argument("max_rounds must be 1 or more");
  if (max_switches < 0) throw std::invalid_argument("max_switches must be 0 or more");
}

std::optional<EmsFit> fit_superquadric(const std::vector<Eigen::Vector3f>& points,
                                       const EmsOptions& options) {
  options.check();
  Eigen::Matrix3Xd some = some_of(points, options.max_points);
  if (some.cols() < kParameters || !some.allFinite()) return std::nullopt;
  const Eigen::Vector3d mean = some.rowwise().mean();
  some.colwise() -= mean;
  const double scale = std::sqrt(some.colwise().squaredNorm().mean());
  some /= scale;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> moments(some * some.transpose() /
                                                               static_cast<double>(some.cols()));
  const Eigen::Vector3d deviations = moments.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  // Points of a plane or line lie on superquadrics of any thickness.
  constexpr double kMinThickness = 0.05;
  if (!(deviations[0] > kMinThickness * deviations[1])) return std::nullopt;
  Eigen::Matrix3d axes = moments.eigenvectors();
  if (axes.determinant() < 0.0) axes.col(0) = -axes.col(0);
  EmsFit fit = Ems(some, options).run(axes, deviations);
  fit.sigma *= scale;
  fit.superquadric.axes *= scale;
  fit.superquadric.X_CS.translation() = mean + scale * fit.superquadric.X_CS.translation();
  return fit;
}

}  // namespace quadrille::bench
