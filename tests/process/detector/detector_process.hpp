#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "process/detector/node.hpp"
#include "quadrille/bus/body_tracks_message.hpp"
#include "quadrille/bus/encode.hpp"
#include "quadrille/bus/quadrics_message.hpp"
#include "support/depth_camera.hpp"

namespace quadrille::test {

using Bytes = std::vector<std::byte>;

/// A detector process whose messages are kept.
struct DetectorProcess {
  explicit DetectorProcess(const DetectorSettings& settings)
      : node(settings, [this](const std::string& channel, std::span<const std::byte> bytes) {
          last[channel].assign(bytes.begin(), bytes.end());
          if (channel == "QUADRICS") published.emplace_back(bytes.begin(), bytes.end());
          if (channel == "QUADRILLE_DETECTOR_STATUS") {
            status.decode(bytes.data(), 0, static_cast<int>(bytes.size()));
          }
        }) {}

  void take(const std::string& channel, const Bytes& bytes, std::int64_t now = 0) {
    for (const Job& job : node.take(Node::Time(now), channel, bytes)) node.work(job);
  }
  /// Does what has waited until now.
  void pass(std::int64_t now) {
    for (const Job& job : node.find_due_jobs(Node::Time(now))) node.work(job);
  }

  /// The tracks of the last message.
  std::set<int> tracks() const {
    std::set<int> found;
    const auto decoded = bus::decode_quadrics(published.back());
    for (const Detection& d : std::get<bus::QuadricsMessage>(decoded).detections) {
      found.insert(d.track);
    }
    return found;
  }

  /// Returns how many clouds were not tracked and why, as the status tells, such as "no_pose 1 ".
  std::string untracked() {
    node.publish_status({});
    std::string text;
    for (const count_t& entry : status.untracked) {
      text += entry.name + " " + std::to_string(entry.count) + " ";
    }
    return text;
  }

  /// The tracks of the bodies of the last cloud.
  std::set<int> body_tracks() const {
    std::set<int> found;
    const auto decoded = bus::decode_body_tracks(last.at("BODY_TRACKS"));
    for (const auto& [id, track] : std::get<bus::BodyTracksMessage>(decoded).track_of) {
      found.insert(track);
    }
    return found;
  }

  std::vector<Bytes> published;
  /// The last message of each channel.
  std::map<std::string, Bytes> last;
  detector_status_t status{};
  DetectorNode node;
};

/// A ball before a wall, both at rest in W, as a camera at X_WC sees them.
inline Bytes encode_view(std::int64_t utime, const Eigen::Isometry3d& X_WC,
                         const std::string& frame = "") {
  const Eigen::Isometry3d X_CW = X_WC.inverse();
  bus::CloudMessage message{utime, 0, {}};
  message.cloud = render(
      {sphere(X_CW * translation(0, 0, 0.9), 0.1), rectangle(X_CW * translation(0, 0, 1.4), 9, 9)},
      {160, 120, 1.0 / 150.0});
  message.cloud.frame = frame;
  return bus::encode_cloud(message, bus::CloudFormat::kDrake);
}

/// Poses of a camera each of whose steps is more than the ball of encode_view() is wide.
inline Eigen::Isometry3d camera_at(int frame) {
  return translation(frame % 2 ? 0.3 : -0.3, 0.02 * frame, 0.0);
}

}  // namespace quadrille::test
