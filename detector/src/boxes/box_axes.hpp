#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxes/face.hpp"

namespace quadrille {

/// The axes of a box by one, two or three of its faces.
///
/// Of several faces the rotation whose first columns are nearest to their normals, weighted by
/// their points (Wahba's problem, solved by the singular value decomposition of Σ wᵢ nᵢ eᵢᵀ); the
/// third column is ± the normal of a third face. Of one face the first column is its normal, and
/// the others lie along the sides of the smallest rectangle around its points, of which one lies
/// along an edge of their convex hull (Freeman and Shapira, 1975).
/// @param faces  their normals nearly at right angles
Eigen::Matrix3d box_axes(const std::vector<const Face*>& faces);

}  // namespace quadrille
