#include "bodies/expect_usual_walls.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "bodies/joint_member.hpp"
#include "bodies/profile.hpp"
#include "bodies/walls.hpp"
#include "fit/distance_sums.hpp"
#include "fit/posed_quadric.hpp"
#include "surfaces/uncertainty.hpp"
#include "surfaces/usual_wall.hpp"

namespace quadrille {
namespace {

// A thickness that is farther from the usual one, in deviations of their difference, is another
// thing than such a wall.
constexpr double kMaxDeviations = 3.0;

/// The surfaces that a wall moves, and the covariance of their parameters.
class WallParts {
 public:
  WallParts(const WallGap& gap, std::vector<CommonAxis>* axes, const std::vector<LastFit>& fits)
      : fits_(fits), numbers_{gap.outer, gap.inner} {
    for (CommonAxis& axis : *axes) {
      const auto has = [&](int k) {
        return std::find(axis.members.begin(), axis.members.end(), k) != axis.members.end();
      };
      if (has(gap.outer) && has(gap.inner)) axis_ = &axis, numbers_ = axis.members;
    }
  }

  const std::vector<int>& numbers() const { return numbers_; }
  /// The common axis of both sides; null if they were fitted one by one.
  CommonAxis* axis() const { return axis_; }

  /// Covariance of the parameters of surface k with those of surface l.
  Eigen::MatrixXd between(int k, int l) const {
    if (axis_) return axis_->covariance.between(place(k), place(l));
    const Eigen::MatrixXd own = parameter_covariance(fits_[k].surface);
    if (k == l) return own;
    return Eigen::MatrixXd::Zero(own.rows(), fits_[l].surface.information.JtJ.rows());
  }
  /// Place of a surface among the members of the axis.
  std::size_t place(int k) const {
    const std::vector<int>& members = axis_->members;
    return static_cast<std::size_t>(std::find(members.begin(), members.end(), k) - members.begin());
  }

