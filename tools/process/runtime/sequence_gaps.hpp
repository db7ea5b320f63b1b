#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace quadrille {

/// Counts the clouds that never came by the gaps in the numbers that their sources give them. Where
/// the numbers stand still or run backwards, the source does not count or has begun anew, and
/// nothing is known of what is missing.
class SequenceGaps {
 public:
  /// A larger step tells of a new beginning and not of a loss.
  static constexpr std::int64_t kMaxStep = 100000;
  /// Sources that are told apart; the numbers of others are not kept.
  static constexpr std::size_t kMaxSources = 64;

  void add(const std::string& source, std::int32_t seq);

  std::int64_t missing() const { return missing_; }

 private:
  std::map<std::string, std::int32_t> last_;
  std::int64_t missing_ = 0;
};

}  // namespace quadrille
