#include "bodies/joint_member.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "fit/family_spec.hpp"
#include "quadrille/detector/quadric.hpp"
#include "surfaces/uncertainty.hpp"

namespace quadrille {
namespace {

// Number of steps of the joint fit, after which nearly all have converged.
constexpr int kJointSteps = 10;
// Mean square of the distances that rounding leaves of exact points, in local coordinates.
constexpr double kExactSquares = 1e-14;
// Growth of the residuals counts as chance up to this quantile of the normal distribution, which
// one body in a thousand exceeds. In simulated kitchens one in twelve does, since
// sensors bend surfaces by more than their noise tells.
constexpr double kChance = 3.09;

/// Quantile of the χ² distribution that belongs to a quantile of the normal one, by the
/// approximation of Wilson and Hilferty, which is right within 1 % here.
double chi_square_quantile(double degrees, double normal) {
  const double v = 2.0 / (9.0 * degrees);
  return degrees * std::pow(1.0 - v + normal * std::sqrt(v), 3);
}

}  // namespace

double variance_of(const Surface& surface) {
  return surface.fit.points * variance_of_mean(surface);
}

Member member_of(int index, const LastFit& fit, bool is_inside, bool is_guest) {
  const Surface& surface = fit.surface;
  auto points = std::make_unique<DistanceSums<float>>(fit.points);
  const double least = kExactSquares * static_cast<double>(fit.points.size());
  const double alone = std::max(least, points->evaluate(surface.fit.posed.matrix()).squares());
  const double scale = surface.local.scale;
  const double weight = surface.fit.points / (scale * scale * alone);
  const CoaxialPart part{surface.fit, surface.local, points.get(), weight};
  const double variance =
      std::max(least, variance_of(surface) + surface.fit.points * bend_variance(surface));
  return {index, &fit, std::move(points), part, alone, variance, is_inside, is_guest};
}

bool changes_type(const Member& member, const FamilyFit& joint) {
  const QuadricType type = canonical_form(joint.posed).type;
  if (joint.family == Family::kCone) return type != QuadricType::kCone;
  if (joint.family == Family::kCylinder) return type != QuadricType::kCylinder;
  if (joint.family == Family::kSphere) return type != QuadricType::kSphere;
  return type != canonical_form(member.part.fit.posed).type;
}

double growth_of(const Member& member, const FamilyFit& joint) {
  return (joint.rss - member.alone) / member.variance;
}

double bic_of(const Member& member, const FamilyFit& joint, int shared) {
  if (changes_type(member, joint)) return std::numeric_limits<double>::infinity();
  const double n = std::max(2.0, member.fit->surface.effective_size);
  return growth_of(member, joint) + (family_spec(joint.family).dof - shared) * std::log(n) -
         2.0 * log_prior(canonical_form(joint.posed).type);
}

bool is_chance(double growth, int unknowns) {
  return growth <= chi_square_quantile(std::max(1, unknowns), kChance);
}

void try_parts(const std::vector<Member>& members, std::vector<CoaxialPart> parts,
               std::optional<JointChoice>* best) {
  std::optional<CoaxialFit> fit = fit_coaxial(parts, kJointSteps);
  if (!fit) return;
  double sum = 0.0;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const bool shares_slope = parts[i].parallel_to && parts[i].fit.family == Family::kCone;
    sum += bic_of(members[i], fit->parts[i], shares_slope ? 1 : 0);
  }
  if (!*best || sum < (*best)->bic) *best = JointChoice{std::move(parts), std::move(*fit), sum};
}

}  // namespace quadrille
