#pragma once

#include <Eigen/Core>
#include <vector>

#include "variants/variant.hpp"

namespace quadrille {

/// Number of points in a basis.
int basis_size(VariantBasis basis);

/// Draws a random basis as a variant has it, and returns the quadrics through it like
/// draw_hypotheses().
/// @param seen  refuses a basis of three points that it contains, and receives others; may be null,
///   and is not used for other kinds of bases
std::vector<Eigen::Matrix4d> draw_variant(const Variant& variant, const Voters& voters,
                                          RandomStream& random, TripletSet* seen = nullptr);

}  // namespace quadrille
