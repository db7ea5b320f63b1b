#pragma once

#include <cstdint>
#include <vector>

#include "quadrille/detector/quadric_type.hpp"

namespace quadrille {

/// All settings of the detector.
struct DetectorOptions {
  /// Chooses the random stream.
  std::uint64_t seed = 1;
  /// Threads to use; never changes the result.
  int threads = 1;
  /// Report only these types; empty means all.
  std::vector<QuadricType> only;

  /// @throws std::invalid_argument naming the field that is out of range
  void check() const;
};

/// Calls visit(name, field) for each scalar setting, in the order of the configuration file.
/// A name is the dotted TOML key, such as "planes.max_distance"; a field is double, int, bool or
/// std::uint64_t.
template <class Options, class Visitor>
void visit_options(Options& o, Visitor&& visit) {
  visit("seed", o.seed);
  visit("threads", o.threads);
}

}  // namespace quadrille
