#pragma once

#include <span>
#include <vector>

#include "base/mask.hpp"

namespace quadrille {

/// Records which samples belong to accepted surfaces; each sample is explained only once.
class Claims {
 public:
  /// @param samples  number of samples
  explicit Claims(int samples);

  /// Claims the samples of a region; samples already claimed stay claimed.
  void add(std::span<const int> region);
  /// The samples that nothing has claimed.
  const Mask& free() const { return free_; }
  /// Returns the samples of a region that nothing has claimed.
  std::vector<int> open_of(std::span<const int> region) const;

 private:
  Mask free_;
};

}  // namespace quadrille
