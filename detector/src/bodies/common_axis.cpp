#include "bodies/common_axis.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <utility>

#include "bodies/axial_part.hpp"
#include "bodies/joint_member.hpp"
#include "bodies/one_centre.hpp"
#include "bodies/straight_sides.hpp"
#include "fit/coaxial_fit.hpp"
#include "fit/family_spec.hpp"
#include "quadrille/detector/quadric.hpp"
#include "surfaces/surface_fit.hpp"
#include "surfaces/uncertainty.hpp"

namespace quadrille {
namespace {

// Parts within kPerhapsOneAxis join the others only if that raises no root mean square distance by
// more than this factor. The walls of a tapered cup that pass for cylinders lean apart, and no axis
// suits both.
constexpr double kMaxWorse = 1.4;
/// The joint fit; nullopt if less than two parts are left. Both sides of a wall become cylinders or
/// parallel cones, where that is better than what they were alone.
std::optional<CoaxialFit> fit_members(const std::vector<Member>& members) {
  if (members.size() < 2) return std::nullopt;
  std::vector<CoaxialPart> alone;
  alone.reserve(members.size());
  for (const Member& member : members) alone.push_back(member.part);
  std::optional<JointChoice> best;
  try_parts(members, alone, &best);
  if (const WallSides wall = straight_wall(members); !wall.empty()) {
    const Eigen::Isometry3d X_CA = mean_axis(members, wall);
    for (const Family family : {Family::kCylinder, Family::kCone}) {
      std::vector<CoaxialPart> parts = alone;
      straighten(members, wall, family, X_CA, &parts);
      try_parts(members, std::move(parts), &best);
    }
  }
  if (!best) return std::nullopt;
  return std::move(best->fit);
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
    const double growth = growth_of(members[i], joint.parts[i]);
    if (growth > most) most = growth, worst = i;
    sum += growth;
  }
  int shared = -static_cast<int>(joint.information.front().rows());
  for (const Member& member : members) shared += family_spec(member.part.fit.family).dof;
  if (is_chance(sum, shared)) return std::nullopt;
  return worst;
}

/// Gives the surfaces of the members their joint fit.
CommonAxis set_fits(const std::vector<Member>& members, const CoaxialFit& joint,
                    std::vector<LastFit>* fits) {
  CommonAxis axis;
  std::vector<double> variances;
  for (std::size_t i = 0; i < members.size(); ++i) {
    Surface& surface = (*fits)[members[i].index].surface;
    // The sum of squares may be that of some of the points only; see ClosedFit.
    FamilyFit fit = joint.parts[i];
    fit.rss = surface.fit.rss * joint.parts[i].rss / members[i].alone;
    set_fit(&surface, std::move(fit));
    const double square = surface.local.scale * surface.local.scale;
    variances.push_back(members[i].part.weight * square * variance_of(surface));
  }
  axis.covariance = covariance_of(joint, variances);
  for (std::size_t i = 0; i < members.size(); ++i) {
    Surface& surface = (*fits)[members[i].index].surface;
    // uncertainty_of() makes the covariance of this.
    const Eigen::MatrixXd covariance = axis.covariance.between(i, i);
    const auto I = Eigen::MatrixXd::Identity(covariance.rows(), covariance.cols());
    surface.information.JtJ = variance_of(surface) * covariance.ldlt().solve(I);
    surface.information.Jt1 = information((*fits)[members[i].index].wall(), surface.fit).Jt1;
    axis.members.push_back(members[i].index);
  }
  return axis;
}

/// The members of each body that may have a common axis.
///
/// The largest part, and those that share its axis within the usual tolerance, are sure members.
/// The others are guests: their axes are farther off.
/// @param taken  nonzero for surfaces that take no part
std::vector<std::vector<Member>> find_members(std::span<const Detection> detections,
                                              const std::vector<LastFit>& fits,
                                              const std::vector<char>& taken) {
  std::vector<AxialPart> parts;
  std::vector<int> index;
  for (std::size_t k = 0; k < detections.size(); ++k) {
    if (fits[k].points.size() == 0 || taken[k]) continue;
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
      members.push_back(member_of(index[k], fits[index[k]], shows_inside(detections[index[k]]),
                                  surely[k] != surely[host]));
    }
    // A part is parallel to one before it.
    std::stable_partition(members.begin(), members.end(),
                          [](const Member& member) { return !member.is_inside; });
    result.push_back(std::move(members));
  }
  return result;
}

}  // namespace

std::vector<CommonAxis> fit_common_axes(std::span<const Detection> detections,
                                        std::vector<LastFit>* fits) {
  std::vector<CommonAxis> axes;
  std::vector<char> taken(fits->size(), 0);
  for (const CentredWall& wall : find_centred_walls(detections, *fits)) {
    for (const Member& side : wall.sides) taken[side.index] = 1;
    axes.push_back(set_fits(wall.sides, wall.fit, fits));
  }
  for (std::vector<Member>& members : find_members(detections, *fits, taken)) {
    std::optional<CoaxialFit> joint = fit_members(members);
    while (joint) {
      const std::optional<std::size_t> worst = misfit(members, *joint);
      if (!worst) break;
      members.erase(members.begin() + static_cast<std::ptrdiff_t>(*worst));
      joint = fit_members(members);
    }
    if (!joint) continue;
    axes.push_back(set_fits(members, *joint, fits));
  }
  return axes;
}

}  // namespace quadrille
