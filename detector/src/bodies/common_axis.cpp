#include "bodies/common_axis.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "bodies/axial_part.hpp"
#include "fit/coaxial_fit.hpp"
#include "fit/distance_sums.hpp"
#include "quadrille/detector/quadric.hpp"
#include "surfaces/uncertainty.hpp"

namespace quadrille {
namespace {

// Number of steps of the joint fit, after which nearly all have converged.
constexpr int kJointSteps = 10;
// Number of unknowns of an axis, each of which a part has alone but not in a joint fit.
constexpr int kAxisUnknowns = 4;
// Growth of the residuals counts as chance up to this quantile of the normal distribution, which
// one body in a thousand exceeds. Of those in simulated kitchens one in twelve does, where sensors
// bend surfaces by more than their noise tells.
constexpr double kChance = 3.09;

// Small parts alone may have axes that are this far off: 20° and a quarter of the radius.
constexpr AxisTolerance kPerhapsOneAxis = {0.35, 0.25};
// Such parts join the others only if that raises no root mean square distance by more than this
// factor. The walls of a tapered cup that pass for cylinders lean apart, and no axis suits both.
constexpr double kMaxWorse = 1.4;
// Mean square of the distances that rounding leaves of exact points, in local coordinates.
constexpr double kRounding = 1e-14;

/// Quantile of the χ² distribution that belongs to a quantile of the normal one, by the
/// approximation of Wilson and Hilferty, which is right within 1 % here.
double chi_square_quantile(double degrees, double normal) {
  const double v = 2.0 / (9.0 * degrees);
  return degrees * std::pow(1.0 - v + normal * std::sqrt(v), 3);
}

/// A surface that may be a part of a body.
struct Member {
  int index;
  std::unique_ptr<DistanceSums<float>> points;
  CoaxialPart part;
  /// Sum of squares of its fit alone, and by how much chance and bent surfaces let it grow for one
  /// unknown less; both in local coordinates.
  double alone, variance;
  /// True if its axis is that of the others only within kPerhapsOneAxis.
  bool is_guest;
};

double variance_of(const Surface& surface) {
  return surface.fit.points * variance_of_mean(surface);
}

Member member_of(int index, const LastFit& fit, bool is_guest) {
  const Surface& surface = fit.surface;
  auto points = std::make_unique<DistanceSums<float>>(fit.points);
  const double least = kRounding * static_cast<double>(fit.points.size());
  const double alone = std::max(least, points->evaluate(surface.fit.posed.matrix()).squares());
  const double scale = surface.local.scale;
  const double weight = surface.fit.points / (scale * scale * alone);
  const CoaxialPart part{surface.fit, surface.local, points.get(), weight};
  const double variance =
      std::max(least, variance_of(surface) + surface.fit.points * bend_variance(surface));
  return {index, std::move(points), part, alone, variance, is_guest};
}

/// The joint fit; nullopt if less than two parts are left.
std::optional<CoaxialFit> fit_members(const std::vector<Member>& members) {
  if (members.size() < 2) return std::nullopt;
  std::vector<CoaxialPart> parts;
  parts.reserve(members.size());
  for (const Member& member : members) parts.push_back(member.part);
  return fit_coaxial(parts, kJointSteps);
}

/// True if a member is of another type in the joint fit than alone.
bool changes_type(const Member& member, const FamilyFit& joint) {
  return canonical_form(joint.posed).type != canonical_form(member.part.fit.posed).type;
}

/// The number of the guest whose distances grow most, if those of any member grow too much or a
/// member's type changes.
std::optional<std::size_t> unwelcome(const std::vector<Member>& members, const CoaxialFit& joint) {
  bool is_worse = false;
  double most = 0.0;
  std::optional<std::size_t> guest;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const double growth = joint.parts[i].rss / members[i].alone;
    is_worse |= growth > kMaxWorse * kMaxWorse || changes_type(members[i], joint.parts[i]);
    if (members[i].is_guest && growth > most) most = growth, guest = i;
  }
  return is_worse ? guest : std::nullopt;
}

/// The number of the member that the joint fit suits least, if it does not suit all of them.
std::optional<std::size_t> misfit(const std::vector<Member>& members, const CoaxialFit& joint) {
  if (const auto guest = unwelcome(members, joint)) return guest;
  double sum = 0.0, most = 0.0;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    if (changes_type(members[i], joint.parts[i])) return i;
    const double growth = (joint.parts[i].rss - members[i].alone) / members[i].variance;
    if (growth > most) most = growth, worst = i;
    sum += growth;
  }
  const auto shared = static_cast<double>(kAxisUnknowns * (members.size() - 1));
  if (sum <= chi_square_quantile(shared, kChance)) return std::nullopt;
  return worst;
}

