#include "process/runtime/poses/posed_views.hpp"

#include <fmt/format.h>

#include <map>
#include <memory>
#include <utility>

#include "process/runtime/status/status.hpp"

namespace quadrille {

PosedViews::PosedViews(std::vector<ViewCamera> cameras, double pose_age, double pose_wait,
                       Work work)
    : cameras_(std::move(cameras)), work_(std::move(work)) {
  for (const ViewCamera& camera : cameras_) {
    clouds_.emplace_back(PoseSource{camera.pose_channel, camera.X_WK, pose_age, pose_wait},
                         "remembered", kMaxBytesWaiting / cameras_.size());
  }
}

int PosedViews::camera_of(const std::string& cloud_channel) const {
  for (std::size_t n = 0; n < cameras_.size(); ++n) {
    if (cameras_[n].cloud_channel == cloud_channel) return static_cast<int>(n) + 1;
  }
  return 0;
}

std::optional<Job> PosedViews::add(int camera, bus::Decoded<bus::CloudMessage> decoded) {
  const auto n = static_cast<std::size_t>(camera) - 1;
  const std::string& channel = cameras_[n].cloud_channel;
  auto cloud = refusals_.accept(channel, std::move(decoded));
  if (!cloud) return std::nullopt;
  ++decoded_;
  const auto shared = std::make_shared<const bus::CloudMessage>(*std::move(cloud));
  return clouds_[n].add(shared->utime, memory_of(shared->cloud),
                        [this, camera, channel, shared](const CameraPose& pose) {
                          return Job{shared->utime,
                                     [this, camera, shared, pose] { work_(camera, *shared, pose); },
                                     {},
                                     channel};
                        });
}

bool PosedViews::receive_pose(const std::string& channel, std::span<const std::byte> bytes,
                              Refusals* refusals) {
  for (std::size_t n = 0; n < cameras_.size(); ++n) {
    if (cameras_[n].X_WK || cameras_[n].pose_channel != channel) continue;
    clouds_[n].receive_pose(bytes, refusals);
    return true;
  }
  return false;
}

void PosedViews::take_due(Node::Time now, std::vector<Job>* jobs) {
  for (PosedClouds& clouds : clouds_) {
    for (Job& job : clouds.take_due(now)) jobs->push_back(std::move(job));
  }
}

std::vector<std::string> PosedViews::find_oddities() const {
  std::vector<std::string> oddities;
  if (refusals_.counts().total() > 0) {
    oddities.push_back(
        fmt::format("of the clouds of further cameras {}", describe(refusals_.counts())));
  }
  if (const std::vector<count_t> unplaced = count_poseless(); !unplaced.empty()) {
    oddities.push_back(
        fmt::format("clouds of further cameras had no pose ({}) and were not remembered",
                    list_counts(unplaced)));
  }
  return oddities;
}

/// Returns the number of clouds of all cameras that got no pose, by reason.
std::vector<count_t> PosedViews::count_poseless() const {
  std::map<std::string, std::int64_t> counts;
  for (const PosedClouds& clouds : clouds_) {
    for (const count_t& count : clouds.count_poseless()) counts[count.name] += count.count;
  }
  std::vector<count_t> summed;
  for (const auto& [name, count] : counts) {
    summed.emplace_back();
    summed.back().name = name;
    summed.back().count = count;
  }
  return summed;
}

}  // namespace quadrille
