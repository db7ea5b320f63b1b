#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "lab/physics/true_body.hpp"
#include "quadrille/detector/detection.hpp"

namespace quadrille::physics {

/// The ground truth of a generated scene, in the camera's frame C.
struct TrueScene {
  std::vector<TrueBody> bodies;
  /// Bodies of clutter, of which the truth gives only centres and radii [m].
  std::vector<std::pair<Eigen::Vector3d, double>> clutter;
  /// Pose of the table: z up, origin in its plane.
  Eigen::Isometry3d X_CT = Eigen::Isometry3d::Identity();
  /// The true quadrics and the table as detections without error; ids as in the file.
  std::vector<Detection> detections;
};

/// Reads the ground truth of `quadrille scene`, or of another generator of the same format:
/// "objects" with "id", "kind", "type", "body", "q", "pose", "box".
///
/// A body has a flat end if the file lists a cap there. Files from generators that leave out what
/// the camera cannot see are completed by type: cylinders are closed, and so are cones that are not
/// cups.
/// @throws std::runtime_error if it is not such a ground truth or names no table
TrueScene true_scene(const nlohmann::ordered_json& truth);

/// Reads the ground truth beside a cloud: NAME.truth.json, or else NAME.json.
/// @throws io::FileError naming the file that is missing or wrong
TrueScene read_true_scene(const std::string& cloud_path);

/// Returns the body that fills most of a box in frame G, |p_G| ≤ half; nullptr if there is none.
const TrueBody* body_in(const TrueScene& scene, const Eigen::Isometry3d& X_CG,
                        const Eigen::Vector3d& half);

/// Returns true if part of the clutter may lie within `reach` [m] of a point.
bool near_clutter(const TrueScene& scene, const Eigen::Vector3d& p_C, double reach);

}  // namespace quadrille::physics
