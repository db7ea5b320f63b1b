#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "fits/normalise.hpp"
#include "quadrille/detector/quadric.hpp"

namespace quadrille {

/// A fit with its name, so that all can be compared in one loop.
struct Contender {
  std::string_view name;
  /// Source of the fit: an equation of the paper, or a short reference.
  std::string_view source;
  /// Least number of points; a minimal fit uses exactly that many, the first ones.
  Eigen::Index min_points;
  bool minimal;
  /// True for our own fits, false for fits by others to which they are compared.
  bool ours;
  std::function<std::optional<Quadric>(const OrientedPointsd&)> fit;
};

/// Returns all fits of general quadrics with their default options; README.md says which of them
/// the detector uses, and why. Only the type-constrained fit uses the type, as in the paper's
/// comparison.
std::vector<Contender> contenders(QuadricType known_type);

/// Returns the contender with the given name; nullptr if there is none.
const Contender* find_contender(const std::vector<Contender>& contenders, std::string_view name);

}  // namespace quadrille
