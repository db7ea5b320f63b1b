#pragma once

#include <string>
#include <vector>

#include "lab/bench/contender.hpp"
#include "lab/bench/frames.hpp"

namespace quadrille::bench {

/// The results of one contender on all frames of a family.
struct Row {
  std::string family, contender;
  /// Type of the surfaces that were counted; empty for all. Planes are counted only together with
  /// all.
  std::string counted;
  /// True if the contender also looks for types that are not counted; finding those is no mistake.
  bool finds_others = false;
  int frames = 0;
  /// Sums over the frames, and all width errors.
  FrameScore total;
  /// Times of each frame [ms].
  std::vector<double> wall_ms, cpu_ms;

  /// NaN if the contender finds other types, since nothing tells which of its wrong findings were
  /// meant for the type that is counted.
  double precision() const;
  /// Median of the relative errors of the widths; NaN if there are none.
  double width_error() const;
  /// Median of the distances of the surfaces [m]; NaN if there are none.
  double distance() const;
};

/// Runs each contender that is available on each frame. All surfaces are counted, except for
/// contenders that look for one type alone. In addition, spheres alone are counted for all
/// contenders.
/// @return rows ordered by family, then counted type, then contender
/// @throws std::runtime_error if a cloud cannot be read or a peer fails
std::vector<Row> run_bench(const std::vector<Contender>& contenders, const FrameOptions& frames);

}  // namespace quadrille::bench
