#pragma once

#include <Eigen/Geometry>
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "quadrille/detector/eigen_layout.hpp"
#include "quadrille/detector/export.hpp"

namespace quadrille {

/// Kinds of bodies, which tell how a body was found.
enum class BodyKind {
  kSingle,      ///< one detection that belongs to no other body
  kRevolution,  ///< surfaces that share an axis, with the lids at their ends
  kBox,         ///< a box; see Box
  kLump,        ///< connected points above a support that no detection explains
};

/// Returns the kind as messages and JSON name it: "single", "revolution", "box" or "lump".
QUADRILLE_EXPORT std::string_view to_string(BodyKind kind);

/// The wall of a hollow body, such as a mug or a bowl.
struct BodyWall {
  /// Distance between its outer and its inner side along their normals, and its standard deviation
  /// [m]. A sensor that smooths its image may move each side along its normals; these errors are
  /// taken to be independent of each other. That most walls are 4 ± 2 mm thick counts as one more
  /// measurement.
  double thickness = 0.0, std = 0.0;
};

/// One thing of the scene, in a cloud with frame C.
struct SceneBody {
  /// The id of its box, or of the part whose axis and frame it has. The ids of lumps continue those
  /// of detections and boxes. So a number names one thing among detections, boxes and bodies.
  int id = 0;
  BodyKind kind = BodyKind::kSingle;
  /// Ids of the detections that are parts of the body: those with more points first, and lids last.
  /// None for lumps, nor for boxes of which no face was detected.
  std::vector<int> parts;
  /// Pose of frame B. The origin is the middle of the body. z runs along the axis of a body of
  /// revolution and away from the support of a lump; for boxes see Box.
  Eigen::Isometry3d X_CB = Eigen::Isometry3d::Identity();
  /// Sizes along x, y, z, and their standard deviations, infinite for a size that the view leaves
  /// open [m].
  Eigen::Vector3d size = Eigen::Vector3d::Zero(), std = Eigen::Vector3d::Zero();
  /// True for each of x, y, z along which the size was seen. Otherwise the size is a guess, or that
  /// of the seen part alone.
  std::array<bool, 3> seen = {false, false, false};
  /// The body's wall, if both sides of it are parts of the body: one was seen from outside and the
  /// other from inside, at equal heights, and they are farther apart than their deviation.
  std::optional<BodyWall> wall;
  /// Id of the plane on which the body stands, negative if that plane was not asked for; none if
  /// the body leans, hangs or its foot is hidden.
  std::optional<int> standing_on;
  /// Number of cloud points on the body, with those of what is connected to it, such as a handle.
  int points = 0;
  /// Number of views that show the body, and the time since the newest of them [s]. They are 1 and
  /// 0 for a body in a single cloud.
  int views = 1;
  double unseen = 0.0;
  /// Number of the body, 1, 2, …, which it keeps in all clouds of a sequence, whatever its kind and
  /// its parts are there (see Tracker); 0 if it was not tracked. No detection has the same track.
  int track = 0;
};

/// Transforms bodies from frame C to frame F.
QUADRILLE_EXPORT std::vector<SceneBody> moved(std::vector<SceneBody> bodies,
                                              const Eigen::Isometry3d& X_FC);

}  // namespace quadrille
