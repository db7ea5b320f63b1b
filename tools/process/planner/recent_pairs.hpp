#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>

#include "process/planner/pairing.hpp"

namespace quadrille {

/// The last clouds with their quadrics, for later requests.
class RecentPairs {
 public:
  /// @param max_pairs  number of pairs to keep, at least 1
  /// @param max_bytes  memory of their clouds; the newest one is always kept
  explicit RecentPairs(std::size_t max_pairs = 32, std::size_t max_bytes = std::size_t{256} << 20)
      : max_pairs_(max_pairs), max_bytes_(max_bytes) {}

  void add(std::shared_ptr<const CloudAndQuadrics> pair);

  /// Returns the newest pair; nullptr before the first one.
  std::shared_ptr<const CloudAndQuadrics> newest() const;
  /// Returns the newest pair whose cloud has this utime [us]; nullptr if none is kept.
  std::shared_ptr<const CloudAndQuadrics> find(std::int64_t cloud_utime) const;
  std::size_t size() const { return pairs_.size(); }

 private:
  std::size_t max_pairs_, max_bytes_, bytes_ = 0;
  std::deque<std::shared_ptr<const CloudAndQuadrics>> pairs_;
};

}  // namespace quadrille
