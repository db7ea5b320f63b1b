#include "view/live/latest_messages.hpp"

#include <algorithm>
#include <iterator>
#include <utility>
#include <variant>

#include "quadrille/bus/grasps_message.hpp"

namespace quadrille::view {
namespace {

/// Time for which clouds are kept after a browser last looked.
constexpr std::chrono::seconds kWatchTime{3};
/// Time after quadrics during which more of them are expected.
constexpr std::chrono::seconds kQuadricsTime{1};
/// Time for which a plan of all objects takes precedence over answers to requests for some.
constexpr std::chrono::seconds kPlanTime{3};

/// Returns true if the grasps answer a request.
bool is_answer(std::span<const std::byte> bytes) {
  const auto decoded = bus::decode_grasps(bytes);
  const auto* const grasps = std::get_if<grasps_t>(&decoded);
  return grasps != nullptr && grasps->request_id != 0;
}

}  // namespace

MessageKeeper::MessageKeeper(LiveChannels channels) : channels_(std::move(channels)) {
  if (!channels_.poses.empty()) latest_.camera.emplace();
}

void MessageKeeper::take(const std::string& channel, std::span<const std::byte> bytes) {
  const std::pair<const std::string&, Bytes LatestMessages::*> slots[] = {
      {channels_.quadrics, &LatestMessages::quadrics},
      {channels_.boxes, &LatestMessages::boxes},
      {channels_.bodies, &LatestMessages::bodies},
      {channels_.body_tracks, &LatestMessages::body_tracks},
      {channels_.grasps, &LatestMessages::grasps},
      {channels_.occupancy, &LatestMessages::occupancy},
      {channels_.obstacles, &LatestMessages::obstacles},
      {channels_.detector_status, &LatestMessages::detector_status},
      {channels_.planner_status, &LatestMessages::planner_status}};
  const bool is_cloud = channel == channels_.cloud;
  const bool is_pose = !channel.empty() && channel == channels_.poses;
  const auto now = Clock::now();
  const bool is_plan = channel == channels_.grasps && !is_answer(bytes);
  {
    const std::lock_guard lock(mutex_);
    if (is_cloud && now > watched_until_) return;
    if (is_plan) plan_came_ = now;
    if (channel == channels_.grasps && now - plan_came_ < kPlanTime && !is_plan) return;
  }
  Bytes copy = std::make_shared<const std::vector<std::byte>>(bytes.begin(), bytes.end());
  const std::lock_guard lock(mutex_);
  if (is_cloud) keep_cloud(std::move(copy));
  if (channel == channels_.robot) {
    // The processes tell of what is refused.
    static_cast<void>(latest_.robot.add(bytes));
  }
  if (is_pose) latest_.camera->add(bytes);
  if (channel == channels_.boxes) latest_.boxes_before = latest_.boxes;
  if (channel == channels_.bodies) latest_.bodies_before = latest_.bodies;
  if (channel == channels_.body_tracks) latest_.body_tracks_before = latest_.body_tracks;
  for (const auto& [name, slot] : slots) {
    if (!is_cloud && name == channel) std::swap(latest_.*slot, copy);
  }
  if (channel == channels_.quadrics) quadrics_came_ = now;
  // Status messages are not part of a scene, and poses without a new cloud change little.
  const bool is_status =
      channel == channels_.detector_status || channel == channels_.planner_status;
  if (is_status || is_pose) return;
  // Clouds, boxes and bodies come before their quadrics, and so do the robot's shapes. They make no
  // scene until these have come, if quadrics have come recently.
  const std::string* const early[] = {&channels_.cloud,  &channels_.boxes,
                                      &channels_.bodies, &channels_.body_tracks,
                                      &channels_.robot,  &channels_.obstacles};
  const bool waits = std::any_of(std::begin(early), std::end(early),
                                 [&](const std::string* name) { return *name == channel; });
  has_news_ = has_news_ || !waits || now - quadrics_came_ > kQuadricsTime;
  news_.notify_one();
}

void MessageKeeper::keep_cloud(Bytes bytes) {
  cloud_bytes_ += bytes->size();
  latest_.clouds.push_back(std::move(bytes));
  while (latest_.clouds.size() > kMaxClouds ||
         (latest_.clouds.size() > 1 && cloud_bytes_ > kMaxCloudBytes)) {
    cloud_bytes_ -= latest_.clouds.front()->size();
    latest_.clouds.pop_front();
  }
}

void MessageKeeper::watch() {
  const std::lock_guard lock(mutex_);
  watched_until_ = Clock::now() + kWatchTime;
  news_.notify_one();
}

bool MessageKeeper::wait(std::chrono::milliseconds timeout) {
  std::unique_lock lock(mutex_);
  const bool ready =
      news_.wait_for(lock, timeout, [this] { return has_news_ && Clock::now() < watched_until_; });
  if (ready) has_news_ = false;
  return ready;
}

LatestMessages MessageKeeper::latest() const {
  const std::lock_guard lock(mutex_);
  return latest_;
}

}  // namespace quadrille::view
