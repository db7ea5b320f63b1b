#include "views/align.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/quantile.hpp"
#include "samples/region.hpp"
#include "views/place_cubes.hpp"

namespace quadrille {
namespace {

// Largest number of steps. The reach is as narrow as it becomes after five, and most views take
// only a few from there.
constexpr int kIterations = 10;
// Samples may match if their positions differ by no more than this many cells beside the errors of
// the poses, and their normals by no more than 25°.
constexpr float kMatchCells = 1.0f, kMinCosine = 0.9f;
// Errors of the poses that are looked for, in standard deviations of their prior: at the first
// step, the share of it from each step to the next, and at last.
constexpr double kReach = 3.0, kNarrowing = 0.7, kLastReach = 0.6;
// Steps end at a change of less than this, in m or rad: far below what sensors tell.
constexpr double kEnough = 5e-5;
// Standard deviation of what is to be trusted: of a shift [m] or a turn [rad].
constexpr double kTrusted = 1e-8;
// Least number of matched samples, and largest root mean square motion in standard deviations.
constexpr int kMinMatches = 50;
constexpr double kMaxDeviation = 4.0;
// Number of samples of each orientation that are matched; more tell nothing new.
constexpr std::size_t kSamples = 200;
// Standard deviation of the sensor's own, slowly varying error of depth [m], and the number of
// places of one orientation in a view at which it is independent.
constexpr double kSensorError = 0.001, kPlaces = 15.0;
// Largest number of samples about a place that are kept for the next steps. More lie there only if
// the poses are off by much, and would fill the memory.
constexpr std::size_t kMostKept = 4096;
// Samples at a depth edge have fewer neighbours than this; they lie partly beside the surface.
constexpr std::size_t kMinNeighbours = 8;

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// The samples of earlier views, by place.
class Target {
 public:
  /// @param reach  about how far from a place the first searches look [m]
  Target(const SurfaceSamples& samples, float reach)
      : samples_(samples), cubes_(samples.raw, reach) {}

  /// The samples within a radius of a place.
  struct Ball {
    Eigen::Vector3f centre = Eigen::Vector3f::Zero();
    float radius = -1.0f;
    std::vector<int> samples;

    /// True if all samples within a reach of p are here.
    bool holds(const Eigen::Vector3f& p, float reach) const {
      return (p - centre).norm() + reach <= radius;
    }
    /// True if few others are.
    bool is_small(float reach) const { return radius < 2.0f * reach; }
  };

  /// The nearest sample with a similar normal within a distance; −1 if there is none.
  /// @param ball  samples about the place; it is filled anew if it lacks some. The next steps move
  ///              a sample little and look less far, so that they seldom need another ball.
  int nearest(const Eigen::Vector3f& p, const Eigen::Vector3f& n, float reach, Ball* ball) const {
    if (!ball->holds(p, reach)) {
      *ball = {p, reach, cubes_.near(p, reach)};
    } else if (!ball->is_small(reach)) {
      *ball = among(ball->samples, p, reach);
    }
    int best = -1;
    float least = reach * reach;
    for (const int j : ball->samples) {
      const float square = (samples_.raw[j] - p).squaredNorm();
      if (square >= least || samples_.n[j].dot(n) < kMinCosine) continue;
      least = square;
      best = j;
    }
    if (ball->samples.size() > kMostKept) *ball = Ball();
    return best;
  }

 private:
  /// The ball of those of some samples that are within a reach of p.
  Ball among(std::span<const int> some, const Eigen::Vector3f& p, float reach) const {
    Ball ball{p, reach, {}};
    for (const int j : some) {
      if ((samples_.raw[j] - p).squaredNorm() < reach * reach) ball.samples.push_back(j);
    }
    return ball;
  }

