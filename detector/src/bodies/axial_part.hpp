#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "boxes/face.hpp"
#include "quadrille/detector/detection.hpp"
#include "surfaces/axis_tolerance.hpp"

namespace quadrille {

/// Gap along the axis between parts of one body, as a share of the larger radius. The detector
/// leaves out narrow shoulders and rims.
inline constexpr double kMaxGapShare = 0.6;

/// A detection that may be a part of a body of revolution.
struct AxialPart {
  const Detection* detection = nullptr;
  /// A point of the axis in the middle of the seen part, and the axis's unit direction; zero for
  /// spheres, through whose centre any axis runs.
  Eigen::Vector3d middle_C = Eigen::Vector3d::Zero(), axis_C = Eigen::Vector3d::Zero();
  /// Largest distance of the seen part from the axis, and half of its length along the axis [m].
  double radius = 0.0, half_length = 0.0;
};

/// The detection as a part of a body of revolution; nullopt for planes and for types or dimensions
/// without such an axis.
std::optional<AxialPart> axial_part(const Detection& detection);

/// The tolerance for parts of one body: 9° and an eighth of the radius.
inline constexpr AxisTolerance kOneAxis = {kMaxSkew, 0.125};

/// True if two parts share an axis and follow each other along it, such as the body and the neck of
/// a bottle, or lie around each other, such as the walls of a mug.
bool share_axis(const AxialPart& a, const AxialPart& b, const AxisTolerance& tolerance = kOneAxis);

/// Numbers that tell for each part to which group it belongs: parts that share an axis, directly or
/// by others, have the same number.
std::vector<int> groups_of(const std::vector<AxialPart>& parts,
                           const AxisTolerance& tolerance = kOneAxis);

/// True if a plane is a lid or a bottom of a part: at right angles to its axis, near its end and no
/// larger than it.
bool is_lid(const Detection& plane, const AxialPart& part);

}  // namespace quadrille
