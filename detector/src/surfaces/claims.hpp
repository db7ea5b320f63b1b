#pragma once

#include <span>
#include <vector>

#include "samples/surface_samples.hpp"
#include "surfaces/evidence/smooth_parts.hpp"

namespace quadrille {

/// Which samples the accepted surfaces hold: each is explained once.
class Claims {
 public:
  explicit Claims(const SurfaceSamples& samples);

  /// Claims the samples of a region; claimed ones stay so.
  void add(std::span<const int> region);
  /// Per sample, nonzero if it was claimed.
  const std::vector<char>& claimed() const { return claimed_; }
  /// The samples of a region that nothing has claimed.
  std::vector<int> open_of(std::span<const int> region) const;

  /// Open samples of the smooth parts that a region lies in, and that it leaves over, per sample of
  /// the region; each part counts by its share of the region.
  double remainder(std::span<const int> region) const;

 private:
  SmoothParts parts_;
  std::vector<char> claimed_;
  /// Per smooth part, the samples that nothing has claimed.
  std::vector<int> open_;
};

}  // namespace quadrille
