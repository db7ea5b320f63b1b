#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "support/depth_camera.hpp"

namespace quadrille::test {

/// A face of a box that bulges: the part of a sphere above a rectangle in the plane z = 0, through
/// its corners.
/// @param share  height of its middle over the rectangle, as a share of the shorter side; 0 for a
///               flat face
inline Patch bulging_face(const Eigen::Isometry3d& X_CP, double width, double height,
                          double share) {
  if (share == 0.0) return rectangle(X_CP, width, height);
  const double bulge = share * std::min(width, height);
  const double half_diagonal = 0.5 * std::hypot(width, height);
  const double radius = (half_diagonal * half_diagonal + bulge * bulge) / (2.0 * bulge);
  Patch face = sphere(X_CP * translation(0, 0, bulge - radius), radius);
  face.box_B = {Eigen::Vector3d(-0.5 * width, -0.5 * height, 0.0),
                Eigen::Vector3d(0.5 * width, 0.5 * height, radius)};
  return face;
}

/// A box of which each edge is a quarter of a cylinder and each corner an eighth of a sphere.
inline std::vector<Patch> rounded_box(const Eigen::Isometry3d& X_CB, const Eigen::Vector3d& size,
                                      double radius, double share = 0.0) {
  const Eigen::Vector3d inner = size - Eigen::Vector3d::Constant(2.0 * radius);
  std::vector<Patch> patches;
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    Eigen::Isometry3d X_BA = Eigen::Isometry3d::Identity();
    X_BA.linear() << Eigen::Vector3d::Unit(u), Eigen::Vector3d::Unit(v),
        Eigen::Vector3d::Unit(axis);
    for (const double side : {-0.5, 0.5}) {
      const Eigen::Isometry3d turn(
          Eigen::AngleAxisd(side < 0.0 ? M_PI : 0.0, Eigen::Vector3d::UnitX()));
      patches.push_back(bulging_face(X_CB * X_BA * translation(0, 0, side * size[axis]) * turn,
                                     inner[u], inner[v], share));
      for (const double other : {-0.5, 0.5}) {
        patches.push_back(mantle(X_CB * X_BA * translation(side * inner[u], other * inner[v], 0),
                                 radius, inner[axis]));
        const double third = axis == 0 ? -0.5 : 0.5;
        if (axis == 2) continue;
        const Eigen::Vector3d corner(third * inner[0], side * inner[1], other * inner[2]);
        patches.push_back(sphere(X_CB * Eigen::Translation3d(corner), radius));
      }
    }
  }
  return patches;
}

}  // namespace quadrille::test
