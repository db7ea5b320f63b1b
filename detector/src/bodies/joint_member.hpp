#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "fit/coaxial_fit.hpp"
#include "fit/distance_sums.hpp"
#include "surfaces/last_fit.hpp"

namespace quadrille {

/// A surface that may be a part of a body.
struct Member {
  int index;
  const LastFit* fit;
  std::unique_ptr<DistanceSums<float>> points;
  CoaxialPart part;
  /// Sum of squares of its fit alone, and by how much chance and bent surfaces let it grow for one
  /// unknown less; both in local coordinates.
  double alone, variance;
  /// True if it was seen from inside.
  bool is_inside;
  /// True if its axis is that of the others only within kPerhapsOneAxis.
  bool is_guest;
};

/// Variance of the mean of a surface's noise, times the number of its points.
double variance_of(const Surface& surface);

/// @param fit  of more than no points; must outlive the member
Member member_of(int index, const LastFit& fit, bool is_inside, bool is_guest);

/// True if a member is of another type in a joint fit than alone, and not because it has another
/// family.
bool changes_type(const Member& member, const FamilyFit& joint);

/// By how much a member's sum of squares grows in a joint fit, in multiples of what chance and bent
/// surfaces let it grow for one unknown less.
double growth_of(const Member& member, const FamilyFit& joint);

/// True if chance explains by how much the residuals of all members grow in a joint fit; see
/// growth_of().
/// @param unknowns  number of unknowns that it has less than the fits alone
bool is_chance(double growth, int unknowns);

/// The Bayesian information criterion of a member's part, k ln n less twice the log-likelihood and
/// the log_prior() of its type; infinite if the type is not the one of its family. Growth of the
/// residuals takes the place of −2 ln L: what chance and bent surfaces explain is no evidence.
/// @param shared  number of its unknowns that belong to another part
double bic_of(const Member& member, const FamilyFit& joint, int shared);

/// A joint fit and the sum of its parts' criteria.
struct JointChoice {
  std::vector<CoaxialPart> parts;
  CoaxialFit fit;
  double bic;
};

/// Fits parts together, and takes the fit if it is better than the best so far.
void try_parts(const std::vector<Member>& members, std::vector<CoaxialPart> parts,
               std::optional<JointChoice>* best);

}  // namespace quadrille
