#pragma once

#include <cstddef>
#include <vector>

#include "samples/surface_samples.hpp"

namespace quadrille {

/// Extends a list of samples over their neighbours until no more join.
/// @param joins  joins(neighbour, sample) is true if the neighbour of a listed sample is to be
///   listed too, which it must say only once
template <class Joins>
std::vector<int> flood(const SurfaceSamples& samples, std::vector<int> list, Joins&& joins) {
  for (std::size_t k = 0; k < list.size(); ++k) {
    const int i = list[k];
    for (const int j : samples.neighbours_of(i)) {
      if (joins(j, i)) list.push_back(j);
    }
  }
  return list;
}

}  // namespace quadrille
