#include "lab/scoring/superquadric.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace quadrille::scoring {
namespace {

/// The norm (s^p + t^p)^(1/p) of two numbers for p = 2/ε, with its derivatives.
struct PairNorm {
  double value = 0.0, by_s = 0.0, by_t = 0.0, by_exponent = 0.0;
};

double entropy_term(double share) { return share > 0.0 ? -share * std::log(share) : 0.0; }

/// The larger number is factored out, so that no power overflows. If σ and 1 − σ are the shares of
/// both terms in the sum, the derivatives are σ N/s, (1 − σ) N/t, and, since dp/dε = −p²/2, N/2
/// times the entropy of the shares.
PairNorm pair_norm(double s, double t, double exponent) {
  const double most = std::max(s, t), least = std::min(s, t);
  if (!(most > 0.0)) return {};
  const double power = std::pow(least / most, 2.0 / exponent);
  const double share = power / (1.0 + power);
  PairNorm norm;
  norm.value = most * std::pow(1.0 + power, 0.5 * exponent);
  const double by_most = (1.0 - share) * norm.value / most;
  const double by_least = least > 0.0 ? share * norm.value / least : 0.0;
  norm.by_s = s >= t ? by_most : by_least;
  norm.by_t = s >= t ? by_least : by_most;
  norm.by_exponent = 0.5 * norm.value * (entropy_term(share) + entropy_term(1.0 - share));
  return norm;
}

/// Returns the zero of a function between a point where it is negative and one where it is not.
template <class Function>
double bisect(const Function& function, double inside, double outside) {
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (inside + outside);
    (function(middle) < 0.0 ? inside : outside) = middle;
  }
  return 0.5 * (inside + outside);
}

}  // namespace

Gauge Superquadric::gauge(const Eigen::Vector3d& p_S) const {
  const Eigen::Vector3d scaled = p_S.cwiseAbs().cwiseQuotient(axes);
  const PairNorm section = pair_norm(scaled.x(), scaled.y(), exponents[1]);
  const PairNorm whole = pair_norm(section.value, scaled.z(), exponents[0]);
  const Eigen::Vector3d by_scaled(whole.by_s * section.by_s, whole.by_s * section.by_t, whole.by_t);
  return {whole.value,
          by_scaled.cwiseProduct(p_S.cwiseSign()).cwiseQuotient(axes),
          {whole.by_exponent, whole.by_s * section.by_exponent}};
}

double Superquadric::value(const Eigen::Vector3d& p_C) const {
  return gauge(X_CS.inverse() * p_C).value - 1.0;
}

Eigen::Vector3d Superquadric::gradient(const Eigen::Vector3d& p_C) const {
  return X_CS.linear() * gauge(X_CS.inverse() * p_C).by_point;
}

std::array<double, 2> Superquadric::crossings(const Eigen::Vector3d& o,
                                              const Eigen::Vector3d& d) const {
  const auto along = [&](double t) { return value(o + t * d); };
  const double middle = d.dot(X_CS.translation() - o), reach = axes.norm();
  // The body is convex, so the value has a single minimum along the line.
  double low = middle - reach, high = middle + reach;
  for (int i = 0; i < 100; ++i) {
    const double third = (high - low) / 3.0;
    if (along(low + third) < along(high - third)) {
      high -= third;
    } else {
      low += third;
    }
  }
  const double deepest = 0.5 * (low + high), nan = std::numeric_limits<double>::quiet_NaN();
  if (!(along(deepest) < 0.0)) return {nan, nan};
  return {bisect(along, deepest, middle - reach), bisect(along, deepest, middle + reach)};
}

}  // namespace quadrille::scoring