 private:
  const std::vector<LastFit>& fits_;
  std::vector<int> numbers_;
  CommonAxis* axis_ = nullptr;
};

/// How the parameters of one surface change.
struct Change {
  int index;
  Eigen::VectorXd step;
  Eigen::MatrixXd covariance;
  /// What the sensor moves the parameters by, for each unit that it moves the surface by along its
  /// normals; empty if that is as before.
  Eigen::VectorXd by_offset;
};

/// What the sensor moves the parameters of a surface by; see Change::by_offset.
Eigen::VectorXd offset_step(const Surface& surface) {
  return -surface.information.JtJ.ldlt().solve(surface.information.Jt1);
}

/// What the usual thickness tells about a wall.
struct Innovation {
  /// μ − t [m], and S [m²].
  double difference, variance;
};

Innovation innovation_of(const WallGap& gap) {
  return {kUsualThickness - gap.thickness, gap.std * gap.std + kThicknessSpread * kThicknessSpread};
}

bool is_likely(const Innovation& innovation) {
  const double& d = innovation.difference;
  return d * d <= kMaxDeviations * kMaxDeviations * innovation.variance;
}

/// The change of surface k.
Change change_of(int k, const WallGap& gap, const WallParts& parts, const Surface& surface,
                 const SurfaceSamples& samples) {
  const auto [difference, S] = innovation_of(gap);
  const Eigen::VectorXd with_t =
      parts.between(k, gap.outer) * gap.by_outer + parts.between(k, gap.inner) * gap.by_inner;
  Eigen::VectorXd gain = with_t / S;
  Eigen::VectorXd by_offset;
  // Variance of t that the own offset of the surface makes, which is accounted for apart.
  double own = 0.0;
  if (k == gap.outer || k == gap.inner) {
    by_offset = offset_step(surface);
    const double slope = (k == gap.outer ? gap.by_outer : gap.by_inner).dot(by_offset);
    const double offset = offset_std(surface, samples);
    gain += offset * offset * slope / S * by_offset;
    by_offset -= slope * gain;
    own = offset * offset * slope * slope;
  }
  const Eigen::MatrixXd both = with_t * gain.transpose();
  return {k, gain * difference,
          parts.between(k, k) - both - both.transpose() + (S - own) * gain * gain.transpose(),
          std::move(by_offset)};
}

/// Gives a surface its changed parameters.
void apply(const Change& change, LastFit* fit) {
  Surface& surface = fit->surface;
  DistanceSums<float> sums(fit->points);
  const double before = sums.evaluate(surface.fit.posed.matrix()).squares();
  surface.fit.posed = moved(surface.fit.family, surface.fit.posed, change.step);
  const double after = sums.evaluate(surface.fit.posed.matrix()).squares();
  // Those of exact points are none.
  if (before > 0.0) surface.fit.rss *= after / before;
  surface.Q = surface.local.to_frame(surface.fit.posed.matrix()).normalized();
  surface.rms = surface.local.scale * std::sqrt(surface.fit.rss / surface.fit.points);
  const auto I = Eigen::MatrixXd::Identity(change.covariance.rows(), change.covariance.cols());
  surface.information.JtJ = variance_of(surface) * change.covariance.ldlt().solve(I);
  if (change.by_offset.size() > 0) {
    surface.information.Jt1 = -surface.information.JtJ * change.by_offset;
  }
}

/// Takes what is now known of a thickness into account in the covariance of a common axis.
void narrow(const WallGap& gap, const WallParts& parts, double variance) {
  CoaxialCovariance& covariance = parts.axis()->covariance;
  const Eigen::VectorXd g = covariance.map[parts.place(gap.outer)].transpose() * gap.by_outer +
                            covariance.map[parts.place(gap.inner)].transpose() * gap.by_inner;
  const Eigen::VectorXd with_t = covariance.unknowns * g;
  covariance.unknowns -= with_t * with_t.transpose() / variance;
}

/// Moves the surfaces of a wall, and notes what is known of its thickness then.
/// @return their numbers
std::vector<int> move_sides(const SurfaceSamples& samples, WallGap* gap,
                            std::vector<CommonAxis>* axes, std::vector<LastFit>* fits) {
  const WallParts parts(*gap, axes, *fits);
  const auto [difference, variance] = innovation_of(*gap);
  std::vector<Change> changes;
  for (const int k : parts.numbers()) {
    changes.push_back(change_of(k, *gap, parts, (*fits)[k].surface, samples));
  }
  if (parts.axis()) narrow(*gap, parts, variance);
  for (const Change& change : changes) apply(change, &(*fits)[change.index]);
  gap->thickness += gap->std * gap->std / variance * difference;
  gap->std *= kThicknessSpread / std::sqrt(variance);
  return parts.numbers();
}

}  // namespace

std::vector<int> expect_usual_walls(const SurfaceSamples& samples, std::vector<WallGap>* gaps,
                                    std::vector<CommonAxis>* axes, std::vector<LastFit>* fits) {
  std::stable_sort(gaps->begin(), gaps->end(),
                   [](const WallGap& a, const WallGap& b) { return a.std < b.std; });
  std::vector<char> has_moved(fits->size(), 0);
  std::vector<WallGap> known;
  std::vector<int> result;
  for (WallGap& gap : *gaps) {
    const std::vector<int> numbers = WallParts(gap, axes, *fits).numbers();
    const auto moved_before = [&](int k) { return has_moved[k] != 0; };
    if (std::any_of(numbers.begin(), numbers.end(), moved_before)) continue;
    if (is_likely(innovation_of(gap))) {
      for (const int k : move_sides(samples, &gap, axes, fits)) {
        has_moved[k] = 1;
        result.push_back(k);
      }
    }
    known.push_back(std::move(gap));
  }
  *gaps = std::move(known);
  return result;
}

}  // namespace quadrille
