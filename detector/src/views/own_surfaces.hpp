#pragma once

#include <span>
#include <vector>

#include "samples/surface_samples.hpp"
#include "search/candidate.hpp"

namespace quadrille {

/// The surfaces that were found in each view before the views were joined.
class OwnSurfaces {
 public:
  /// @param samples     of all views; they must outlive this
  /// @param candidates  the surfaces of all views, each on samples of the view that found it
  OwnSurfaces(const SurfaceSamples& samples, const std::vector<Candidate>& candidates);

  /// True if a surface runs over most of two surfaces, or more, that one view told apart. Things
  /// that stand side by side may look like one from where only a strip of each is seen.
  /// @param region  the samples of the surface, of any view
  bool tell_apart(std::span<const int> region) const;

 private:
  const SurfaceSamples& samples_;
  std::vector<std::vector<std::vector<int>>> regions_of_view_;
};

}  // namespace quadrille
