#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "quadrille/detector/point_cloud.hpp"

namespace quadrille::test {

/// Turned and moved at random, by metres.
Eigen::Isometry3d random_camera_pose(std::mt19937& random);

/// The pose as --camera-pose takes it, with all its digits.
std::string pose_option(const Eigen::Isometry3d& X_WK);

/// A .ply of the cloud's points in frame W, as doubles: their rounding would be another noise.
/// @param X_WK  pose of frame K in W, times a scale if the file is in another unit
std::string moved_ply(const PointCloud& cloud_K, const Eigen::Affine3d& X_WK);

/// Sees to it that a plan in W has the grasps of one in K: poses, contacts and all numbers.
/// @return how many grasps there are
std::size_t check_same_grasps(const nlohmann::json& in_K, const nlohmann::json& in_W,
                              const Eigen::Isometry3d& X_WK);

/// What `quadrille plan --json` says, for which it has to succeed.
nlohmann::json plan(const std::string& arguments);

}  // namespace quadrille::test
