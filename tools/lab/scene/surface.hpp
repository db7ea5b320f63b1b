#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "quadrille/detector/quadric.hpp"

namespace quadrille::scene {

/// A piece of a quadric (or plane) in its own frame S.
struct Surface {
  /// A type name of the detector, or "table", "wall", "cap", "face" for planes.
  std::string type;
  bool curved = false;
  Quadric Q_S;
  /// The piece lies within this box [m].
  Eigen::AlignedBox3d box_S;
  /// For caps: the cap lies only where this quadric is not positive.
  std::optional<Quadric> within_S;
  /// Named dimensions [m].
  std::vector<std::pair<std::string, double>> dims;
};

/// Surfaces that move together, in frame B of the body, whose z axis points up if it stands.
struct Body {
  std::string type;
  std::vector<Surface> surfaces;
  /// Pose of each surface in frame B.
  std::vector<Eigen::Isometry3d> X_BS;
  Eigen::Isometry3d X_WB = Eigen::Isometry3d::Identity();
  /// Radius of the footprint about the origin of B [m].
  double reach = 0.0;
};

/// Casts rays from the origin of frame C at a surface.
class SurfaceCaster {
 public:
  SurfaceCaster(const Surface& surface, const Eigen::Isometry3d& X_CS);

  /// Returns the smallest t > 0 for which t * ray lies on the piece; nullopt if there is none.
  std::optional<double> first_hit(const Eigen::Vector3d& ray) const;
  /// Returns the unit normal at a point of the surface, towards the origin of C.
  Eigen::Vector3d normal(const Eigen::Vector3d& p_C) const;

 private:
  bool holds(const Eigen::Vector3d& p_C) const;

  const Surface& surface_;
  Eigen::Isometry3d X_SC_;
  Quadric Q_C_;
};

}  // namespace quadrille::scene
