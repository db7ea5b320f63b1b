#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

namespace quadrille {

/// Counts the clouds that never came, by the gaps in the numbers that their sources give them. If
/// the numbers stand still or go back, the source does not count or was restarted, and nothing is
/// known about missing clouds.
class SequenceGaps {
 public:
  /// A larger step means that the source was restarted, not that clouds were lost.
  static constexpr std::int64_t kMaxStep = 100000;
  /// Limit of the sources that are distinguished; further sources are ignored.
  static constexpr std::size_t kMaxSources = 64;

  void add(const std::string& source, std::int32_t seq);

  std::int64_t missing() const { return missing_; }

 private:
  std::map<std::string, std::int32_t> last_;
  std::int64_t missing_ = 0;
};

}  // namespace quadrille
