#include "quadrille/grasping/conventions.hpp"

namespace quadrille {
namespace {

/// Returns the rotation whose columns are the axes of H in G.
Eigen::Matrix3d rotation(HandConvention convention) {
  Eigen::Matrix3d R_GH = Eigen::Matrix3d::Identity();
  switch (convention) {
    case HandConvention::kDrake:
      R_GH << Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX();
      break;
    case HandConvention::kMoveit:
      break;
    case HandConvention::kGpd:
    case HandConvention::kGraspnet:
      R_GH << Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitX();
      break;
  }
  return R_GH;
}

/// Returns how far the origin of H lies behind that of G [m].
double offset(HandConvention convention, const Gripper& gripper, double width) {
  switch (convention) {
    case HandConvention::kDrake:
    case HandConvention::kMoveit: {
      const bool given = gripper.tcp > 0.0;
      return given ? gripper.tcp + gripper.extension(width)
                   : gripper.reach(width) + gripper.palm.z();
    }
    case HandConvention::kGpd:
      return gripper.reach(width);
    case HandConvention::kGraspnet:
      break;
  }
  return 0.0;
}

}  // namespace

std::string_view to_string(HandConvention convention) {
  switch (convention) {
    case HandConvention::kDrake:
      return "drake";
    case HandConvention::kMoveit:
      return "moveit";
    case HandConvention::kGpd:
      return "gpd";
    case HandConvention::kGraspnet:
      break;
  }
  return "graspnet";
}

Eigen::Isometry3d hand_in_grasp(HandConvention convention, const Gripper& gripper, double width) {
  Eigen::Isometry3d X_GH = Eigen::Isometry3d::Identity();
  X_GH.linear() = rotation(convention);
  X_GH.translation().z() = -offset(convention, gripper, width);
  return X_GH;
}

Eigen::Isometry3d hand_pose(HandConvention convention, const Gripper& gripper,
                            const Eigen::Isometry3d& X_CG, double width) {
  return X_CG * hand_in_grasp(convention, gripper, width);
}

Eigen::Isometry3d grasp_of_hand(HandConvention convention, const Gripper& gripper,
                                const Eigen::Isometry3d& X_CH, double width) {
  return X_CH * hand_in_grasp(convention, gripper, width).inverse();
}

}  // namespace quadrille