/// Gives the surfaces of the members their joint fit.
void set_fits(const std::vector<Member>& members, const CoaxialFit& joint,
              std::vector<LastFit>* fits) {
  std::vector<double> variances;
  for (std::size_t i = 0; i < members.size(); ++i) {
    Surface& surface = (*fits)[members[i].index].surface;
    // The sum of squares may be that of some of the points only; see ClosedFit.
    const double rss = surface.fit.rss * joint.parts[i].rss / members[i].alone;
    surface.fit = joint.parts[i];
    surface.fit.rss = rss;
    surface.Q = surface.local.to_frame(surface.fit.posed.matrix()).normalized();
    surface.rms = surface.local.scale * std::sqrt(rss / surface.fit.points);
    const double square = surface.local.scale * surface.local.scale;
    variances.push_back(members[i].part.weight * square * variance_of(surface));
  }
  const std::vector<Eigen::MatrixXd> covariance = covariances(joint, variances);
  for (std::size_t i = 0; i < members.size(); ++i) {
    Surface& surface = (*fits)[members[i].index].surface;
    // uncertainty_of() makes the covariance of this.
    const auto I = Eigen::MatrixXd::Identity(covariance[i].rows(), covariance[i].cols());
    surface.information.JtJ = variance_of(surface) * covariance[i].ldlt().solve(I);
    surface.information.Jt1 = information((*fits)[members[i].index].wall(), surface.fit).Jt1;
  }
}

/// The members of each body that may have a common axis.
///
/// The largest part, and those that share its axis within the usual tolerance, are sure members.
/// The others are guests: their axes are farther off.
std::vector<std::vector<Member>> find_members(std::span<const Detection> detections,
                                              const std::vector<LastFit>& fits) {
  std::vector<AxialPart> parts;
  std::vector<int> index;
  for (std::size_t k = 0; k < detections.size(); ++k) {
    if (fits[k].points.size() == 0) continue;
    if (!has_one_axis(fits[k].surface.fit.family)) continue;
    const std::optional<AxialPart> part = axial_part(detections[k]);
    if (!part) continue;
    parts.push_back(*part);
    index.push_back(static_cast<int>(k));
  }
  std::map<int, std::vector<std::size_t>> bodies;
  const std::vector<int> perhaps = groups_of(parts, kPerhapsOneAxis), surely = groups_of(parts);
  for (std::size_t k = 0; k < parts.size(); ++k) bodies[perhaps[k]].push_back(k);
  std::vector<std::vector<Member>> result;
  for (const auto& [number, body] : bodies) {
    if (body.size() < 2) continue;
    const std::size_t host =
        *std::max_element(body.begin(), body.end(), [&](std::size_t a, std::size_t b) {
          return fits[index[a]].points.size() < fits[index[b]].points.size();
        });
    std::vector<Member> members;
    for (const std::size_t k : body) {
      members.push_back(member_of(index[k], fits[index[k]], surely[k] != surely[host]));
    }
    result.push_back(std::move(members));
  }
  return result;
}

}  // namespace

std::vector<int> fit_common_axes(std::span<const Detection> detections,
                                 std::vector<LastFit>* fits) {
  std::vector<int> changed;
  for (std::vector<Member>& members : find_members(detections, *fits)) {
    std::optional<CoaxialFit> joint = fit_members(members);
    while (joint) {
      const std::optional<std::size_t> worst = misfit(members, *joint);
      if (!worst) break;
      members.erase(members.begin() + static_cast<std::ptrdiff_t>(*worst));
      joint = fit_members(members);
    }
    if (!joint) continue;
    set_fits(members, *joint, fits);
    for (const Member& member : members) changed.push_back(member.index);
  }
  return changed;
}

}  // namespace quadrille
