#include "fits/polynomial.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace quadrille {
namespace {

double largest(const std::vector<double>& coefficients) {
  double size = 0.0;
  for (const double c : coefficients) size = std::max(size, std::abs(c));
  return size;
}

}  // namespace

std::vector<double> real_roots(std::vector<double> c) {
  const double size = largest(c);
  if (!(size > 0.0) || !std::isfinite(size)) return {};
  while (std::abs(c.back()) <= 1e-14 * size) c.pop_back();
  const Eigen::Index degree = static_cast<Eigen::Index>(c.size()) - 1;
  if (degree < 1) return {};
  Eigen::MatrixXd companion = Eigen::MatrixXd::Zero(degree, degree);
  for (Eigen::Index i = 0; i < degree; ++i) {
    if (i > 0) companion(i, i - 1) = 1.0;
    companion(i, degree - 1) = -c[i] / c[degree];
  }
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(companion, false);
  std::vector<double> roots;
  for (Eigen::Index i = 0; i < degree; ++i) {
    const std::complex<double> root = solver.eigenvalues()[i];
    // Rounding splits a double root into a pair that differs by the square root of the rounding
    // error.
    if (std::abs(root.imag()) <= 1e-6 * (1.0 + std::abs(root))) roots.push_back(root.real());
  }
  std::sort(roots.begin(), roots.end());
  return roots;
}

std::vector<double> double_roots(const std::vector<double>& c, double noise) {
  std::vector<double> derivative;
  for (std::size_t k = 1; k < c.size(); ++k) derivative.push_back(static_cast<double>(k) * c[k]);
  if (derivative.empty()) return {};
  std::vector<double> roots;
  for (const double x : real_roots(derivative)) {
    double value = 0.0, terms = 0.0;
    for (std::size_t k = c.size(); k-- > 0;) {
      value = value * x + c[k];
      terms = terms * std::abs(x) + 1.0;
    }
    if (std::abs(value) <= noise * largest(c) * terms) roots.push_back(x);
  }
  return roots;
}

}  // namespace quadrille
