#pragma once

#include <Eigen/Geometry>
#include <vector>

/// Belongs to a target that uses Eigen and includes no header of quadrille.
struct Placed {
  double weight = 0.0;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  Eigen::Matrix4d Q = Eigen::Matrix4d::Zero();
};

/// The mean origin of the poses, moved by the inverse of the last.
Placed place(const std::vector<Eigen::Isometry3d>& poses, const std::vector<Placed>& more);

/// Solves with those of Eigen's decompositions that the libraries use too, so that the linker has
/// to choose between the functions of both; returns a residual.
double decompose(const Eigen::MatrixXd& A);
