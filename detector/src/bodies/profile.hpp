#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "bodies/common_axis.hpp"
#include "surfaces/last_fit.hpp"

namespace quadrille {

/// True if a surface has one axis of revolution, or many as a sphere, and its last fit. Its profile
/// is its radius at each height z of its canonical frame.
bool is_turned(const LastFit& fit);

/// A place next to a profile: its distance from the axis, and its height along the axis over the
/// middle of the canonical frame, in local coordinates.
struct Place {
  double radius, height;
};

/// The axis of a surface of revolution, z of its canonical frame; that of a sphere may be any.
Eigen::Vector3d own_axis(const Surface& surface);

/// Height of a point along an axis over the middle of a surface's canonical frame, in local
/// coordinates.
/// @param axis_C  the surface's own axis, or of a sphere any unit vector
double height_in(const Surface& surface, const Eigen::Vector3d& p_C, const Eigen::Vector3d& axis_C);

/// Radius at a height of the canonical frame of a matrix, in local coordinates; none where there is
/// no section.
std::optional<double> radius_at(const Eigen::Matrix4d& D, double z);

/// The mean of a profile's signed distances from places, positive outside, and its derivative by
/// the parameters of the surface's family; the places stay where they are [m].
struct MeanDistance {
  double value = 0.0;
  Eigen::VectorXd derivative;
};

/// @param places  at least one
/// @param axis_C  the axis along which their heights count, see height_in()
MeanDistance mean_distance(const Surface& surface, const std::vector<Place>& places,
                           const Eigen::Vector3d& axis_C);

/// Covariance of the parameters of a surface's fit, shapes and then motions.
Eigen::MatrixXd parameter_covariance(const Surface& surface);

/// The change of the parameters of a surface's fit if the sensor moves the whole surface along its
/// normals by one unit of the local coordinates; see uncertainty_of().
Eigen::VectorXd offset_step(const Surface& surface);

/// Covariance of the parameters of two surfaces; nullopt if they were fitted one by one.
std::optional<Eigen::MatrixXd> parameter_covariance(int a, int b, std::span<const CommonAxis> axes);

}  // namespace quadrille
