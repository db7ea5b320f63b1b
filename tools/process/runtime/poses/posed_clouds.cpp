#include "process/runtime/poses/posed_clouds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "process/runtime/status/status.hpp"

namespace quadrille {

PosedClouds::PosedClouds(PoseSource source, std::string fate)
    : source_(std::move(source)),
      fate_(std::move(fate)),
      max_wait_(std::llround(1e6 * source_.max_wait)),
      poses_(source_.max_age, source_.max_wait) {}

void PosedClouds::receive_pose(std::span<const std::byte> bytes, Refusals* refusals) {
  ++poses_received_;
  if (const auto pose = refusals->accept(source_.channel, bus::decode_pose(bytes))) {
    poses_.add(*pose);
  }
}

std::optional<Job> PosedClouds::add(std::int64_t utime, Then then) {
  if (source_.fixed || source_.channel.empty()) return then({source_.fixed});
  const CameraPose pose = poses_.at(utime);
  if (waiting_.empty() && pose.X_WK) {
    note(utime, pose);
    return then(pose);
  }
  Waiting& cloud = waiting_.emplace_back();
  cloud.utime = utime;
  cloud.since = now_;
  // Moved in: a copy would copy the points of the cloud.
  cloud.thens.push_back(std::move(then));
  return std::nullopt;
}

bool PosedClouds::follow(std::int64_t utime, Then then) {
  const auto last = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                 [&](const Waiting& cloud) { return cloud.utime == utime; });
  if (last == waiting_.rend()) return false;
  last->thens.push_back(std::move(then));
  return true;
}

std::vector<Job> PosedClouds::take_due(Node::Time now) {
  now_ = std::max(now_, now);
  std::vector<Job> jobs;
  while (!waiting_.empty()) {
    CameraPose pose = poses_.at(waiting_.front().utime);
    if (!is_due(waiting_.front(), pose)) break;
    if (!pose.X_WK) explain(waiting_.front(), &pose);
    const Waiting cloud = std::move(waiting_.front());
    waiting_.pop_front();
    note(cloud.utime, pose);
    for (const Then& then : cloud.thens) {
      if (auto job = then(pose)) jobs.push_back(std::move(*job));
    }
  }
  return jobs;
}

bool PosedClouds::is_due(const Waiting& cloud, const CameraPose& pose) const {
  return pose.X_WK || is_crowded() || max_wait_ == max_wait_.zero() || now_ == Node::Time::max() ||
         now_ - cloud.since > max_wait_;
}

/// Explains why the first cloud gets no pose.
void PosedClouds::explain(const Waiting& cloud, CameraPose* none) const {
  none->detail = poses_.explain(cloud.utime, *none);
  if (is_crowded()) none->detail += fmt::format("; more than {} clouds wait", kMaxCloudsWaiting);
}

/// Counts the outcome for a cloud, and logs problems with its pose.
void PosedClouds::note(std::int64_t utime, const CameraPose& pose) {
  last_age_ = pose.age;
  if (pose.X_WK) {
    const std::string far = describe_if_far(pose);
    if (!far.empty()) far_log_.warning(source_.channel + ": " + far);
    return;
  }
  ++poseless_[static_cast<std::size_t>(pose.lack)];
  poseless_log_.warning(
      fmt::format("{}: cloud {} is not {}: {}", source_.channel, utime, fate_, pose.detail));
}

std::int64_t PosedClouds::poseless() const {
  return std::accumulate(poseless_.begin(), poseless_.end(), std::int64_t{0});
}

std::vector<count_t> PosedClouds::count_poseless() const {
  constexpr std::array<const char*, 3> kNames = {"no_pose", "old_pose", "late_pose"};
  std::vector<count_t> counts;
  for (std::size_t i = 0; i < kNames.size(); ++i) {
    if (poseless_[i] == 0) continue;
    counts.emplace_back();
    counts.back().name = kNames[i];
    counts.back().count = poseless_[i];
  }
  return counts;
}

std::string PosedClouds::find_oddity(std::int64_t clouds) const {
  if (poses_received_ == 0 || poseless() == 0) return "";
  return fmt::format("{} of {} clouds had no pose of the camera ({}) and were not {}", poseless(),
                     clouds, list_counts(count_poseless()), fate_);
}

double PosedClouds::last_age_ms() const { return last_age_ ? 1e3 * *last_age_ : -1.0; }

}  // namespace quadrille