  const SurfaceSamples& samples_;
  PlaceCubes cubes_;
};

// Number of orientations that are told apart: each component of a normal is about −1, 0 or 1.
constexpr std::size_t kWays = 27;

/// Normal equations of the matches whose surfaces look the same way.
struct Equations {
  Matrix6d A = Matrix6d::Zero();
  Vector6d b = Vector6d::Zero();
  int matches = 0;
};

/// Number of the orientation of a normal, of kWays, such that a table does not outweigh the sides
/// of what stands on it.
std::size_t orientation_of(const Eigen::Vector3d& normal) {
  const Eigen::Array3i way = normal.array().round().cast<int>() + 1;
  return static_cast<std::size_t>(way.x()) + 3 * static_cast<std::size_t>(way.y()) +
         9 * static_cast<std::size_t>(way.z());
}

/// Weight of a residual by Cauchy's function, which leaves little to those far beyond sigma.
double weight_of(double residual, double sigma) {
  const double x = residual / (2.0 * sigma);
  return 1.0 / (sigma * sigma * (1.0 + x * x));
}

/// Samples that lie within their surface, evenly chosen from each orientation.
std::vector<int> evenly_oriented(const SurfaceSamples& samples) {
  std::array<std::vector<int>, kWays> ways;
  for (int i = 0; i < samples.size(); ++i) {
    if (samples.neighbours_of(i).size() < kMinNeighbours) continue;
    ways[orientation_of(samples.n[i].cast<double>())].push_back(i);
  }
  std::vector<int> some;
  for (const std::vector<int>& way : ways) {
    const std::vector<int> chosen = spread_evenly(way, kSamples);
    some.insert(some.end(), chosen.begin(), chosen.end());
  }
  return some;
}

/// How far a place may be off [m].
/// @param errors  of the pose, in standard deviations
double off_at(const Eigen::Vector3d& p, const Eigen::Vector3d& eye, double errors,
              const ViewOptions& options) {
  return errors * (options.shift + options.turn * (p - eye).norm());
}

/// How far most of these samples look for others at the first step [m].
float usual_reach(const SurfaceSamples& view, const std::vector<int>& some,
                  const Eigen::Vector3d& eye, const ViewOptions& options) {
  if (some.empty()) return 1.0f;
  std::vector<float> reaches;
  reaches.reserve(some.size());
  for (const int i : some) {
    const double off = off_at(view.raw[i].cast<double>(), eye, kReach, options);
    reaches.push_back(kMatchCells * view.cell[i] + static_cast<float>(off));
  }
  return median(reaches);
}

}  // namespace

std::optional<Eigen::Isometry3d> align(const SurfaceSamples& view, const Eigen::Vector3d& eye,
                                       const SurfaceSamples& before, const ViewOptions& options) {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  if (options.shift == 0.0 && options.turn == 0.0) return X;
  Vector6d prior;
  prior << Eigen::Vector3d::Constant(std::pow(std::max(kTrusted, options.turn), -2)),
      Eigen::Vector3d::Constant(std::pow(std::max(kTrusted, options.shift), -2));
  Vector6d motion = Vector6d::Zero();
  const std::vector<int> some = evenly_oriented(view);
  const Target target(before, usual_reach(view, some, eye, options));
  std::vector<Target::Ball> balls(some.size());
  int matches = 0;
  for (int step = 0; step < kIterations; ++step) {
    matches = 0;
    std::array<Equations, kWays> ways;
    // The first steps look for what poses may be off, the later ones for what is left of it.
    const double errors = std::max(kLastReach, kReach * std::pow(kNarrowing, step));
    for (std::size_t k = 0; k < some.size(); ++k) {
      const int i = some[k];
      const Eigen::Vector3d p = X * view.raw[i].cast<double>();
      const Eigen::Vector3f n = (X.linear() * view.n[i].cast<double>()).cast<float>();
      const double off = off_at(p, eye, errors, options);
      const float reach = kMatchCells * view.cell[i] + static_cast<float>(off);
      const int j = target.nearest(p.cast<float>(), n, reach, &balls[k]);
      if (j < 0) continue;
      const Eigen::Vector3d normal = before.n[j].cast<double>();
      const double residual = normal.dot(p - before.raw[j].cast<double>());
      if (std::abs(residual) > off) continue;
      const double sigma = std::sqrt(std::pow(view.sigma[i], 2) + std::pow(before.sigma[j], 2) +
                                     std::pow(kSensorError, 2));
      Vector6d J;
      J << (p - eye).cross(normal), normal;
      const double weight = weight_of(residual, sigma);
      Equations& way = ways[orientation_of(normal)];
      way.A += weight * J * J.transpose();
      way.b -= weight * residual * J;
      ++way.matches;
      ++matches;
    }
    Matrix6d A = prior.asDiagonal();
    Vector6d b = -prior.cwiseProduct(motion);
    for (const Equations& way : ways) {
      const double share = std::min(1.0, kPlaces / std::max(1, way.matches));
      A += share * way.A;
      b += share * way.b;
    }
    const Vector6d change = A.ldlt().solve(b);
    motion += change;
    const Eigen::Vector3d turn = change.head<3>();
    const Eigen::Isometry3d about = Eigen::Translation3d(eye + change.tail<3>()) *
                                    Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()) *
                                    Eigen::Translation3d(-eye);
    X = about * X;
    const bool narrow = errors == kLastReach;
    if (narrow && change.tail<3>().norm() < kEnough && turn.norm() < kEnough) break;
  }
  const double deviation = std::sqrt(motion.cwiseAbs2().dot(prior) / 6.0);
  if (matches < kMinMatches || !(deviation < kMaxDeviation)) return std::nullopt;
  return X;
}

}  // namespace quadrille
