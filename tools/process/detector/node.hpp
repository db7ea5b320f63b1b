#pragma once

#include <chrono>
#include <cstdint>
#include <lcmtypes/quadrille/detector_status_t.hpp>
#include <lcmtypes/quadrille/forget_t.hpp>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "poses/placement.hpp"
#include "process/detector/cloud_channels.hpp"
#include "process/detector/settings.hpp"
#include "process/detector/trackers.hpp"
#include "process/runtime/node.hpp"
#include "process/runtime/poses/forgetting.hpp"
#include "process/runtime/poses/posed_clouds.hpp"
#include "process/runtime/poses/posed_views.hpp"
#include "process/runtime/refusals.hpp"
#include "process/runtime/robot/robot_history.hpp"
#include "process/runtime/status/rate.hpp"
#include "process/runtime/status/stages.hpp"
#include "process/runtime/viewer.hpp"
#include "process/runtime/watch/sequence_gaps.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/detector/detection.hpp"
#include "quadrille/detector/lasting_detector.hpp"

namespace quadrille {

/// Finds and tracks the quadrics in the clouds of one channel, or of all channels that a pattern
/// matches.
class DetectorNode : public Node {
 public:
  DetectorNode(const DetectorSettings& settings, bus::Publish publish);

  std::vector<InChannel> in_channels() const override;
  std::vector<OutChannel> out_channels() const override;
  std::optional<Job> receive(const std::string& channel, std::span<const std::byte> bytes) override;
  std::vector<Job> find_due_jobs(Time now) override;
  std::string publish_status(const RunState& run) override;
  std::string summary() const override;
  std::vector<std::string> find_oddities() const override;

 private:
  using TimePoint = std::chrono::steady_clock::time_point;

  std::optional<Job> receive_cloud(const std::string& channel, std::span<const std::byte> bytes);
  std::optional<Job> receive_view(int camera, std::span<const std::byte> bytes);
  void track(const std::string& channel, const bus::CloudMessage& cloud,
             const Eigen::Isometry3d& X_WK, DetectionResult* result);
  std::optional<Job> receive_forget(const std::string& channel, std::span<const std::byte> bytes);
  void forget(const forget_t& message);
  RobotShapes robot_at(const bus::CloudMessage& cloud, const Placement& placement);
  DetectionResult detect_lasting(const bus::CloudMessage& cloud, const PointCloud& cloud_K,
                                 const Eigen::Isometry3d& X_WK, int camera = 0);
  void remember_view(int camera, const bus::CloudMessage& cloud, const CameraPose& pose);
  DetectionResult detect_placed(const std::string& channel, const bus::CloudMessage& cloud,
                                const CameraPose& pose, const Placement& placement);
  void detect_and_publish(const std::string& channel, const bus::CloudMessage& cloud,
                          const CameraPose& pose, TimePoint received);
  void publish_quadrics(const std::string& channel, const bus::CloudMessage& cloud,
                        const std::string& frame, const DetectionResult& result);
  void publish_bodies(const std::string& channel, const bus::CloudMessage& cloud,
                      const std::string& frame, const DetectionResult& result);
  void show(const bus::CloudMessage& cloud, const Placement& placement,
            const DetectionResult& result);
  void fill_counts(detector_status_t* status);

  const DetectorSettings settings_;
  const bus::Publish publish_;
  const std::string settings_hash_;

  // Of the working thread only.
  Trackers trackers_;
  /// What earlier clouds showed.
  LastingDetector lasting_;
  ForgottenTime forgotten_;
  /// The placement of the last cloud, and the name of its frame.
  std::optional<Placement> placement_;
  std::string frame_;
  LimitedLog trackers_log_, warnings_log_;
  /// The viewer, if --viz is given.
  std::optional<Viewer> viewer_;

  mutable std::mutex mutex_;
  detector_status_t counts_{};
  std::int64_t detections_ = 0;
  PosedClouds posed_clouds_;
  /// The clouds of further cameras.
  PosedViews posed_views_;
  SequenceGaps gaps_;
  /// Refused clouds and poses, and messages on the robot and what to forget.
  Refusals refusals_, refused_knowledge_;
  CloudChannels cloud_channels_;
  RobotHistory robot_;
  Stages stages_{{"decode", "wait", "detect", "quadrics"}};
  Rate received_rate_, published_rate_;
};

}  // namespace quadrille
