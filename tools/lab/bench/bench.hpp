#pragma once

#include <string>
#include <vector>

#include "lab/bench/contender.hpp"
#include "lab/bench/frames.hpp"

namespace quadrille::bench {

/// What a contender made of all frames of a family.
struct Row {
  std::string family, contender;
  /// The type of the surfaces that were counted; empty for all. Planes go with all.
  std::string counted;
  /// The contender also looks for types that are not counted: that it found others is no mistake.
  bool finds_others = false;
  int frames = 0;
  /// Sums over the frames, and all width errors.
  FrameScore total;
  /// One a frame [ms].
  std::vector<double> wall_ms, cpu_ms;

  /// Undefined (NaN) if the contender finds others, for nothing tells which of its wrong findings
  /// were meant for the type that is counted.
  double precision() const;
  /// Median of the relative errors of the widths; NaN if there are none.
  double width_error() const;
};

/// Has each contender that is not absent work on each frame. All surfaces are counted, but for
/// contenders that look for one type alone; and, for all of them, spheres alone.
/// @return by family, then counted type, then contender
/// @throws std::runtime_error if a cloud cannot be read or a peer fails
std::vector<Row> run_bench(const std::vector<Contender>& contenders, const FrameOptions& frames);

}  // namespace quadrille::bench
