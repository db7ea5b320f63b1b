#include "process/runtime/poses/posed_clouds.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "process/runtime/status/status.hpp"

namespace quadrille {

PosedClouds::PosedClouds(PoseSource source, std::string fate, std::size_t max_bytes)
    : source_(std::move(source)),
      fate_(std::move(fate)),
      waiting_(source_.max_age, source_.max_wait, max_bytes) {}

void PosedClouds::receive_pose(std::span<const std::byte> bytes, Refusals* refusals) {
  ++poses_received_;
  if (const auto pose = refusals->accept(source_.channel, bus::decode_pose(bytes))) {
    waiting_.add(*pose);
  }
}

std::optional<Job> PosedClouds::add(std::int64_t utime, std::size_t bytes, Then then) {
  if (source_.fixed || source_.channel.empty()) return then({source_.fixed});
  const bool is_first = waiting_.empty();
  // Moved in: a copy would copy the points of the cloud.
  Thens thens;
  thens.push_back(std::move(then));
  waiting_.add(utime, bytes, now_.count(), std::move(thens));
  if (!is_first) return std::nullopt;
  const auto due = waiting_.take_due(now_.count());
  if (!due) return std::nullopt;
  std::vector<Job> jobs = finish(*due);
  if (jobs.empty()) return std::nullopt;
  return std::move(jobs.front());
}

bool PosedClouds::follow(std::int64_t utime, Then then) {
  Thens* const thens = waiting_.find(utime);
  if (thens == nullptr) return false;
  thens->push_back(std::move(then));
  return true;
}

std::vector<Job> PosedClouds::take_due(Node::Time now) {
  now_ = std::max(now_, now);
  std::vector<Job> jobs;
  while (const auto due = waiting_.take_due(now_.count(), now_ == Node::Time::max())) {
    for (Job& job : finish(*due)) jobs.push_back(std::move(job));
  }
  return jobs;
}

/// Makes the jobs of a cloud that waits no longer.
std::vector<Job> PosedClouds::finish(const WaitingClouds<Thens>::Posed& due) {
  note(due.utime, due.pose);
  std::vector<Job> jobs;
  for (const Then& then : due.cloud) {
    if (auto job = then(due.pose)) jobs.push_back(std::move(*job));
  }
  return jobs;
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
  std::vector<count_t> counts;
  for (std::size_t i = 0; i < kPoseLackNames.size(); ++i) {
    if (poseless_[i] == 0) continue;
    counts.emplace_back();
    counts.back().name = kPoseLackNames[i];
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
