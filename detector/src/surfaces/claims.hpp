#pragma once

#include <span>
#include <vector>

namespace quadrille {

/// Records which samples belong to accepted surfaces; each sample is explained only once.
class Claims {
 public:
  /// @param samples  number of samples
  explicit Claims(int samples);

  /// Claims the samples of a region; samples already claimed stay claimed.
  void add(std::span<const int> region);
  /// Per sample, nonzero if it was claimed.
  const std::vector<char>& claimed() const { return claimed_; }
  /// Returns the samples of a region that nothing has claimed.
  std::vector<int> open_of(std::span<const int> region) const;

 private:
  std::vector<char> claimed_;
};

}  // namespace quadrille
