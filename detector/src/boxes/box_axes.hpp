#pragma once

#include <Eigen/Core>
#include <vector>

#include "boxes/face.hpp"

namespace quadrille {

/// Finds the axes of a box from one, two or three of its faces.
///
/// For several faces, it is the rotation whose first columns are nearest to their normals, weighted
/// by their points (Wahba's problem, solved by the singular value decomposition of Σ wᵢ nᵢ eᵢᵀ);
/// the third column is ± the normal of a third face. For one face, the first column is its normal,
/// and the others lie along the smallest rectangle around its points, one side of which lies along
/// an edge of their convex hull (Freeman and Shapira, 1975).
/// @param faces  faces whose normals are nearly at right angles
Eigen::Matrix3d box_axes(const std::vector<const Face*>& faces);

}  // namespace quadrille
