#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fit/distance_sums.hpp"
#include "fit/family_fit.hpp"
#include "fit/normalisation.hpp"

namespace quadrille {

/// True if all quadrics of a family have one axis of revolution, the z axis of their canonical
/// frame. A sphere has many.
bool has_one_axis(Family family);

/// A part of a body of revolution: a fit of a family with one axis, or of a sphere, and its points,
/// both in local coordinates.
struct CoaxialPart {
  FamilyFit fit;
  Normalisation local;
  /// Must outlive the part; its quadric is changed.
  DistanceSums<float>* points;
  /// Weight of its squared distances, the inverse of their variance [1/m²].
  double weight;
  /// Number of an earlier part of the same family to which it is parallel, as the two sides of a
  /// wall are: cones share their slope, spheres their centre. Both must have it from the start.
  std::optional<std::size_t> parallel_to = {};
};

/// Fits of several parts about one axis.
struct CoaxialFit {
  /// Frame A: its z axis is the common axis.
  Eigen::Isometry3d X_CA = Eigen::Isometry3d::Identity();
  /// The fit of each part in its local coordinates.
  std::vector<FamilyFit> parts;
  /// For each part the weighted JᵀJ of its distances with respect to the unknowns of the joint fit,
  /// and the map M from a step in these unknowns to one in the family's parameters.
  std::vector<Eigen::MatrixXd> information, map;
};

/// Fits several parts about one axis by Levenberg-Marquardt. Unknown are the axis, by two
/// translations across it and two rotations, and of each part its profile: the shapes of its
/// family, and its place along the axis if the family has one. Parallel parts have an unknown in
/// common. Minimised is the weighted sum of
/// squared first-order distances of all points.
///
/// A step in the parameters of a part at height h on the axis follows from one in the axis: the
/// rotation r is the same, and the translation is t + r × (0, 0, h).
/// @param parts  at least one
/// @return nullopt if no finite step exists
std::optional<CoaxialFit> fit_coaxial(std::span<const CoaxialPart> parts, int iterations);

/// Covariance of the unknowns of a joint fit, and the maps of CoaxialFit.
struct CoaxialCovariance {
  Eigen::MatrixXd unknowns;
  std::vector<Eigen::MatrixXd> map;

  /// Covariance of the parameters of part i, shapes and then motions, with those of part k.
  Eigen::MatrixXd between(std::size_t i, std::size_t k) const {
    return map[i] * unknowns * map[k].transpose();
  }
};

/// The covariance of a joint fit: with H = Σ H_i of all parts, H⁻¹ (Σ v_i H_i) H⁻¹.
/// @param variances  v_i: the distances of part i tell as much as independent ones of v_i times
///   their variance
CoaxialCovariance covariance_of(const CoaxialFit& fit, std::span<const double> variances);

}  // namespace quadrille
