#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "fits/normalise.hpp"
#include "quadrille/detector/quadric_type.hpp"

namespace quadrille {

/// A fit with its name, so that all can be compared in one loop.
struct Contender {
  std::string_view name;
  /// Where it is from: the paper's equation or the reference in short.
  std::string_view source;
  /// Least number of points; a minimal fit uses just as many, the first.
  Eigen::Index min_points;
  bool minimal;
  /// True for our own fits, false for those of others that they are measured against.
  bool ours;
  std::function<std::optional<Quadric>(const OrientedPointsd&)> fit;
};

/// All fits of general quadrics with their default options; README.md says which of them the
/// detector uses, and why. The type is told to the
/// type-constrained one alone, as in the paper's comparison.
std::vector<Contender> contenders(QuadricType known_type);

/// The contender of a name; nullptr if there is none.
const Contender* find_contender(const std::vector<Contender>& contenders, std::string_view name);

}  // namespace quadrille
