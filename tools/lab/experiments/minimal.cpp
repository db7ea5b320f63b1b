#include <fmt/format.h>

#include <Eigen/QR>
#include <Eigen/SVD>
#include <cmath>
#include <limits>

#include "fits/compact_fit.hpp"
#include "fits/linear_system.hpp"
#include "fits/solution_space.hpp"
#include "fits/three_point_fit.hpp"
#include "lab/experiments/experiments.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/experiments/random_quadric.hpp"
#include "variants/gradient_scales.hpp"

namespace quadrille::experiments {
namespace {

using Matrix12x10 = Eigen::Matrix<double, 12, 10>;
using Vector12 = Eigen::Matrix<double, 12, 1>;

/// The paper's compact system of three oriented points, without heap memory.
struct System {
  Matrix12x10 A;
  Vector12 n;
};

System system_of(const OrientedPointsd& points) {
  System system;
  system.n.setZero();
  for (int i = 0; i < 3; ++i) {
    system.A.row(i) = monomials(points.points.col(i)).transpose();
    system.A.middleRows<3>(3 + 3 * i) = monomial_gradients(points.points.col(i));
    system.n.segment<3>(3 + 3 * i) = points.normals.col(i);
  }
  return system;
}

/// A method that computes a quadric from three oriented points and a further position; zero if it
/// finds none.
struct Way {
  std::string name, label;
  bool from_svd;
  std::function<Vector10d(const OrientedPointsd&)> solve;
};

/// Computes λ from the position alone: theorem 3 with the first row of the further point's system.
Vector10d with_lambda(const Vector10d& p, const Vector10d& mu, const OrientedPointsd& points) {
  const Vector10d v = monomials(points.points.col(3));
  return p - v.dot(p) / v.dot(mu) * mu;
}

template <class Decomposition>
Vector10d by_svd(const OrientedPointsd& points) {
  const System system = system_of(points);
  Decomposition svd(system.A, Eigen::ComputeFullU | Eigen::ComputeFullV);
  svd.setThreshold(1e-9);
  return with_lambda(svd.solve(system.n), svd.matrixV().col(9), points);
}

Vector10d by_qr(const OrientedPointsd& points) {
  const System system = system_of(points);
  const Eigen::ColPivHouseholderQR<Matrix12x10> qr(system.A);
  // The null vector follows by back substitution from the last column, whose pivot vanishes.
  Vector10d mu = Vector10d::Zero(), p = Vector10d::Zero();
  const auto R = qr.matrixR().topLeftCorner<9, 9>().triangularView<Eigen::Upper>();
  mu[9] = 1.0;
  mu.head<9>() = -R.solve(qr.matrixR().topRightCorner<9, 1>());
  const Vector12 right = qr.householderQ().transpose() * system.n;
  p.head<9>() = R.solve(right.head<9>());
  return with_lambda(qr.colsPermutation() * p, qr.colsPermutation() * mu, points);
}

Vector10d through_fourth(const std::optional<Pencil>& pencil, const OrientedPointsd& points) {
  if (!pencil) return Vector10d::Zero();
  const Eigen::Vector4d x = points.points.col(3).homogeneous();
  const double z = pencil->plane.dot(x);
  return Quadric(pencil->at(-x.dot(pencil->Q0 * x) / (z * z))).coefficients();
}

Vector10d by_closed_form(const OrientedPointsd& points) {
  return through_fourth(make_pencil({points.at(0), points.at(1), points.at(2)}), points);
}

Vector10d by_solved_lengths(const OrientedPointsd& points) {
  return through_fourth(make_scaled_pencil({points.at(0), points.at(1), points.at(2)}, 0.0),
                        points);
}

Vector10d coefficients_of(const std::optional<Quadric>& Q) {
  return Q ? Q->coefficients() : Vector10d(Vector10d::Zero());
}

std::vector<Way> all_ways() {
  using Dynamic = Eigen::MatrixXd;
  return {
      {"closed form (make_pencil, λ)", "closed form", false, by_closed_form},
      {"closed form with solved lengths (make_scaled_pencil, λ)", "lengths solved", false,
       by_solved_lengths},
      {"the same, normalised, with its error (fit_three_points)", "with its error", false,
       [](const OrientedPointsd& p) {
         const auto fit = fit_three_points(p);
         return fit ? fit->Q.coefficients() : Vector10d(Vector10d::Zero());
       }},
      {"compact system of 4 points by normal equations (fit_compact)", "4 points, normal equations",
       false, [](const OrientedPointsd& p) { return coefficients_of(fit_compact(p)); }},
      {"12x10, pivoted QR", "12x10, pivoted QR", false, by_qr},
      {"12x10, JacobiSVD of fixed size", "12x10, JacobiSVD, fixed size", true,
       by_svd<Eigen::JacobiSVD<Matrix12x10>>},
      {"12x10, JacobiSVD", "12x10, JacobiSVD", true, by_svd<Eigen::JacobiSVD<Dynamic>>},
      {"12x10, BDCSVD", "12x10, BDCSVD", true, by_svd<Eigen::BDCSVD<Dynamic>>},
  };
}

/// @param types  number of curved types to draw from
std::vector<OrientedPointsd> random_bases(int count, int types, std::uint64_t seed) {
  std::vector<OrientedPointsd> bases;
  for (int k = 0; k < count; ++k) {
    RandomStream random(seed, static_cast<std::uint64_t>(k));
    bases.push_back(sample(random_quadric(curved_type(k % types), random), 4, random));
  }
  return bases;
}

/// Returns the median difference between two methods' quadrics on spheres, where all gradients have
/// the same length.
double difference(const Way& a, const Way& b, std::uint64_t seed) {
  std::vector<double> differences;
  for (const OrientedPointsd& basis : random_bases(101, 1, seed)) {
    differences.push_back((a.solve(basis).normalized() - b.solve(basis).normalized()).norm());
  }
  return quantile(differences, 0.5);
}

/// Returns for random bases of all curved types but sphere and circular cylinder, with exact points
/// and unit normals, how far points of the true surface in the unit ball lie from the quadric that
/// a method finds, in the median over 50 points.
std::vector<double> errors_of(const Way& way, int bases, std::uint64_t seed) {
  std::vector<double> errors;
  for (int k = 0; static_cast<int>(errors.size()) < bases; ++k) {
    const QuadricType type = curved_type(k % kCurvedTypes);
    if (type == QuadricType::kSphere || type == QuadricType::kCylinder) continue;
    RandomStream random(seed, static_cast<std::uint64_t>(k));
    const Quadric truth = random_quadric(type, random);
    const Vector10d q = way.solve(sample(truth, 4, random));
    if (q.isZero(0.0)) continue;
    const OrientedPointsd others = sample(truth, 50, random);
    std::vector<double> distances;
    for (Eigen::Index i = 0; i < others.size(); ++i) {
      distances.push_back(std::abs(Quadric(q).distance(others.points.col(i))));
    }
    errors.push_back(quantile(distances, 0.5));
  }
  return errors;
}

}  // namespace

Report run_minimal(const Settings& settings) {
  const int rounds = settings.quick ? 5 : 301;
  const std::vector<OrientedPointsd> bases = random_bases(240, kCurvedTypes, settings.seed);
  const std::vector<Way> ways = all_ways();
  std::vector<std::vector<double>> times(ways.size());
  // The variable is volatile so that no compiler optimises the work away.
  volatile double sink = 0.0;
  for (int round = 0; round < rounds; ++round) {
    // The methods take turns, so that all are timed under the same conditions.
    for (std::size_t k = 0; k < ways.size(); ++k) {
      const double time = microseconds([&] {
        for (const OrientedPointsd& basis : bases) sink = ways[k].solve(basis)[0];
      });
      times[k].push_back(time / static_cast<double>(bases.size()));
    }
    settings.progress((round + 1.0) / rounds);
  }
  Report report;
  report.data.columns = {"way", "median_us", "times_faster_than_svd", "difference_on_spheres"};
  double svd = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < ways.size(); ++k) {
    if (ways[k].from_svd) svd = std::min(svd, quantile(times[k], 0.5));
  }
  Plot plot{"Distribution of the time of a minimal solve", "µs", "share of the rounds", {}, true};
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const double median = quantile(times[k], 0.5);
    report.data.row(ways[k].name, median, svd / median,
                    difference(ways[k], ways.back(), settings.seed));
    plot.lines.push_back({ways[k].label, {}, ways[k].from_svd});
    for (double share = 0.0; share <= 1.0; share += 0.02) {
      plot.lines.back().points.emplace_back(quantile(times[k], share), share);
    }
    if (!ways[k].from_svd) {
      report.findings.push_back(
          fmt::format("{}: {} µs, {} times faster than the fastest SVD ({} µs).", ways[k].name,
                      number(median), number(svd / median), number(svd)));
    }
  }
  report.findings.push_back(
      fmt::format("Median of {} rounds over {} bases on one thread, against the fastest SVD.",
                  rounds, bases.size()));
  const int draws = settings.quick ? 100 : 2000;
  for (const Way& way : {ways[0], ways[1]}) {
    const std::vector<double> errors = errors_of(way, draws, settings.seed);
    report.findings.push_back(fmt::format(
        "{}, {} random bases of the curved types but sphere and circular cylinder, exact points "
        "and "
        "unit normals: the surface is off by {} of the radius in the median, and by {} in a tenth "
        "of the bases.",
        way.label, draws, number(quantile(errors, 0.5)), number(quantile(errors, 0.9))));
  }
  report.tables = {report.data};
  report.plots = {plot};
  return report;
}

}  // namespace quadrille::experiments
