#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/detector/detection.hpp"
#include "run/publish.hpp"

namespace quadrille {

/// One shape of a link, in the form of drake.lcmt_viewer_geometry_data.
struct ViewerShape {
  std::int8_t type = 0;
  Eigen::Isometry3d X_LS = Eigen::Isometry3d::Identity();
  /// Red, green, blue and opacity.
  std::array<float, 4> color = {1.0f, 1.0f, 1.0f, 1.0f};
  std::vector<float> numbers;
};

/// An object that moves as one.
struct ViewerLink {
  std::string name;
  Eigen::Isometry3d X_WL = Eigen::Isometry3d::Identity();
  std::vector<ViewerShape> shapes;
};

/// Makes a box of this size, centred at the origin of its frame.
ViewerShape box_shape(const Eigen::Vector3d& size, const Eigen::Isometry3d& X_LS,
                      const std::array<float, 4>& color);

/// Returns the links of what was found: spheres, ellipsoids and cylinders as such, planes as thin
/// boxes, boxes by their sizes, and all other quadrics as meshes of their seen part. The names
/// contain the track, or the id if there is no track.
std::vector<ViewerLink> links_of(const DetectionResult& found);

/// The channels of a scene.
struct ViewerChannels {
  std::string load, draw;
};

/// Shows links in Meldis. A load message resets the viewer's whole scene, so it is sent only when
/// links come, go or change their shape. It is also repeated from time to time for viewers that
/// start later; those that have the scene ignore it. Poses are sent each time.
class Viewer {
 public:
  Viewer(ViewerChannels channels, bus::Publish publish);

  /// @param utime  time of the cloud [us]
  /// @return number of bytes published
  std::int64_t show(std::int64_t utime, std::vector<ViewerLink> links);

 private:
  bool shows(const std::vector<ViewerLink>& links) const;

  ViewerChannels channels_;
  bus::Publish publish_;
  std::vector<ViewerLink> loaded_;
  std::optional<std::int64_t> loaded_at_;
};

/// Encodes the finite points of a cloud, evenly thinned, as a drake.lcmt_point_cloud in the form
/// that Meldis accepts: only x, y, z, flagged as finite.
/// @param X_RC  pose of the cloud's frame in that of the results
std::vector<std::byte> encode_viewer_cloud(const bus::CloudMessage& cloud,
                                           const Eigen::Isometry3d& X_RC);

}  // namespace quadrille
