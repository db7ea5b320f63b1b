#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "lab/experiments/experiments.hpp"
#include "lab/experiments/measure.hpp"
#include "lab/experiments/random_quadric.hpp"
#include "search/basis.hpp"

namespace quadrille::experiments {
namespace {

// The limit is that of the vote: points nearer to the data plane tell nothing about λ.
constexpr double kMinHeight = 0.05;
constexpr int kPerQuadric = 50;
constexpr int kBins = 48;
constexpr const char* kOwnVoter = "voter on the quadric";

/// The paper's solution space of one basis: p is the least solution, μ a unit vector.
struct Space {
  Vector10d p, mu;
  /// Conversion from the closed form's λ to the paper's: stretch · λ + shift.
  double stretch, shift;
};

Space space_of(const Pencil& pencil) {
  const Vector10d q0 = Quadric(pencil.Q0).coefficients();
  const Vector10d m =
      Quadric(Eigen::Matrix4d(pencil.plane * pencil.plane.transpose())).coefficients();
  Space space;
  space.stretch = m.norm();
  space.mu = m / space.stretch;
  space.shift = space.mu.dot(q0);
  space.p = q0 - space.shift * space.mu;
  return space;
}

/// Returns λ of a fourth point on f₀ + λ z²; nullopt if the point is too near to the data plane.
std::optional<double> lambda_of(const Pencil& pencil, const Eigen::Vector3d& x) {
  const Eigen::Vector4d X = x.homogeneous();
  const double z = pencil.plane.dot(X);
  if (std::abs(z) < kMinHeight) return std::nullopt;
  return -X.dot(pencil.Q0 * X) / (z * z);
}

/// Returns the angle as printed in the paper, from the first two coordinates of p and of p + λμ.
double printed_angle(const Space& space, double lambda) {
  const Vector10d q = space.p + lambda * space.mu;
  return std::atan2(q[1] - space.p[1], q[0] - space.p[0]);
}

struct Collected {
  /// The values of the paper's λ.
  std::vector<double> lambda;
  /// Largest number of different printed angles, to a millionth, over the voters of one basis.
  std::size_t max_angles = 0;
};

/// Returns random points of one quadric on a random side, so that convex and concave pieces are
/// equally likely.
OrientedPointsd random_points(RandomStream& random, int count) {
  const Quadric Q = random_quadric(curved_type(random.below(kCurvedTypes)), random);
  OrientedPointsd points = sample(Q, count, random);
  if (random.below(2) == 0) points.normals *= -1.0;
  return points;
}

void collect(const OrientedPointsd& points, const OrientedPointsd& voters, RandomStream& random,
             Collected* into) {
  const auto draw = [&] { return points.at(random.below(static_cast<int>(points.size()))); };
  for (int k = 0; k < kPerQuadric;) {
    const auto pencil = make_pencil({draw(), draw(), draw()});
    if (!pencil) continue;
    const int voter = random.below(static_cast<int>(voters.size()));
    const auto lambda = lambda_of(*pencil, voters.points.col(voter));
    if (!lambda) continue;
    const Space space = space_of(*pencil);
    into->lambda.push_back(space.stretch * *lambda + space.shift);
    ++k;
  }
}

std::size_t count_angles(const OrientedPointsd& points) {
  const auto pencil = make_pencil({points.at(0), points.at(1), points.at(2)});
  if (!pencil) return 0;
  const Space space = space_of(*pencil);
  std::set<long> angles;
  for (Eigen::Index i = 3; i < points.size(); ++i) {
    const auto lambda = lambda_of(*pencil, points.points.col(i));
    if (!lambda) continue;
    const double paper = space.stretch * *lambda + space.shift;
    angles.insert(std::lround(1e6 * printed_angle(space, paper)));
  }
  return angles.size();
}

/// @param same  true if the voter lies on the basis's quadric; false if on another one
Collected collect_all(int triplets, bool same, const Settings& settings, double progress_from) {
  Collected collected;
  collected.lambda.reserve(static_cast<std::size_t>(triplets) + kPerQuadric);
  for (int k = 0; static_cast<int>(collected.lambda.size()) < triplets; ++k) {
    RandomStream random(settings.seed, static_cast<std::uint64_t>(2 * k + (same ? 0 : 1)));
    const OrientedPointsd points = random_points(random, 60);
    collect(points, same ? points : random_points(random, 60), random, &collected);
    if (k % 20 == 0) collected.max_angles = std::max(collected.max_angles, count_angles(points));
    if (k % 100 == 0) {
      settings.progress(progress_from +
                        0.5 * static_cast<double>(collected.lambda.size()) / triplets);
    }
  }
  std::sort(collected.lambda.begin(), collected.lambda.end());
  return collected;
}

/// Returns the share of the sorted values that are at most x.
double share_below(const std::vector<double>& sorted, double x) {
  return static_cast<double>(std::upper_bound(sorted.begin(), sorted.end(), x) - sorted.begin()) /
         static_cast<double>(sorted.size());
}

double quantile_of_sorted(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

double atan_share(double lambda, double scale) { return 0.5 + std::atan(lambda / scale) / M_PI; }

/// Returns the largest difference between the measured distribution and that of atan.
double max_gap(const std::vector<double>& sorted, double scale) {
  double largest = 0.0;
  for (int k = 1; k < 1000; ++k) {
    const double share = k / 1000.0;
    largest =
        std::max(largest, std::abs(share - atan_share(quantile_of_sorted(sorted, share), scale)));
  }
  return largest;
}

/// Returns the entropy of the votes over equal bins of atan, relative to that of a uniform
/// distribution.
double entropy_share(const std::vector<double>& sorted, double scale) {
  double entropy = 0.0, before = 0.0;
  for (int k = 1; k <= kBins; ++k) {
    const double edge = scale * std::tan(M_PI * (static_cast<double>(k) / kBins - 0.5));
    const double upto = k == kBins ? 1.0 : share_below(sorted, edge);
    if (upto > before) entropy -= (upto - before) * std::log(upto - before);
    before = upto;
  }
  return entropy / std::log(static_cast<double>(kBins));
}

double median_size(const std::vector<double>& sorted) {
  std::vector<double> sizes;
  for (const double lambda : sorted) sizes.push_back(std::abs(lambda));
  return quantile(std::move(sizes), 0.5);
}

Plot density_plot(const std::vector<double>& same, const std::vector<double>& other, double scale) {
  Plot plot{"Density of λ", "λ", "density", {}};
  const double reach = 8.0 * scale, step = reach / 60.0;
  const auto measured = [&](const std::string& name, const std::vector<double>& sorted) {
    Series line{name, {}};
    for (double x = -reach; x < reach; x += step) {
      const double share = share_below(sorted, x + step) - share_below(sorted, x);
      line.points.emplace_back(x + 0.5 * step, share / step);
    }
    plot.lines.push_back(line);
  };
  measured(kOwnVoter, same);
  measured("voter on another", other);
  const auto expected = [&](const std::string& name, double s) {
    Series line{name, {}, true};
    for (double x = -reach; x <= reach; x += step) {
      line.points.emplace_back(x, s / (M_PI * (s * s + x * x)));
    }
    plot.lines.push_back(line);
  };
  expected("atan, λ₀ = 1", 1.0);
  expected("atan, λ₀ = median |λ|", scale);
  return plot;
}

Plot inverse_plot(const std::vector<double>& same, double scale) {
  Plot plot{"Bins by the measured distribution and by atan", "λ", "place of the bin, 0 to 1", {}};
  Series measured{"measured distribution", {}, false, false, kOwnVoter},
      one{"atan, λ₀ = 1", {}, true}, fitted{"atan, λ₀ = median |λ|", {}, true};
  for (int k = 2; k <= 98; ++k) {
    const double x = quantile_of_sorted(same, k / 100.0);
    if (std::abs(x) > 8.0 * scale) continue;
    measured.points.emplace_back(x, k / 100.0);
    one.points.emplace_back(x, atan_share(x, 1.0));
    fitted.points.emplace_back(x, atan_share(x, scale));
  }
  plot.lines = {measured, one, fitted};
  return plot;
}

}  // namespace

Report run_lambda(const Settings& settings) {
  const int triplets = settings.quick ? 20000 : 2500000;
  const Collected same = collect_all(triplets, true, settings, 0.0);
  const Collected other = collect_all(triplets, false, settings, 0.5);
  const double scale = median_size(same.lambda);
  Report report;
  report.data.columns = {"voter", "share", "lambda", "atan_1", "atan_median"};
  for (const auto& [name, lambda] : {std::pair{"same", &same.lambda}, {"other", &other.lambda}}) {
    for (int k = 1; k < 200; ++k) {
      const double x = quantile_of_sorted(*lambda, k / 200.0);
      report.data.add({name, number(k / 200.0), number(x), number(atan_share(x, 1.0)),
                       number(atan_share(x, scale))});
    }
  }
  Table summary{fmt::format("λ of {} triplets with a fourth point, in the unit ball", triplets),
                {"fourth point", "median λ", "median |λ|", "|λ| > 10", "|λ| > 75", "λ₀",
                 "largest gap to atan", "entropy over 48 bins of 1"},
                {}};
  for (const auto& [name, lambda] :
       {std::pair{"on the quadric", &same.lambda}, {"on another", &other.lambda}}) {
    // The value is named, because clang cannot capture structured bindings.
    const auto beyond = [&values = *lambda](double x) {
      return number(1.0 - share_below(values, x) + share_below(values, -x));
    };
    for (const double s : {1.0, scale}) {
      summary.add({name, number(quantile_of_sorted(*lambda, 0.5)), number(median_size(*lambda)),
                   beyond(10.0), beyond(75.0), number(s), number(max_gap(*lambda, s)),
                   number(entropy_share(*lambda, s))});
    }
  }
  report.findings = {
      fmt::format("Half of all |λ| are below {}; atan(λ / λ₀) follows the measured distribution to "
                  "within {} for λ₀ = 1 and {} for λ₀ = {}.",
                  number(scale), number(max_gap(same.lambda, 1.0)),
                  number(max_gap(same.lambda, scale)), number(scale)),
      fmt::format("The angle as printed, from differences of the first two coefficients, takes at "
                  "most {} values over all voters of a basis: both differences are multiples of λ, "
                  "so that it keeps the sign of λ alone.",
                  std::max(same.max_angles, other.max_angles))};
  report.tables = {summary};
  report.plots = {density_plot(same.lambda, other.lambda, scale), inverse_plot(same.lambda, scale)};
  return report;
}

}  // namespace quadrille::experiments
