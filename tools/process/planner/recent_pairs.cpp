#include "process/planner/recent_pairs.hpp"

#include <algorithm>
#include <utility>

#include "poses/waiting_clouds.hpp"

namespace quadrille {

void RecentPairs::add(std::shared_ptr<const CloudAndQuadrics> pair) {
  bytes_ += memory_of(pair->cloud->cloud);
  pairs_.push_back(std::move(pair));
  while (pairs_.size() > 1 && (pairs_.size() > max_pairs_ || bytes_ > max_bytes_)) {
    bytes_ -= memory_of(pairs_.front()->cloud->cloud);
    pairs_.pop_front();
  }
}

std::shared_ptr<const CloudAndQuadrics> RecentPairs::newest() const {
  return pairs_.empty() ? nullptr : pairs_.back();
}

std::shared_ptr<const CloudAndQuadrics> RecentPairs::find(std::int64_t cloud_utime) const {
  const auto found = std::find_if(pairs_.rbegin(), pairs_.rend(), [&](const auto& pair) {
    return pair->cloud->utime == cloud_utime;
  });
  return found == pairs_.rend() ? nullptr : *found;
}

}  // namespace quadrille
