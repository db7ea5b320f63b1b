#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <lcmtypes/quadrille/count_t.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "process/runtime/node.hpp"
#include "process/runtime/poses/posed_clouds.hpp"
#include "process/runtime/poses/view_camera.hpp"
#include "process/runtime/refusals.hpp"
#include "quadrille/bus/cloud_message.hpp"
#include "quadrille/bus/status_message.hpp"

namespace quadrille {

/// The clouds of further cameras, which get the poses of theirs. The cameras are numbered from 1
/// on, since 0 is the first camera. Not for two threads at once.
class PosedViews {
 public:
  /// The work on a cloud, for the working thread.
  using Work =
      std::function<void(int camera, const bus::CloudMessage& cloud, const CameraPose& pose)>;

  /// @param pose_age, pose_wait  as PoseSource has them [s]
  PosedViews(std::vector<ViewCamera> cameras, double pose_age, double pose_wait, Work work);

  /// Returns the camera whose clouds come on a channel; 0 for none.
  int camera_of(const std::string& cloud_channel) const;

  /// The channel of a camera's clouds.
  const std::string& channel(int camera) const { return cameras_[camera - 1].cloud_channel; }

  /// Number of clouds that passed all checks.
  std::int64_t decoded() const { return decoded_; }

  /// Adds a cloud of a camera, or counts and logs why it was refused.
  /// @return its job, if it need not wait for its pose
  std::optional<Job> add(int camera, bus::Decoded<bus::CloudMessage> decoded);

  /// Receives a message of a channel of poses; an invalid one is added to the refusals.
  /// @return false if the channel is none of them
  bool receive_pose(const std::string& channel, std::span<const std::byte> bytes,
                    Refusals* refusals);

  /// Adds the jobs of the clouds that wait no longer; see PosedClouds::take_due().
  void take_due(Node::Time now, std::vector<Job>* jobs);

  /// Returns what is odd about the clouds of a whole log.
  std::vector<std::string> find_oddities() const;

  /// Fills in what the status says of further cameras.
  template <class Status>
  void fill(Status* status) const {
    status->decoded_views = decoded_;
    status->rejected_views = bus::to_message(refusals_.counts());
    status->num_rejected_views = static_cast<std::int32_t>(status->rejected_views.size());
    status->unplaced_views = count_poseless();
    status->num_unplaced_views = static_cast<std::int32_t>(status->unplaced_views.size());
  }

 private:
  std::vector<count_t> count_poseless() const;

  std::vector<ViewCamera> cameras_;
  /// For each camera.
  std::deque<PosedClouds> clouds_;
  Work work_;
  Refusals refusals_;
  std::int64_t decoded_ = 0;
};

}  // namespace quadrille
