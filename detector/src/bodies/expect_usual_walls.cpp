#include "bodies/expect_usual_walls.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "bodies/joint_member.hpp"
#include "bodies/profile.hpp"
#include "fit/distance_sums.hpp"
#include "fit/posed_quadric.hpp"
#include "surfaces/surface_fit.hpp"
#include "surfaces/uncertainty.hpp"
#include "surfaces/usual_wall.hpp"

namespace quadrille {
namespace {

// No root mean square distance grows by more than this factor. A usual thickness that asks for more
// would tear the fit off its points. With a factor of 2 one of 24 walls that time of flight bends
// stays wrong.
constexpr double kMaxWorse = 3.0;

/// Place of a surface among the members of an axis; their number if it is none of them.
std::size_t place(const CommonAxis& axis, int k) {
  return static_cast<std::size_t>(std::find(axis.members.begin(), axis.members.end(), k) -
                                  axis.members.begin());
}

/// The axis about which both sides of a gap were fitted; null if there is none.
CommonAxis* axis_of(const WallGap& gap, std::vector<CommonAxis>* axes) {
  const auto has_both = [&](const CommonAxis& axis) {
    const std::size_t none = axis.members.size();
    return place(axis, gap.outer) < none && place(axis, gap.inner) < none;
  };
  const auto found = std::find_if(axes->begin(), axes->end(), has_both);
  return found == axes->end() ? nullptr : &*found;
}

/// The difference between the usual thickness μ and the measured one t, and its variance S.
struct Innovation {
  /// [m], [m²]
  double difference, variance;
};

Innovation innovation_of(const WallGap& gap) {
  return {kUsualThickness - gap.thickness, gap.std * gap.std + kThicknessSpread * kThicknessSpread};
}

/// How the fit of one surface changes.
struct Change {
  PosedQuadric posed;
  /// By which its sum of squares grows.
  double growth;
  /// Covariance of its parameters but for what the sensor moves it by, and that; see offset_step().
  Eigen::MatrixXd covariance;
  Eigen::VectorXd by_offset;
};

/// The change of member i of an axis.
Change change_of(std::size_t i, const WallGap& gap, const CommonAxis& axis, const LastFit& fit,
                 const SurfaceSamples& samples) {
  const auto [difference, S] = innovation_of(gap);
  const Surface& surface = fit.surface;
  const CoaxialCovariance& C = axis.covariance;
  const Eigen::VectorXd with_t = C.between(i, place(axis, gap.outer)) * gap.by_outer +
                                 C.between(i, place(axis, gap.inner)) * gap.by_inner;
  Eigen::VectorXd gain = with_t / S;
  Eigen::VectorXd by_offset = offset_step(surface);
  // Variance of t that the own offset of the surface makes, which is accounted for apart.
  double own = 0.0;
  const int k = axis.members[i];
  if (k == gap.outer || k == gap.inner) {
    const double slope = (k == gap.outer ? gap.by_outer : gap.by_inner).dot(by_offset);
    const double offset = offset_std(surface, samples);
    gain += offset * offset * slope / S * by_offset;
    by_offset -= slope * gain;
    own = offset * offset * slope * slope;
  }
  const Eigen::MatrixXd both = with_t * gain.transpose();
  const PosedQuadric posed = moved(surface.fit.family, surface.fit.posed, gain * difference);
  DistanceSums<float> sums(fit.points);
  const double before = sums.evaluate(surface.fit.posed.matrix()).squares();
  // Exact points have no residuals that grow.
  const double growth = before > 0.0 ? sums.evaluate(posed.matrix()).squares() / before : 1.0;
  return {posed, growth,
          C.between(i, i) - both - both.transpose() + (S - own) * gain * gain.transpose(),
          std::move(by_offset)};
}

/// True if a surface may change so: it keeps its type and its points.
bool is_possible(const Change& change, const Surface& surface) {
  return canonical_form(change.posed).type == canonical_form(surface.fit.posed).type &&
         change.growth < kMaxWorse * kMaxWorse;
}

void apply(const Change& change, Surface* surface) {
  FamilyFit fit = surface->fit;
  fit.posed = change.posed;
  fit.rss *= change.growth;
  set_fit(surface, std::move(fit));
  const auto I = Eigen::MatrixXd::Identity(change.covariance.rows(), change.covariance.cols());
  surface->information.JtJ = variance_of(*surface) * change.covariance.ldlt().solve(I);
  surface->information.Jt1 = -surface->information.JtJ * change.by_offset;
}

/// Takes what is now known of a thickness into account in the covariance of a common axis.
void narrow(const WallGap& gap, CommonAxis* axis) {
  CoaxialCovariance& covariance = axis->covariance;
  const Eigen::VectorXd g = covariance.map[place(*axis, gap.outer)].transpose() * gap.by_outer +
                            covariance.map[place(*axis, gap.inner)].transpose() * gap.by_inner;
  const Eigen::VectorXd with_t = covariance.unknowns * g;
  covariance.unknowns -= with_t * with_t.transpose() / innovation_of(gap).variance;
}

/// Moves the surfaces about an axis, and notes what is known of the thickness then.
/// @return false if that is not possible
bool move_to_usual(const SurfaceSamples& samples, WallGap* gap, CommonAxis* axis,
                   std::vector<LastFit>* fits) {
  std::vector<Change> changes;
  for (std::size_t i = 0; i < axis->members.size(); ++i) {
    const LastFit& fit = (*fits)[axis->members[i]];
    changes.push_back(change_of(i, *gap, *axis, fit, samples));
    if (!is_possible(changes.back(), fit.surface)) return false;
  }
  for (std::size_t i = 0; i < changes.size(); ++i) {
    apply(changes[i], &(*fits)[axis->members[i]].surface);
  }
  narrow(*gap, axis);
  const auto [difference, variance] = innovation_of(*gap);
  gap->thickness += gap->std * gap->std / variance * difference;
  gap->std *= kThicknessSpread / std::sqrt(variance);
  return true;
}

}  // namespace

std::vector<int> expect_usual_walls(const SurfaceSamples& samples, std::vector<WallGap>* gaps,
                                    std::vector<CommonAxis>* axes, std::vector<LastFit>* fits) {
  std::stable_sort(gaps->begin(), gaps->end(),
                   [](const WallGap& a, const WallGap& b) { return a.std < b.std; });
  std::vector<char> has_moved(fits->size(), 0);
  std::vector<int> result;
  std::vector<WallGap> known;
  for (WallGap& gap : *gaps) {
    if (has_moved[gap.outer] || has_moved[gap.inner]) continue;
    CommonAxis* axis = axis_of(gap, axes);
    const bool is_thicker = gap.thickness - gap.std > kMaxThickness;
    if (axis && !is_thicker && move_to_usual(samples, &gap, axis, fits)) {
      for (const int k : axis->members) has_moved[k] = 1;
      result.insert(result.end(), axis->members.begin(), axis->members.end());
    }
    known.push_back(std::move(gap));
  }
  *gaps = std::move(known);
  return result;
}

}  // namespace quadrille
