#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

namespace quadrille {

/// Fewer points than this make no surface.
inline constexpr std::size_t kMinPoints = 50;

/// Returns up to some thousands of finite points spread evenly over the cloud.
std::vector<Eigen::Vector3d> some_of(std::span<const Eigen::Vector3f> points);

/// Coordinate-wise median of some points, which must not be empty.
Eigen::Vector3d middle_of(const std::vector<Eigen::Vector3d>& some);

}  // namespace quadrille
