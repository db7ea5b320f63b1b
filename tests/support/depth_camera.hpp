#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <vector>

#include "base/random.hpp"
#include "quadrille/detector/point_cloud.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille::test {

/// A piece of a quadric in its own frame B: what of it lies in the box and where `within` is not
/// positive.
struct Patch {
  Eigen::Matrix4d D = Eigen::Matrix4d::Zero();
  Eigen::Isometry3d X_CB = Eigen::Isometry3d::Identity();
  Eigen::AlignedBox3d box_B{Eigen::Vector3d::Constant(-1e3), Eigen::Vector3d::Constant(1e3)};
  Eigen::Matrix4d within = Eigen::Matrix4d::Zero();
};

struct Camera {
  int width = 320, height = 240;
  /// Tangent from pixel to pixel.
  double pitch = 1.0 / 300.0;
  /// Standard deviation along z at 1 m [m]; it grows with the square of z.
  double noise = 0.0;
  std::uint64_t seed = 1;
};

inline Eigen::Matrix4d diagonal(double a, double b, double c, double d) {
  return Eigen::Vector4d(a, b, c, d).asDiagonal();
}

/// Standard normal (Box and Muller).
inline double gaussian(RandomStream& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.uniform()));
  return radius * std::cos(2.0 * M_PI * random.uniform());
}

inline Eigen::Isometry3d translation(double x, double y, double z) {
  return Eigen::Isometry3d(Eigen::Translation3d(x, y, z));
}

/// Pose X_CW of the world in a camera at the eye that looks at the origin of W, whose z is up; y of
/// the camera points down.
inline Eigen::Isometry3d world_seen_from(const Eigen::Vector3d& eye) {
  const Eigen::Vector3d z = -eye.normalized();
  const Eigen::Vector3d x = z.cross(Eigen::Vector3d::UnitZ()).normalized();
  Eigen::Isometry3d X_WC = Eigen::Isometry3d::Identity();
  X_WC.linear() << x, z.cross(x), z;
  X_WC.translation() = eye;
  return X_WC.inverse();
}

inline Patch sphere(const Eigen::Isometry3d& X_CB, double radius) {
  Patch patch;
  patch.D = diagonal(1, 1, 1, -radius * radius);
  patch.X_CB = X_CB;
  return patch;
}

/// The mantle of a cylinder along z around the origin of B.
inline Patch mantle(const Eigen::Isometry3d& X_CB, double radius, double length) {
  Patch patch;
  patch.D = diagonal(1, 1, 0, -radius * radius);
  patch.X_CB = X_CB;
  patch.box_B.min().z() = -0.5 * length;
  patch.box_B.max().z() = 0.5 * length;
  return patch;
}

/// A rectangle in the plane z = 0 of B.
inline Patch rectangle(const Eigen::Isometry3d& X_CB, double width, double height) {
  Patch patch;
  patch.D(2, 3) = patch.D(3, 2) = 0.5;
  patch.X_CB = X_CB;
  const Eigen::Vector3d half(0.5 * width, 0.5 * height, 1e3);
  patch.box_B = {-half, half};
  return patch;
}

/// A can with a lid at its upper end.
inline std::vector<Patch> can(const Eigen::Isometry3d& X_CB, double radius, double length) {
  Patch lid = rectangle(X_CB * translation(0, 0, 0.5 * length), 1e3, 1e3);
  lid.within = diagonal(1, 1, 0, -radius * radius);
  return {mantle(X_CB, radius, length), lid};
}

/// The six faces of a box around the origin of B.
inline std::vector<Patch> box(const Eigen::Isometry3d& X_CB, const Eigen::Vector3d& size) {
  std::vector<Patch> faces;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-0.5, 0.5}) {
      Eigen::Isometry3d X_BF = Eigen::Isometry3d::Identity();
      X_BF.linear() << Eigen::Vector3d::Unit((axis + 1) % 3), Eigen::Vector3d::Unit((axis + 2) % 3),
          Eigen::Vector3d::Unit(axis);
      X_BF.translation() = side * size[axis] * Eigen::Vector3d::Unit(axis);
      faces.push_back(rectangle(X_CB * X_BF, size[(axis + 1) % 3], size[(axis + 2) % 3]));
    }
  }
  return faces;
}

/// Nearest positive parameter at which the ray of direction d_C from the origin meets the patch;
/// infinite if it does not.
inline double hit(const Patch& patch, const Eigen::Isometry3d& X_BC, const Eigen::Vector3d& d_C) {
  const Eigen::Vector3d o = X_BC.translation(), d = X_BC.linear() * d_C;
  double nearest = std::numeric_limits<double>::infinity();
  for (const double t : Quadric(patch.D).crossings(o, d)) {
    const Eigen::Vector3d x = o + t * d;
    const bool within = Quadric(patch.within).value(x) <= 0.0;
    if (t > 0.0 && t < nearest && patch.box_B.contains(x) && within) nearest = t;
  }
  return nearest;
}

/// What a depth camera at the origin sees along z: an organised cloud in frame C.
inline PointCloud render(const std::vector<Patch>& patches, const Camera& camera = {}) {
  PointCloud cloud;
  cloud.width = camera.width;
  cloud.height = camera.height;
  cloud.frame = "camera";
  cloud.read = static_cast<std::size_t>(camera.width) * camera.height;
  std::vector<Eigen::Isometry3d> X_BC;
  for (const Patch& patch : patches) X_BC.push_back(patch.X_CB.inverse());
  RandomStream random(camera.seed, 0);
  for (int j = 0; j < camera.height; ++j) {
    for (int i = 0; i < camera.width; ++i) {
      const Eigen::Vector3d ray(camera.pitch * (i + 0.5 - 0.5 * camera.width),
                                camera.pitch * (j + 0.5 - 0.5 * camera.height), 1.0);
      double z = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k < patches.size(); ++k) {
        z = std::min(z, hit(patches[k], X_BC[k], ray));
      }
      const double noisy = z + camera.noise * z * z * gaussian(random);
      cloud.points.push_back(
          std::isfinite(z) ? Eigen::Vector3f((noisy * ray).cast<float>())
                           : Eigen::Vector3f::Constant(std::numeric_limits<float>::quiet_NaN()));
    }
  }
  return cloud;
}

}  // namespace quadrille::test
