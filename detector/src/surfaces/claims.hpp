#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/mask.hpp"
#include "samples/surface_samples.hpp"
#include "surfaces/evidence/smooth_parts.hpp"

namespace quadrille {

/// Records which samples belong to accepted surfaces; each sample is explained only once. Copies
/// are cheap.
class Claims {
 public:
  explicit Claims(const SurfaceSamples& samples);

  /// Claims the samples of a region; samples already claimed stay claimed.
  void add(std::span<const int> region);
  /// The samples that nothing has claimed.
  const Mask& free() const { return free_; }
  /// Returns the samples of a region that nothing has claimed.
  std::vector<int> open_of(std::span<const int> region) const;

  /// Number of open samples that a region leaves over in the smooth parts in which it lies, per
  /// sample of the region. Each part counts by its share of the region.
  double remainder(std::span<const int> region) const;

 private:
  std::shared_ptr<const SmoothParts> parts_;
  Mask free_;
  /// Per smooth part, the number of its unclaimed samples.
  std::vector<int> open_;
};

}  // namespace quadrille
